# Contact forces below each cube of the stack, and the load of each pair at rest.
load style
set xrange [0:2]
set logscale y
set yrange [4:4000]
set xlabel 'time [s]'
set ylabel 'contact force [N]'
array colour[5] = [vermilion, orange, blue, green, violet]
array name[5] = ['below cube 1 (the ground)', 'below cube 2', 'below cube 3', 'below cube 4', 'below cube 5']
plot for [i=1:5] 12 * (6 - i) with lines linewidth 0.7 dashtype '.' linecolor rgb '#888888' notitle, \
     for [i=1:5] data using 1:i+1 skip 1 with lines linewidth 1.5 linecolor rgb colour[i] title name[i]
