#!/bin/sh
# SPDX-License-Identifier: MIT
# must_fail.sh COMPILER FILE...: each file compiles as it is, and no more with -DL3D_MUST_FAIL. A line
# "// The error says: TEXT" is what the compiler has to say then.

compiler=$1
shift
worst=0
for file; do
    if ! $compiler -fsyntax-only "$file"; then
        echo "not ok $file does not compile even without its mistake"
        worst=1
    elif said=$($compiler -fsyntax-only -DL3D_MUST_FAIL "$file" 2>&1); then
        echo "not ok $file compiles with its mistake"
        worst=1
    elif ! echo "$said" | grep -qF -- "$(sed -n 's|^// The error says: ||p' "$file")"; then
        echo "not ok $file fails, but the error does not help"
        worst=1
    else
        echo "ok $file"
    fi
done
exit $worst
