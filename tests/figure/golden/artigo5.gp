# Figures drawn by mbcc. `gnuplot THIS` writes them anew; gnuplot 5.4 or later.
set terminal svg size 1350, 562 dynamic font 'Helvetica, Arial, sans-serif, 10' background 'white'
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

set xrange [0:5]

$data_1 << EOD
0 0.707106781
1.25 1.25308635e-07
2.5 -0.828278461
3.75 -3.93433592e-07
5 0.997331727
EOD
$data_2 << EOD
0 0
1.25 0.740137022
2.5 2.54677272e-07
3.75 -0.934233669
5 -5.4842219e-07
EOD
$data_3 << EOD
0 0.707106781
1.25 0.672455404
2.5 0.560313415
3.75 0.35664997
5 0.0729025023
EOD
$data_4 << EOD
0 0
1.25 -4.65041805
2.5 -1.51853568
3.75 5.86996322
5 0.322173928
EOD
$data_5 << EOD
0 4.44288294
1.25 0.923792049
2.5 -5.20422704
3.75 -1.36823947
5 6.26641999
EOD
$data_6 << EOD
0 0
1.25 -1.01677052
2.5 -2.24476245
3.75 -3.58406099
5 -4.40744486
EOD
$data_7 << EOD
0 -13.9577284
1.25 -11.6087083
2.5 28.5168071
3.75 17.1937887
5 -58.6413553
EOD
$data_8 << EOD
0 -0
1.25 -17.4033024
2.5 -19.0824721
3.75 45.9404171
5 4.04853534
EOD
$data_9 << EOD
0 -13.9577284
1.25 -15.8118624
2.5 -19.2910359
3.75 -17.5380624
5 -4.2865392
EOD
$data_10 << EOD
0 2
1.25 2
2.5 2
3.75 2
5 2
EOD
$data_11 << EOD
0 1
1.25 1
2.5 1
3.75 1
5 1
EOD
$data_12 << EOD
0 -0.75
1.25 -0.4375
2.5 -0.125
3.75 0.1875
5 0.5
EOD
$data_13 << EOD
0 0
1.25 0
2.5 0
3.75 0
5 0
EOD
$data_14 << EOD
0 0
1.25 0
2.5 0
3.75 0
5 0
EOD
$data_15 << EOD
0 0.25
1.25 0.25
2.5 0.25
3.75 0.25
5 0.25
EOD
$data_16 << EOD
0 0
1.25 0
2.5 0
3.75 -0
5 -0
EOD
$data_17 << EOD
0 0
1.25 0
2.5 0
3.75 -0
5 -0
EOD
$data_18 << EOD
0 0
1.25 0
2.5 0
3.75 0
5 0
EOD
$data_19 << EOD
0 2.22044605e-16
1.25 9.19314821e-07
2.5 3.66793226e-06
3.75 8.2499311e-06
5 1.46518893e-05
EOD
$data_20 << EOD
0 0
1.25 1.25308635e-07
2.5 2.54677272e-07
3.75 3.9343359e-07
5 5.48422188e-07
EOD
$data_21 << EOD
0 0
1.25 1.43413685e-06
2.5 2.88036985e-06
3.75 4.34694531e-06
5 5.83113011e-06
EOD
$data_22 << EOD
0 2.75743158e-16
1.25 6.02628667e-09
2.5 2.07712114e-08
3.75 4.28022002e-08
5 6.02521844e-08
EOD
$data_23 << EOD
0 0
1.25 0
2.5 0
3.75 0
5 0
EOD
$data_24 << EOD
0 0
1.25 0
2.5 0
3.75 0
5 0
EOD
$data_25 << EOD
0 3.33829561e-16
1.25 1.40290053e-15
2.5 1.05735054e-15
3.75 3.05094449e-15
5 2.56434851e-14
EOD
$data_26 << EOD
0 0
1.25 1.77551095e-15
2.5 3.55271368e-15
3.75 6.5626114e-15
5 0
EOD
$data_27 << EOD
0 0
1.25 0
2.5 0
3.75 0
5 0
EOD
$data_28 << EOD
0 0
1.25 0
2.5 0
3.75 0
5 0
EOD

set multiplot

set label 2 'particle 1' noenhanced at screen 0.04889, screen 0.96975 font ',13' textcolor rgb '#000000'
set lmargin at screen 0.04889; set rmargin at screen 0.31556
set tmargin at screen 0.90036; set bmargin at screen 0.66904
set label 1 'coordinates' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 5
set yrange [-1.05012759:1.11322565]; unset logscale y; set format y '%.6g'; set ytics 0.5
set format x ''; unset xlabel
plot $data_1 smooth mcsplines with lines linetype 1 dashtype 1 title 'x1', \
     $data_2 smooth mcsplines with lines linetype 2 dashtype 1 title 'y1', \
     $data_3 smooth mcsplines with lines linetype 3 dashtype 1 title 'z1'
unset label
unset arrow
set lmargin at screen 0.04889; set rmargin at screen 0.31556
set tmargin at screen 0.62989; set bmargin at screen 0.39858
set label 1 'velocities' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 5
set yrange [-5.89246586:6.95465881]; unset logscale y; set format y '%.6g'; set ytics 2
set format x ''; unset xlabel
plot $data_4 smooth mcsplines with lines linetype 1 dashtype 1 title 'vx1', \
     $data_5 smooth mcsplines with lines linetype 2 dashtype 1 title 'vy1', \
     $data_6 smooth mcsplines with lines linetype 3 dashtype 1 title 'vz1'
