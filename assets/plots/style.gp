# The style of all plots. The program sets before it is loaded: data, made, format (png or svg), width, height
# [pixels], and the palette of the frames by name (vermilion, orange, blue, green, violet, ivory).
letters = width / 75.0
lines = width / 700.0
if (format eq 'svg') {
    set terminal svg size width,height font sprintf('DejaVu Sans,%.1f', letters) background rgb 'white' linewidth lines
} else {
    set terminal pngcairo size width,height font sprintf('DejaVu Sans,%.1f', 0.75 * letters) linewidth lines
}
set output made
set datafile separator ','
set encoding utf8
set border 3 linecolor rgb '#444444' linewidth 0.6
set tics nomirror out scale 0.5 textcolor rgb '#222222'
set grid linecolor rgb '#dddddd' linetype 1 linewidth 0.4
set key top right reverse Left spacing 1.3 samplen 2.5
