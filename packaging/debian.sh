#!/bin/sh
# SPDX-License-Identifier: MIT
# debian.sh VERSION FOLDER: source and binary packages from FOLDER/l3d-VERSION.tar.gz into
# FOLDER/debian, and what lintian says of them. A warning or an error fails.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$2"
rm -rf debian
mkdir debian
cd debian
cp "../l3d-$1.tar.gz" "l3d_$1.orig.tar.gz"
tar xf "l3d_$1.orig.tar.gz"
cp -r "$here/debian" "l3d-$1/"
# The plug-in for STEP and IGES is packed where Open CASCADE is installed.
[ -e /usr/include/opencascade/STEPCAFControl_Reader.hxx ] || export DEB_BUILD_PROFILES=pkg.l3d.nocad
# Some ten minutes: what is built is shown, all else goes to the log.
{ (cd "l3d-$1" && dpkg-buildpackage -us -uc 2>&1) || touch failed; } | tee build.log |
    grep --line-buffered -E '^\[[0-9]+/[0-9]+\]|^ *dh_|^ dpkg-' || true
[ ! -e failed ] || { tail -40 build.log; exit 1; }
ls ./*.deb
# There is no bug for it to close: nobody has asked Debian for it yet.
lintian --fail-on error,warning --info --suppress-tags initial-upload-closes-no-bugs ./*.changes
