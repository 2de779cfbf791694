# gnuplot work_precision_top.gp
$line0 << end
1.6151 0.617284
1.77931 0.326505
2.01293 1.34803
2.16628 0.158452
3.37504 0.061362
5.27835 0.0265615
25.9948 0.00869496
end
$line1 << end
2.23387 0.584503
3.29456 0.277576
4.23897 0.140128
6.84737 0.054365
12.3312 0.0243117
end
$line2 << end
14.3322 1.03517
28.1817 0.338743
51.416 0.28859
117.151 0.0845193
337.11 0.0643735
end
$line3 << end
3.73318 0.633176
4.2692 3.09648
7.32596 292.912
7.76246 0.163274
22.0894 0.0416272
83.2314 0.0103566
end
$line4 << end
437.933 0.00987873
end
$line5 << end
245.523 0.650576
end
$line6 << end
466.162 0.0362423
477.813 0.155623
569.673 0.00688986
end
$line7 << end
305.304 300.459
373.277 288.533
475.762 283.488
683.058 254.327
end
$line8 << end
74.5303 0.164349
94.3251 0.0874581
139.138 0.0479253
219.956 0.0190697
349.802 0.0107562
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
plot $line0 using 1:2 with linespoints lw 3 pt 4 lc rgb '#000000' title 'afd float', \
     $line1 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#d62728' title 'fd float', \
     $line2 using 1:2 with linespoints lw 1.5 pt 6 lc rgb '#1f77b4' title 'subdivision', \
     $line3 using 1:2 with linespoints lw 1.5 pt 7 lc rgb '#2ca02c' title 'tessellation', \
     $line4 using 1:2 with linespoints lw 1.5 pt 8 lc rgb '#ff7f0e' title 'micropolygons', \
     $line5 using 1:2 with linespoints lw 1.5 pt 9 lc rgb '#9467bd' title 'isocurves', \
     $line6 using 1:2 with linespoints lw 1.5 pt 10 lc rgb '#8c564b' title 'scanline', \
     $line7 using 1:2 with linespoints lw 1.5 pt 11 lc rgb '#17becf' title 'voxels', \
     $line8 using 1:2 with linespoints lw 1.5 pt 12 lc rgb '#e377c2' title 'mesa'
set terminal png size 1100,680
set output 'work_precision_top.png'
plot $line0 using 1:2 with linespoints lw 3 pt 4 lc rgb '#000000' title 'afd float', \
     $line1 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#d62728' title 'fd float', \
     $line2 using 1:2 with linespoints lw 1.5 pt 6 lc rgb '#1f77b4' title 'subdivision', \
     $line3 using 1:2 with linespoints lw 1.5 pt 7 lc rgb '#2ca02c' title 'tessellation', \
     $line4 using 1:2 with linespoints lw 1.5 pt 8 lc rgb '#ff7f0e' title 'micropolygons', \
     $line5 using 1:2 with linespoints lw 1.5 pt 9 lc rgb '#9467bd' title 'isocurves', \
     $line6 using 1:2 with linespoints lw 1.5 pt 10 lc rgb '#8c564b' title 'scanline', \
     $line7 using 1:2 with linespoints lw 1.5 pt 11 lc rgb '#17becf' title 'voxels', \
     $line8 using 1:2 with linespoints lw 1.5 pt 12 lc rgb '#e377c2' title 'mesa'
