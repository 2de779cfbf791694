# SPDX-License-Identifier: MIT
# What each rule of leaving out gains on the scenes that it is made for, and what it costs where it finds nothing:
# from leaving_out.csv, by `make pictures`.
set datafile separator ","
set border 1
set tics nomirror
set grid xtics lt 1 lc rgb "#dddddd"
unset key
set logscale x
set xrange [1:200]
set xtics (1, 2, 5, 10, 20, 50, 100, 200)
set yrange [18:0]
set xlabel "time of a frame, per cent of the same frame without the rule"
set title "green: there is work to leave out; red: there is none; black: quartiles"
set lmargin 44
least(x) = x < 1.05 ? 1.05 : x
rows = "< tail -n +2 docs/report/leaving_out.csv | sed 's/, one-sided/ one-sided/'"
do for [kind in "png svg"] {
    if (kind eq "png") { set terminal pngcairo size 900,520 font "sans,11" } else { set terminal svg size 900,520 font "sans,12" background rgb "white" }
    set output "docs/report/leaving_out.".kind
    plot rows using (least(column(11))):($0 + 1):(1):(least(column(11))):($0 + 0.65):($0 + 1.35):(column(3) == 1 ? 0x66aa55 : 0xcc6655):ytic(stringcolumn(1).": ".stringcolumn(2)) \
             with boxxyerror fs solid 0.8 lc rgb variable, \
         rows using (least(column(11))):($0 + 1):(least(column(10))):(least(column(12))) with xerrorbars lw 1.6 pt 0 lc rgb "black", \
         100, "+" using (100):(0):(0):(18) with vectors nohead dt 2 lc rgb "#444444"
}