unset label
unset arrow
set lmargin at screen 0.04889; set rmargin at screen 0.31556
set tmargin at screen 0.35943; set bmargin at screen 0.12811
set label 1 'accelerations' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 5
set yrange [-64.9162616:52.2153235]; unset logscale y; set format y '%.6g'; set ytics 20
set format x '%g'; set xlabel 't' offset 0, 0.5
plot $data_7 smooth mcsplines with lines linetype 1 dashtype 1 title 'ax1', \
     $data_8 smooth mcsplines with lines linetype 2 dashtype 1 title 'ay1', \
     $data_9 smooth mcsplines with lines linetype 3 dashtype 1 title 'az1'
unset label
unset arrow

set label 2 'particle 2' noenhanced at screen 0.38222, screen 0.96975 font ',13' textcolor rgb '#000000'
set lmargin at screen 0.38222; set rmargin at screen 0.64889
set tmargin at screen 0.90036; set bmargin at screen 0.66904
set label 1 'coordinates' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 5
set yrange [-0.915:2.165]; unset logscale y; set format y '%.6g'; set ytics 0.5
set format x ''; unset xlabel
plot $data_10 smooth mcsplines with lines linetype 1 dashtype 1 title 'x2', \
     $data_11 smooth mcsplines with lines linetype 2 dashtype 1 title 'y2', \
     $data_12 smooth mcsplines with lines linetype 3 dashtype 1 title 'z2'
unset label
unset arrow
set lmargin at screen 0.38222; set rmargin at screen 0.64889
set tmargin at screen 0.62989; set bmargin at screen 0.39858
set label 1 'velocities' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 5
set yrange [-0.015:0.265]; unset logscale y; set format y '%.6g'; set ytics 0.05
set format x ''; unset xlabel
plot $data_13 smooth mcsplines with lines linetype 1 dashtype 1 title 'vx2', \
     $data_14 smooth mcsplines with lines linetype 2 dashtype 1 title 'vy2', \
     $data_15 smooth mcsplines with lines linetype 3 dashtype 1 title 'vz2'
unset label
unset arrow
set lmargin at screen 0.38222; set rmargin at screen 0.64889
set tmargin at screen 0.35943; set bmargin at screen 0.12811
set label 1 'accelerations' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 5
set yrange [-1:1]; unset logscale y; set format y '%.6g'; set ytics 0.5
set format x '%g'; set xlabel 't' offset 0, 0.5
plot $data_16 smooth mcsplines with lines linetype 1 dashtype 1 title 'ax2', \
     $data_17 smooth mcsplines with lines linetype 2 dashtype 1 title 'ay2', \
     $data_18 smooth mcsplines with lines linetype 3 dashtype 1 title 'az2'
unset label
unset arrow

set label 2 'constraint errors' noenhanced at screen 0.71556, screen 0.96975 font ',13' textcolor rgb '#000000'
set lmargin at screen 0.71556; set rmargin at screen 0.98222
set tmargin at screen 0.90036; set bmargin at screen 0.66904
set label 1 'of position' noenhanced at graph 0, graph 1 offset character 0, 0.50 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 3
set yrange [1e-16:0.0001]; set logscale y; set format y '10^{%T}'; set ytics autofreq
set format x ''; unset xlabel
plot $data_19 with lines linetype 1 dashtype 1 linewidth 1 title 'sphere', \
     $data_20 with lines linetype 2 dashtype 1 linewidth 1 title 'meridian'
unset label
unset arrow
set lmargin at screen 0.71556; set rmargin at screen 0.98222
set tmargin at screen 0.60498; set bmargin at screen 0.37367
set label 1 'of velocity' noenhanced at graph 0, graph 1 offset character 0, 1.45 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 2
set yrange [1e-16:1e-05]; set logscale y; set format y '10^{%T}'; set ytics autofreq
set format x ''; unset xlabel
plot $data_21 with lines linetype 1 dashtype 1 linewidth 1 title 'sphere', \
     $data_22 with lines linetype 2 dashtype 1 linewidth 1 title 'meridian', \
     $data_23 with lines linetype 3 dashtype 1 linewidth 1 title 'constraint_3: 0', \
     $data_24 with lines linetype 4 dashtype 1 linewidth 1 title 'constraint_4: 0'
unset label
unset arrow
set lmargin at screen 0.71556; set rmargin at screen 0.98222
set tmargin at screen 0.30961; set bmargin at screen 0.07829
set label 1 'of acceleration' noenhanced at graph 0, graph 1 offset character 0, 1.45 textcolor rgb '#444444'
set key at graph 1, graph 1 right bottom maxcols 2
set yrange [1e-16:1e-13]; set logscale y; set format y '10^{%T}'; set ytics autofreq
set format x '%g'; set xlabel 't' offset 0, 0.5
plot $data_25 with lines linetype 1 dashtype 1 linewidth 1 title 'sphere', \
     $data_26 with lines linetype 2 dashtype 1 linewidth 1 title 'meridian', \
     $data_27 with lines linetype 3 dashtype 1 linewidth 1 title 'constraint_3: 0', \
     $data_28 with lines linetype 4 dashtype 1 linewidth 1 title 'constraint_4: 0'
unset label
unset arrow
unset multiplot
