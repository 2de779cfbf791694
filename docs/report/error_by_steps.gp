# gnuplot error_by_steps.gp
$line0 << end
4 6.67864
8 1.74228
16 0.42955
32 0.107122
64 0.0267959
128 0.00681561
end
$line1 << end
4 6.85579
8 1.71395
16 0.428487
32 0.107122
64 0.0267804
128 0.0066951
end
$line2 << end
4 23.1896
8 1.74223
16 0.42955
32 0.377462
64 3.86599
128 22.324
256 93.0587
end
$line3 << end
4 24.1575
8 6.03938
16 1.50985
32 0.377462
64 0.0943654
128 0.0235913
256 0.00589784
end
set logscale xy
set grid xtics ytics lc rgb '#dddddd'
set format y '%g'
set key outside right top noenhanced
set title 'error of n x n quads a patch; dashed: slope -2' noenhanced
set xlabel 'n, quads along a patch'
set ylabel 'error in pixels'
set terminal svg size 900,560 dynamic background rgb 'white'
set output 'error_by_steps.svg'
plot $line0 using 1:2 with linespoints lw 2 pt 5 lc 1 title 'tessellation', \
     $line1 using 1:2 with lines dt 2 lw 1 lc 1 notitle, \
     $line2 using 1:2 with linespoints lw 2 pt 6 lc 2 title 'fd 16.16', \
     $line3 using 1:2 with lines dt 2 lw 1 lc 2 notitle
set terminal png size 1100,680
set output 'error_by_steps.png'
plot $line0 using 1:2 with linespoints lw 2 pt 5 lc 1 title 'tessellation', \
     $line1 using 1:2 with lines dt 2 lw 1 lc 1 notitle, \
     $line2 using 1:2 with linespoints lw 2 pt 6 lc 2 title 'fd 16.16', \
     $line3 using 1:2 with lines dt 2 lw 1 lc 2 notitle
