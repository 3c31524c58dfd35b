#!/bin/sh
# Builds src/libashImpact.so if it is not there, sends the parcels of expected.json at a wall, compares.
#   sh run.sh          with the table
#   sh run.sh solver   with libashimpact (pkg-config ashimpact), which must agree within 1e-10
set -e
cd "$(dirname "$0")"
export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}"    # without it every program of Debian's package aborts
tolerance=""
rm -f check/constant/variant
if [ "$1" = solver ]; then
    ldd src/libashImpact.so 2>/dev/null | grep -q libashimpact || sh src/build.sh solver
    echo "solver yes;" >check/constant/variant
    tolerance=1e-10
fi
[ -f src/libashImpact.so ] || sh src/build.sh
cd check
rm -rf 0.* postProcessing
blockMesh >log.blockMesh 2>&1 || { tail -n 20 log.blockMesh >&2; exit 1; }
icoUncoupledKinematicParcelFoam >log.parcels 2>&1 || { tail -n 20 log.parcels >&2; exit 1; }
cd ..
python3 compare.py $tolerance
