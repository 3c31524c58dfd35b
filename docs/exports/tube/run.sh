#!/bin/sh
# A jet of 100,000 ash particles on a tube: twice with the model of ashimpact, on one process and on two MPI ranks, and
# once with a constant restitution. Usage: sh run.sh EXPORTED WORK
#   EXPORTED  folder of `ashimpact export openfoam` for 2 to 120 um, whose run.sh has run: it holds the built library
#   WORK      folder for the runs
set -e
export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}"
here=$(cd "$(dirname "$0")" && pwd)
exported=$(cd "$1" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)
export LD_LIBRARY_PATH="$exported/src:$LD_LIBRARY_PATH"
for case in ash mpi constant; do
    rm -rf "${work:?}/$case"
    mkdir "$work/$case"
    cd "$work/$case"
    cp -r "$here/system" "$here/constant" .
    cp -r "$here/0.orig" 0
    cp "$exported/ashTable" constant/
    walls=ash
    [ $case = constant ] && walls=constant
    cp "constant/walls.$walls" constant/walls
    blockMesh >log.blockMesh
    postProcess -func writeCellCentres -time 0 >log.writeCellCentres
    python3 "$here/flow.py"
    if [ $case = mpi ]; then
        decomposePar >log.decomposePar
        mpirun --oversubscribe ${MPI_OPTIONS} -n 2 icoUncoupledKinematicParcelFoam -parallel >log.parcels
    else
        icoUncoupledKinematicParcelFoam >log.parcels
    fi
    echo "$case: done"
done
python3 "$here/evaluate.py" "$work"
cd "$work" && gnuplot "$here/tube.gnuplot"
