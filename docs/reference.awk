# SPDX-License-Identifier: MIT
# reference.awk: a public header as Doxygen is to read it, each line in its place.
#
# The lines at the top say what the file is for. A label, such as "Expects:", begins a paragraph.

BEGIN { labels = "(Shape|Units|Expects|Errors|Lives|Cost|Source|Order|Fixed): " }

FNR == 1 { is_top = 1; was_comment = 0; sub(/^\/\/ SPDX.*/, "/// \\file") }

FNR > 1 && is_top { is_top = sub(/^\/\/ /, "/// ") }

!match($0, /\/\/\/[< ]/) { was_comment = 0; print; next }

{
    done = substr($0, 1, RSTART + RLENGTH - 1)
    rest = substr($0, RSTART + RLENGTH)
    # A comment that begins with a label has its summary there, so no paragraph ends before.
    is_first = !was_comment || done ~ /<$/
    while (match(rest, "(^ *|[.;] )" labels)) {
        before = substr(rest, 1, RSTART - 1)
        found = substr(rest, RSTART, RLENGTH)
        end = found ~ /^[.;]/ ? substr(found, 1, 1) " " : ""
        label = substr(found, match(found, labels), RLENGTH - 1)
        match(rest, "(^ *|[.;] )" labels)
        rest = substr(rest, RSTART + RLENGTH)
        paragraph = is_first && before end == "" ? "" : "<p>"
        done = done before end paragraph "<b>" label "</b> "
        is_first = 0
    }
    was_comment = 1
    print done rest
}
