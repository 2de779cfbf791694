# SPDX-License-Identifier: MIT
# config.mk: everything a user may want to change; each value can also be given to make.

VERSION := $(shell awk '/L3D_VERSION_TEXT/{ gsub(/"/, "", $$3); print $$3 }' lib/base/version.h)
RELEASED := November 21, 2026
ABI     := 0#      of the shared library: counted up when a program has to be compiled anew
PREFIX  ?= /usr/local

REAL  ?= float#    the scalar l3d_real: float, double or fixed
MODE  ?= release#  release, debug, asan (with UBSan), tsan, cov or fuzz
REALS ?= float fixed#  what `make install` installs libraries of
BUILD ?= build#    where everything made goes, a folder per variant

ifneq ($(filter default undefined,$(origin CXX)),)
CXX := g++
endif
FREETYPE     ?= /usr/include/freetype2#  where the headers of FreeType 2 are
WERROR       ?=#  -Werror makes warnings errors, as .ci/run, make matrix and the hooks do
CLANG_FORMAT ?= clang-format
CLANG_TIDY   ?= clang-tidy
PYTHON       ?= /usr/bin/python3#  whose headers the Python module is compiled with, and what tests run it with
AT_ONCE ?= 8#  how many sources of a folder are compiled together; 1 is quicker while you change a single one
TEST_TIMEOUT ?= 900#  seconds a test program may take, sanitizers on a slow machine included
STRESS_TIMEOUT ?= 7200#  seconds the slow tests of one layer may take together

FUZZ_CXX     ?= clang++#  the compiler that has libFuzzer
FUZZ_SECONDS ?= 60#  for each reader; a crash, 10 seconds for one text or this much memory ends it:
FUZZ_LIMITS  ?= -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=64 -max_len=4096

# Debian packages, each with its proof: a header, a library or a program that must be there.
PACKAGES_build  := $(if $(findstring clang,$(CXX)),clang:clang++,g++:$(CXX)) libpng-dev:png.h libjpeg62-turbo-dev:jpeglib.h libx11-dev:X11/Xlib.h \
    libxext-dev:X11/extensions/XShm.h libx11-xcb-dev:X11/Xlib-xcb.h \
    libxcb-randr0-dev:xcb/randr.h libxcb-shm0-dev:xcb/shm.h libxcb-xinput-dev:xcb/xinput.h \
    libxkbcommon-dev:xkbcommon/xkbcommon-compose.h libxau-dev:X11/Xauth.h libgl-dev:GL/glext.h libcli11-dev:CLI/CLI.hpp \
    nlohmann-json3-dev:nlohmann/json.hpp \
    libglm-dev:glm/glm.hpp libhwy-dev:hwy/highway.h libfreetype-dev:freetype2/ft2build.h \
    libharfbuzz-dev:harfbuzz/hb.h libfribidi-dev:fribidi/fribidi.h libfontconfig-dev:fontconfig/fontconfig.h
CHARTS          := libjs-chart.js:/usr/share/javascript/chart.js/chart.min.js
FONT            := fonts-dejavu-core:/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
PACKAGES_run    := $(FONT) libosmesa6:libOSMesa.so
PACKAGES_test   := libgtest-dev:gtest/gtest.h python3:python3 xvfb:Xvfb xdotool:xdotool \
    x11-xkb-utils:setxkbmap x11-utils:xprop xauth:xauth wmctrl:wmctrl openbox:openbox i3-wm:i3 \
    parallel:parallel strace:strace locales:/usr/share/i18n/locales/de_DE libegl1:libEGL.so libgl1-mesa-dri:libEGL_mesa.so libosmesa6:libOSMesa.so \
    libboost-dev:boost/multiprecision/cpp_bin_float.hpp gnuplot-nox:gnuplot \
    libosd-dev:opensubdiv/far/patchTableFactory.h $(CHARTS) $(FONT)
PACKAGES_install := pkgconf:pkg-config cmake:cmake mandoc:mandoc parallel:parallel
PACKAGES_python := $(PACKAGES_build) python3-dev:Python.h
PACKAGES_wheel  := python3-build:pyproject-build python3-setuptools:/usr/lib/python3/dist-packages/setuptools \
    python3-wheel:/usr/lib/python3/dist-packages/wheel python3-venv:/usr/share/doc/python3-venv \
    python3-numpy:/usr/lib/python3/dist-packages/numpy mypy:mypy
PACKAGES_bare   := debootstrap:debootstrap
PACKAGES_package := $(PACKAGES_python) build-essential:/usr/share/build-essential/list debhelper:dh \
    dh-python:dh_python3 lintian:lintian
PACKAGES_lint   := clang-format:$(CLANG_FORMAT)
PACKAGES_tidy   := clang-tidy:$(CLANG_TIDY)
PACKAGES_matrix := clang:clang++ libclang-rt-dev:sanitizer/asan_interface.h
PACKAGES_stability := gnuplot-nox:gnuplot python3:python3 libboost-dev:boost/multiprecision/cpp_bin_float.hpp
PACKAGES_faults := python3:python3 strace:strace
PACKAGES_farm   := slurmctld:/usr/sbin/slurmctld slurmd:/usr/sbin/slurmd slurm-client:sbatch openssh-server:/usr/sbin/sshd \
    openssh-client:ssh parallel:parallel ffmpeg:ffmpeg iproute2:ip util-linux:unshare python3:python3
PACKAGES_models := assimp-utils:assimp python3:python3
PACKAGES_displays := python3:python3 xvfb:Xvfb xdotool:xdotool wmctrl:wmctrl xserver-xephyr:Xephyr \
    tigervnc-standalone-server:Xvnc xserver-xorg-video-dummy:Xorg xwayland:Xwayland weston:weston \
    twm:twm openbox:openbox icewm:icewm fluxbox:fluxbox i3-wm:i3 awesome:awesome xfwm4:xfwm4 \
    metacity:metacity mutter:mutter kwin-x11:kwin_x11 dbus:dbus-run-session \
    matchbox-window-manager:matchbox-window-manager
PACKAGES_fuzz   := $(PACKAGES_matrix)
PACKAGES_bench  := python3:python3 libegl1:libEGL.so libgl1-mesa-dri:libEGL_mesa.so \
    libembree-dev:embree3/rtcore.h xvfb:Xvfb libbenchmark-dev:benchmark/benchmark.h \
    libcairo2-dev:cairo/cairo.h libagg-dev:agg2/agg_basics.h
PACKAGES_report := gnuplot-nox:gnuplot graphviz:dot python3:python3 $(CHARTS)
PACKAGES_docs   := doxygen:doxygen
