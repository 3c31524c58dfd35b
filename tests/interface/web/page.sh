#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ashimpact.html in real browsers: page.sh PROGRAM, which makes the results it is compared with. Exits with 77, after saying
# why, where the page, the browser or the packages of npm are missing (`./dev deps web`); in CI that is a failure.
set -euo pipefail
program=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(readlink -f "$here/../../..")
modules=$root/build/browser

missing() {
    echo "SKIPPED: $1; ./dev deps web installs it" >&2
    [[ ! ${CI:-} || " ${ASHIMPACT_CANNOT_INSTALL:-} " == *" web "* ]] || exit 1
    exit 77
}
command -v node >/dev/null || missing "node is missing"
browser=$(command -v chromium || command -v chromium-browser) || missing "chromium is missing"
firefox=$(command -v firefox-esr || command -v firefox) || missing "firefox-esr is missing"
[[ -d $modules/node_modules/axe-core && -d $modules/node_modules/playwright-core ]] || missing "axe-core and playwright-core are missing"
page=$root/build/web/ashimpact.html
[[ -f $page ]] || missing "build/web is not built (./dev web builds it)"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
mkdir built-in
(cd built-in && "$program" run -q -o results >/dev/null)
"$program" init example >/dev/null
(cd example && "$program" run -q case.json -o results >/dev/null)
NODE_PATH=$modules/node_modules CHROMIUM=$browser FIREFOX=$firefox node "$here/page.test.cjs" "$page" "$work" "$program"
