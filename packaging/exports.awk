# SPDX-License-Identifier: MIT
# exports.awk: from `nm -g --defined-only -f posix` of all objects to the linker's version script.
# Exported are the names that begin with l3d_: functions, classes and what compilers add to these.
# What is in l3d_detail is the library's own; instantiations of other libraries' templates are
# everybody's.

BEGIN { print "{\nglobal:" }

# _Z; a table (virtual functions, type) or a guard; N, K: a member, const; length and name.
$1 ~ /^(l3d_|_Z(T[VIST]|GV|Thn?[0-9]+_)?N?K?[0-9]+l3d_)/ && $1 !~ /^_Z[A-Za-z_0-9]*N?K?10l3d_detail/ {
    if (!($1 in seen))
        print "    " $1 ";"
    seen[$1]
}

END { print "local:\n    *;\n};" }
