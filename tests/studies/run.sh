#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh CRITICAL_VELOCITY_STUDY FIT_STUDY: both with a few laboratories a row (a minute), or whole where
# ASHIMPACT_WHOLE is set: 200 a row, its value if that is above 1 (an hour and a half on two cores).
set -eu
whole=${ASHIMPACT_WHOLE:-0}
seed=20261211
if [ "$whole" = 0 ]; then
    "$1" 8
    "$2" 5
    exit
fi
[ "$whole" -gt 1 ] || whole=200
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
{ /usr/bin/python3 "$(dirname "$0")/truths.py" "$folder" "$whole" "$seed" && "$1" files "$folder"; } >"$folder/stranger" 2>&1 &
stranger=$!
"$1" "$whole" "" "" "$seed" || status=1
"$2" "$whole" || status=1
wait "$stranger" || status=1
cat "$folder/stranger"
exit $status
