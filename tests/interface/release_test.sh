#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# release_test.sh: packaging/release changes the version everywhere, once.
set -euo pipefail
root=$(dirname "$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "failed: $1"; exit 1; }

mkdir "$scratch/packaging" "$scratch/debian"
cp -r "$root"/packaging/{release,recipes} "$scratch/packaging/"
cp "$root/debian/changelog" "$scratch/debian/"
cp "$root/CMakeLists.txt" "$root/CITATION.cff" "$root/CHANGELOG.md" "$scratch/"
cd "$scratch"
for wrong in '' 1.0 v1.0.0 '1.0.0-rc1'; do
    if packaging/release "$wrong" 2>/dev/null; then fail "version '$wrong' was taken"; fi
done
diff -q CITATION.cff "$root/CITATION.cff" || fail 'a refused version changed a file'

for version in 97.0.0 97.1.0; do
    packaging/release "$version"
    grep -q "^project(ashimpact VERSION $version " CMakeLists.txt || fail "CMakeLists.txt is not at $version"
    [[ $(grep -c '^version: ' CITATION.cff) == 1 && $(grep -c '^date-released: ' CITATION.cff) == 1 ]] || fail 'CITATION.cff'
    grep -qx "version: $version" CITATION.cff || fail "CITATION.cff is not at $version"
    for recipe in packaging/recipes/*/*.*; do
        [[ $(diff "$root/$recipe" "$recipe" | grep '^>' | grep -cF "$version") -ge 1 ]] || fail "$recipe"
    done
    [[ $(head -1 debian/changelog) == "ashimpact ($version) unstable; urgency=medium" ]] || fail 'debian/changelog'
    [[ $(grep '^## ' CHANGELOG.md | head -2) == '## [Unreleased]'*"[$version] - "* ]] || fail 'CHANGELOG.md'
done
tail -n "$(wc -l <"$root/debian/changelog")" debian/changelog | diff - "$root/debian/changelog" || fail 'older entries changed'
if packaging/release 97.1.0 2>/dev/null; then fail 'the same version was released again'; fi
if command -v dpkg-parsechangelog >/dev/null; then
    [[ $(dpkg-parsechangelog -S Version 2>&1) == 97.1.0 ]] || fail 'debian/changelog cannot be read'
fi
echo 'one version in every file'
