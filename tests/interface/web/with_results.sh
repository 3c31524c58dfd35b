# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced with PROGRAM as $1 by run.sh and page.sh: with_results leaves the built-in case and init's example, each with the results of
# the program of this machine, in the working folder. missing WHAT exits with 77, after saying why; in CI that is a failure.
program=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(readlink -f "$here/../../..")

missing() {
    echo "SKIPPED: $1; ./dev deps web installs it" >&2
    [[ ! ${CI:-} || " ${ASHIMPACT_CANNOT_INSTALL:-} " == *" web "* ]] || exit 1
    exit 77
}
command -v node >/dev/null || missing "node is missing"

with_results() {
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    cd "$work"
    mkdir built-in
    (cd built-in && "$program" run -q -o results >/dev/null)
    "$program" init example >/dev/null
    (cd example && "$program" run -q case.json -o results >/dev/null)
}
