# SPDX-License-Identifier: MIT
# front_door.awk: names every include by which a public header would reach a private one, every two
# public headers of one name, and every declaration that programs could not link to. Given: the list
# of public headers, then these headers themselves.

FNR == NR && /^#/ { next }

FNR == NR {
    is_public[$0]
    name = $0
    sub(/.*\//, "", name)
    if (name in place)
        complain($0 " has the name of " place[name])
    place[name] = $0
    next
}

FNR == 1 {
    declaration = ""
    depth = 0
}

/^ *# *include "/ {
    split($0, part, "\"")
    if (!(part[2] in is_public))
        complain(FILENAME " is public and includes " part[2])
}

/^ *(#|\/\/)/ { next }

# A body follows its declaration here: one that ends without a body needs the library.
{
    sub(/ *\/\/.*/, "")
    sub(/= [{][}]/, "")
    declaration = declaration " " $0
    depth += gsub(/[{]/, "{") - gsub(/[}]/, "}")
    if (depth > 0 || !/[;}]$/)
        next
    gsub(/  +/, " ", declaration)
    if (declaration !~ /[{}]|L3D_PUBLIC| inline | constexpr / &&
        declaration !~ /^ (template <.*> )?(class|struct|enum|using|static_assert)/)
        complain(FILENAME ":" FNR ": programs cannot link to this without L3D_PUBLIC:" declaration)
    declaration = ""
}

function complain(what) {
    print "not ok front-door: " what
    worst = 1
}

END {
    if (!worst)
        print "ok front-door"
    exit worst
}
