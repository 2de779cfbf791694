#!/bin/sh
# SPDX-License-Identifier: MIT
# must_fail.sh COMPILER FILE...: each file compiles as it is, and no more with -DL3D_MUST_FAIL.

compiler=$1
shift
worst=0
for file; do
    if ! $compiler -fsyntax-only "$file"; then
        echo "not ok $file does not compile even without its mistake"
        worst=1
    elif $compiler -fsyntax-only -DL3D_MUST_FAIL "$file" 2> /dev/null; then
        echo "not ok $file compiles with its mistake"
        worst=1
    else
        echo "ok $file"
    fi
done
exit $worst
