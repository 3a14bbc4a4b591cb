# Shares of throws of dice that end on a square face: measured and computed.
load style
set logscale x
set xrange [0.45:2.8]
set xtics (0.5, 0.7, 1, 1.5, 2, 2.5)
set yrange [0:1]
set xlabel 'length / edge of the square'
set ylabel 'share with a square face on top'
plot data using 1:7:8 skip 1 with filledcurves fillstyle solid 0.25 linecolor rgb blue title 'computed, all frictions and restitutions', \
     data using 1:4 skip 1 with lines linewidth 2.5 linecolor rgb blue title 'computed, the best pair', \
     data using 1:2:(2*$3) skip 1 with yerrorbars linewidth 1.5 pointtype 7 pointsize 0.9 linecolor rgb vermilion title 'measured, ±2 standard deviations'
