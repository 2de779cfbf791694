# SPDX-License-Identifier: MIT
# man_page.awk: a page in section 1 from what a program says with --help, so that options have their
# texts in one place. Given: program, date.

# Prints text so that roff reads nothing into it, each sentence on lines of its own.
function text(words,    count, word, i, line) {
    gsub(/\\/, "\\e", words)
    gsub(/-/, "\\-", words)
    count = split(words, word, " ")
    for (i = 1; i <= count; ++i) {
        if (length(line) + length(word[i]) >= 79 || line ~ /\.$/) {
            print line
            line = ""
        }
        if (line == "" && word[i] ~ /^[.']/)
            word[i] = "\\&" word[i]
        line = line (line == "" ? "" : " ") word[i]
    }
    print line
}

# "-h,--help" as macros.
function flags(names,    i, count, name) {
    count = split(names, name, ",")
    for (i = 1; i <= count; ++i) {
        sub(/^-/, "", name[i])
        gsub(/-/, "\\-", name[i])
        printf "%sFl %s", (i > 1 ? " , " : ""), name[i]
    }
}

# "NUMBER=0.25", a kind and what is taken unasked.
function option(names, kind,    usual) {
    printf ".It "
    flags(names)
    usual = kind
    if (sub(/=.*/, "", kind))
        sub(/^[^=]*=/, "", usual)
    else
        usual = ""
    gsub(/-/, "\\-", usual)
    print (kind == "" ? "" : " Ar " kind) (usual == "" ? "" : " Pq " usual)
}

function head(first) {
    first = purpose
    sub(/\. .*|\.$/, "", first)
    print ".\\\" Made from what the program says with --help."
    print ".Dd " date
    print ".Dt " toupper(program) " 1"
    print ".Os"
    print ".Sh NAME\n.Nm " program
    print ".Nd " tolower(substr(first, 1, 1)) substr(first, 2)
    print ".Sh SYNOPSIS\n.Nm\n.Op Ar option ..."
    if (/\[FILE\]/)
        print ".Op Ar file"
    print ".Sh DESCRIPTION"
    text(purpose)
    print ".Sh OPTIONS"
}

function close_list() {
    if (part == "options")
        print ".El"
}

/^Usage: / { head(); next }
# A heading of options, which have lists of their own.
after_blank && /^[A-Z].*:$/ {
    close_list()
    part = /^Examples:$/ ? "examples" : "options"
    sub(/:$/, "")
    if (part == "options")
        print ".Ss " $0 "\n.Bl -tag -width Ds"
    after_blank = 0
    next
}
/^Environment: / {
    close_list()
    print ".Sh ENVIRONMENT"
    part = "environment"
    sub(/^Environment: /, "")
}
# A paragraph between the two, such as what may stand for a word in capitals.
after_blank && part ~ /^(options|notes)$/ && /^[^ ]/ {
    close_list()
    print part == "notes" ? ".Pp" : ".Ss Words"
    part = "notes"
}
{ after_blank = $0 == "" }
after_blank { next }

part == "" { purpose = purpose (purpose == "" ? "" : " ") $0 }

# Two spaces before an option, many before a text that has a line of its own.
part == "options" {
    if (match($0, /^  -[^ ]+/)) {
        names = $1
        rest = substr($0, RSTART + RLENGTH)
        kind = ""
        if (rest ~ /^ [^ ]/) {
            kind = $2
            sub(/^ [^ ]+/, "", rest)
        }
        option(names, kind)
        $0 = rest
    }
    sub(/^ +/, "")
    if ($0 != "")
        text($0)
}

part == "notes" || part == "environment" { text($0) }

# They come behind the exit status: each a line with the command, and one with its purpose.
part == "examples" {
    gsub(/-/, "\\-")
    is_purpose = /^   /
    sub(/^ +/, "")
    examples = examples (is_purpose ? "" : ".It Ic ") $0 "\n"
}

END {
    print ".Sh EXIT STATUS"
    text("0 well, 1 failure, 2 wrong usage, 3 no display, 4 no usable back-end, " \
         "5 bad input file, 6 display lost.")
    if (examples != "")
        print ".Sh EXAMPLES\n.Bl -tag -width Ds\n" examples ".El"
    print ".Sh SEE ALSO\n.Xr l3d 7"
}
