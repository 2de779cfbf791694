# gnuplot work_precision_top.gp
$line0 << end
1.31268 0.617284
1.47924 0.326505
1.57756 1.34803
1.81548 0.158452
2.80024 0.061362
4.60665 0.0265615
22.543 0.00869496
end
$line1 << end
1.8673 0.584503
2.41495 0.277576
3.53765 0.140128
6.46558 0.054365
11.6201 0.0243117
end
$line2 << end
13.0826 1.03517
25.4118 0.338743
46.2693 0.28859
119.092 0.0845193
240.521 0.0643735
end
$line3 << end
2.31231 3.09648
2.6374 0.633176
4.18234 292.912
6.62596 0.163274
19.7597 0.0416272
64.8741 0.0103566
end
$line4 << end
282.25 0.00987873
end
$line5 << end
231.832 0.650576
end
$line6 << end
413.638 0.0362423
427.066 0.155623
439.365 0.00688986
end
$line7 << end
242.368 300.459
284.39 288.533
391.077 283.488
602.279 254.327
end
$line8 << end
36.3315 0.164349
49.7507 0.0874581
65.3624 0.0479253
120.443 0.0190697
201.521 0.0107562
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
