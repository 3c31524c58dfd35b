#!/usr/bin/env bash
# libraries.sh FOLDER: what the build for browsers takes from Debian, into FOLDER.
#   source/NAME    source packages of the libraries that have to be compiled for WebAssembly
#   include        links to the header-only libraries of this machine, so that nothing else of /usr/include is seen
# A folder source/NAME that is there already is taken as it is; UDUNITS2_SOURCE names a source tree of UDUNITS-2 for
# machines whose mirror lacks that package. Does nothing when all is there.
set -euo pipefail
folder=$1
names=(gsl udunits expat zlib minizip nettle pugixml highway)
headers=(fmt spdlog nlohmann valijson eigen3 boost fast_float)

sources=$folder/source
mkdir -p "$sources/.apt/partial" "$folder/include"
log=$folder/libraries.log

for header in "${headers[@]}"; do
    [[ -d /usr/include/$header ]] || { echo "libraries.sh: /usr/include/$header is missing; ./dev deps web" >&2; exit 1; }
    ln -sfn "/usr/include/$header" "$folder/include/$header"
done

if [[ ${UDUNITS2_SOURCE:-} && ! -e $sources/udunits ]]; then cp -r "$UDUNITS2_SOURCE" "$sources/udunits"; fi

missing=()
for name in "${names[@]}"; do [[ -d $sources/$name ]] || missing+=("$name"); done
if ((${#missing[@]})); then
    # shellcheck source=/dev/null
    . /etc/os-release
    echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" >"$sources/.apt/sources.list"
    apt=(apt-get -q -o "Dir::Etc::sourcelist=$sources/.apt/sources.list" -o Dir::Etc::sourceparts=-
         -o "Dir::State::lists=$sources/.apt" -o APT::Sandbox::User=root)
    "${apt[@]}" update >"$log" 2>&1 || { tail -n 3 "$log" >&2; exit 1; }
    for name in "${missing[@]}"; do
        echo "libraries.sh: fetching the source package of $name" >&2
        rm -rf "$sources/.new"
        mkdir "$sources/.new"
        (cd "$sources/.new" && "${apt[@]}" source "$name" >>"$log" 2>&1) ||
            { tail -n 3 "$log" >&2; echo "libraries.sh: no source package of $name (all of the output: $log)" >&2; exit 1; }
        mv "$sources"/.new/*/ "$sources/$name"
        rm -rf "$sources/.new"
    done
fi

# GSL asks the compiler for its config.h. It takes a browser for a 32-bit machine with IEEE arithmetic, which it is.
if [[ ! -f $sources/gsl/.configured ]]; then
    echo "libraries.sh: configuring GSL" >&2
    (
        cd "$sources/gsl"
        NODE_PATH=/usr/share/nodejs emconfigure ./configure --host=i686-pc-linux-gnu --disable-shared
        make -C gsl header-links
        touch .configured
    ) >>"$log" 2>&1 || { tail -n 5 "$log" >&2; exit 1; }
fi
