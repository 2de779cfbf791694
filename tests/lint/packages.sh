#!/bin/sh
# SPDX-License-Identifier: MIT
# packages.sh PACKAGE:PROOF...: makes sure of Debian packages.
# A proof is a header, a library, a file or a program; dpkg-query knows better where there is one.
# Installs what is missing where that needs no password; else says in one line what to install.

known_to_dpkg() { dpkg-query -W -f '${db:Status-Status}' "$1" 2> /dev/null | grep -q '^installed'; }

installed() {
    case $2 in
    *.h | *.hpp | *.so)
        if command -v dpkg-query > /dev/null; then
            known_to_dpkg "$1"
        elif [ "${2%.so}" != "$2" ]; then
            ldconfig -p | grep -q "$2"
        else
            echo "#include <$2>" | ${CXX:-c++} -std=c++20 -fsyntax-only -x c++ - 2> /dev/null
        fi ;;
    /*) [ -e "$2" ] ;;
    *) command -v "$2" > /dev/null ;;
    esac
}

find_missing() {
    missing=
    for entry; do
        installed "${entry%%:*}" "${entry#*:}" || missing="$missing ${entry%%:*}"
    done
}

find_missing "$@"
[ "$missing" ] || exit 0

# make -j starts several of these, and apt-get would fail where another one runs.
exec 9< "$0"
flock 9
find_missing "$@"
[ "$missing" ] || exit 0

fail() {
    echo "error: missing packages:$missing ($1)" >&2
    exit 1
}

command -v apt-get > /dev/null || fail "Debian's names; no apt-get here to install them"
as_root=
if [ "$(id -u)" != 0 ]; then
    as_root="sudo -n"
    $as_root true 2> /dev/null || fail "try: sudo apt-get install$missing"
fi
echo "  APT  $missing"
export DEBIAN_FRONTEND=noninteractive
{
    $as_root apt-get update &&
        $as_root apt-get install -y --no-install-recommends $missing
} > /dev/null || fail "apt-get could not install them"
