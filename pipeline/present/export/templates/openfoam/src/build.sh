#!/bin/sh
# Builds libashImpact.so beside this file. `sh build.sh solver` links libashimpact too (pkg-config ashimpact).
#   with wmake (an OpenFOAM environment): wmake does it, see Make/
#   else, as with Debian's package, which has no headers: OPENFOAM_SOURCE names a source tree of v1912;
#   without it, apt-get fetches Debian's source package (45 MB) into ./openfoam-source
# `sh build.sh headers` only fetches that.
set -e
cd "$(dirname "$0")"
flags="" libraries=""
if [ "$1" = solver ]; then
    flags="-DASHIMPACT_C_INTERFACE $(pkg-config --cflags ashimpact)"
    libraries="$(pkg-config --libs ashimpact) -Wl,-rpath,$(pkg-config --variable=libdir ashimpact)"
elif command -v wmake >/dev/null && [ -n "$WM_PROJECT_DIR" ]; then
    [ "$1" = headers ] || FOAM_USER_LIBBIN="$PWD" exec wmake libso
    exit 0
fi
source="${OPENFOAM_SOURCE:-$PWD/openfoam-source}"
if [ ! -d "$source/src/lagrangian" ]; then
    echo "build.sh: fetching the source package of openfoam for its headers" >&2
    mkdir -p "$source/apt/partial"
    . /etc/os-release
    echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" >"$source/apt.list"
    (
        cd "$source"
        apt="apt-get -q -o Dir::Etc::sourcelist=$source/apt.list -o Dir::Etc::sourceparts=- -o Dir::State::lists=$source/apt"
        $apt update
        $apt source --download-only openfoam=$(dpkg-query -W -f '${source:Version}' openfoam)
        tar xjf openfoam_*.orig.tar.bz2 --strip-components=1 --wildcards '*/src/*' '*/wmake/*'
        rm -f openfoam_*.orig.tar.bz2
    ) >"$source.log" 2>&1 || { tail -n 5 "$source.log" >&2; exit 1; }
fi
[ "$1" != headers ] || exit 0
includes=""
for folder in OpenFOAM OSspecific/POSIX finiteVolume meshTools lagrangian/basic lagrangian/intermediate \
    lagrangian/distributionModels regionModels/regionModel regionModels/surfaceFilmModels transportModels \
    transportModels/compressible thermophysicalModels/basic thermophysicalModels/reactionThermo \
    thermophysicalModels/specie thermophysicalModels/SLGThermo thermophysicalModels/thermophysicalProperties \
    thermophysicalModels/radiation TurbulenceModels/turbulenceModels TurbulenceModels/compressible \
    TurbulenceModels/incompressible; do
    [ -d "$source/src/$folder/lnInclude" ] ||
        (cd "$source/src" && WM_PROJECT_DIR="$source" WM_DIR="$source/wmake" "$source/wmake/wmakeLnInclude" -s "$folder" >/dev/null)
    includes="$includes -isystem $source/src/$folder/lnInclude"
done
# -fpermissive and -w: the headers of that year, not ours, which come by -I.
${CXX:-g++} -std=c++11 -DOPENFOAM=1912 -DWM_DP -DWM_LABEL_SIZE=32 -DNoRepository -ftemplate-depth-100 -O2 -fPIC \
    -fpermissive -w -I. -isystem "$source/src/transportModels" $includes $flags -shared makeAshImpact.C -o libashImpact.so.new \
    -Wl,--no-as-needed -llagrangianIntermediate -llagrangian -lfiniteVolume -lmeshTools -lOpenFOAM $libraries
mv libashImpact.so.new libashImpact.so
