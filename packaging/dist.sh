#!/bin/sh
# SPDX-License-Identifier: MIT
# dist.sh VERSION FOLDER: FOLDER/l3d-VERSION.tar.gz of the commit that is checked out. The same
# commit gives the same bytes: git takes the times of the files from it, and gzip adds none.
set -eu
name=l3d-$1
mkdir -p "$2"
git diff --quiet HEAD -- || echo "note: what is not committed is left out" >&2
git archive --format=tar --prefix="$name/" HEAD | gzip -9n > "$2/$name.tar.gz"
echo "$2/$name.tar.gz"
