#!/bin/sh
# Runs the impacts and compares them with expected.json.
set -e
cd "$(dirname "$0")"
@command@
python3 compare.py
