# SPDX-License-Identifier: MIT
# summary.awk: judges the logs named as arguments; ends with the one line "N passed, N failed".
# Understood: GoogleTest's output, lines `ok NAME` / `not ok NAME why`, and "exit status N" last.

# Shows what was said since the last success: how a failure began and ended, 40 lines each.
function show(    i) {
    for (i = 1; i <= said; ++i) {
        if (i <= 40 || i > said - 40)
            print pending[i]
        else if (i == 41)
            print "... " said - 80 " lines more in the log"
    }
    said = 0
}

# What a skipped test said: GoogleTest prints it between the test's first line and its last.
function reason(    i, text) {
    for (i = 1; i < said; ++i)
        if (pending[i] != "" && pending[i] !~ /\[ RUN      \]|: Skipped$/)
            text = text " " pending[i]
    return text
}

function success() { ++passed; ++good; said = 0; running = "" }
function failure() { ++failed; ++bad; show(); running = "" }

function read_line(line) {
    pending[++said] = line
    if (match(line, /\[ RUN      \] /))
        running = substr(line, RSTART + RLENGTH)
    else if (line ~ /\[       OK \] .*\([0-9]+ ms\)$/ || line ~ /^ok /)
        success()
    else if (line ~ /\[  FAILED  \] .*\([0-9]+ ms\)$/ || line ~ /^not ok /)
        failure()
    else if (match(line, /\[  SKIPPED \] /) && running != "") {
        ++skipped
        print line, reason()
        said = 0
        running = ""
    } else if (line ~ /^skipped /) {
        ++skipped
        ++left_out
        print line
        said = 0
    } else if (line ~ /^exit status [0-9]+$/)
        status = substr(line, 13)
}

function judge(file,    line, found) {
    good = bad = left_out = said = 0
    running = status = ""
    while ((found = (getline line < file)) > 0)
        read_line(line)
    close(file)
    if (found < 0) {
        print "not built: " file
        failure()
    } else if (running != "") {
        print "crashed or out of time: " file
        failure()
    } else if (!bad && status != 0) {
        print "exit status " status ": " file
        failure()
    } else if (!bad && !good && !left_out) {
        print "nothing was tested: " file
        failure()
    }
    printf "%s %d passed, %d failed: %s\n", bad ? "!!" : "  ", good, bad, file
}

BEGIN {
    for (i = 1; i < ARGC; ++i)
        judge(ARGV[i])
    if (skipped)
        printf "%d skipped\n", skipped
    printf "%d passed, %d failed\n", passed, failed
    exit failed || !passed
}
