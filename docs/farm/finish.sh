#!/bin/sh
# SPDX-License-Identifier: MIT
# finish.sh FRAMES PATTERN COMMAND...: draws what is missing or torn of a sequence, and makes a video if ffmpeg is there.
# The video has the name of the frames' folder.
set -eu
frames=$1 pattern=$2
shift 2
# A pattern is a format of printf, too.
missing=$(printf "$pattern\n" $(seq 0 $((frames - 1))) | while read -r file; do [ -e "$file" ] || echo "$file"; done | wc -l)
echo "$missing of $frames frames are missing"
"$@" --resume --output "$pattern" --frames "$frames"
command -v ffmpeg > /dev/null || exit 0
video=$(dirname "$pattern")
ffmpeg -y -loglevel error -framerate 30 -i "$pattern" -frames:v "$frames" -pix_fmt yuv420p "$video.part.mp4" < /dev/null
mv "$video.part.mp4" "$video.mp4"
