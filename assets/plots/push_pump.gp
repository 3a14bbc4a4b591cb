# Energy that a wall gains against the sweeps of a step, for four ways to push overlaps apart.
load style
set logscale x 2
set xtics (8, 16, 32, 64, 128)
set xrange [7:146]
set yrange [0.001:*]
set logscale y
set format y '10^{%T}'
set xlabel 'sweeps in a step of 1/60 s'
set ylabel 'largest rise of energy [J], at least 0.001'
set key outside right top Left reverse
array colour[4] = [violet, vermilion, orange, green]
array name[4] = ['no push', 'persistent', 'single-frame, in the system', 'single-frame, apart, small steps']
plot for [i=1:4] data using 1:(column(i+1) > 0.001 ? column(i+1) : 0.001) skip 1 with linespoints linewidth 1.5 \
         pointtype 7 pointsize 0.8 linecolor rgb colour[i] title name[i]
