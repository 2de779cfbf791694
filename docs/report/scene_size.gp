# gnuplot scene_size.gp
$d0_0 << end
4 3.33918
16 3.81025
64 3.98471
256 7.13726
1024 15.7459
4096 26.7406
end
$d0_1 << end
4 9.99516
16 6.36966
64 8.88626
256 9.01577
1024 14.9564
4096 23.4146
end
$d0_2 << end
4 35.5767
16 32.6314
64 47.2033
256 89.7034
1024 106.382
4096 106.749
end
$d0_3 << end
4 6.50862
16 2.54211
64 3.14317
256 4.13947
1024 12.8158
4096 39.2183
end
$d0_4 << end
4 9.87447
16 5.33837
64 7.42782
256 21.5043
1024 45.0011
4096 154.167
end
$d0_5 << end
4 368.719
16 249.693
64 316
256 277.902
1024 302.498
4096 306.604
end
$d0_6 << end
4 545.579
16 390.521
64 492.437
256 545.725
1024 578.115
4096 600.613
end
$d0_7 << end
4 122.327
16 174.476
64 155.091
256 145.377
1024 85.5157
4096 89.8216
end
set logscale xy
set grid xtics ytics lt 1 lw 1 lc rgb '#dddddd'
set format xy '%g'
set border 3
set tics nomirror
set terminal svg size 900,560 font 'sans,13' dynamic background rgb 'white'
set output 'scene_size.svg'
unset label
unset key
set title 'the same hills, cut into more and more patches' noenhanced
set xlabel 'patches'
set ylabel 'milliseconds a frame, one thread'
set xrange [2.82843:17559.9]
set yrange [1.9343:880.507]
set label 'fd' at graph 0.8333,0.4030 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.8333,0.4335 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.8333,0.4917 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'mesa' at graph 0.8333,0.6259 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.8333,0.6564 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.8333,0.7153 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.8276 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.8333,0.9375 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle
set output
set terminal pngcairo size 1100,680 font 'sans,12' background rgb 'white'
set output 'scene_size.png'
unset label
unset key
set title 'the same hills, cut into more and more patches' noenhanced
set xlabel 'patches'
set ylabel 'milliseconds a frame, one thread'
set xrange [2.82843:17559.9]
set yrange [1.9343:880.507]
set label 'fd' at graph 0.8333,0.4057 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.8333,0.4309 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.8333,0.4917 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'mesa' at graph 0.8333,0.6271 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.8333,0.6553 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.8333,0.7153 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.8276 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.8333,0.9375 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle
set output
