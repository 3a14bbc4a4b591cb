# Energy that a wall gains over the sweeps per step, for four ways to push overlaps apart.
load style
set xrange [2:26]
set yrange [-0.5:*]
set xlabel 'sweeps in a step of 1/60 s'
set ylabel 'largest rise of energy [J]'
array colour[4] = [violet, vermilion, orange, green]
array name[4] = ['no push', 'persistent', 'single-frame, in the system', 'single-frame, apart, in small steps']
array width[4] = [4, 1.5, 1.5, 1.5]
plot for [i=1:4] data using 1:i+1 skip 1 with linespoints linewidth width[i] pointtype 7 pointsize 0.8 \
         linecolor rgb colour[i] title name[i]
