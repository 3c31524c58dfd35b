#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# openfoam_headers.sh PROGRAM RUN: the exported model of OpenFOAM compiles with the headers of each source tree of ESI's in
# ASHIMPACT_OPENFOAM_TREES (folders, a space between them; src and META-INFO/api-info are read), and says why it does not
# with those of others. Nothing is linked.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1" export openfoam "$2" -o "$scratch/ash" >/dev/null 2>&1
source=$scratch/ash/src
for defined in -UOPENFOAM -DOPENFOAM=1812; do
    if g++ -fsyntax-only "$defined" -I"$source" "$source/makeAshImpact.C" 2>"$scratch/log"; then exit 1; fi
    grep -m 1 -o '#error ".*AshImpact needs OpenFOAM.com (ESI), v1912 or later"' "$scratch/log"
done
for tree in ${ASHIMPACT_OPENFOAM_TREES:-}; do
    api=$(sed -n 's/^api=//p' "$tree/META-INFO/api-info") includes=()
    for folder in OpenFOAM OSspecific/POSIX finiteVolume finiteArea faOptions meshTools fileFormats surfMesh lagrangian/basic \
        lagrangian/intermediate lagrangian/distributionModels regionModels/regionModel regionModels/surfaceFilmModels regionFaModels \
        transportModels transportModels/compressible thermophysicalModels/basic thermophysicalModels/reactionThermo \
        thermophysicalModels/specie thermophysicalModels/SLGThermo thermophysicalModels/thermophysicalProperties \
        thermophysicalModels/radiation TurbulenceModels/turbulenceModels TurbulenceModels/compressible \
        TurbulenceModels/incompressible; do
        [[ -d $tree/src/$folder ]] || continue
        links=$scratch/$api/$folder/lnInclude
        mkdir -p "$links"
        find "$tree/src/$folder" -name '*.[CHh]' -exec ln -sf -t "$links" {} +
        includes+=(-isystem "$links" -isystem "$tree/src/$folder")
    done
    g++ -std=c++17 "-DOPENFOAM=$api" -DWM_DP -DWM_LABEL_SIZE=32 -DNoRepository -fsyntax-only -w -fpermissive -I"$source" \
        "${includes[@]}" "$source/makeAshImpact.C"
    echo "compiles with the headers of v$api"
done
