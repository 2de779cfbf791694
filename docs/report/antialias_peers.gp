# SPDX-License-Identifier: MIT
# Error against time of anti-aliased pictures, from antialias_peers.csv: `make pictures`.
set terminal pngcairo size 1200,780 font "sans,11"
set output "docs/report/antialias_peers.png"
set datafile separator ","
set datafile missing NaN
set logscale xy
set grid xtics ytics lc rgb "#dddddd"
set xtics (2, 5, 10, 20, 50, 100, 200, 500, 1000)
set ytics (0.2, 0.5, 1, 2, 5, 10, 20, 50)
set format y "%g"
set multiplot layout 2,3 margins 0.06,0.985,0.13,0.91 spacing 0.045,0.11 \
    title "Anti-aliased pictures of the teapot, 1024 x 768, one thread: error against time"
rows(view) = sprintf("< awk -F, '$1 == 1 && $2 == \"%s\"' docs/report/antialias_peers.csv", view)
# Ours has a line beside each rival; those beside one rival are as good as those beside another.
of(rival, side) = stringcolumn(5) eq rival && stringcolumn(6) eq side ? column(11) : NaN
set xrange [2:1200]
set style line 1 lw 3 pt 7 lc rgb "#9400d3"
set style line 2 lw 2 pt 9 lc rgb "#009e73"
set style line 3 lw 2 pt 5 lc rgb "#56b4e9"
set style line 4 lw 2 pt 13 lc rgb "#e69f00"
unset key
do for [panel = 0:5] {
    error = panel < 3 ? 9 : 10
    view = word("full closeup top", panel % 3 + 1)
    set title sprintf("%s, %s", view, panel < 3 ? "all pixels" : "pixels at edges")
    set ylabel panel % 3 ? "" : "root mean square error, levels of 255"
    set xlabel panel < 3 ? "" : "milliseconds a frame"
    if (panel < 3) { set yrange [0.2:10] } else { set yrange [0.5:30] }
    plot rows(view) using (of("llvmpipe_pixels", "l3d")):error with linespoints ls 1, \
         rows(view) using (of("llvmpipe_samples", "llvmpipe_samples")):error \
             with linespoints ls 2, \
         rows(view) using (of("llvmpipe_pixels", "llvmpipe_pixels")):error \
             with linespoints ls 3, \
         rows(view) using (of("embree", "embree")):error with linespoints ls 4
}
# A panel without a plot, as wide as the picture, for the key of all.
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0.01
set tmargin at screen 0.06
unset border
unset tics
unset grid
unset title
unset xlabel
unset ylabel
set key center center horizontal
plot NaN with linespoints ls 1 title "l3d", \
     NaN with linespoints ls 2 title "llvmpipe, 4 samples a pixel", \
     NaN with linespoints ls 3 title "llvmpipe, 4 x 4 times the pixels", \
     NaN with linespoints ls 4 title "Embree, 16 rays a pixel"
unset multiplot
