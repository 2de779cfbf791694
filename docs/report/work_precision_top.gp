# gnuplot work_precision_top.gp
$line0 << end
1.7896 1.46852
1.86256 0.363904
2.00131 0.682628
2.32991 0.169783
2.84391 0.0750855
3.95946 0.0331011
15.0221 0.00984005
end
$line1 << end
2.36344 0.559202
2.97928 0.279142
3.86303 0.142586
6.39837 0.0612906
7.89375 0.0248696
end
$line2 << end
12.2322 0.799078
16.1594 0.383177
41.7932 0.200605
103.871 0.149247
165.001 0.0500867
end
$line3 << end
1.67047 1.91997
2.05233 179.118
3.03398 0.375676
3.05077 0.0998575
8.8797 0.0250351
24.2942 0.00640111
end
$line4 << end
145.919 0.0104437
end
$line5 << end
97.6557 0.642879
end
$line6 << end
205.443 0.144054
217.802 0.00660891
220.401 0.0320063
end
$line7 << end
131.721 179.659
136.346 187.634
188.588 175.001
287.298 89.2556
end
$line8 << end
35.0336 0.185848
40.6675 0.0803076
49.5966 0.0457017
109.109 0.0180498
150.138 0.0098695
end
set logscale xy
set grid xtics ytics lc rgb '#dddddd'
set format y '%g'
set key outside right top noenhanced
set title 'error against time, view top' noenhanced
set xlabel 'milliseconds a frame, one thread'
set ylabel 'error in pixels: outlines, and depth but for a thousandth'
set terminal svg size 900,560 dynamic background rgb 'white'
set output 'work_precision_top.svg'
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
set output 'work_precision_top.png'
plot $line0 using 1:2 with linespoints lw 2 pt 5 lc 1 title 'afd float', \
     $line1 using 1:2 with linespoints lw 2 pt 6 lc 2 title 'fd float', \
     $line2 using 1:2 with linespoints lw 2 pt 7 lc 3 title 'subdivision', \
     $line3 using 1:2 with linespoints lw 2 pt 8 lc 4 title 'tessellation', \
     $line4 using 1:2 with linespoints lw 2 pt 9 lc 5 title 'micropolygons', \
     $line5 using 1:2 with linespoints lw 2 pt 10 lc 6 title 'isocurves', \
     $line6 using 1:2 with linespoints lw 2 pt 11 lc 7 title 'scanline', \
     $line7 using 1:2 with linespoints lw 2 pt 12 lc 8 title 'voxels', \
     $line8 using 1:2 with linespoints lw 2 pt 13 lc 9 title 'mesa'
