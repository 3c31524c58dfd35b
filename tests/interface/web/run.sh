#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The program for pages against the program of this machine: run.sh PROGRAM. The reference impacts, the built-in case and
# init's example give the same results under node. Builds the page's program as `./dev web` does. Exits with 77, after saying why, where
# emscripten or node is missing (`./dev deps web`); in CI that is a failure.
set -euo pipefail
program=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(readlink -f "$here/../../..")

missing() {
    echo "SKIPPED: $1; ./dev deps web installs it" >&2
    [[ ! ${CI:-} || " ${ASHIMPACT_CANNOT_INSTALL:-} " == *" web "* ]] || exit 1
    exit 77
}
command -v em++ >/dev/null || missing "emscripten is missing"
command -v node >/dev/null || missing "node is missing"
module=$root/build/web/ashimpact.js
[[ -f $module ]] || missing "build/web is not built (./dev web builds it)"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir built-in
(cd built-in && "$program" run -q -o results >/dev/null)
"$program" init example >/dev/null
(cd example && "$program" run -q case.json -o results >/dev/null)
flags=()
node --no-experimental-fetch -e 0 2>/dev/null && flags=(--no-experimental-fetch)
agrees() { # MODULE DIRECT [CASE]
    node "${flags[@]}" "$here/agreement.test.cjs" "$1" "$work" "$program" "$2" "${3:-}"
}
agrees "$module" 1e-9 example
# In extended precision, where `./dev test web` has built it, the last digits are the same as well.
[[ ! -f $root/build/web-extended/ashimpact.js ]] || agrees "$root/build/web-extended/ashimpact.js" 1e-12
