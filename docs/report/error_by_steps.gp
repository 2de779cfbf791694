# gnuplot error_by_steps.gp
$line0 << end
4 11.3714
8 2.79597
16 0.689664
32 0.171902
64 0.0430182
128 0.0108321
end
$line1 << end
4 11.0018
8 2.75044
16 0.687609
32 0.171902
64 0.0429756
128 0.0107439
end
$line2 << end
4 37.3502
8 2.79541
16 0.689567
32 1.05394
64 6.35375
128 39.8757
256 148.715
end
$line3 << end
4 67.4523
8 16.8631
16 4.21577
32 1.05394
64 0.263485
128 0.0658714
256 0.0164678
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
plot $line0 using 1:2 with linespoints lw 1.5 pt 4 lc rgb '#000000' title 'tessellation', \
     $line1 using 1:2 with lines dt 2 lw 1 lc rgb '#000000' notitle, \
     $line2 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#d62728' title 'fd 16.16', \
     $line3 using 1:2 with lines dt 2 lw 1 lc rgb '#d62728' notitle
set terminal png size 1100,680
set output 'error_by_steps.png'
plot $line0 using 1:2 with linespoints lw 1.5 pt 4 lc rgb '#000000' title 'tessellation', \
     $line1 using 1:2 with lines dt 2 lw 1 lc rgb '#000000' notitle, \
     $line2 using 1:2 with linespoints lw 1.5 pt 5 lc rgb '#d62728' title 'fd 16.16', \
     $line3 using 1:2 with lines dt 2 lw 1 lc rgb '#d62728' notitle
