# Speed of the wave along a row of dominoes over the gap between them.
load style
set xrange [0:0.85]
set yrange [0:*]
set xlabel 'gap between two dominoes / h'
set ylabel 'speed of the wave / √(g h)'
plot data using 1:4 skip 1 with linespoints linewidth 2 pointtype 7 pointsize 0.7 linecolor rgb green title 'friction 0.1, h = 48 mm', \
     data using 1:2 skip 1 with linespoints linewidth 2 pointtype 7 pointsize 0.7 linecolor rgb blue title 'friction 0.3, h = 48 mm', \
     data using 1:3 skip 1 with points pointtype 6 pointsize 1.6 linewidth 1.5 linecolor rgb orange title 'friction 0.3, h = 192 mm', \
     data using 1:5 skip 1 with linespoints linewidth 2 pointtype 7 pointsize 0.7 linecolor rgb vermilion title 'friction 0.6, h = 48 mm'
