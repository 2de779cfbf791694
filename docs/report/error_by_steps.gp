# gnuplot error_by_steps.gp
$d0_0 << end
2 16
4 11.3714
8 2.09387
16 0.621945
32 0.140438
64 0.0166913
128 0.0050057
end
$d0_1 << end
2 39.8045
4 9.95112
8 2.48778
16 0.621945
32 0.155486
64 0.0388716
128 0.00971789
end
$d0_2 << end
4 6.79993
8 2.04793
16 0.396676
32 0.140438
64 2.05403
128 23.3429
256 11.3598
end
$d0_3 << end
4 8.98803
8 2.24701
16 0.561752
32 0.140438
64 0.0351095
128 0.00877738
256 0.00219434
end
set logscale xy
set grid xtics ytics lt 1 lw 1 lc rgb '#dddddd'
set format xy '%g'
set border 3
set tics nomirror
set terminal svg size 900,560 font 'sans,13' dynamic background rgb 'white'
set output 'error_by_steps.svg'
unset label
unset key
set title 'n x n quads a patch: exact corners, and corners walked in 16.16; dashed, slope -2' noenhanced
set xlabel 'n, quads along a patch'
set ylabel 'largest error of outlines, pixels'
set xrange [1.56917:709.176]
set yrange [0.00134392:79.0744]
set label 'tessellation' at graph 0.7200,0.1197 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label '16.16' at graph 0.8333,0.8233 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_1 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e69f00' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_3 using 1:2 with lines dt 2 lw 1.4 lc rgb '#d55e00' notitle
set output
set terminal pngcairo size 1100,680 font 'sans,12' background rgb 'white'
set output 'error_by_steps.png'
unset label
unset key
set title 'n x n quads a patch: exact corners, and corners walked in 16.16; dashed, slope -2' noenhanced
set xlabel 'n, quads along a patch'
set ylabel 'largest error of outlines, pixels'
set xrange [1.56917:709.176]
set yrange [0.00134392:79.0744]
set label 'tessellation' at graph 0.7200,0.1197 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
set label '16.16' at graph 0.8333,0.8233 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_1 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e69f00' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_3 using 1:2 with lines dt 2 lw 1.4 lc rgb '#d55e00' notitle
set output
