# gnuplot arithmetic.gp
$d0_0 << end
4 9.86478e-05
8 0.000646997
16 0.00499669
32 0.0407049
64 0.328416
128 2.64066
256 21.1835
512 170.554
1024 1364.25
2048 3435.71
4096 3449
8192 3449.07
end
$d0_1 << end
4 0.000114441
8 0.000709534
16 0.00531769
32 0.0418777
64 0.333748
128 2.66749
256 21.335
512 170.67
1024 1365.34
2048 10922.7
4096 87381.4
8192 699051
end
$d0_2 << end
4 1.13992e-05
8 8.16516e-05
16 0.000631738
32 0.00509961
64 0.0407716
128 0.330961
256 2.64065
512 21.1839
1024 170.555
2048 1364.77
4096 3451.7
8192 3467.7
end
$d0_3 << end
4 1.43051e-05
8 8.86917e-05
16 0.000664711
32 0.00523472
64 0.0417185
128 0.333436
256 2.66687
512 21.3337
1024 170.667
2048 1365.33
4096 10922.7
8192 87381.3
end
$d0_4 << end
4 6.93413e-06
8 2.50264e-05
16 4.39692e-05
32 6.88663e-05
64 0.00010073
128 0.000223384
256 0.00048391
512 0.000832934
1024 0.00133461
2048 0.00261553
4096 0.0051821
8192 0.0103939
end
$d0_5 << end
4 1.28746e-05
8 3.31402e-05
16 6.28829e-05
32 9.01669e-05
64 0.000176769
128 0.00034977
256 0.000695671
512 0.00138742
1024 0.00277089
2048 0.00553782
4096 0.0110717
8192 0.0221394
end
$d0_6 << end
4 1.31956e-09
8 9.58005e-09
16 7.57462e-08
32 5.99279e-07
64 4.96467e-06
128 4.03922e-05
256 0.000324152
512 0.00259877
1024 0.0207295
2048 0.165867
4096 1.33175
8192 10.6446
end
$d0_7 << end
4 1.74623e-09
8 1.08266e-08
16 8.11415e-08
32 6.39004e-07
64 5.09259e-06
128 4.07026e-05
256 0.000325546
512 0.00260422
1024 0.0208334
2048 0.166667
4096 1.33333
8192 10.6667
end
$d0_8 << end
4 0.000130268
8 0.000385242
16 0.000577864
32 0.000974365
64 0.00183466
128 0.00428066
256 0.00921096
512 0.0142287
1024 0.0322386
2048 0.0766904
4096 0.109161
8192 0.231399
end
$d0_9 << end
4 0.00276184
8 0.00349045
16 0.00533962
32 0.0091989
64 0.0169892
128 0.0326034
256 0.063848
512 0.126345
1024 0.251344
2048 0.501343
4096 1.00134
8192 2.00134
end
$d0_10 << end
4 7.95808e-13
8 8.95284e-13
16 9.9476e-13
32 2.16005e-12
64 3.86535e-12
128 8.66862e-12
256 1.48361e-11
512 2.92744e-11
1024 5.81508e-11
2048 1.24828e-10
4096 2.11514e-10
8192 5.27365e-10
end
$d0_11 << end
4 1.48077e-11
8 1.61648e-11
16 1.96092e-11
32 2.67977e-11
64 4.13082e-11
128 7.03919e-11
256 1.2859e-10
512 2.45e-10
1024 4.77828e-10
2048 9.43488e-10
4096 1.87481e-09
8192 3.73746e-09
end
set logscale xy
set grid xtics ytics lt 1 lw 1 lc rgb '#dddddd'
set format xy '%g'
set border 3
set tics nomirror
set terminal svg size 900,560 font 'sans,13' dynamic background rgb 'white'
set output 'arithmetic.svg'
unset label
unset key
set title 'round-off of cubics over 1024 pixels: solid, measured; dashed, theory' noenhanced
set xlabel 'steps without a restart'
set ylabel 'largest round-off, pixels'
set xrange [2.73208:40622.7]
set yrange [1.00838e-13:1.26057e+07]
set label 'double' at graph 0.8333,0.1850 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label '32-bit graded' at graph 0.8333,0.5480 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'float' at graph 0.8333,0.6151 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label '32.32' at graph 0.8333,0.6978 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label '16.16' at graph 0.8333,0.8054 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label '32-bit block' at graph 0.8333,0.8402 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_1 using 1:2 with lines dt 2 lw 1.4 lc rgb '#d55e00' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_3 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_5 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e377c2' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_7 using 1:2 with lines dt 2 lw 1.4 lc rgb '#009e73' notitle, \
     $d0_8 using 1:2 with linespoints lw 2.4 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_9 using 1:2 with lines dt 2 lw 1.4 lc rgb '#000000' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_11 using 1:2 with lines dt 2 lw 1.4 lc rgb '#0072b2' notitle
set output
set terminal pngcairo size 1100,680 font 'sans,12' background rgb 'white'
set output 'arithmetic.png'
unset label
unset key
set title 'round-off of cubics over 1024 pixels: solid, measured; dashed, theory' noenhanced
set xlabel 'steps without a restart'
set ylabel 'largest round-off, pixels'
set xrange [2.73208:40622.7]
set yrange [1.00838e-13:1.26057e+07]
set label 'double' at graph 0.8333,0.1850 left offset 0.9,0 tc rgb '#0072b2' noenhanced front
set label '32-bit graded' at graph 0.8333,0.5480 left offset 0.9,0 tc rgb '#e377c2' noenhanced front
set label 'float' at graph 0.8333,0.6151 left offset 0.9,0 tc rgb '#000000' noenhanced front
set label '32.32' at graph 0.8333,0.6978 left offset 0.9,0 tc rgb '#009e73' noenhanced front
set label '16.16' at graph 0.8333,0.8101 left offset 0.9,0 tc rgb '#d55e00' noenhanced front
set label '32-bit block' at graph 0.8333,0.8355 left offset 0.9,0 tc rgb '#e69f00' noenhanced front
plot $d0_0 using 1:2 with linespoints lw 1.6 pt 5 ps 0.9 lc rgb '#d55e00' notitle, \
     $d0_1 using 1:2 with lines dt 2 lw 1.4 lc rgb '#d55e00' notitle, \
     $d0_2 using 1:2 with linespoints lw 1.6 pt 9 ps 0.9 lc rgb '#e69f00' notitle, \
     $d0_3 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e69f00' notitle, \
     $d0_4 using 1:2 with linespoints lw 1.6 pt 11 ps 0.9 lc rgb '#e377c2' notitle, \
     $d0_5 using 1:2 with lines dt 2 lw 1.4 lc rgb '#e377c2' notitle, \
     $d0_6 using 1:2 with linespoints lw 1.6 pt 13 ps 0.9 lc rgb '#009e73' notitle, \
     $d0_7 using 1:2 with lines dt 2 lw 1.4 lc rgb '#009e73' notitle, \
     $d0_8 using 1:2 with linespoints lw 2.4 pt 7 ps 0.9 lc rgb '#000000' notitle, \
     $d0_9 using 1:2 with lines dt 2 lw 1.4 lc rgb '#000000' notitle, \
     $d0_10 using 1:2 with linespoints lw 1.6 pt 4 ps 0.9 lc rgb '#0072b2' notitle, \
     $d0_11 using 1:2 with lines dt 2 lw 1.4 lc rgb '#0072b2' notitle
set output
