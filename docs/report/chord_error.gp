# gnuplot chord_error.gp
$d0_0 << end
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
$d0_1 << end
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
set grid xtics ytics lt 1 lw 1 lc rgb '#dddddd'
set format xy '%g'
set border 3
set tics nomirror
set terminal svg size 900,560 font 'sans,13' dynamic background rgb 'white'
set output 'chord_error.svg'
unset label
unset key
set title 'chords of cubics over 1024 pixels: solid, measured; dashed, by the second derivative' noenhanced
set xlabel 'steps'
set ylabel 'largest error, pixels'
set xrange [0.757858:820.296]
set yrange [0.012177:3032.03]
set label 'chord' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#000000' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 2 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with lines dt 2 lw 1.4 lc rgb '#000000' notitle
set output
set terminal pngcairo size 1100,680 font 'sans,12' background rgb 'white'
set output 'chord_error.png'
unset label
unset key
set title 'chords of cubics over 1024 pixels: solid, measured; dashed, by the second derivative' noenhanced
set xlabel 'steps'
set ylabel 'largest error, pixels'
set xrange [0.757858:820.296]
set yrange [0.012177:3032.03]
set label 'chord' at graph 0.8333,0.0446 left offset 0.9,0 tc rgb '#000000' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 2 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_1 using 1:2 with lines dt 2 lw 1.4 lc rgb '#000000' notitle
set output
