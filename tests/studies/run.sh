#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh CRITICAL_VELOCITY_STUDY FIT_STUDY: both with a few laboratories a row (a minute), or whole where
# ASHIMPACT_WHOLE is set (two hours on one core).
set -eu
if [ -n "${ASHIMPACT_WHOLE:-}" ]; then
    "$1" 1000
    "$2" 200
else
    "$1" quick 8
    "$2" 5
fi
