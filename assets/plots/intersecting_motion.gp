# Height of the topmost centre and largest upward velocity under three kinds of push.
load style
set multiplot layout 2,1
set lmargin 9
set xrange [0:6]
set ylabel narrow ? 'topmost centre [m]' : 'height of the topmost centre [m]'
set format x ''
set key inside top left vertical title ''
if (narrow) { set yrange [0:90] }
plot data using 1:4 with lines linewidth 2 linecolor rgb vermilion title 'persistent', \
     data using 1:2 with lines linewidth 2 dashtype '-' linecolor rgb blue title 'none', \
     data using 1:6 with lines linewidth 2 linecolor rgb green title 'single-frame'
set format x '%g'
set yrange [*:*]
set xlabel 'time [s]'
set ylabel narrow ? 'upwards [m/s]' : 'largest upward velocity [m/s]'
unset key
plot data using 1:5 with lines linewidth 2 linecolor rgb vermilion, \
     data using 1:3 with lines linewidth 2 dashtype '-' linecolor rgb blue, \
     data using 1:7 with lines linewidth 2 linecolor rgb green
unset multiplot
