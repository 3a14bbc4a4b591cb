# A picture with texts over it, for print. Set by the program, besides the variables of style.gp: picture (PNG), across,
# down (its size in pixels). Data: x, y from the bottom left [pixels], 1 if centred there, text.
load style
unset border
unset tics
unset key
set margins 0,0,0,0
set xrange [0:across]
set yrange [0:down]
set datafile separator '\t'
stats data using 1 nooutput
# Of a transparent picture the opacity is the fourth of its numbers.
if (transparent) { plot picture binary filetype=png origin=(0.5,0.5) with rgbalpha notitle, \
     data using (column(3) > 0.5 ? $1 : NaN):2:4 with labels center noenhanced textcolor rgb ink notitle, \
     data using (column(3) > 0.5 ? NaN : $1):2:4 with labels left noenhanced textcolor rgb ink notitle
} else { plot picture binary filetype=png origin=(0.5,0.5) with rgbimage notitle, \
     data using (column(3) > 0.5 ? $1 : NaN):2:4 with labels center noenhanced textcolor rgb ink notitle, \
     data using (column(3) > 0.5 ? NaN : $1):2:4 with labels left noenhanced textcolor rgb ink notitle
}
