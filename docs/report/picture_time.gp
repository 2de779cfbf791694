# gnuplot picture_time.gp
$d0_0 << end
0.641611 6.22753
0.658946 4.9779
0.711393 3.77795
0.873404 2.82374
1.5567 1.75578
2.32279 1.13013
5.32954 0.586288
end
$d0_1 << end
0.897089 5.85099
1.21854 4.14755
1.79957 2.73836
3.32337 1.96548
5.52875 1.19439
end
$d0_2 << end
9.2236 6.3654
15.7761 4.89939
35.1997 3.62112
76.9728 2.32671
end
$d0_3 << end
1.58965 47.8339
1.6846 22.0388
0.78922 10.2098
1.58199 4.97326
4.47745 2.39684
15.6008 1.2892
47.9005 0.416324
end
$d0_4 << end
3.66868 46.9856
4.75556 20.4961
7.62764 9.68159
15.0863 4.573
35.6575 2.24833
end
$d0_5 << end
1.62381 46.9856
1.6577 20.4961
0.7967 9.68652
1.43117 4.57809
4.33329 2.25067
end
$d0_6 << end
66.7179 0.936444
138.572 0.78387
277.505 0.72121
497.166 0.291186
end
$d0_7 << end
40.7287 11.5704
113.851 11.79
188.771 11.9005
333.872 11.9919
end
$d0_8 << end
235.587 3.88763
240.141 1.85333
236.914 1.18099
231.737 0.574463
end
$d0_9 << end
71.9652 6.04365
148.72 2.18819
243.555 2.05833
358.892 0.789476
end
$d0_10 << end
186.079 20.3013
185.128 20.1549
185.284 20.1395
188.519 20.1342
end
$d0_11 << end
10.0223 8.13656
36.183 4.46675
86.5367 3.04119
170.415 1.87525
end
$d0_12 << end
21.5389 1.17668
67.5343 1.2734
125.602 1.29634
400.68 1.24755
end
$d0_13 << end
188.131 58.6834
220.072 37.4978
307.65 28.8072
502.296 21.3635
end
$d0_14 << end
17.6002 2.68886
23.9475 1.87093
35.1034 1.5508
65.887 1.12204
end
$d0_15 << end
20.044 4.90763
35.4558 3.65087
41.4018 2.84809
104.85 1.72169
end
$d0_16 << end
28.1196 4.92287
37.644 3.65517
35.5124 2.84502
50.0301 1.86239
end
set logscale xy
set grid xtics ytics lt 1 lw 1 lc rgb '#dddddd'
set format xy '%g'
set border 3
set tics nomirror
set terminal svg size 900,560 font 'sans,13' dynamic background rgb 'white'
set output 'picture_time.svg'
unset label
unset key
set title 'teapot, full: how wrong a picture is' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'root of the mean square error, grey levels of 255'
set xrange [0.45982:2035.33]
set yrange [0.223333:85.0784]
set label 'micropolygons' at graph 0.8321,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5534,0.1048 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7412,0.1590 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'afd' at graph 0.2919,0.1624 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'whitted' at graph 0.7933,0.2125 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'mesa' at graph 0.5914,0.2716 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2962,0.2822 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'kept' at graph 0.8064,0.2895 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'llvmpipe' at graph 0.6467,0.3306 left offset 0.9,0 tc rgb '#1b1b8f' noenhanced front
set label 'Embree' at graph 0.5586,0.3553 left offset 0.9,0 tc rgb '#c51b7d' noenhanced front
set label 'lane-carpenter' at graph 0.7046,0.3654 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'zsort' at graph 0.5182,0.3902 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2672,0.3888 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.6099,0.4001 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7847,0.6703 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7166,0.7575 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.8333,0.7675 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 1.2 pt 12 ps 0.9 lc rgb '#8a8500' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.6 pt 6 ps 0.9 lc rgb '#56b4e9' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_9 using 1:2 with linespoints lw 1.2 pt 8 ps 0.9 lc rgb '#c7a17a' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.2 pt 14 ps 0.9 lc rgb '#a0522d' notitle, \
     $d0_11 using 1:2 with linespoints lw 1.2 pt 9 ps 0.9 lc rgb '#66c2a5' notitle, \
     $d0_12 using 1:2 with linespoints lw 1.2 pt 4 ps 0.9 lc rgb '#f4a6d7' notitle, \
     $d0_13 using 1:2 with linespoints lw 1.6 pt 10 ps 0.9 lc rgb '#8a8a8a' notitle, \
     $d0_14 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle, \
     $d0_15 using 1:2 with linespoints lw 1.6 pt 2 ps 0.9 lc rgb '#1b1b8f' notitle, \
     $d0_16 using 1:2 with linespoints lw 1.6 pt 3 ps 0.9 lc rgb '#c51b7d' notitle
set output
set terminal pngcairo size 1100,680 font 'sans,12' background rgb 'white'
set output 'picture_time.png'
unset label
unset key
set title 'teapot, full: how wrong a picture is' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'root of the mean square error, grey levels of 255'
set xrange [0.45982:2035.33]
set yrange [0.223333:85.0784]
set label 'micropolygons' at graph 0.8321,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5534,0.1048 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7412,0.1590 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'afd' at graph 0.2919,0.1624 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'whitted' at graph 0.7933,0.2125 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'mesa' at graph 0.5914,0.2716 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2962,0.2822 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'kept' at graph 0.8064,0.2895 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'llvmpipe' at graph 0.6467,0.3382 left offset 0.9,0 tc rgb '#1b1b8f' noenhanced front
set label 'Embree' at graph 0.5586,0.3569 left offset 0.9,0 tc rgb '#c51b7d' noenhanced front
set label 'lane-carpenter' at graph 0.7046,0.3636 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'zsort' at graph 0.5182,0.3886 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2672,0.3888 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.6099,0.3944 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7847,0.6703 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7166,0.7575 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.8333,0.7675 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 1.2 pt 12 ps 0.9 lc rgb '#8a8500' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.6 pt 6 ps 0.9 lc rgb '#56b4e9' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_9 using 1:2 with linespoints lw 1.2 pt 8 ps 0.9 lc rgb '#c7a17a' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.2 pt 14 ps 0.9 lc rgb '#a0522d' notitle, \
     $d0_11 using 1:2 with linespoints lw 1.2 pt 9 ps 0.9 lc rgb '#66c2a5' notitle, \
     $d0_12 using 1:2 with linespoints lw 1.2 pt 4 ps 0.9 lc rgb '#f4a6d7' notitle, \
     $d0_13 using 1:2 with linespoints lw 1.6 pt 10 ps 0.9 lc rgb '#8a8a8a' notitle, \
     $d0_14 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle, \
     $d0_15 using 1:2 with linespoints lw 1.6 pt 2 ps 0.9 lc rgb '#1b1b8f' notitle, \
     $d0_16 using 1:2 with linespoints lw 1.6 pt 3 ps 0.9 lc rgb '#c51b7d' notitle
set output
