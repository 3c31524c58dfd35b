#!/usr/bin/env bash
# libraries.sh FOLDER: what the build for browsers takes from Debian, into FOLDER.
#   source/NAME    source packages of the libraries that have to be compiled for WebAssembly
#   include        links to the header-only libraries of this machine, so that nothing else of /usr/include is seen
# A folder source/NAME that is there already is taken as it is. Does nothing when all is there.
set -euo pipefail
mkdir -p "$1"
folder=$(readlink -f "$1")
names=(gsl zlib minizip nettle pugixml highway)
headers=(CLI fmt spdlog nlohmann valijson eigen3 boost fast_float)

sources=$folder/source
mkdir -p "$folder/apt/lists/partial" "$folder/include" "$sources"
log=$folder/libraries.log

for header in "${headers[@]}"; do
    [[ -d /usr/include/$header ]] || { echo "libraries.sh: /usr/include/$header is missing; ./dev deps web" >&2; exit 1; }
    ln -sfn "/usr/include/$header" "$folder/include/$header"
done

missing=()
for name in "${names[@]}"; do [[ -d $sources/$name ]] || missing+=("$name"); done
if ((${#missing[@]})); then
    # shellcheck source=/dev/null
    . /etc/os-release
    echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" >"$folder/apt/sources.list"
    # The list of sources is outside the folder of lists, in which apt-get update deletes every unknown file.
    apt=(apt-get -q -o "Dir::Etc::sourcelist=$folder/apt/sources.list" -o Dir::Etc::sourceparts=-
         -o "Dir::State::lists=$folder/apt/lists" -o APT::Sandbox::User=root)
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

# GSL's configure step uses the compiler to write config.h. It takes a browser for a 32-bit machine with IEEE arithmetic, which it is.
if [[ ! -f $sources/gsl/.configured ]]; then
    echo "libraries.sh: configuring GSL" >&2
    (
        cd "$sources/gsl"
        NODE_PATH=/usr/share/nodejs emconfigure ./configure --host=i686-pc-linux-gnu --disable-shared
        make -C gsl header-links
        touch .configured
    ) >>"$log" 2>&1 || { tail -n 5 "$log" >&2; exit 1; }
fi
