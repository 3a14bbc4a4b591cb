# Share of each stage in a step, one bar per scene. Set by the program, besides the variables of style.gp: bars,
# made_on. Data: scene with its us per step, and where each stage ends in per cent.
load style
stages = 'rules forces rows system solve remember integrate'
array colour[7] = ['#888888', violet, blue, green, vermilion, orange, ivory]
small = sprintf(',%.1f', 0.62 * (format eq 'svg' ? 1.0 : 0.75) * letters)
set lmargin at screen 0.33
set rmargin at screen 0.97
set tmargin at screen 1.0 - 90.0 / height
set bmargin at screen 120.0 / height
set xrange [0:100]
set yrange [bars - 0.4:-0.6]
set border 0
set tics scale 0
unset grid
set xlabel 'share of the step [%]'
set label 2 made_on at screen 0.99, screen 18.0 / height right font small textcolor rgb '#888888' noenhanced
set key at screen 0.33, screen 1.0 - 15.0 / height top left horizontal samplen 1.2 Left reverse
begin(k) = k == 1 ? 0.0 : column(k)
plot for [k=1:7] data using (begin(k)):0:(begin(k)):(column(k + 1)):($0 - 0.36):($0 + 0.36) with boxxyerror \
         fillstyle solid 1.0 noborder linecolor rgb colour[k] title word(stages, k), \
     data using (0):0:ytic(1) with points pointtype 0 notitle
