# gnuplot error_time.gp
$d0_0 << end
0.681389 1.27649
0.716712 0.252355
0.776991 0.230083
1.01376 0.0760727
1.91295 0.0249165
2.99038 0.0118688
5.82216 0.00480035
end
$d0_1 << end
0.681389 1.7376
0.716712 0.90215
0.776991 0.490928
1.01376 0.24853
1.91295 0.099275
2.99038 0.0499591
5.82216 0.0199662
end
$d0_2 << end
1.37734 0.460009
1.27478 0.21298
2.77263 0.10942
3.76864 0.0317154
5.50768 0.0126698
end
$d0_3 << end
1.37734 0.995573
1.27478 0.504389
2.77263 0.257821
3.76864 0.106256
5.50768 0.0650654
end
$d0_4 << end
11.2146 0.397744
16.1858 0.217819
32.0344 0.122641
78.0673 0.0487473
end
$d0_5 << end
11.2146 0.999927
16.1858 0.499827
32.0344 0.249995
78.0673 0.0999981
end
$d0_6 << end
1.63724 16
1.69167 11.3714
0.765975 2.09387
1.53471 0.621945
4.67714 0.140438
15.6248 0.0166913
52.1821 0.0050057
end
$d0_7 << end
1.63724 174.371
1.69167 43.5956
0.765975 10.9016
1.53471 2.72814
4.67714 0.684771
15.6248 0.173929
52.1821 0.0462178
end
$d0_8 << end
3.7023 16
4.77799 11.3714
7.50458 2.09387
22.0094 0.621945
39.0838 0.140438
end
$d0_9 << end
1.55223 16
1.60666 11.3714
0.719827 2.09387
1.37803 0.621945
8.42178 0.140438
end
$d0_10 << end
108.235 0.00543811
147.391 0.0136459
288.735 0.0136459
562.943 0.0136459
end
$d0_11 << end
108.235 0.0624879
147.391 0.0523786
288.735 0.0523299
562.943 0.0523299
end
$d0_12 << end
42.5242 0.563902
113.041 0.638099
185.084 0.64648
325.441 0.664085
end
$d0_13 << end
261.651 0.140625
237.358 0.0318314
229.401 0.0114089
267.491 0.00626309
end
$d0_14 << end
79.8772 0.947749
162.142 0.947749
257.132 0.00777273
411.097 0.00160861
end
$d0_15 << end
197.893 16
198.89 16
196.129 16
191.457 16
end
$d0_16 << end
12.4977 0.518943
38.0791 0.122641
91.6816 0.0418987
191.339 0.0226721
end
$d0_17 << end
30.5318 0.00246026
77.9781 0.00246026
151.5 0.00159003
544.944 0.00159003
end
$d0_18 << end
185.371 18.3987
218.615 8.87488
326.745 4.22956
525.196 2.51603
end
$d0_19 << end
23.9189 0.1836
33.7081 0.0747686
36.9965 0.0161339
64.4287 0.0104229
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
set xrange [0.487014:2307.01]
set yrange [0.000890024:392.897]
set label 'kept' at graph 0.8295,0.0277 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7962,0.0625 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2932,0.1297 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5523,0.1329 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7454,0.1501 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5772,0.1893 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2866,0.2043 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2100 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.7058,0.2491 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5999,0.3080 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5181,0.3894 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3368,0.3894 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7686,0.5089 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8251,0.6114 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7059,0.7537 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
set xrange [0.487014:2307.01]
set yrange [0.000890024:392.897]
set label 'kept' at graph 0.8295,0.0324 left offset 0.9,0 tc rgb '#f4a6d7' noenhanced front
set label 'whitted' at graph 0.7962,0.0578 left offset 0.9,0 tc rgb '#c7a17a' noenhanced front
set label 'afd' at graph 0.2932,0.1297 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'tessellation' at graph 0.5523,0.1329 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7454,0.1501 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'mesa' at graph 0.5772,0.1893 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2866,0.2043 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'micropolygons' at graph 0.8333,0.2100 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'lane-carpenter' at graph 0.7058,0.2491 left offset 0.9,0 tc rgb '#66c2a5' noenhanced front
set label 'subdivision' at graph 0.5999,0.3080 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'zsort' at graph 0.5181,0.3894 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.3368,0.3894 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'isocurves' at graph 0.7686,0.5089 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8251,0.6114 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
set label 'blinn' at graph 0.7059,0.7537 left offset 0.9,0 tc rgb '#a0522d' noenhanced front
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
