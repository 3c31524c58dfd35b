#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The program for pages against the program of this machine: run.sh PROGRAM. The reference impacts, the built-in case and
# init's example give the same results under node, by the page's program that `./dev web` builds.
set -euo pipefail
# shellcheck source=tests/interface/web/with_results.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/with_results.sh" "$1"
command -v em++ >/dev/null || missing "emscripten is missing"
module=$root/build/web/ashimpact.js
[[ -f $module ]] || missing "build/web is not built (./dev web builds it)"

with_results
flags=()
node --no-experimental-fetch -e 0 2>/dev/null && flags=(--no-experimental-fetch)
agrees() { # MODULE DIRECT [CASE]
    node "${flags[@]}" "$here/agreement.test.cjs" "$1" "$work" "$program" "$2" "${3:-}"
}
agrees "$module" 1e-9 example
# In extended precision, where `./dev test web` has built it, the last digits are the same as well.
[[ ! -f $root/build/web-extended/ashimpact.js ]] || agrees "$root/build/web-extended/ashimpact.js" 1e-12
