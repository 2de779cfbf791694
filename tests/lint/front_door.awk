# SPDX-License-Identifier: MIT
# front_door.awk: names every include by which a public header would reach a private one, and every
# two public headers of one name. Given: the list of public headers, then these headers themselves.

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

/^ *# *include "/ {
    split($0, part, "\"")
    if (!(part[2] in is_public))
        complain(FILENAME " is public and includes " part[2])
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
