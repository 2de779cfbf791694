#!/bin/sh
# SPDX-License-Identifier: MIT
# matrix.sh FOLDER: runs every test in each variant, keeps the logs there, ends with a table.

mkdir -p "$1"
table=
worst=0
for compiler in g++ clang++; do
    for real in float double fixed; do
        for mode in release asan; do
            variant="$compiler $real $mode"
            log="$1/$real-$mode-$compiler.log"
            echo "== $variant"
            $MAKE test WITH="lab thorough" CXX=$compiler REAL=$real MODE=$mode WERROR=-Werror > "$log" 2>&1 || worst=1
            verdict=$(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$log" | tail -n 1)
            table="$table$(printf '%-24s %s' "$variant" "${verdict:-not built: see $log}")
"
        done
    done
done
printf '%s' "$table"
exit $worst
