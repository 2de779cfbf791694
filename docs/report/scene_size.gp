# gnuplot scene_size.gp
$d0_0 << end
4 3.40151
16 2.53713
64 2.73701
256 5.54212
1024 9.30102
4096 25.3678
end
$d0_1 << end
4 6.32287
16 5.75117
64 5.21097
256 7.94354
1024 11.4522
4096 27.8068
end
$d0_2 << end
4 29.6418
16 31.2944
64 41.5236
256 84.4188
1024 95.0823
4096 103.462
end
$d0_3 << end
4 3.96132
16 3.15907
64 1.16741
256 3.30614
1024 9.98493
4096 35.3781
end
$d0_4 << end
4 7.91731
16 5.06006
64 6.81326
256 13.247
1024 45.7432
4096 124.262
end
$d0_5 << end
4 382.343
16 227.554
64 232.507
256 250.025
1024 254.045
4096 276.073
end
$d0_6 << end
4 483.983
16 390.001
64 436.015
256 522.252
1024 561.214
4096 550.945
end
$d0_7 << end
4 107.623
16 117.522
64 109.916
256 107.758
1024 106.706
4096 78.805
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
set yrange [0.857291:864.693]
set label 'afd' at graph 0.8333,0.4754 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.8333,0.5103 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'tessellation' at graph 0.8333,0.5450 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'mesa' at graph 0.8333,0.6537 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.8333,0.6888 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.8333,0.7237 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.8349 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.8333,0.9348 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
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
set yrange [0.857291:864.693]
set label 'afd' at graph 0.8333,0.4837 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'fd' at graph 0.8333,0.5091 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'tessellation' at graph 0.8333,0.5379 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'mesa' at graph 0.8333,0.6537 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.8333,0.6930 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.8333,0.7195 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.8349 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.8333,0.9348 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle
set output
