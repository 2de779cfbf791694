#!/bin/sh
# SPDX-License-Identifier: MIT
# bare.sh FOLDER [TARGET...]: makes the targets, run and test unless told otherwise, of the commit that
# is checked out, on a Debian 12 that has nothing but git, make and certificates. It lies in FOLDER/root,
# and FOLDER/TARGET.log holds what was said. The host's apt knows where Debian is and how it is reached.
set -eu
suite=bookworm

fail() {
    echo "error: make bare: $1; nothing was tried" >&2
    exit 1
}

if [ "$1" != --apart ]; then
    [ "$(id -u)" = 0 ] || fail "only root may put a Debian into a folder and run programs there"
    [ -e /proc/self/mounts ] || fail "/proc is not mounted here"
    command -v debootstrap > /dev/null || fail "debootstrap is missing"
    # Mounts and processes go with the process that has these name spaces, however it ends.
    apart="unshare --mount --pid --fork --kill-child"
    $apart true || fail "nothing can be mounted here for one process alone"
    mkdir -p "$1"
    exec $apart "$0" --apart "$@"
fi

folder=$(cd "$2" && pwd)
root=$folder/root
shift 2
[ $# -gt 0 ] || set -- run test

sources=$(apt-get indextargets --format 'deb $(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
    grep -E " $suite(-updates|-security)? " | sort -u)
mirror=$(echo "$sources" | sed -n "s/^deb \(.*\) $suite main$/\1/p" | head -n 1)
[ "$mirror" ] || fail "apt's sources name no mirror of $suite"
eval "$(apt-config shell http_proxy Acquire::http::Proxy https_proxy Acquire::https::Proxy)"
export http_proxy="${http_proxy-}" https_proxy="${https_proxy-}"

git diff --quiet HEAD -- || echo "note: what is not committed is left out" >&2
rm -rf "$folder"
mkdir -p "$folder"
echo "  BARE  $suite in $root"
debootstrap --variant=minbase --include=git,make,ca-certificates "$suite" "$root" "$mirror" \
    > "$folder/debootstrap.log" 2>&1 || { tail -n 5 "$folder/debootstrap.log" >&2; fail "debootstrap failed"; }
echo "$sources" > "$root/etc/apt/sources.list"
apt-config dump | grep -E '^Acquire::https?::(Proxy|CaInfo) ' > "$root/etc/apt/apt.conf.d/90host" || true
cp /etc/hosts /etc/resolv.conf "$root/etc/"
cp /usr/local/share/ca-certificates/*.crt "$root/usr/local/share/ca-certificates/" 2> /dev/null || true
for place in dev sys; do mount --rbind "/$place" "$root/$place"; done
mount -t proc proc "$root/proc"

# Nothing of the host's environment but the way to Debian.
inside() {
    chroot "$root" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
        LANG=C.UTF-8 http_proxy="$http_proxy" https_proxy="$https_proxy" sh -c "$1"
}
inside update-ca-certificates > /dev/null 2>&1
git clone -q --no-local . "$root/l3d"

for target; do
    echo "  BARE  make $target"
    begun=$(date +%s)
    status=0
    inside "cd /l3d && make $target" > "$folder/$target.log" 2>&1 || status=$?
    tail -n 5 "$folder/$target.log"
    echo "make $target: exit status $status after $(($(date +%s) - begun)) s; all it said: $folder/$target.log"
    [ "$status" = 0 ] || exit "$status"
done
