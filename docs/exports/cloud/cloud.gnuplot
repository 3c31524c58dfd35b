set terminal svg size 620,380 font "sans,13" background "white"
set output "cloud.svg"
set logscale x
set xlabel "diameter [um]"
set ylabel "captured fraction"
set xrange [60:130]
set xtics (60, 70, 80, 90, 100, 110, 120, 130)
set yrange [0:*]
set key top right
plot "cloud.dat" using 1:4 with lines lw 2 lc rgb "#0050a0" title "ashimpact sweep", \
     "cloud.dat" using 1:3 with points pt 7 ps 0.7 lc rgb "#b04000" title "LAMMPS"
