# gnuplot error_time.gp
$d0_0 << end
0.88365 1.27649
1.11304 0.252355
1.16831 0.230083
1.2576 0.0760727
2.05438 0.0249165
3.30137 0.0118688
7.15848 0.00480035
end
$d0_1 << end
0.88365 1.7376
1.11304 0.90215
1.16831 0.490928
1.2576 0.24853
2.05438 0.099275
3.30137 0.0499591
7.15848 0.0199662
end
$d0_2 << end
1.78214 0.460009
1.80122 0.21298
3.17685 0.10942
3.91762 0.0317154
6.519 0.0126698
end
$d0_3 << end
1.78214 0.995573
1.80122 0.504389
3.17685 0.257821
3.91762 0.106256
6.519 0.0650654
end
$d0_4 << end
9.7177 0.397744
16.4802 0.217819
32.0026 0.122641
79.3531 0.0487473
end
$d0_5 << end
9.7177 0.999927
16.4802 0.499827
32.0026 0.249995
79.3531 0.0999981
end
$d0_6 << end
2.05557 16
2.8908 11.3714
1.01536 2.09387
1.98568 0.621945
5.16662 0.140438
19.8505 0.0166913
59.7471 0.0050057
end
$d0_7 << end
2.05557 174.371
2.8908 43.5956
1.01536 10.9016
1.98568 2.72814
5.16662 0.684771
19.8505 0.173929
59.7471 0.0462178
end
$d0_8 << end
4.34812 16
5.76753 11.3714
8.29715 2.09387
15.5941 0.621945
35.8365 0.140438
end
$d0_9 << end
1.73906 16
1.80376 11.3714
0.858893 2.09387
1.55308 0.621945
4.95652 0.140438
end
$d0_10 << end
71.9894 0.00543811
155.952 0.0136459
294.813 0.0136459
534.642 0.0136459
end
$d0_11 << end
71.9894 0.0624879
155.952 0.0523786
294.813 0.0523299
534.642 0.0523299
end
$d0_12 << end
43.2417 0.563902
112.35 0.638099
244.152 0.64648
367.287 0.664085
end
$d0_13 << end
241.45 0.140625
240.136 0.0318314
245.891 0.0114089
264.03 0.00626309
end
$d0_14 << end
191.749 18.3987
236.095 8.87488
324.844 4.22956
526.251 2.51603
end
$d0_15 << end
21.6105 0.1836
31.0636 0.0747686
55.436 0.0161339
92.7131 0.0104229
end
set logscale xy
set grid xtics ytics lt 1 lw 1 lc rgb '#dddddd'
set format xy '%g'
set border 3
set tics nomirror
set terminal svg size 900,560 font 'sans,13' dynamic background rgb 'white'
set output 'error_time.svg'
unset label
unset key
set title 'teapot, full: solid, the error measured; dashed, the bound certified' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'largest error of outlines, pixels'
set xrange [0.622634:2064.57]
set yrange [0.00283964:363.654]
set label 'afd' at graph 0.3013,0.0446 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5630,0.0482 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7463,0.0673 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.6172,0.1106 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2897,0.1272 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1335 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5980,0.2417 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4999,0.3317 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2559,0.3317 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7870,0.4638 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8314,0.5771 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with lines dt 2 lw 1.4 lc rgb '#000000' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_3 using 1:2 with lines dt 2 lw 1.4 lc rgb '#0072b2' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_5 using 1:2 with lines dt 2 lw 1.4 lc rgb '#009e73' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_7 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e69f00' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_9 using 1:2 with linespoints lw 1.2 pt 12 ps 0.9 lc rgb '#8a8500' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_11 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e377c2' notitle, \
     $d0_12 using 1:2 with linespoints lw 1.6 pt 6 ps 0.9 lc rgb '#56b4e9' notitle, \
     $d0_13 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_14 using 1:2 with linespoints lw 1.6 pt 10 ps 0.9 lc rgb '#8a8a8a' notitle, \
     $d0_15 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle
set output
set terminal pngcairo size 1100,680 font 'sans,12' background rgb 'white'
set output 'error_time.png'
unset label
unset key
set title 'teapot, full: solid, the error measured; dashed, the bound certified' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'largest error of outlines, pixels'
set xrange [0.622634:2064.57]
set yrange [0.00283964:363.654]
set label 'afd' at graph 0.3013,0.0446 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5630,0.0482 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7463,0.0673 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.6172,0.1106 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2897,0.1272 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.1335 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'subdivision' at graph 0.5980,0.2417 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.4999,0.3317 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2559,0.3317 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7870,0.4638 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8314,0.5771 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with lines dt 2 lw 1.4 lc rgb '#000000' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_3 using 1:2 with lines dt 2 lw 1.4 lc rgb '#0072b2' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_5 using 1:2 with lines dt 2 lw 1.4 lc rgb '#009e73' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_7 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e69f00' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_9 using 1:2 with linespoints lw 1.2 pt 12 ps 0.9 lc rgb '#8a8500' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_11 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e377c2' notitle, \
     $d0_12 using 1:2 with linespoints lw 1.6 pt 6 ps 0.9 lc rgb '#56b4e9' notitle, \
     $d0_13 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_14 using 1:2 with linespoints lw 1.6 pt 10 ps 0.9 lc rgb '#8a8a8a' notitle, \
     $d0_15 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle
set output
