# SPDX-License-Identifier: MIT
# How sources are compiled. Each choice of number type, mode and compiler has a folder of its own.

flags_float   := -DL3D_REAL_FLOAT
flags_double  := -DL3D_REAL_DOUBLE
flags_fixed   := -DL3D_REAL_FIXED
# What makes mistakes harder to misuse: guarded stacks, checked calls of the C library, addresses
# that nobody can guess, and tables that nobody can write to after the start.
HARDENED      := -fstack-protector-strong -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -fPIE
# A program takes of a unit what it calls.
flags_release := -O3 -DNDEBUG -ffunction-sections -fdata-sections $(HARDENED)
link_release := -Wl,--gc-sections -Wl,-z,relro,-z,now
pie_release   := -pie
flags_debug   := -O0 -g
flags_asan    := -O1 -g -fno-omit-frame-pointer -fno-sanitize-recover=all \
                 -fsanitize=address,undefined,float-cast-overflow
flags_tsan    := -O1 -g -fsanitize=thread
flags_cov     := -O0 -g --coverage
flags_fuzz    := -O1 -g -fno-omit-frame-pointer -fno-sanitize-recover=all \
                 -fsanitize=fuzzer-no-link,address,undefined

# Leaks in libraries that are not ours to mend.
export LSAN_OPTIONS ?= suppressions=$(CURDIR)/tests/lint/leaks.supp:print_suppressions=0

ifeq ($(filter $(REAL),float double fixed),)
$(error REAL=$(REAL) is unknown; choose float, double or fixed)
endif
ifeq ($(filter $(MODE),release debug asan tsan cov fuzz),)
$(error MODE=$(MODE) is unknown; choose release, debug, asan, tsan, cov or fuzz)
endif

compiler := $(notdir $(lastword $(CXX)))
OUT      := $(BUILD)/$(REAL)-$(MODE)$(if $(filter-out g++,$(compiler)),-$(compiler))

# -ffp-contract=off: float results must not depend on whether the machine has fused operations.
# -Wno-...: g++ 12 sees overlaps and endless copies in std::string's own code (GCC bug 105651), and notes that vectors are
# passed otherwise than by GCC 4.5.
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion $(WERROR) \
            $(if $(findstring clang,$(compiler)),,-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds -Wno-psabi)
FLAGS     = -std=c++20 $(WARNINGS) -ffp-contract=off -fno-math-errno -pthread \
            $(flags_$(REAL)) $(flags_$(MODE)) -I$(OUT) -isystem $(FREETYPE) $(CPPFLAGS) $(CXXFLAGS)
# A source is of the library, a test, or of the rest, and so are its flags.
kind = $(if $(filter lib/% python/% plugins/%,$(1)),lib,$(if $(filter %_test.cpp,$(1)),test,rest))
# What the shared library is made of serves the static one, too: without interposition the code is
# that of -fPIE, which programs get anyway, and one compilation is enough.
# L3D_PUBLIC marks what the shared library exports.
# Lanes are compiled for AVX-512, AVX2, SSE4 and none. Processors with SSSE3 alone are those of 2006 to 2008: they
# get the last, and each file of lanes is compiled a fifth sooner.
FLAGS_lib  := -fPIC -fno-semantic-interposition -fvisibility=hidden -DHWY_DISABLED_TARGETS=HWY_SSSE3
# Tests take longer to compile than to run, so they are compiled quickly. The files beside them that do the work, such as
# judges of pictures, are optimised.
# At -Og, g++ 12 takes the state of a std::stop_token for uninitialized.
FLAGS_test := $(if $(filter release,$(MODE)),-Og $(if $(findstring clang,$(compiler)),,-Wno-maybe-uninitialized))
# What a program does once need not be fast.
less_optimised = $(if $(filter lib/system/% apps/%,$(1)),$(if $(filter release,$(MODE)),-O1))
# The standard library's headers are half of what a source takes to compile: each kind has them
# precompiled. A source includes what it uses all the same, as `make tidy` sees.
headers_lib  := lib/base/precompiled.h
headers_test := tests/precompiled.h
headers_rest := lib/base/precompiled.h
precompiled   = $(OUT)/precompiled/$(call kind,$(1)).h
LINK      = $(CXX) $(FLAGS) -Wl,--as-needed $(link_$(MODE)) $(LDFLAGS)
