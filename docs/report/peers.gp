# SPDX-License-Identifier: MIT
# Error against time of l3d and of those it is compared with, from peers.csv: `make pictures`.
set terminal pngcairo size 900,420 font "sans,11"
set output "docs/report/peers.png"
set datafile separator ","
set logscale xy
set xlabel "milliseconds a frame, one thread, 1024 x 768"
set ylabel "error in pixels, at most"
set grid lc rgb "#dddddd"
set key outside right top
set xrange [0.3:30]
set yrange [0.05:1]
set ytics ("0.1" 0.1, "0.25" 0.25, "0.5" 0.5)
set title "the teapot, view full"
rows = "< awk -F, '$1 == 1 && $2 == \"full\" && $3 == 1024' docs/report/peers.csv"
of(mesh, time) = stringcolumn(13) eq mesh ? column(time) : NaN
set datafile missing NaN
plot rows using (of("adaptive", 11)):5 with linespoints lw 2 pt 7 title "l3d, a grey a vertex", \
     rows using (of("adaptive", 9)):5 with linespoints lw 2 pt 5 title "l3d, a normal a pixel", \
     rows using (of("thinned", 17)):5 with linespoints lw 2 pt 9 title "llvmpipe, thinned mesh", \
     rows using (of("adaptive", 17)):5 with linespoints lw 2 pt 8 title "llvmpipe, adaptive mesh", \
     rows using (of("thinned", 21)):5 with linespoints lw 2 pt 11 title "Embree, thinned mesh", \
     rows using (of("adaptive", 21)):5 with linespoints lw 2 pt 10 title "Embree, adaptive mesh"
