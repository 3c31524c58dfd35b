#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The report in a real browser: run.sh PROGRAM. Exits with 77, after saying why, where the browser or the packages of npm
# are missing (`./dev deps report`); in CI that is a failure.
set -euo pipefail
program=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(readlink -f "$here/../../../..")
modules=$root/build/browser

missing() {
    echo "SKIPPED: $1; ./dev deps report installs it" >&2
    [[ ! ${CI:-} ]] || exit 1
    exit 77
}
command -v node >/dev/null || missing "node is missing"
browser=$(command -v chromium || command -v chromium-browser) || missing "chromium is missing"
[[ -d $modules/node_modules/axe-core && -d $modules/node_modules/playwright-core ]] || missing "axe-core and playwright-core are missing"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$program" run -o paper >/dev/null
"$program" init example >/dev/null
"$program" run example/case.json -o example/results >/dev/null
"$program" report paper example/results -o both.html >/dev/null
cp "$here/sweep.json" spec.json
"$program" sweep spec.json -o sweep.json >/dev/null
cp "$here/hostile.json" hostile.json
"$program" run hostile.json -o hostile >/dev/null
NODE_PATH=$modules/node_modules CHROMIUM=$browser node "$here/report.test.cjs" "$work"
