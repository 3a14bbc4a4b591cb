# Least thickness and least friction of an arch over the number of its voussoirs.
load style
if (narrow) { set multiplot layout 2,1 } else { set multiplot layout 1,2 }
set xrange [0:34]
set xlabel 'voussoirs'
set key inside bottom right vertical title ''
set ylabel narrow ? 'thickness / radius' : 'least thickness / mean radius'
set yrange [0.09:0.112]
plot data using 1:3 skip 1 with lines linewidth 2 linecolor rgb blue title 'limit analysis', \
     data using 1:6 skip 1 with lines dashtype 2 linewidth 2 linecolor rgb violet title 'very many', \
     data using 1:2 skip 1 with points pointtype 7 pointsize 1.2 linecolor rgb vermilion title 'runs'
set ylabel narrow ? 'least friction' : 'least friction coefficient'
set yrange [0.36:0.39]
plot data using 1:5 skip 1 with lines linewidth 2 linecolor rgb blue title 'limit analysis', \
     data using 1:4 skip 1 with points pointtype 7 pointsize 1.2 linecolor rgb vermilion title 'runs'
unset multiplot
