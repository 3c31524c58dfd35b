#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# within.sh SECONDS COMMAND...: runs the command. Its short form is ended after so many seconds and fails then; the whole
# form (ASHIMPACT_WHOLE) may take what ctest gives it.
seconds=$1
shift
[ -n "$ASHIMPACT_WHOLE" ] && exec "$@"
timeout --kill-after=10 "$seconds" "$@"
status=$?
[ $status -ne 124 ] || echo "ended: the short form may take $seconds s" >&2
exit $status
