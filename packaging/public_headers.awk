# SPDX-License-Identifier: MIT
# public_headers.awk: of the headers named as arguments, those that others can include: all but
# the private ones (_p.h, -inl.h) and what includes a private one, be it through others.

FNR == 1 {
    name = FILENAME
    sub(/^lib\//, "", name)
    files[++count] = name
    hidden[name] = name ~ /(_p|-inl)\.h$/
}

/^#include "/ {
    split($0, part, "\"")
    includes[name, part[2]]
}

END {
    do {
        changed = 0
        for (pair in includes) {
            split(pair, of, SUBSEP)
            if (hidden[of[2]] && !hidden[of[1]])
                changed = hidden[of[1]] = 1
        }
    } while (changed)
    for (i = 1; i <= count; ++i)
        if (!hidden[files[i]])
            print files[i]
}
