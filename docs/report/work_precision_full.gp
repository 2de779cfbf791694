# gnuplot work_precision_full.gp
$line0 << end
0.646503 0.740614
0.670354 1.69349
0.70656 1.35463
0.984778 0.323745
2.0696 0.124784
3.28675 0.0545971
7.61022 0.0184527
end
$line1 << end
1.38707 0.788241
2.00373 0.192891
2.04064 0.398986
4.29247 0.074112
6.02565 0.0346593
end
$line2 << end
0.651973 1.69349
1.01053 0.323745
1.08403 1.35463
1.38931 0.740614
1.61113 0.1253
3.27818 0.0635311
9.24799 0.0197379
end
$line3 << end
0.718024 0.740614
1.04536 1.69349
1.2821 1.35463
1.77883 0.124784
2.26794 0.323745
2.45092 0.0545964
8.69825 0.0197379
end
$line4 << end
0.870882 0.788241
2.0579 0.398986
2.76757 0.192838
5.03632 0.074075
7.08921 0.0346601
end
$line5 << end
1.116 0.786574
1.85226 0.471861
1.8969 0.398472
3.89011 1.7293
7.27169 5.68723
end
$line6 << end
1.04541 0.788241
1.55647 0.399116
1.81451 0.192693
4.51303 0.0743347
5.24796 0.101126
end
$line7 << end
1.5618 0.788241
1.8338 0.192838
2.05752 0.398986
4.19464 0.074075
7.22307 0.0346444
end
$line8 << end
0.951586 1.74223
1.89243 0.42955
2.34444 23.1896
3.59323 0.377462
8.6256 3.86599
21.8925 22.324
84.7454 93.0587
end
$line9 << end
8.91318 1.35473
11.5134 0.693217
21.4276 0.341003
62.4634 0.164832
127.531 0.0759664
end
$line10 << end
0.795607 1.74228
0.925506 6.67864
1.0102 0.42955
2.20365 0.107122
6.91228 0.0267959
17.8405 0.00681561
end
$line11 << end
70.3828 0.00586905
end
$line12 << end
56.0192 0.687225
end
$line13 << end
129.05 0.152846
137.249 0.0303993
147.923 0.00649969
end
$line14 << end
90.4891 96.3236
122.178 76.522
136.936 45.1567
251.258 1.66006
end
$line15 << end
15.3686 0.188756
28.2375 0.104846
32.2297 0.0546538
79.5268 0.0216144
146.648 0.00991206
end
set logscale xy
set grid xtics ytics lc rgb '#dddddd'
set format y '%g'
set key outside right top noenhanced
set title 'error against time, view full' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'error in pixels: outlines, and depth but for a thousandth'
set terminal svg size 900,560 dynamic background rgb 'white'
set output 'work_precision_full.svg'
plot $line0 using 1:2 with linespoints lw 2 pt 5 lc 1 title 'afd float', \
     $line1 using 1:2 with linespoints lw 2 pt 6 lc 2 title 'fd float', \
     $line2 using 1:2 with linespoints lw 2 pt 7 lc 3 title 'afd double', \
     $line3 using 1:2 with linespoints lw 2 pt 8 lc 4 title 'afd 32.32', \
     $line4 using 1:2 with linespoints lw 2 pt 9 lc 5 title 'fd double', \
     $line5 using 1:2 with linespoints lw 2 pt 10 lc 6 title 'fd 16.16', \
     $line6 using 1:2 with linespoints lw 2 pt 11 lc 7 title 'fd 32-bit block', \
     $line7 using 1:2 with linespoints lw 2 pt 12 lc 8 title 'fd 32.32', \
     $line8 using 1:2 with linespoints lw 2 pt 13 lc 9 title 'fd 16.16, n steps', \
     $line9 using 1:2 with linespoints lw 2 pt 4 lc 10 title 'subdivision', \
     $line10 using 1:2 with linespoints lw 2 pt 5 lc 11 title 'tessellation', \
     $line11 using 1:2 with linespoints lw 2 pt 6 lc 12 title 'micropolygons', \
     $line12 using 1:2 with linespoints lw 2 pt 7 lc 13 title 'isocurves', \
     $line13 using 1:2 with linespoints lw 2 pt 8 lc 14 title 'scanline', \
     $line14 using 1:2 with linespoints lw 2 pt 9 lc 15 title 'voxels', \
     $line15 using 1:2 with linespoints lw 2 pt 10 lc 16 title 'mesa'
set terminal png size 1100,680
set output 'work_precision_full.png'
plot $line0 using 1:2 with linespoints lw 2 pt 5 lc 1 title 'afd float', \
     $line1 using 1:2 with linespoints lw 2 pt 6 lc 2 title 'fd float', \
     $line2 using 1:2 with linespoints lw 2 pt 7 lc 3 title 'afd double', \
     $line3 using 1:2 with linespoints lw 2 pt 8 lc 4 title 'afd 32.32', \
     $line4 using 1:2 with linespoints lw 2 pt 9 lc 5 title 'fd double', \
     $line5 using 1:2 with linespoints lw 2 pt 10 lc 6 title 'fd 16.16', \
     $line6 using 1:2 with linespoints lw 2 pt 11 lc 7 title 'fd 32-bit block', \
     $line7 using 1:2 with linespoints lw 2 pt 12 lc 8 title 'fd 32.32', \
     $line8 using 1:2 with linespoints lw 2 pt 13 lc 9 title 'fd 16.16, n steps', \
     $line9 using 1:2 with linespoints lw 2 pt 4 lc 10 title 'subdivision', \
     $line10 using 1:2 with linespoints lw 2 pt 5 lc 11 title 'tessellation', \
     $line11 using 1:2 with linespoints lw 2 pt 6 lc 12 title 'micropolygons', \
     $line12 using 1:2 with linespoints lw 2 pt 7 lc 13 title 'isocurves', \
     $line13 using 1:2 with linespoints lw 2 pt 8 lc 14 title 'scanline', \
     $line14 using 1:2 with linespoints lw 2 pt 9 lc 15 title 'voxels', \
     $line15 using 1:2 with linespoints lw 2 pt 10 lc 16 title 'mesa'
