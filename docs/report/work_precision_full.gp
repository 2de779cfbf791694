# gnuplot work_precision_full.gp
$line0 << end
0.709601 0.877782
0.733731 1.446
0.80983 0.637822
1.03217 0.264742
1.58699 0.108222
2.46241 0.0472502
10.8943 0.0130941
end
$line1 << end
1.13628 0.803006
1.47278 0.392978
2.07798 0.194864
3.94922 0.0751898
6.67951 0.0343905
end
$line2 << end
0.730241 0.877782
0.747661 1.446
0.817581 0.637822
1.03964 0.321219
1.59057 0.11765
2.40801 0.0482047
8.75758 0.016223
end
$line3 << end
0.70996 0.877782
0.736391 1.446
0.81615 0.637822
1.0436 0.254042
1.59525 0.108552
2.51503 0.0482047
10.5601 0.016223
end
$line4 << end
1.14961 0.803006
1.50327 0.392978
2.10386 0.194797
3.87741 0.0751898
6.71132 0.0343327
end
$line5 << end
1.16597 0.803487
1.48765 1.09249
2.10296 3.76515
3.85649 12.3966
6.79417 25.2421
end
$line6 << end
1.14473 0.802898
1.48581 0.39318
2.10033 0.194022
3.79287 0.108543
6.58781 0.324382
end
$line7 << end
1.21726 0.803006
1.57097 0.392978
2.32168 0.194797
4.50907 0.0751898
6.78782 0.0343403
end
$line8 << end
1.10063 2.79541
1.37129 0.689567
2.49072 37.3502
2.64643 1.05394
6.62054 6.35375
17.8535 39.8757
54.3683 148.715
end
$line9 << end
8.54642 1.19003
15.5608 0.67459
30.7709 0.326583
71.6349 0.137176
146.062 0.080476
end
$line10 << end
1.02255 2.79597
1.63702 0.689664
2.04424 11.3714
4.24753 0.171902
14.221 0.0430182
43.7708 0.0108321
end
$line11 << end
152.399 0.0136459
end
$line12 << end
139.643 0.638099
end
$line13 << end
215.625 0.140625
222.514 0.00626309
225.666 0.0318314
end
$line14 << end
206.004 164.635
253.796 131.888
366.104 97.8337
631.604 28.902
end
$line15 << end
19.9623 0.220927
30.7487 0.106364
45.1697 0.0527916
78.1824 0.0218244
133.773 0.00973802
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
plot $line0 using 1:2 with linespoints lw 3 pt 4 lc rgb '#000000' title 'afd float', \
     $line1 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#d62728' title 'fd float', \
     $line2 using 1:2 with linespoints lw 3 pt 6 lc rgb '#1f77b4' title 'afd double', \
     $line3 using 1:2 with linespoints lw 3 pt 7 lc rgb '#2ca02c' title 'afd 32.32', \
     $line4 using 1:2 with linespoints lw 1.5 pt 8 lc rgb '#ff7f0e' title 'fd double', \
     $line5 using 1:2 with linespoints lw 1.5 pt 9 lc rgb '#9467bd' title 'fd 16.16', \
     $line6 using 1:2 with linespoints lw 1.5 pt 10 lc rgb '#8c564b' title 'fd 32-bit block', \
     $line7 using 1:2 with linespoints lw 1.5 pt 11 lc rgb '#17becf' title 'fd 32.32', \
     $line8 using 1:2 with linespoints lw 1.5 pt 12 lc rgb '#e377c2' title 'fd 16.16, n steps', \
     $line9 using 1:2 with linespoints lw 1.5 pt 13 lc rgb '#7f7f7f' title 'subdivision', \
     $line10 using 1:2 with linespoints lw 1.5 pt 4 lc rgb '#bcbd22' title 'tessellation', \
     $line11 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#00429d' title 'micropolygons', \
     $line12 using 1:2 with linespoints lw 1.5 pt 6 lc rgb '#93003a' title 'isocurves', \
     $line13 using 1:2 with linespoints lw 1.5 pt 7 lc rgb '#5a7d00' title 'scanline', \
     $line14 using 1:2 with linespoints lw 1.5 pt 8 lc rgb '#000000' title 'voxels', \
     $line15 using 1:2 with linespoints lw 1.5 pt 9 lc rgb '#d62728' title 'mesa'
set terminal png size 1100,680
set output 'work_precision_full.png'
plot $line0 using 1:2 with linespoints lw 3 pt 4 lc rgb '#000000' title 'afd float', \
     $line1 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#d62728' title 'fd float', \
     $line2 using 1:2 with linespoints lw 3 pt 6 lc rgb '#1f77b4' title 'afd double', \
     $line3 using 1:2 with linespoints lw 3 pt 7 lc rgb '#2ca02c' title 'afd 32.32', \
     $line4 using 1:2 with linespoints lw 1.5 pt 8 lc rgb '#ff7f0e' title 'fd double', \
     $line5 using 1:2 with linespoints lw 1.5 pt 9 lc rgb '#9467bd' title 'fd 16.16', \
     $line6 using 1:2 with linespoints lw 1.5 pt 10 lc rgb '#8c564b' title 'fd 32-bit block', \
     $line7 using 1:2 with linespoints lw 1.5 pt 11 lc rgb '#17becf' title 'fd 32.32', \
     $line8 using 1:2 with linespoints lw 1.5 pt 12 lc rgb '#e377c2' title 'fd 16.16, n steps', \
     $line9 using 1:2 with linespoints lw 1.5 pt 13 lc rgb '#7f7f7f' title 'subdivision', \
     $line10 using 1:2 with linespoints lw 1.5 pt 4 lc rgb '#bcbd22' title 'tessellation', \
     $line11 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#00429d' title 'micropolygons', \
     $line12 using 1:2 with linespoints lw 1.5 pt 6 lc rgb '#93003a' title 'isocurves', \
     $line13 using 1:2 with linespoints lw 1.5 pt 7 lc rgb '#5a7d00' title 'scanline', \
     $line14 using 1:2 with linespoints lw 1.5 pt 8 lc rgb '#000000' title 'voxels', \
     $line15 using 1:2 with linespoints lw 1.5 pt 9 lc rgb '#d62728' title 'mesa'
