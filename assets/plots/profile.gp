# Performance profiles. Set by the program, besides the variables of style.gp: names, colours, dashes (words, one per
# method), last (end of the ratios), machine. Data blocks: one per method, the corners of its steps.
load style
set logscale x
set xrange [1:last]
set yrange [0:1.03]
set lmargin at screen 0.085
set rmargin at screen 0.735
set tmargin at screen 0.965
set bmargin at screen 0.13
set xlabel "CPU time over that of the fastest method, logarithmic"
set ylabel "share of the problems that are solved"
share = (format eq 'svg' ? 1.0 : 0.75) * letters
small = sprintf(',%.1f', 0.62 * share)
set label 100 machine at screen 0.992,0.018 right font small textcolor rgb '#888888'
legend = sprintf(',%.1f', 0.8 * share)
set key at screen 0.745,0.965 samplen 2.2 top left Left reverse noenhanced font legend
grey = "#444444"
set dashtype 2 (6,4)
set dashtype 3 (1.5,3)
plot for [i=1:words(names)] data index i - 1 using 1:2 with steps linewidth 2 dashtype int(word(dashes, i)) \
    linecolor rgb value(word(colours, i)) title word(names, i)
