# SPDX-License-Identifier: MIT
# errors_doc.awk: a declaration that gives a unique_ptr or takes `why` must say how it fails.

FNR == 1 { comment = declaration = "" }

/^ *\/\/\// { comment = comment $0 "\n"; next }
/^ *(\/\/|#|$|public:|protected:|private:)/ { next }

{
    declaration = declaration $0
    if (declaration !~ /[;{}]/)
        next
    sub(/ *[{}].*/, "", declaration)
    # What overrides, and the private half of a public call, is documented where it is first said.
    fails = declaration ~ /std::unique_ptr<[^()]*[a-z_]\(/ || declaration ~ /std::string& why/
    if (fails && declaration !~ /override|[ >&*]do_/ && comment !~ /Errors:/) {
        gsub(/  +/, " ", declaration)
        sub(/^ /, "", declaration)
        printf "%s:%d: no `Errors:` above: %s\n", FILENAME, FNR, declaration
        missing = 1
    }
    comment = declaration = ""
}

END { exit missing }
