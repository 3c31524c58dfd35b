#!/bin/sh
# Compiles ash_wall.c against the stand-in for udf.h (not Fluent), sends it the particles of expected.json, compares.
set -e
cd "$(dirname "$0")"
${CC:-cc} -std=c99 -O2 -Wall -Wextra -Wno-unused-parameter -Istand_in -I. ash_wall.c stand_in/check.c -o stand_in/check -lm
python3 compare.py
