#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ashimpact.html in real browsers, beside the results of the program of this machine: page.sh PROGRAM.
set -euo pipefail
# shellcheck source=tests/interface/web/with_results.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/with_results.sh" "$1"
modules=$root/build/browser
browser=$(command -v chromium || command -v chromium-browser) || missing "chromium is missing"
firefox=$(command -v firefox-esr || command -v firefox) || missing "firefox-esr is missing"
[[ -d $modules/node_modules/axe-core && -d $modules/node_modules/playwright-core ]] || missing "axe-core and playwright-core are missing"
page=$root/build/web/ashimpact.html
[[ -f $page ]] || missing "build/web is not built (./dev web builds it)"

with_results
NODE_PATH=$modules/node_modules CHROMIUM=$browser FIREFOX=$firefox node "$here/page.test.cjs" "$page" "$work" "$program"
