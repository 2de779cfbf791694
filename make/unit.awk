# SPDX-License-Identifier: MIT
# unit.awk: the sources that are named, as one. The nameless namespace of a test gets a name around it, so tests may
# call different things by one name; other sources may not.

function close_spaces() {
    for (; open; --open)
        print "}"
}

FNR == 1 {
    close_spaces()
    space = FILENAME
    gsub(/.*\/|\.cpp$/, "", space)
    print "#line 1 \"" FILENAME "\""
}
FILENAME ~ /_test\.cpp$/ && /^namespace \{$/ {
    print "namespace file_" space " { namespace {"
    ++open
    next
}
{ print }
END { close_spaces() }
