# gnuplot work_precision_full.gp
$line0 << end
0.892442 0.877782
0.917547 1.446
1.0966 0.637822
1.17918 0.264751
1.72956 0.108222
2.78889 0.0472502
12.4528 0.0130941
end
$line1 << end
1.37441 0.803006
1.68557 0.392978
2.30756 0.194864
4.22602 0.0751898
7.07857 0.0343905
end
$line2 << end
0.900535 0.877782
0.951581 1.446
1.01481 0.637822
1.18002 0.321219
1.66883 0.11765
3.82996 0.0482047
10.1405 0.016223
end
$line3 << end
0.940705 0.877782
0.965525 1.446
1.02895 0.637822
1.21355 0.254042
1.65209 0.108552
2.66141 0.0482047
11.5495 0.016223
end
$line4 << end
1.32418 0.803006
1.66296 0.392978
2.26104 0.194797
4.28508 0.0751898
7.09192 0.0343327
end
$line5 << end
1.3294 0.803487
2.07758 1.09249
3.15218 3.76515
5.15477 12.3966
9.78562 25.2421
end
$line6 << end
1.57745 0.802898
1.62577 0.39318
2.24726 0.194022
4.12622 0.108543
6.96027 0.324382
end
$line7 << end
1.8299 0.803006
2.28692 0.392978
3.38534 0.194797
6.0275 0.0751898
9.09072 0.0343403
end
$line8 << end
1.31519 2.79541
1.45179 0.689567
2.70107 1.05394
3.09088 37.3502
6.8354 6.35375
24.936 39.8757
71.8283 148.715
end
$line9 << end
9.68577 1.19003
16.7011 0.67459
33.1483 0.326583
81.3915 0.137176
170.131 0.080476
end
$line10 << end
1.6891 2.79597
2.17817 0.689664
2.67809 11.3714
7.76438 0.171902
23.3464 0.0430182
47.162 0.0108321
end
$line11 << end
164.031 0.0136459
end
$line12 << end
135.086 0.638099
end
$line13 << end
234.736 0.140625
239.535 0.0318314
243.365 0.00626309
end
$line14 << end
197.412 164.635
237.183 131.888
316.837 97.8337
491.431 28.902
end
$line15 << end
24.2897 0.220927
34.8226 0.106364
49.1945 0.0527916
93.8618 0.0218244
162.798 0.00973802
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
