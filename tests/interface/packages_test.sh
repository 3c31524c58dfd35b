#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# packages_test.sh BUILD: the Debian packages, as lintian sees them and as they install into an empty Debian tree.
# Whole (ASHIMPACT_WHOLE): the source archive is built too, in a folder without git.
set -euo pipefail
build=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(readlink -f "$here/../..")
scratch=$(mktemp -d)
trap 'rm -rf --one-file-system "$scratch"' EXIT

# shellcheck source=tests/leave_out.sh
source "$here/../leave_out.sh"
for tool in dpkg-buildpackage lintian debootstrap; do
    command -v "$tool" >/dev/null || leave_out "there is no $tool (./dev deps packages)"
done
((EUID == 0)) || leave_out 'only root can make an empty Debian tree'

echo '== packages'
"$root/packaging/build" "$scratch/package" "$build"
for name in ashimpact libashimpact1 libashimpact-dev python3-ashimpact ashimpact-doc; do
    compgen -G "$scratch/package/${name}_*.deb" >/dev/null || { echo "failed: no package $name"; exit 1; }
done
echo '== lintian'
lintian --allow-root --fail-on error "$scratch"/package/*.changes

if [[ ${ASHIMPACT_WHOLE:-} ]]; then
    echo '== the source archive'
    mkdir "$scratch/source"
    tar -xzf "$scratch"/package/ashimpact-*.tar.gz -C "$scratch/source" --strip-components=1
    [[ ! -e $scratch/source/.git ]]
    (cd "$scratch/source" && GIT_CEILING_DIRECTORIES=$scratch ./dev build && build/release/ashimpact --version)
    rm -rf "$scratch/source"
fi

echo '== an empty Debian tree'
tree=$scratch/tree
codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
# shellcheck disable=SC2016  # apt-get's own placeholders
mirror=$(apt-get indextargets --format '$(REPO_URI)' "Codename: $codename" | head -1)
debootstrap --variant=minbase "$codename" "$tree" "${mirror:-http://deb.debian.org/debian}" >"$scratch/log" 2>&1 ||
    { tail -5 "$scratch/log"; leave_out "debootstrap of $codename from ${mirror:-deb.debian.org} failed"; }
cp /etc/resolv.conf "$tree/etc/" 2>/dev/null || true
mkdir -p "$tree/etc/apt/apt.conf.d" "$tree/packages" "$tree/consumers"
apt-config dump | grep -iE '^Acquire::(http|https)::Proxy ' >"$tree/etc/apt/apt.conf.d/99proxy" || true
cp "$scratch"/package/*.deb "$tree/packages/"
cp -r "$here"/consumers/* "$here/c89_test.c" "$tree/consumers/"

# Runs a command in the tree; its mounts and processes end with it.
inside() {
    unshare --mount --pid --fork --kill-child --mount-proc="$tree/proc" \
        chroot "$tree" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
}
apt_inside() { inside apt-get -q -y -o APT::Install-Recommends=false "$@" >"$scratch/log" 2>&1 || { tail -20 "$scratch/log"; exit 1; }; }
our=(ashimpact libashimpact1 libashimpact-dev python3-ashimpact ashimpact-doc)
files() {  # of the tree, but those that apt and dpkg keep for themselves
    (cd "$tree" && find . -xdev \( -path ./proc -o -path ./tmp -o -path ./var/lib/apt -o -path ./var/lib/dpkg \
        -o -path ./var/cache -o -path ./var/log -o -path ./packages -o -path ./consumers \) -prune -o -print | sort)
}

apt_inside update
apt_inside install g++ cmake make pkg-config libfmt-dev libgsl-dev libhwy-dev libminizip-dev libpugixml-dev libtbb-dev
inside sh -c 'apt-get -q -y --no-install-recommends install /packages/*.deb' >"$scratch/log" 2>&1 ||
    { tail -20 "$scratch/log"; exit 1; }
apt_inside purge "${our[@]}"
files >"$scratch/before"  # what they depend on is there, they are not
if grep ashimpact "$scratch/before"; then
    echo 'failed: the packages leave these files behind'
    exit 1
fi
inside sh -c 'apt-get -q -y --no-install-recommends install /packages/*.deb' >"$scratch/log" 2>&1 ||
    { tail -20 "$scratch/log"; exit 1; }

echo '== used'
inside ashimpact --version
inside ashimpact run -o /tmp/run 2>&1 | tail -3
[[ -s $tree/tmp/run/comparison.json && -s $tree/tmp/run/report.html ]]
inside python3 -c '
import ashimpact
ash = dict(law="jkr", radius=22e-6, density=2160.0, contact_modulus=60e9, work_of_adhesion=0.3, damping=1e-5)
v = ashimpact.critical_velocities(**ash).critical_velocity
assert ashimpact.impacts(velocity=0.9 * v, **ash).captured and not ashimpact.impacts(velocity=1.1 * v, **ash).captured
assert "comparison" in ashimpact.run()
print("v_c =", v)'
inside sh -c 'cd /tmp && cp -r /consumers . && sed -i s,\.\./\.\./c89_test.c,../c89_test.c, consumers/cmake/CMakeLists.txt &&
    cmake -S consumers/cmake -B b >log 2>&1 && cmake --build b >>log 2>&1 || { cat log; exit 1; }
    ./b/deposit && ./b/deposit_static && ./b/c_program &&
    g++ -std=c++17 consumers/deposit.cpp -o c $(pkg-config --cflags --libs ashimpact) && ./c'
for page in usr/share/man/man1/ashimpact.1.gz usr/share/bash-completion/completions/ashimpact \
    usr/share/zsh/vendor-completions/_ashimpact usr/share/doc/ashimpact/html/index.html; do
    [[ -s $tree/$page ]] || { echo "failed: no $page"; exit 1; }
done
python3 "$root/tests/interface/installed_pages_test.py" --below "$tree/usr/share/doc/ashimpact"

echo '== removed'
apt_inside purge "${our[@]}"
files | diff "$scratch/before" - || { echo 'failed: files differ from before the packages were installed'; exit 1; }
echo 'installed, used and removed without a rest'
