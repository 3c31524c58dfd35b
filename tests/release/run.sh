#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh BUILD: what dist holds (./dev release): the tarball in a folder that has busybox and nothing else and in Debian 11 and 13,
# the package of npm in an empty prefix, both without a network, the exported model of OpenFOAM; all of it made twice.
set -euo pipefail
build=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(readlink -f "$here/../..")
# shellcheck source=tests/leave_out.sh
source "$here/../leave_out.sh"
[[ -f $root/dist/SHA256SUMS ]] || leave_out 'there is no dist (./dev release)'
((EUID == 0)) || leave_out 'only root can change into an empty folder'
version=$(sed -n 's/^project(ashimpact VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
scratch=$(mktemp -d)
trap 'rm -rf --one-file-system "$scratch"' EXIT

echo '== checksums and the page'
(cd "$root/dist" && sha256sum --quiet -c SHA256SUMS)
for file in $(grep -o 'href="[^"]*"' "$root/dist/index.html" | cut -d'"' -f2); do [[ -s $root/dist/$file ]]; done

echo '== results of the program of this machine'
mkdir "$scratch/native"
(cd "$scratch/native" && "$build/ashimpact" run -q -o built-in >/dev/null && "$build/ashimpact" init example >/dev/null &&
    "$build/ashimpact" run -q example/case.json -o example/results >/dev/null)

# inside TREE COMMAND...: in a tree of its own, with /proc, without a network.
inside() {
    mkdir -p "$1/proc"
    unshare --mount --net --pid --fork --kill-child --mount-proc="$1/proc" \
        chroot "$1" "${starter[@]}" HOME=/ PATH=/bin:/usr/bin "${@:2}"
}
tarball() { # TREE: the tarball works there and gives the same bytes
    local top
    tar -xzf "$root"/dist/ashimpact-*-linux-x86_64.tar.gz -C "$1"
    top=/$(basename "$1"/ashimpact-*)
    mkdir -p "$1/out"
    cp -r "$scratch/native/example" "$1/example"
    mount --bind "$1$top" "$1$top"
    mount -o remount,bind,ro "$1$top"
    inside "$1" "$top/bin/ashimpact" run -q -o /out/built-in >/dev/null
    inside "$1" "$top/bin/ashimpact" run -q /example/case.json -o /out/example >/dev/null
    inside "$1" "$top/bin/ashimpact" sweep /sweep.json -o /out/sweep.json >/dev/null
    [[ -s $1/out/sweep.json ]]
    inside "$1" "$top/bin/ashimpact-python" -c 'import ashimpact, numpy
v = ashimpact.critical_velocities(law="jkr", radius=22e-6, density=2160.0, contact_modulus=60e9, work_of_adhesion=numpy.full(3, 0.3), damping=1e-5)
print("Python:", v.critical_velocity)'
    umount "$1$top"
    node "$here/same.cjs" "$scratch/native/built-in" "$1/out/built-in"
    node "$here/same.cjs" "$scratch/native/example/results" "$1/out/example"
}
example_sweep() { sed -n '/^```json$/,/^```$/{/^`/d;p}' "$root/docs/sweep.md" | sed '/^}$/q' >"$1/sweep.json"; }

echo '== tarball, beside a static busybox'
tree=$scratch/empty starter=(/bin/busybox env -i)
mkdir -p "$tree/bin"
cp /bin/busybox "$tree/bin/"
for name in sh dirname readlink; do ln -s busybox "$tree/bin/$name"; done
example_sweep "$tree"
tarball "$tree"

for suite in bullseye trixie; do  # Debian 11, with glibc 2.31 and Python 3.9, and 13, with Python 3.13
    echo "== tarball, Debian $suite"
    tree=$scratch/$suite starter=(/usr/bin/env -i)
    if ! debootstrap --variant=minbase --include=python3,python3-numpy "$suite" "$tree" http://deb.debian.org/debian >"$scratch/log" 2>&1; then
        tail -n 3 "$scratch/log"
        echo "not run: $suite is not to be had here"
        continue
    fi
    example_sweep "$tree"
    tarball "$tree"
    # Library and module in a process of that system; a Python that the module is not built for is refused in one line.
    inside "$tree" python3 -c 'import ctypes, glob, importlib.machinery, sys
prefix = glob.glob("/ashimpact-*")[0]
library = ctypes.CDLL(prefix + "/lib/libashimpact.so.1")
error = ctypes.create_string_buffer(512)
assert library.ashimpact_open(b"none", None, None, None, 0, ctypes.byref(ctypes.c_void_p()), error) == 2
print("library:", error.value.decode())
sys.path.insert(0, prefix + "/python")
if glob.glob(prefix + "/python/ashimpact/_core" + importlib.machinery.EXTENSION_SUFFIXES[0]):
    import ashimpact, numpy
    v = ashimpact.critical_velocities(law="jkr", radius=22e-6, density=2160.0, contact_modulus=60e9, work_of_adhesion=numpy.full(3, 0.3), damping=1e-5)
    print(f"Python {sys.version_info[:2]}:", v.critical_velocity, len(ashimpact.run()), "artifacts")
else:
    try: import ashimpact
    except ImportError as error:
        print(error)
        assert str(error).endswith(f", not for {sys.version_info[0]}.{sys.version_info[1]}")
    else: raise AssertionError("imported")'
done

echo '== package of npm'
offline() { unshare --net -- env HOME="$scratch" npm_config_cache="$scratch/.npm" "$@"; }
offline npm install --silent --offline --no-audit --global --prefix "$scratch/prefix" "$root/dist/ashimpact-$version.tgz"
mkdir "$scratch/npm"
cp -r "$scratch/native/example" "$scratch/npm/"
rm -r "$scratch/npm/example/results"
cd "$scratch/npm"
offline "$scratch/prefix/bin/ashimpact" run -q -o built-in >/dev/null
offline "$scratch/prefix/bin/ashimpact" run -q example/case.json -o example/results >/dev/null
offline node "$here/npm.cjs" "$build/ashimpact" "$scratch/prefix" "$scratch/native" "$scratch/npm"

echo '== OpenFOAM'
"$here/openfoam_headers.sh" "$build/ashimpact" "$scratch/native/built-in"

echo '== made again'
"$root/packaging/dist/build" "$scratch/again" "$build" "$root/build/web" >/dev/null
diff "$root/dist/SHA256SUMS" "$scratch/again/SHA256SUMS"
echo 'all that is handed out works'
