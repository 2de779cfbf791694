# SPDX-License-Identifier: MIT
# reference.awk: a public header as Doxygen is to read it, each line in its place.
#
# - The lines at the top say what the file is for.
# - A label, such as "Expects:", begins a paragraph.
# - A comment before `double x = 0, y = 0;` is each member's.
# - What `= default` compares needs no words in the header.

BEGIN { labels = "(Shape|Units|Expects|Errors|Lives|Cost|Source|Order|Fixed): " }

# Ends a paragraph before each label but one that the comment begins with: its summary is there.
function labelled(text, is_first,    done, before, found, stop) {
    done = ""
    while (match(text, "(^ *|[.;] )" labels)) {
        before = substr(text, 1, RSTART - 1)
        found = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        stop = found ~ /^[.;]/ ? substr(found, 1, 2) : ""
        match(found, labels)
        done = done before stop (is_first && before stop == "" ? "" : "<p>") \
               "<b>" substr(found, RSTART, RLENGTH - 1) "</b> "
        is_first = 0
    }
    return done text
}

# `T a = 0, b = 0;` as `T a = 0; /** comment */ T b = 0;`. Commas within brackets separate nothing.
function one_by_one(line, comment,    type, done, depth, i, c) {
    if (line !~ /;$/ || !match(line, /^ *[A-Za-z_:0-9]+(<[^>]*>)? /))
        return line
    type = substr(line, 1, RLENGTH)
    done = type
    depth = 0
    for (i = RLENGTH + 1; i <= length(line); ++i) {
        c = substr(line, i, 1)
        depth += (c ~ /[{(<[]/) - (c ~ /[})>\]]/)
        done = done (c == "," && depth == 0 ? "; /** " comment " */ " type : c)
    }
    return done
}

FNR == 1 { is_top = 1; comment = ""; sub(/^\/[\/*] SPDX.*/, "/// \\file") }

FNR > 1 && is_top { is_top = sub(/^\/[\/*] /, "/// "); sub(/ \*\/$/, "") }

/ operator==\(.*= default;/ && comment == "" {
    sub(/friend/, "/** Whether all members are equal. */ friend")
}

match($0, /\/\/\/<? /) {
    is_own_line = $0 ~ /^ *\/\/\/ /
    code = substr($0, 1, RSTART + RLENGTH - 1)
    text = labelled(substr($0, RSTART + RLENGTH), comment == "" || !is_own_line)
    print code text
    comment = is_own_line ? comment " " text : ""
    next
}

comment != "" && $0 !~ /\(.*\)/ { $0 = one_by_one($0, comment) }

{
    comment = $0 ~ /^ *\/\/\/$/ ? comment " " : ""
    print
}
