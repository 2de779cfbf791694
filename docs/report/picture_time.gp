# gnuplot picture_time.gp
$d0_0 << end
0.88365 6.22753
1.11304 4.9779
1.16831 3.77795
1.2576 2.82374
2.05438 1.75578
3.30137 1.13013
7.15848 0.586288
end
$d0_1 << end
1.78214 5.85099
1.80122 4.14755
3.17685 2.73836
3.91762 1.96548
6.519 1.19439
end
$d0_2 << end
9.7177 6.3654
16.4802 4.89939
32.0026 3.62112
79.3531 2.32671
end
$d0_3 << end
2.05557 47.8339
2.8908 22.0388
1.01536 10.2098
1.98568 4.97326
5.16662 2.39684
19.8505 1.2892
59.7471 0.416324
end
$d0_4 << end
4.34812 46.9856
5.76753 20.4961
8.29715 9.68159
15.5941 4.573
35.8365 2.24833
end
$d0_5 << end
1.73906 46.9856
1.80376 20.4961
0.858893 9.68652
1.55308 4.57809
4.95652 2.25067
end
$d0_6 << end
71.9894 0.936444
155.952 0.78387
294.813 0.72121
534.642 0.291186
end
$d0_7 << end
43.2417 11.5704
112.35 11.79
244.152 11.9005
367.287 11.9919
end
$d0_8 << end
241.45 3.88763
240.136 1.85333
245.891 1.18099
264.03 0.574463
end
$d0_9 << end
191.749 58.6834
236.095 37.4978
324.844 28.8072
526.251 21.3635
end
$d0_10 << end
21.6105 2.68886
31.0636 1.87093
55.436 1.5508
92.7131 1.12204
end
$d0_11 << end
20.044 4.90763
35.4558 3.65087
41.4018 2.84809
104.85 1.72169
end
$d0_12 << end
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
set xrange [0.622634:2064.57]
set yrange [0.223333:85.0784]
set label 'micropolygons' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5630,0.1048 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7463,0.1590 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'afd' at graph 0.3013,0.1624 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'mesa' at graph 0.6172,0.2716 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2897,0.2822 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'llvmpipe' at graph 0.6324,0.3252 left offset 0.9,0 tc rgb '#1b1b8f' noenhanced front
set label 'Embree' at graph 0.5411,0.3556 left offset 0.9,0 tc rgb '#c51b7d' noenhanced front
set label 'zsort' at graph 0.4999,0.3862 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2559,0.3888 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.5980,0.4166 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7870,0.6703 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8314,0.7675 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 1.2 pt 12 ps 0.9 lc rgb '#8a8500' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.6 pt 6 ps 0.9 lc rgb '#56b4e9' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_9 using 1:2 with linespoints lw 1.6 pt 10 ps 0.9 lc rgb '#8a8a8a' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle, \
     $d0_11 using 1:2 with linespoints lw 1.6 pt 2 ps 0.9 lc rgb '#1b1b8f' notitle, \
     $d0_12 using 1:2 with linespoints lw 1.6 pt 3 ps 0.9 lc rgb '#c51b7d' notitle
set output
set terminal pngcairo size 1100,680 font 'sans,12' background rgb 'white'
set output 'picture_time.png'
unset label
unset key
set title 'teapot, full: how wrong a picture is' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'root of the mean square error, grey levels of 255'
set xrange [0.622634:2064.57]
set yrange [0.223333:85.0784]
set label 'micropolygons' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'tessellation' at graph 0.5630,0.1048 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label 'scanline' at graph 0.7463,0.1590 left offset 0.9,0 tc rgb '#7a4a1e' noenhanced front
set label 'afd' at graph 0.3013,0.1624 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label 'mesa' at graph 0.6172,0.2716 left offset 0.9,0 tc rgb '#6a3d9a' noenhanced front
set label 'fd' at graph 0.2897,0.2822 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label 'llvmpipe' at graph 0.6324,0.3332 left offset 0.9,0 tc rgb '#1b1b8f' noenhanced front
set label 'Embree' at graph 0.5411,0.3583 left offset 0.9,0 tc rgb '#c51b7d' noenhanced front
set label 'zsort' at graph 0.4999,0.3835 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label 'zbuffer' at graph 0.2559,0.3888 left offset 0.9,0 tc rgb '#8a8500' noenhanced front
set label 'subdivision' at graph 0.5980,0.4085 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label 'isocurves' at graph 0.7870,0.6703 left offset 0.9,0 tc rgb '#56b4e9' noenhanced front
set label 'voxels' at graph 0.8314,0.7675 left offset 0.9,0 tc rgb '#8a8a8a' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 3 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_3 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_5 using 1:2 with linespoints lw 1.2 pt 12 ps 0.9 lc rgb '#8a8500' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_7 using 1:2 with linespoints lw 1.6 pt 6 ps 0.9 lc rgb '#56b4e9' notitle, \
     $d0_8 using 1:2 with linespoints lw 1.6 pt 8 ps 0.9 lc rgb '#7a4a1e' notitle, \
     $d0_9 using 1:2 with linespoints lw 1.6 pt 10 ps 0.9 lc rgb '#8a8a8a' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.6 pt 15 ps 0.9 lc rgb '#6a3d9a' notitle, \
     $d0_11 using 1:2 with linespoints lw 1.6 pt 2 ps 0.9 lc rgb '#1b1b8f' notitle, \
     $d0_12 using 1:2 with linespoints lw 1.6 pt 3 ps 0.9 lc rgb '#c51b7d' notitle
set output
