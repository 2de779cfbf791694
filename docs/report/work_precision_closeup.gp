# gnuplot work_precision_closeup.gp
$line0 << end
1.07519 1.21419
1.13693 0.750256
1.13993 0.422038
1.40195 0.325597
1.98542 0.0998581
3.14275 0.0384794
17.2306 0.0138091
end
$line1 << end
1.52742 0.756619
2.10606 0.37363
2.84134 0.184142
5.28704 0.0696761
9.35672 0.0318449
end
$line2 << end
11.2876 1.91979
18.8677 0.563065
36.4992 0.483516
87.7532 0.138657
188.388 0.11893
end
$line3 << end
1.75457 1.35662
4.11398 0.336906
4.19119 5.42291
4.82211 21.4237
12.3343 0.0840904
38.8976 0.0210578
end
$line4 << end
294.561 0.0124757
end
$line5 << end
285.997 0.666606
end
$line6 << end
396.722 0.148282
406.675 0.0282719
422.694 0.00602633
end
$line7 << end
286.842 235.141
306.235 189.491
391.678 93.2477
611.978 23.1294
end
$line8 << end
30.9981 0.265111
46.0337 0.126281
67.0586 0.0653536
133.102 0.0245933
204.913 0.0124597
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
