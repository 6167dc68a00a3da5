# title: The complexity constant in theory and experiment
# desc: On the left C of Theorem 7.1 over m = 2, ..., 16 for p = (3,3,3), (5,5,5) and (7,7,7), with a logarithmic scale: it falls at first. On the right, for p = (3,3,3) and m = 2, ..., 8, the limits of the ratio of new to marked elements in the experiment, beside C/3000. The values are those of complexity-theory.dat and complexity-experiment.dat.
set terminal svg size 960,440 dynamic font "DejaVu Sans,12" background "#ffffff"
set multiplot layout 1,2
set grid linecolor "#dddddd"
set xlabel "m"
theory = folder . "/complexity-theory.dat"
experiment = folder . "/complexity-experiment.dat"
set title "C in theory"
set logscale y
set format y "10^{%T}"
set xrange [1.5:16.5]
set key right top
plot theory using 1:4 title "p = (7,7,7)" with linespoints linecolor "#009e73" pointtype 9 dashtype 2, \
     theory using 1:3 title "p = (5,5,5)" with linespoints linecolor "#d55e00" pointtype 5 dashtype 3, \
     theory using 1:2 title "p = (3,3,3)" with linespoints linecolor "#0072b2" pointtype 7 dashtype 1
set title "C' in the experiment, p = (3,3,3)"
unset logscale y
set format y "%g"
set xrange [1.5:8.5]
set yrange [0:*]
set key right top
plot experiment using 1:2 title "limit of new / marked elements" with linespoints linecolor "#0072b2" pointtype 7 dashtype 1, \
     experiment using 1:3 title "C / 3000" with linespoints linecolor "#d55e00" pointtype 4 dashtype 2
unset multiplot
