# SPDX-License-Identifier: MIT
# test_unit.awk: the tests that are named, as one source. The nameless namespace of each gets a name
# around it, so tests may call different things by one name.

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
/^namespace \{$/ {
    print "namespace file_" space " { namespace {"
    ++open
    next
}
{ print }
END { close_spaces() }
