#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# install_test.sh BUILD: installs libashimpact into a scratch folder, moves it, and builds users' programs against it
# by CMake and by pkg-config, shared and static.
set -euo pipefail
build=$1
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

for component in library development; do
    cmake --install "$build" --prefix "$scratch/first" --component "$component" >/dev/null
done
mv "$scratch/first" "$scratch/moved"  # nothing that is installed may know where it was
prefix=$scratch/moved

echo '== only what is public'
(cd "$prefix" && find include -type f | sort) | tee "$scratch/headers"
printf '%s\n' include/ashimpact.h include/ashimpact/error.hpp include/ashimpact/model.hpp include/ashimpact/results.hpp | cmp - "$scratch/headers"
library=$(find "$prefix" -name 'libashimpact.so.1')
nm -D --defined-only "$library" | awk '{print $3}' | sort >"$scratch/symbols"
grep -o '^ashimpact_[a-z_]*(' <(sed 's/ *\*\{0,1\}\(ashimpact_[a-z_]*(\)/\n\1/g' "$prefix/include/ashimpact.h") |
    tr -d '(' | sort -u | sed 's/$/@@ASHIMPACT_1/' >"$scratch/declared"
grep '@@' "$scratch/symbols" | diff - "$scratch/declared" # as many functions as the header declares, each with its version
if grep -v '@@ASHIMPACT_1$' "$scratch/symbols" | grep -v '^ASHIMPACT_1$'; then
    echo 'symbols without a version are visible'
    exit 1
fi

echo '== by CMake'
cmake -S "$here/consumers/cmake" -B "$scratch/cmake" -DCMAKE_PREFIX_PATH="$prefix" >"$scratch/log" 2>&1 ||
    { cat "$scratch/log"; exit 1; }
cmake --build "$scratch/cmake" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
for program in deposit deposit_static c_program; do "$scratch/cmake/$program"; done

echo '== by pkg-config'
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name ashimpact.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046  # words
g++ -std=c++17 -Wall -Wextra -Wpedantic -Werror "$here/consumers/deposit.cpp" -o "$scratch/deposit" \
    $(pkg-config --cflags --libs ashimpact)
LD_LIBRARY_PATH=$(dirname "$library") "$scratch/deposit"
# shellcheck disable=SC2046
gcc -std=c89 -pedantic -Wall -Werror "$here/c89_test.c" -o "$scratch/c89" $(pkg-config --cflags --libs ashimpact)
LD_LIBRARY_PATH=$(dirname "$library") "$scratch/c89"
echo '== by pkg-config, static'
# Debian has no static libraries of all that it needs: these are the shared ones, ashimpact itself is not.
# shellcheck disable=SC2046
g++ -std=c++17 "$here/consumers/deposit.cpp" -o "$scratch/deposit_static" $(pkg-config --cflags ashimpact) \
    -Wl,-Bstatic -L"$(pkg-config --variable=libdir ashimpact)" -lashimpact -Wl,-Bdynamic \
    $(pkg-config --static --libs-only-l ashimpact | sed 's/-lashimpact//')
if readelf -d "$scratch/deposit_static" | grep libashimpact; then
    echo 'a static program needs the shared library'
    exit 1
fi
"$scratch/deposit_static"
[[ $(pkg-config --modversion ashimpact) == "$(sed -n 's/^Version: //p' "$PKG_CONFIG_PATH/ashimpact.pc")" ]]
echo '== the program of the how-to page'
sed -n '/^```c$/,/^```$/p' "$here/../../docs/how-to/flow-codes.md" | sed '/^```/d' >"$scratch/stick.c"
# shellcheck disable=SC2046
gcc "$scratch/stick.c" -o "$scratch/stick" $(pkg-config --cflags --libs ashimpact)
LD_LIBRARY_PATH=$(dirname "$library") "$scratch/stick" | grep -E '^v_c = [0-9.e-]+ m/s, e\(2 v_c\) = 0\.[0-9]+$'
echo 'all consumers built and ran'
