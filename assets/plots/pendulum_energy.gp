# Energy of a pendulum with either kind of push on its bar.
load style
set xrange [0:120]
set yrange [0:1.05]
set xlabel 'time [s]'
set ylabel narrow ? 'energy / start' : 'energy of the swing, share of the start'
set key inside bottom left vertical title ''
plot data using 1:2 with lines linewidth 2 linecolor rgb green title 'persistent, β = 1', \
     data using 1:3 with lines linewidth 2 linecolor rgb orange title 'persistent, β = 0.2', \
     data using 1:4 with lines linewidth 2 linecolor rgb vermilion title 'single-frame, β = 1'
