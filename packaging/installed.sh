#!/bin/sh
# SPDX-License-Identifier: MIT
# installed.sh BINDIR LIBDIR INCLUDEDIR SHAREDIR DOCDIR: says where things were put, and what has to be set
# so that a shell, a compiler and the loader find them; runs ldconfig. DESTDIR from the environment: a staging
# folder, of which nobody runs anything, so nothing has to be set.

echo "l3d is installed:"
echo "  programs   ${DESTDIR}$1"
echo "  libraries  ${DESTDIR}$2"
echo "  headers    ${DESTDIR}$3/l3d"
echo "  models     ${DESTDIR}$4/l3d"
echo "  documents  ${DESTDIR}$5"
[ -z "$DESTDIR" ] || exit 0

# set_path VARIABLE FOLDER VALUE USUAL...: unless the folder is in the value or among the usual ones.
set_path() {
    name=$1 folder=$2 value=$3
    shift 3
    case ":$value:" in *":$folder:"*) return ;; esac
    for usual; do [ "$usual" != "$folder" ] || return 0; done
    echo "  export $name=\"$folder:\$$name\""
}
advice=$(set_path PATH "$1" "$PATH"
    set_path LD_LIBRARY_PATH "$2" "$LD_LIBRARY_PATH" /usr/lib /lib
    set_path PKG_CONFIG_PATH "$2/pkgconfig" "$PKG_CONFIG_PATH" /usr/lib/pkgconfig /usr/local/lib/pkgconfig
    set_path CMAKE_PREFIX_PATH "${2%/lib}" "$CMAKE_PREFIX_PATH" /usr /usr/local)
[ -z "$advice" ] || { echo "Set, unless it is:"; echo "$advice"; }
command -v pkg-config > /dev/null || echo "Programs of your own are built with pkg-config, which is not here (Debian: pkgconf)."
# The loader looks into its usual folders by a list that has to be written anew.
case $2 in
/lib | /usr/lib | /usr/lib/* | /usr/local/lib)
    if [ "$(id -u)" = 0 ] && PATH=$PATH:/sbin:/usr/sbin ldconfig; then
        echo "The loader finds the libraries: ldconfig has listed them."
    else
        echo "Run ldconfig as root: the loader does not find the libraries before."
    fi ;;
esac
