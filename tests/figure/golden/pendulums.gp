# Figures drawn by mbcc. `gnuplot THIS` writes them anew; gnuplot 5.4 or later.
set terminal pdfcairo size 6.250, 7.722 font 'Sans, 10' fontscale 0.8
set output 'figure'

# Colours of Okabe and Ito, which the colour-blind tell apart too; dash patterns for the results.
set linetype 1 linewidth 1.6 linecolor rgb '#0072b2'
set linetype 2 linewidth 1.6 linecolor rgb '#d55e00'
set linetype 3 linewidth 1.6 linecolor rgb '#009e73'
set linetype 4 linewidth 1.6 linecolor rgb '#cc79a7'
set linetype 5 linewidth 1.6 linecolor rgb '#e69f00'
set linetype 6 linewidth 1.6 linecolor rgb '#56b4e9'
set linetype 7 linewidth 1.6 linecolor rgb '#555555'
# Broad and pale ones, for what lies under other lines.
set linetype 11 linewidth 4 linecolor rgb '#a6cde6'
set linetype 12 linewidth 4 linecolor rgb '#f3c3a3'
set linetype 13 linewidth 4 linecolor rgb '#a6dccb'
set linetype 14 linewidth 4 linecolor rgb '#ecd0df'
set linetype 15 linewidth 4 linecolor rgb '#f6dba6'
set linetype 16 linewidth 4 linecolor rgb '#c6e5f6'
set linetype 17 linewidth 4 linecolor rgb '#c8c8c8'
set dashtype 1 solid
set dashtype 2 (7, 4)
set dashtype 3 (1.5, 3)
set dashtype 4 (9, 3, 1.5, 3)
set dashtype 5 (14, 5)

set encoding utf8
set samples 1000
set border 3 linewidth 0.7 linecolor rgb '#888888'
set tics out nomirror scale 0.5 textcolor rgb '#444444'
set grid linetype -1 linewidth 0.4 linecolor rgb '#dddddd'
set key noenhanced samplen 1.6 spacing 0.95 horizontal textcolor rgb '#222222'

set xrange [0:2]

$data_1 << EOD
0 1
1 0
EOD
$data_2 << EOD
0 0
1 -1
EOD
$data_3 << EOD
0 1
2 0.5
EOD
$data_4 << EOD
0 0
2 -1
EOD
$data_5 << EOD
0 0
1 -4
EOD
$data_6 << EOD
0 0
1 0
EOD
$data_7 << EOD
0 0
2 -3
EOD
$data_8 << EOD
0 0
2 0
EOD
$data_9 << EOD
0 0
1 0
EOD
$data_10 << EOD
0 -9.81
1 20
EOD
$data_11 << EOD
0 0
2 0
EOD
$data_12 << EOD
0 -9.81
2 20
EOD
$data_13 << EOD
0 1.5
1 0
EOD
$data_14 << EOD
0 0
2 30
EOD

set multiplot
set arrow 1 from screen 0.14667, screen 0.98022 to screen 0.19556, screen 0.98022 nohead linetype 17 dashtype 1
set label 11 'long.csv' noenhanced at screen 0.19556, screen 0.98022 offset 0.6, 0
set arrow 2 from screen 0.41867, screen 0.98022 to screen 0.46756, screen 0.98022 nohead linetype 7 dashtype 2
set label 12 'it'."'".'s short.csv' noenhanced at screen 0.46756, screen 0.98022 offset 0.6, 0

set label 2 'bob' noenhanced at screen 0.14667, screen 0.92986 font ',13' textcolor rgb '#000000'
set lmargin at screen 0.14667; set rmargin at screen 0.94667
set tmargin at screen 0.85971; set bmargin at screen 0.62590
set label 1 'coordinates' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 6
set yrange [-1.12:1.12]; unset logscale y; set format y '%.6g'; set ytics 0.5
set format x ''; unset xlabel
plot $data_1 with lines linetype 11 dashtype 1 notitle, \
     $data_2 with lines linetype 12 dashtype 1 notitle, \
     $data_3 with lines linetype 1 dashtype 2 notitle, \
     $data_4 with lines linetype 2 dashtype 2 notitle, \
     keyentry with lines linetype 1 title 'x', \
     keyentry with lines linetype 2 title 'y'
unset label
unset arrow
set lmargin at screen 0.14667; set rmargin at screen 0.94667
set tmargin at screen 0.58633; set bmargin at screen 0.35252
set label 1 'velocities' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 6
set yrange [-4.24:0.24]; unset logscale y; set format y '%.6g'; set ytics 1
set format x ''; unset xlabel
plot $data_5 with lines linetype 11 dashtype 1 notitle, \
     $data_6 with lines linetype 12 dashtype 1 notitle, \
     $data_7 with lines linetype 1 dashtype 2 notitle, \
     $data_8 with lines linetype 2 dashtype 2 notitle, \
     keyentry with lines linetype 1 title 'vx', \
     keyentry with lines linetype 2 title 'vy'
unset label
unset arrow
set lmargin at screen 0.14667; set rmargin at screen 0.94667
set tmargin at screen 0.31295; set bmargin at screen 0.07914
set label 1 'accelerations' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 5
set yrange [-11.5986:21.7886]; unset logscale y; set format y '%.6g'; set ytics 5
set format x '%g'; set xlabel 't' offset 0, 0.5
plot $data_9 with lines linetype 11 dashtype 1 notitle, \
     $data_10 with lines linetype 12 dashtype 1 notitle, \
     $data_11 with lines linetype 1 dashtype 2 notitle, \
     $data_12 with lines linetype 2 dashtype 2 notitle, \
     keyentry with lines linetype 1 title 'ax', \
     keyentry with lines linetype 2 title 'ay'
unset label
unset arrow
unset multiplot
set multiplot
set arrow 1 from screen 0.14667, screen 0.98022 to screen 0.19556, screen 0.98022 nohead linetype 17 dashtype 1
set label 11 'long.csv' noenhanced at screen 0.19556, screen 0.98022 offset 0.6, 0
set arrow 2 from screen 0.41867, screen 0.98022 to screen 0.46756, screen 0.98022 nohead linetype 7 dashtype 2
set label 12 'it'."'".'s short.csv' noenhanced at screen 0.46756, screen 0.98022 offset 0.6, 0

set label 2 'outputs' noenhanced at screen 0.14667, screen 0.92986 font ',13' textcolor rgb '#000000'
set lmargin at screen 0.14667; set rmargin at screen 0.94667
set tmargin at screen 0.85971; set bmargin at screen 0.62590
set label 1 'angle' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 1
set yrange [-0.09:1.59]; unset logscale y; set format y '%.6g'; set ytics 0.5
set format x ''; unset xlabel
plot $data_13 with lines linetype 11 dashtype 1 notitle
unset label
unset arrow
set lmargin at screen 0.14667; set rmargin at screen 0.94667
set tmargin at screen 0.58633; set bmargin at screen 0.35252
set label 1 'pull' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 1
set yrange [-1.8:31.8]; unset logscale y; set format y '%.6g'; set ytics 5
set format x '%g'; set xlabel 't' offset 0, 0.5
plot $data_14 with lines linetype 1 dashtype 2 notitle
unset label
unset arrow
unset multiplot
