# Work-precision diagram of several methods, lower left is better. Set by the program, besides the variables of
# style.gp: names, colours, dashes, marks (words, one per line); theories, failures, front (counts); error_axis,
# work_axis, machine; error_low, error_high, work_low, work_high. Data blocks: one per method; the Pareto front;
# labels; failures; one per theory.
load style
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set xrange [error_low:error_high]
set yrange [work_low:work_high]
set lmargin at screen 0.085
set rmargin at screen 0.745
set tmargin at screen 0.965
set bmargin at screen 0.12
set xlabel error_axis.', logarithmic'
set ylabel work_axis.', logarithmic'
share = (format eq 'svg' ? 1.0 : 0.75) * letters
small = sprintf(',%.1f', 0.62 * share)
legend = sprintf(',%.1f', 0.8 * share)
set label 100 machine at screen 0.992,0.018 right font small textcolor rgb '#888888'
set key at screen 0.755,0.965 samplen 2.2 top left Left reverse noenhanced font legend
grey = "#444444"
count = words(names)
set dashtype 2 (6,4)
set dashtype 3 (1.5,3)
plot data index count using 1:2 with lines linewidth 5 linecolor rgb '#dddddd' notitle, \
     for [i=1:theories] data index count + 2 + i using 1:2 with lines linewidth 0.8 linecolor rgb '#999999' notitle, \
     for [i=1:count] data index i - 1 using 1:2 with linespoints linewidth 1.4 pointsize 0.9 \
         dashtype int(word(dashes, i)) pointtype int(word(marks, i)) linecolor rgb value(word(colours, i)) notitle, \
     data index count + 2 using 1:2:4 with points pointtype 6 pointsize 1.3 linewidth 1.6 linecolor rgb variable notitle, \
     data index count + 1 using 1:2:3:4 with labels font small textcolor rgb variable notitle, \
     for [i=1:count] keyentry with linespoints linewidth 1.4 pointsize 0.9 dashtype int(word(dashes, i)) \
         pointtype int(word(marks, i)) linecolor rgb value(word(colours, i)) title word(names, i), \
     for [i=1:failures] keyentry with points pointtype 6 pointsize 1.3 linewidth 1.6 linecolor rgb '#444444' title 'fell or blew up', \
     for [i=1:front] keyentry with lines linewidth 5 linecolor rgb '#dddddd' title 'Pareto front'
