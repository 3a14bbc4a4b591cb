# Kinetic energy per body of the five regular solids over time.
load style
set xrange [0:6]
set logscale y
set yrange [1e-6:*]
set format y '10^{%L}'
set xlabel 'time [s]'
set ylabel 'kinetic energy per body [J]'
plot data using 1:2 skip 1 with lines linewidth 1.5 linecolor rgb vermilion title 'tetrahedron', \
     data using 1:3 skip 1 with lines linewidth 1.5 linecolor rgb orange title 'cube', \
     data using 1:4 skip 1 with lines linewidth 1.5 linecolor rgb blue title 'octahedron', \
     data using 1:5 skip 1 with lines linewidth 1.5 linecolor rgb green title 'dodecahedron', \
     data using 1:6 skip 1 with lines linewidth 1.5 linecolor rgb violet title 'icosahedron'
