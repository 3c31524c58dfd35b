#!/bin/sh
# 100,000 ash particles of many sizes and velocities on a wall in LAMMPS under mpirun, and which of them stay, beside what
# ashimpact says of each and of each size. Usage: sh run.sh ASHIMPACT WORK [PARTICLES]
set -e
here=$(cd "$(dirname "$0")" && pwd)
ashimpact=$(readlink -f "$1")
mkdir -p "$2"
cd "$2"
ash="--law dmt --contact-modulus 89e9 --work-of-adhesion 0.3 --density 2179.5 --damping 0.0151"
sizes="--from-diameter 60e-6 --to-diameter 130e-6 --damping-exponent 1.5 --to-velocity 5"
"$ashimpact" export lammps $ash --radius 44e-6 $sizes -o lammps
"$ashimpact" export table $ash --radius 44e-6 $sizes -o table
cd lammps
mpirun --oversubscribe ${MPI_OPTIONS} -n 2 lmp -in in.cloud -var particles "${3:-100000}" -var fastest 5 -screen none -log log.cloud
cd ..
python3 "$here/evaluate.py" . "$ashimpact"
gnuplot "$here/cloud.gnuplot"
