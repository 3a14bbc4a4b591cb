# CPU time per step of a scene as it is, and with everything constructed. Set by the program, besides the variables
# of style.gp: bars, made_on. Data: scene, us as it is, us with everything.
load style
small = sprintf(',%.1f', 0.62 * (format eq 'svg' ? 1.0 : 0.75) * letters)
set lmargin at screen 0.24
set rmargin at screen 0.9
set tmargin at screen 1.0 - 90.0 / height
set bmargin at screen 130.0 / height
set logscale x
set yrange [bars - 0.4:-0.6]
set border 1
set ytics scale 0
unset mytics
set xlabel 'CPU time of a step [us], logarithmic'
set label 2 made_on at screen 0.99, screen 18.0 / height right font small textcolor rgb '#888888' noenhanced
set key at screen 0.24, screen 1.0 - 25.0 / height top left horizontal maxrows 1 samplen 1.2 Left reverse
plot data using 2:0:($3 - $2):(0) with vectors nohead linewidth 4 linecolor rgb ivory notitle, \
     data using 2:0:ytic(1) with points pointtype 7 pointsize 1.6 linecolor rgb green title 'as it is', \
     data using 3:0 with points pointtype 7 pointsize 1.6 linecolor rgb vermilion title 'with everything', \
     data using ($3 > $2 ? $3 : $2):0:(sprintf('  × %.2f', $3 / $2)) with labels left font small notitle
