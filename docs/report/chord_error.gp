# gnuplot chord_error.gp
$line0 << end
1 537.958
2 206.065
4 67.2702
8 19.3046
16 5.13704
32 1.32312
64 0.335638
128 0.0845167
256 0.0212051
end
$line1 << end
1 1394.67
2 348.667
4 87.1668
8 21.7917
16 5.44793
32 1.36198
64 0.340495
128 0.0851239
256 0.021281
end
set logscale xy
set grid xtics ytics lc rgb '#dddddd'
set format y '%g'
set key outside right top noenhanced
set title 'chords of random cubics over 1024 px; dashed: h^2/8 max f' noenhanced
set xlabel 'steps'
set ylabel 'largest error in pixels'
set terminal svg size 900,560 dynamic background rgb 'white'
set output 'chord_error.svg'
plot $line0 using 1:2 with linespoints lw 1.5 pt 4 lc rgb '#000000' title 'measured', \
     $line1 using 1:2 with lines dt 2 lw 1 lc rgb '#000000' notitle
set terminal png size 1100,680
set output 'chord_error.png'
plot $line0 using 1:2 with linespoints lw 1.5 pt 4 lc rgb '#000000' title 'measured', \
     $line1 using 1:2 with lines dt 2 lw 1 lc rgb '#000000' notitle
