# SPDX-License-Identifier: MIT
# layers.awk: reads the headers, and the compiler's dependency files of sources, and names every
# include that breaks the law.
# Given: out, the variant's folder; law, "layer: layers it may use; ..."; with_compare and
# with_reference, the folders under tests and apps that may use these layers beside the library.

BEGIN {
    count = split(law, rows, ";")
    for (i = 1; i <= count; ++i) {
        split(rows[i], row, ":")
        layer = row[1]
        gsub(/ /, "", layer)
        allow(layer, layer)
        used = split(row[2], names, " ")
        for (j = 1; j <= used; ++j)
            allow(layer, names[j])
    }
    allow_all(with_compare, "compare")
    allow_all(with_reference, "reference")
}

function allow_all(folders, other,    names, used, j) {
    used = split(folders, names, " ")
    for (j = 1; j <= used; ++j)
        allow(names[j], other)
}

function allow(layer, other) { may[layer, other] = 1 }

# The layer a path of ours belongs to, "" for any other file.
function layer_of(path,    part) {
    split(path, part, "/")
    if (path ~ /^tests\/reference\//)
        return "reference"
    return part[1] == "lib" ? part[2] : part[1] ~ /^(apps|compare|python)$/ ? part[1] : ""
}

function permitted(unit, other,    part) {
    split(unit, part, "/")
    if ((part[1] "/" part[2], other) in may)
        return 1
    if (unit !~ /^(tests|plugins)\//)
        return (layer_of(unit), other) in may
    return (part[2] == "bench" ? "apps" : part[2], other) in may
}

# One complaint per file and offended layer is enough.
function complain(unit, what, path) {
    if (!((unit, what) in told))
        print "not ok include: " unit " must not see " path
    told[unit, what] = 1
}

function check(unit, path,    other, name) {
    other = layer_of(path)
    if (other != "" && !permitted(unit, other))
        complain(unit, other, path)
    name = unit
    sub(/.*\//, "", name)
    if (path ~ /\/(X11|GL|GLES[23]?|EGL)\// && name !~ /x11|shm|mesa/)
        complain(unit, "a window system", path " (only files named x11, shm or mesa may)")
}

FNR == 1 && FILENAME ~ /\.h$/ { ++units }
FILENAME ~ /\.h$/ {
    if ($1 == "#include") {
        path = $2
        gsub(/["<>]/, "", path)
        check(FILENAME, $2 !~ /^"/ ? "/usr/include/" path : path ~ /^compare\// ? path : "lib/" path)
    }
    next
}

# The target of a rule names the unit: build/<variant>/lib/geom/real.o is lib/geom/real.cpp.
index($1, out) == 1 && $1 ~ /\.o:$/ {
    unit = substr($1, length(out) + 1)
    sub(/\.o:$/, ".cpp", unit)
    ++units
}

# Rules without prerequisites come from -MP.
$1 ~ /:$/ && $1 !~ /\.o:$/ { next }

{
    for (i = 1; i <= NF; ++i)
        if ($i !~ /:$/ && $i != "\\")
            check(unit, $i)
}

END {
    for (complaint in told)
        exit 1
    print units ? "ok include, " units " files" : "not ok include: no dependency file"
    exit !units
}
