#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh CRITICAL_VELOCITY_STUDY FIT_STUDY: both with a few laboratories a row (a minute), or whole where
# ASHIMPACT_WHOLE is set: 200 a row, its value if that is above 1 (four hours on one core).
set -eu
whole=${ASHIMPACT_WHOLE:-0}
if [ "$whole" = 0 ]; then
    "$1" quick 8
    "$2" 5
    exit
fi
[ "$whole" -gt 1 ] || whole=200
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
"$1" "$whole" || status=1
python3 "$(dirname "$0")/truths.py" "$folder" "$whole"
"$1" files "$folder" || status=1
"$2" "$whole" || status=1
exit $status
