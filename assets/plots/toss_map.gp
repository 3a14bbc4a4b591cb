# Mean error of tosses over the two numbers of the law of contact. Set by the program: best_friction, best_restitution.
load style
unset grid
set xlabel 'friction'
set ylabel 'restitution'
set palette defined (0 '#0b3c5d', 0.5 '#7fb0c9', 1 '#f6f1e4')
set cblabel 'mean error of position [% of an edge]' textcolor rgb ink
set cbtics textcolor rgb ink
set xrange [*:*] noextend
set yrange [*:*] noextend
set label 1 '' at best_friction,best_restitution point pointtype 2 pointsize 2 linewidth 3 linecolor rgb vermilion front
plot data using 1:2:(100*$3) skip 1 with image notitle
