# SPDX-License-Identifier: GPL-3.0-or-later
# For tests that are scripts: `leave_out WHAT` ends a test that cannot be done, saying what is missing. Exit status 77 is a
# test that was skipped; in CI it fails instead, unless ./dev could not install what is missing.
# shellcheck shell=bash
leave_out() {
    echo "left out: $1"
    [[ ${CI:-} && -z ${ASHIMPACT_CANNOT_INSTALL:-} ]] && exit 1
    exit 77
}
