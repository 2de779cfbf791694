# gnuplot picture_time.gp
$d0_0 << end
0.681389 6.22753
0.716712 4.9779
0.776991 3.77795
1.01376 2.82374
1.91295 1.75578
2.99038 1.13013
5.82216 0.586288
end
$d0_1 << end
1.37734 5.85099
1.27478 4.14755
2.77263 2.73836
3.76864 1.96548
5.50768 1.19439
end
$d0_2 << end
11.2146 6.3654
16.1858 4.89939
32.0344 3.62112
78.0673 2.32671
end
$d0_3 << end
1.63724 47.8339
1.69167 22.0388
0.765975 10.2098
1.53471 4.97326
4.67714 2.39684
15.6248 1.2892
52.1821 0.416324
end
$d0_4 << end
3.7023 46.9856
4.77799 20.4961
7.50458 9.68159
22.0094 4.573
39.0838 2.24833
end
$d0_5 << end
1.55223 46.9856
1.60666 20.4961
0.719827 9.68652
1.37803 4.57809
8.42178 2.25067
end
$d0_6 << end
108.235 0.936444
147.391 0.78387
288.735 0.72121
562.943 0.291186
end
$d0_7 << end
42.5242 11.5704
113.041 11.79
185.084 11.9005
325.441 11.9919
end
$d0_8 << end
261.651 3.88763
237.358 1.85333
229.401 1.18099
267.491 0.574463
end
$d0_9 << end
79.8772 6.04365
162.142 2.18819
257.132 2.05833
411.097 0.789476
end
$d0_10 << end
197.893 20.3013
198.89 20.1549
196.129 20.1395
191.457 20.1342
end
$d0_11 << end
12.4977 8.13656
38.0791 4.46675
91.6816 3.04119
191.339 1.87525
end
$d0_12 << end
30.5318 1.17668
77.9781 1.2734
151.5 1.29634
544.944 1.24755
end
$d0_13 << end
185.371 58.6834
218.615 37.4978
326.745 28.8072
525.196 21.3635
end
$d0_14 << end
23.9189 2.68886
33.7081 1.87093
36.9965 1.5508
64.4287 1.12204
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
set xrange [0.487014:2307.01]
set yrange [0.223333:85.0784]
set label 'micropolygons' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5523,0.1048 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7454,0.1590 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'afd' at graph 0.2932,0.1624 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'whitted' at graph 0.7962,0.2125 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'mesa' at graph 0.5772,0.2716 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2866,0.2822 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'kept' at graph 0.8295,0.2895 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'llvmpipe' at graph 0.6347,0.3306 left offset 0.9,0 tc rgb '#1b1b8f' noenhanced front
set label 'Embree' at graph 0.5473,0.3553 left offset 0.9,0 tc rgb '#c51b7d' noenhanced front
set label 'lane-carpenter' at graph 0.7058,0.3654 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'zsort' at graph 0.5181,0.3902 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3368,0.3888 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.5999,0.4001 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7686,0.6703 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7059,0.7575 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.8251,0.7675 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
set xrange [0.487014:2307.01]
set yrange [0.223333:85.0784]
set label 'micropolygons' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5523,0.1048 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7454,0.1590 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'afd' at graph 0.2932,0.1624 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'whitted' at graph 0.7962,0.2125 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'mesa' at graph 0.5772,0.2716 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2866,0.2822 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'kept' at graph 0.8295,0.2895 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'llvmpipe' at graph 0.6347,0.3382 left offset 0.9,0 tc rgb '#1b1b8f' noenhanced front
set label 'Embree' at graph 0.5473,0.3569 left offset 0.9,0 tc rgb '#c51b7d' noenhanced front
set label 'lane-carpenter' at graph 0.7058,0.3636 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'zsort' at graph 0.5181,0.3886 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3368,0.3888 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.5999,0.3944 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7686,0.6703 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'blinn' at graph 0.7059,0.7575 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
set label 'voxels' at graph 0.8251,0.7675 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
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
