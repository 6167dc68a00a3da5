# title: Perfect B-splines and their antiderivatives
# desc: B*_4 (solid), B*_6 (dotted) and B*_10 (dashed) over [-1,1]: bells that are symmetric to 0, the narrower and higher the greater the order; their antiderivatives rise from 0 to 1 and pass 1/2 at 0. The values are those of perfect-bsplines.dat.
set terminal svg size 720,480 dynamic font "DejaVu Sans,12" background "#ffffff"
set xlabel "u"
set xrange [-1:1]
set yrange [0:*]
set grid linecolor "#dddddd"
set key left top
data = folder . "/perfect-bsplines.dat"
plot data using 1:2 title "B*_4" with lines linecolor "#0072b2" linewidth 2 dashtype 1, \
     data using 1:4 title "B*_6" with lines linecolor "#d55e00" linewidth 2 dashtype 3, \
     data using 1:6 title "B*_{10}" with lines linecolor "#009e73" linewidth 2 dashtype 2, \
     data using 1:3 title "antiderivative of B*_4" with lines linecolor "#0072b2" linewidth 1 dashtype 1, \
     data using 1:5 title "of B*_6" with lines linecolor "#d55e00" linewidth 1 dashtype 3, \
     data using 1:7 title "of B*_{10}" with lines linecolor "#009e73" linewidth 1 dashtype 2
