# gnuplot work_precision_closeup.gp
$line0 << end
1.24367 1.21419
1.25829 0.750256
1.365 0.422038
1.63461 0.325597
2.26504 0.0998977
3.59653 0.0384794
19.5664 0.0138091
end
$line1 << end
1.89187 0.756619
2.35707 0.37363
3.60486 0.184142
6.26991 0.0696761
10.4036 0.0318449
end
$line2 << end
11.9587 1.91979
19.911 0.563065
35.1562 0.483516
93.3579 0.138657
207.926 0.11893
end
$line3 << end
2.25999 1.35662
4.90003 5.42291
5.38554 21.4237
5.50757 0.336906
15.6957 0.0840904
71.2103 0.0210578
end
$line4 << end
464.302 0.0124757
end
$line5 << end
472.228 0.666606
end
$line6 << end
548.815 0.0282719
556.676 0.00602633
558.639 0.148282
end
$line7 << end
350.234 189.491
358.448 235.141
427.738 93.2477
585.157 23.1294
end
$line8 << end
39.0276 0.265111
54.3955 0.126281
84.9422 0.0653536
161.166 0.0245933
269.614 0.0124597
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
set output 'work_precision_closeup.png'
plot $line0 using 1:2 with linespoints lw 3 pt 4 lc rgb '#000000' title 'afd float', \
     $line1 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#d62728' title 'fd float', \
     $line2 using 1:2 with linespoints lw 1.5 pt 6 lc rgb '#1f77b4' title 'subdivision', \
     $line3 using 1:2 with linespoints lw 1.5 pt 7 lc rgb '#2ca02c' title 'tessellation', \
     $line4 using 1:2 with linespoints lw 1.5 pt 8 lc rgb '#ff7f0e' title 'micropolygons', \
     $line5 using 1:2 with linespoints lw 1.5 pt 9 lc rgb '#9467bd' title 'isocurves', \
     $line6 using 1:2 with linespoints lw 1.5 pt 10 lc rgb '#8c564b' title 'scanline', \
     $line7 using 1:2 with linespoints lw 1.5 pt 11 lc rgb '#17becf' title 'voxels', \
     $line8 using 1:2 with linespoints lw 1.5 pt 12 lc rgb '#e377c2' title 'mesa'
