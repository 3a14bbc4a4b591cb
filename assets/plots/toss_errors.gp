# Error of computed tosses over the time since the first contact. Blocks after the first are other engines: a name,
# then time and mean error of position.
load style
grey = "#444444"
set xrange [0:0.6]
set yrange [0:*]
set y2range [0:*]
set ytics nomirror
set y2tics textcolor rgb ink
set border 11
set key top left
set xlabel 'time since the first contact [s]'
set ylabel 'position [% of an edge]'
set y2label 'orientation [degrees]' textcolor rgb ink
plot data index 0 using 1:(100*$3) skip 1 with lines linewidth 2.5 linecolor rgb blue title 'position, mean', \
     data index 0 using 1:(100*$4) skip 1 with lines linewidth 2 dashtype (6,4) linecolor rgb blue title 'position, median', \
     data index 0 using 1:5 skip 1 axes x1y2 with lines linewidth 2.5 linecolor rgb vermilion title 'orientation, mean', \
     data index 0 using 1:6 skip 1 axes x1y2 with lines linewidth 2 dashtype (6,4) linecolor rgb vermilion title 'orientation, median', \
     for [i=1:others] data index i using 1:(100*$2) with lines linewidth 1.5 dashtype i+1 linecolor rgb grey title 'position, mean: '.columnhead(1)
