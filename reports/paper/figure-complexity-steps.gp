# title: New elements per marked element over the steps of the experiment
# desc: For m = 2, 3, 4, 5 the ratio of new to marked elements after 1 to 150 steps in the corner of 5 x 5 x 5 cubes, p = (3,3,3). The ratios rise towards their limits 3840, 1680, 1152 and 924; horizontal dashes show C/3000, which the one for m = 3 passes at step 117. The values are those of complexity-steps.dat and complexity-experiment.dat.
set terminal svg size 860,520 dynamic font "DejaVu Sans,12" background "#ffffff"
set grid linecolor "#dddddd"
set xlabel "refinement steps"
set ylabel "new elements / marked elements"
set xrange [0:152]
set yrange [0:*]
set key right center outside
steps = folder . "/complexity-steps.dat"
bound = folder . "/complexity-experiment.dat"
plot steps using 1:3 title "m = 2" with lines linecolor "#0072b2" linewidth 2 dashtype 1, \
     steps using 1:5 title "m = 3" with lines linecolor "#d55e00" linewidth 2 dashtype 2, \
     steps using 1:7 title "m = 4" with lines linecolor "#009e73" linewidth 2 dashtype 3, \
     steps using 1:9 title "m = 5" with lines linecolor "#cc79a7" linewidth 2 dashtype 4, \
     bound every ::0::3 using (0):3:(152):(0) title "C / 3000" with vectors nohead linecolor "#000000" linewidth 0.7 dashtype 2, \
     bound every ::0::3 using (100):3:(sprintf("C / 3000 for m = %d", $1)) notitle with labels left offset 0,0.5 font ",10"
