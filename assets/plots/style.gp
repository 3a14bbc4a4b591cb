# The style of all plots. The program sets before it is loaded: data, made, format (png, svg or pdf), width, height
# [pixels], letters (size of the font [pixels]), inch (pixels of paper per inch), dark and transparent (0 or 1), and the
# palette by name (vermilion, orange, blue, green, violet, ivory).
lines = letters / 9.33
paper = dark ? '#16181d' : 'white'
ink = dark ? '#e8e8e8' : '#222222'
faint = dark ? '#aaaaaa' : '#444444'
if (format eq 'svg') {
    set terminal svg size width,height font sprintf('DejaVu Sans,%.1f', letters) linewidth lines \
        background rgb (transparent ? '#00ffffff' : paper)
} else { if (format eq 'pdf') {
    set terminal pdfcairo size ceil(72.0 * width / inch) / 72.0,ceil(72.0 * height / inch) / 72.0 font sprintf('DejaVu Sans,%.2f', letters * 72.0 / inch) \
        linewidth lines * 72.0 / inch * 2.0 dashlength 0.7 pointscale 0.55
    if (dark && !transparent) { set object 1 rectangle from screen 0,0 to screen 1,1 behind fillcolor rgb paper fillstyle solid noborder }
} else { if (transparent) {
    set terminal pngcairo size width,height font sprintf('DejaVu Sans,%.1f', 0.75 * letters) linewidth lines transparent
} else {
    set terminal pngcairo size width,height font sprintf('DejaVu Sans,%.1f', 0.75 * letters) linewidth lines \
        background rgb paper
} } }
set output made
set datafile separator ','
set encoding utf8
set border 3 linecolor rgb faint linewidth 0.6
set tics nomirror out scale 0.5 textcolor rgb ink
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
set grid linecolor rgb (dark ? '#3a3d44' : '#dddddd') linetype 1 linewidth 0.4
set key top right reverse Left spacing 1.3 samplen 2.5 textcolor rgb ink
# In one column of a page there is room for some thirty letters only, and the key stands below.
narrow = width / letters < 50
if (narrow) { set key outside bottom center horizontal samplen 1.5 spacing 1.1; set xlabel offset 0,0.4 }
