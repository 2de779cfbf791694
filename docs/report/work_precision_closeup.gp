# gnuplot work_precision_closeup.gp
$line0 << end
0.829496 1.52244
1.17202 0.87302
1.51919 0.601399
2.30413 0.34015
3.81719 0.115057
4.86467 0.0582072
15.7476 0.0174543
end
$line1 << end
1.53984 0.369113
2.62889 0.720536
3.08903 0.183308
3.64802 0.0706866
6.26207 0.0321072
end
$line2 << end
7.43603 1.35638
14.6282 1.19216
24.4293 0.340099
67.2182 0.0952289
136.218 0.076925
end
$line3 << end
1.09125 0.845324
1.52646 3.38228
2.59632 13.2824
2.93303 0.209729
5.5068 0.0524142
16.187 0.0131461
end
$line4 << end
139.251 0.00563508
end
$line5 << end
175.797 0.610069
end
$line6 << end
212.691 0.165678
215.059 0.00755545
237.431 0.0295408
end
$line7 << end
121.919 145.572
154.51 115.329
194.677 25.6098
222.916 3.51813
end
$line8 << end
23.6401 0.209187
36.2769 0.133581
80.32 0.0590906
96.7122 0.0246768
197.743 0.0124882
end
set logscale xy
set grid xtics ytics lc rgb '#dddddd'
set format y '%g'
set key outside right top noenhanced
set title 'error against time, view closeup' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'error in pixels: outlines, and depth but for a thousandth'
set terminal svg size 900,560 dynamic background rgb 'white'
set output 'work_precision_closeup.svg'
plot $line0 using 1:2 with linespoints lw 2 pt 5 lc 1 title 'afd float', \
     $line1 using 1:2 with linespoints lw 2 pt 6 lc 2 title 'fd float', \
     $line2 using 1:2 with linespoints lw 2 pt 7 lc 3 title 'subdivision', \
     $line3 using 1:2 with linespoints lw 2 pt 8 lc 4 title 'tessellation', \
     $line4 using 1:2 with linespoints lw 2 pt 9 lc 5 title 'micropolygons', \
     $line5 using 1:2 with linespoints lw 2 pt 10 lc 6 title 'isocurves', \
     $line6 using 1:2 with linespoints lw 2 pt 11 lc 7 title 'scanline', \
     $line7 using 1:2 with linespoints lw 2 pt 12 lc 8 title 'voxels', \
     $line8 using 1:2 with linespoints lw 2 pt 13 lc 9 title 'mesa'
set terminal png size 1100,680
set output 'work_precision_closeup.png'
plot $line0 using 1:2 with linespoints lw 2 pt 5 lc 1 title 'afd float', \
     $line1 using 1:2 with linespoints lw 2 pt 6 lc 2 title 'fd float', \
     $line2 using 1:2 with linespoints lw 2 pt 7 lc 3 title 'subdivision', \
     $line3 using 1:2 with linespoints lw 2 pt 8 lc 4 title 'tessellation', \
     $line4 using 1:2 with linespoints lw 2 pt 9 lc 5 title 'micropolygons', \
     $line5 using 1:2 with linespoints lw 2 pt 10 lc 6 title 'isocurves', \
     $line6 using 1:2 with linespoints lw 2 pt 11 lc 7 title 'scanline', \
     $line7 using 1:2 with linespoints lw 2 pt 12 lc 8 title 'voxels', \
     $line8 using 1:2 with linespoints lw 2 pt 13 lc 9 title 'mesa'
