#!/bin/sh
# SPDX-License-Identifier: MIT
# What programs can link to in a shared library: functions, variables, tables of virtual functions and
# types. Inline functions and templates are left out: compilers differ in which of them they export.
set -e
nm -D --defined-only -C "$1" |
    sed -nE 's/^[0-9a-f]+ [TBDR] //p; s/^[0-9a-f]+ V ((vtable|typeinfo) for .*)/\1/p' |
    sed -E 's/std::__cxx11::basic_string<char, std::char_traits<char>, std::allocator<char> >/std::string/g
            s/std::basic_string_view<char, std::char_traits<char> >/std::string_view/g
            s/\[abi:cxx11\]//g
            s/, std::(allocator|default_delete)<([^<>]|<[^<>]*>)*> *>/>/g' |
    LC_ALL=C sort -u
