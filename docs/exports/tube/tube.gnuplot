set terminal svg size 900,420 font "sans,13" background "white"
set output "tube.svg"
set multiplot layout 1,2
set key above left reverse Left maxrows 4
set logscale x
set xlabel "diameter [um]"
set ylabel "share of the particles that fly at the tube"
set xrange [2:120]
set yrange [0:1]
plot "size.dat" using 1:2 with linespoints pt 6 dt 2 lc rgb "#666666" title "hit", \
     "size.dat" using 1:3:5 with yerrorbars pt 7 lc rgb "#b04000" notitle, \
     "size.dat" using 1:3 with lines lw 2 lc rgb "#b04000" title "stuck, ashImpact", \
     "size.dat" using 1:4 with points pt 2 lc rgb "#0050a0" title "the same on two MPI ranks", \
     "size.dat" using 1:6 with lines lw 2 lc rgb "#208040" title "stuck, constant e = 0.5"
unset logscale x
set key default
set key inside top right vertical
set xrange [0:90]
set autoscale y
set yrange [0:*]
set xlabel "angle from the front of the tube [deg]"
set ylabel "particles in 5 deg"
plot "angle.dat" using 1:2 with steps dt 2 lc rgb "#666666" title "hit", \
     "angle.dat" using 1:3 with steps lw 2 lc rgb "#b04000" title "stuck, ashImpact"
