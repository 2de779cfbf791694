# gnuplot error_time.gp
$d0_0 << end
0.641611 1.27649
0.658946 0.252355
0.711393 0.230083
0.873404 0.0760727
1.5567 0.0249165
2.32279 0.0118688
5.32954 0.00480035
end
$d0_1 << end
0.641611 1.7376
0.658946 0.90215
0.711393 0.490928
0.873404 0.24853
1.5567 0.099275
2.32279 0.0499591
5.32954 0.0199662
end
$d0_2 << end
0.897089 0.460009
1.21854 0.21298
1.79957 0.10942
3.32337 0.0317154
5.52875 0.0126698
end
$d0_3 << end
0.897089 0.995573
1.21854 0.504389
1.79957 0.257821
3.32337 0.106256
5.52875 0.0650654
end
$d0_4 << end
9.2236 0.397744
15.7761 0.217819
35.1997 0.122641
76.9728 0.0487473
end
$d0_5 << end
9.2236 0.999927
15.7761 0.499827
35.1997 0.249995
76.9728 0.0999981
end
$d0_6 << end
1.58965 16
1.6846 11.3714
0.78922 2.09387
1.58199 0.621945
4.47745 0.140438
15.6008 0.0166913
47.9005 0.0050057
end
$d0_7 << end
1.58965 174.371
1.6846 43.5956
0.78922 10.9016
1.58199 2.72814
4.47745 0.684771
15.6008 0.173929
47.9005 0.0462178
end
$d0_8 << end
3.66868 16
4.75556 11.3714
7.62764 2.09387
15.0863 0.621945
35.6575 0.140438
end
$d0_9 << end
1.62381 16
1.6577 11.3714
0.7967 2.09387
1.43117 0.621945
4.33329 0.140438
end
$d0_10 << end
66.7179 0.00543811
138.572 0.0136459
277.505 0.0136459
497.166 0.0136459
end
$d0_11 << end
66.7179 0.0624879
138.572 0.0523786
277.505 0.0523299
497.166 0.0523299
end
$d0_12 << end
40.7287 0.563902
113.851 0.638099
188.771 0.64648
333.872 0.664085
end
$d0_13 << end
235.587 0.140625
240.141 0.0318314
236.914 0.0114089
231.737 0.00626309
end
$d0_14 << end
71.9652 0.947749
148.72 0.947749
243.555 0.00777273
358.892 0.00160861
end
$d0_15 << end
186.079 16
185.128 16
185.284 16
188.519 16
end
$d0_16 << end
10.0223 0.518943
36.183 0.122641
86.5367 0.0418987
170.415 0.0226721
end
$d0_17 << end
21.5389 0.00246026
67.5343 0.00246026
125.602 0.00159003
400.68 0.00159003
end
$d0_18 << end
188.131 18.3987
220.072 8.87488
307.65 4.22956
502.296 2.51603
end
$d0_19 << end
17.6002 0.1836
23.9475 0.0747686
35.1034 0.0161339
65.887 0.0104229
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
set xrange [0.45982:2035.33]
set yrange [0.000890024:392.897]
set label 'kept' at graph 0.8064,0.0277 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7933,0.0625 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2919,0.1297 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5534,0.1329 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7412,0.1501 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5914,0.1893 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2962,0.2043 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8321,0.2100 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.7046,0.2491 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.6099,0.3080 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5182,0.3894 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2672,0.3894 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7847,0.5089 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.6114 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7166,0.7537 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
     $d0_14 using 1:2 with linespoints lw 1.2 pt 8 ps 0.9 lc rgb '#c7a17a' notitle, \
     $d0_15 using 1:2 with linespoints lw 1.2 pt 14 ps 0.9 lc rgb '#a0522d' notitle, \
     $d0_16 using 1:2 with linespoints lw 1.2 pt 9 ps 0.9 lc rgb '#66c2a5' notitle, \
     $d0_17 using 1:2 with linespoints lw 1.2 pt 4 ps 0.9 lc rgb '#f4a6d7' notitle, \
     $d0_18 using 1:2 with linespoints lw 1.6 pt 10 ps 0.9 lc rgb '#8a8a8a' notitle, \
     $d0_19 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle
set output
set terminal pngcairo size 1100,680 font 'sans,12' background rgb 'white'
set output 'error_time.png'
unset label
unset key
set title 'teapot, full: solid, the error measured; dashed, the bound certified' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'largest error of outlines, pixels'
set xrange [0.45982:2035.33]
set yrange [0.000890024:392.897]
set label 'kept' at graph 0.8064,0.0324 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7933,0.0578 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2919,0.1297 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5534,0.1329 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7412,0.1501 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5914,0.1893 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2962,0.2043 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8321,0.2100 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.7046,0.2491 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.6099,0.3080 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5182,0.3894 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2672,0.3894 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7847,0.5089 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8333,0.6114 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7166,0.7537 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
     $d0_14 using 1:2 with linespoints lw 1.2 pt 8 ps 0.9 lc rgb '#c7a17a' notitle, \
     $d0_15 using 1:2 with linespoints lw 1.2 pt 14 ps 0.9 lc rgb '#a0522d' notitle, \
     $d0_16 using 1:2 with linespoints lw 1.2 pt 9 ps 0.9 lc rgb '#66c2a5' notitle, \
     $d0_17 using 1:2 with linespoints lw 1.2 pt 4 ps 0.9 lc rgb '#f4a6d7' notitle, \
     $d0_18 using 1:2 with linespoints lw 1.6 pt 10 ps 0.9 lc rgb '#8a8a8a' notitle, \
     $d0_19 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle
set output
