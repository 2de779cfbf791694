# gnuplot scene_size.gp
$d0_0 << end
4 2.25996
16 2.16209
64 3.04705
256 5.69022
1024 11.3361
4096 24.7769
end
$d0_1 << end
4 6.82984
16 6.89048
64 5.47155
256 7.5726
1024 10.865
4096 22.8635
end
$d0_2 << end
4 31.902
16 39.2987
64 42.2573
256 82.6327
1024 100.692
4096 100.616
end
$d0_3 << end
4 4.09259
16 2.89533
64 1.63449
256 3.05892
1024 10.3
4096 34.6584
end
$d0_4 << end
4 11.9959
16 5.06727
64 6.64423
256 13.78
1024 38.5633
4096 134.41
end
$d0_5 << end
4 399.145
16 219.839
64 228.065
256 245.375
1024 270.422
4096 280.742
end
$d0_6 << end
4 513.642
16 379.362
64 428.56
256 531.319
1024 557.926
4096 549.789
end
$d0_7 << end
4 87.2424
16 120.971
64 115.255
256 110.611
1024 81.5857
4096 79.9294
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
set yrange [1.22102:839.267]
set label 'fd' at graph 0.8333,0.4372 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.8333,0.4721 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.8333,0.5122 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'mesa' at graph 0.8333,0.6401 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.8333,0.6753 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.8333,0.7196 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.8324 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.8333,0.9353 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
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
set yrange [1.22102:839.267]
set label 'fd' at graph 0.8333,0.4419 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'afd' at graph 0.8333,0.4673 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.8333,0.5122 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'mesa' at graph 0.8333,0.6401 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'subdivision' at graph 0.8333,0.6753 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.8333,0.7196 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'micropolygons' at graph 0.8333,0.8324 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'scanline' at graph 0.8333,0.9353 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle
set output
