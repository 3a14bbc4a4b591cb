# Outcomes of runs over two parameters, one cell per run. Set by the program, besides the variables of style.gp:
# heading; x_axis, y_axis; x_ticks, y_ticks (as `set xtics` takes them); x_low, x_high, y_low, y_high;
# x_logarithmic, y_logarithmic; outcomes, colours (words, one per outcome); number_words; theory (empty for none);
# command. Data: two blocks, the cells and the line of theory.
load style
if (x_logarithmic) set logscale x
if (y_logarithmic) set logscale y
set xrange [x_low:x_high]
set yrange [y_low:y_high]
eval sprintf('set xtics (%s)', x_ticks)
eval sprintf('set ytics (%s)', y_ticks)
unset mxtics
unset mytics
unset grid
set border 0
set tics scale 0
set lmargin at screen 0.095
set rmargin at screen 0.735
set tmargin at screen 0.915
set bmargin at screen 0.135
set xlabel x_axis.(x_logarithmic ? ', logarithmic' : '') noenhanced
set ylabel y_axis.(y_logarithmic ? ', logarithmic' : '') noenhanced
share = (format eq 'svg' ? 1.0 : 0.75) * letters
small = sprintf(',%.1f', 0.7 * share)
inner = sprintf(',%.1f', 0.85 * share)
legend = sprintf(',%.1f', 0.8 * share)
set label 99 heading at screen 0.095,0.958 left font sprintf(',%.1f', 1.1 * share) noenhanced
set label 100 command at screen 0.992,0.02 right font small textcolor rgb '#666666' noenhanced
set label 101 'numbers: '.number_words at screen 0.752,0.145 left font small textcolor rgb '#444444' noenhanced
set key at screen 0.745,0.925 samplen 1.6 top left Left reverse font legend
plot data index 0 using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid 1.0 border rgb 'white' linewidth 1.5 \
         linecolor rgb variable notitle, \
     data index 1 using 1:2 with lines linewidth 2.2 linecolor rgb '#444444' notitle, \
     data index 1 using 1:2 with lines linewidth 1.2 dashtype (6,4) linecolor rgb 'white' notitle, \
     data index 0 using 1:2:8:9 with labels font inner textcolor rgb variable notitle, \
     for [i=1:words(outcomes)] keyentry with boxes fillstyle solid 1.0 border rgb 'white' \
         linecolor rgb word(colours, i) title word(outcomes, i), \
     for [i=1:strlen(theory) > 0] keyentry with lines linewidth 2 dashtype (6,4) linecolor rgb '#444444' title theory
