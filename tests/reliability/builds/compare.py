#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether builds of the program agree: `ashimpact run` of the built-in case by each of them, every number of every artifact.

    compare.py PROGRAM OTHER...      to 1e-12 of the number, or of the greatest of its list; all else has to be the same

Without a second one that exists it ends with 77, a test that was left out; in CI that is a failure.
Shares of a variance ("influences") are parts of 1, and differences of nearly equal numbers: they are compared to 1e-12 of 1.
So are the Monte Carlo errors of an interval's ends, whose terms are velocities: they are compared to 1e-12 of the median.
Points of the drawn curves are where a search ends, which stops at 1e-5 of restitution: they are compared to 1e-9.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

MOST = 1e-12
MOST_OF_CURVES = 1e-9
# What names a build, and hashes and sizes of what is compared itself.
COUNTED = ("sha256", "result_sha256", "run", "revision", "intervals", "inputs", "bytes")


def artifacts_of(program, folder):
    subprocess.run([program, "run", "-o", folder, "--no-report"], check=True, capture_output=True)
    return {path.name: json.loads(path.read_text()) for path in sorted(pathlib.Path(folder).glob("*.json"))}


def differences(one, other, place, scale, found):
    """Appends (relative difference, place) of every number; other kinds of differences as infinite ones."""
    if isinstance(one, bool) or isinstance(other, bool) or not (
            isinstance(one, (int, float)) and isinstance(other, (int, float))):
        if isinstance(one, dict) and isinstance(other, dict) and one.keys() == other.keys():
            for key in one:
                if key not in COUNTED:
                    differences(one[key], other[key], f"{place}/{key}", scale_of(key, one, place, scale), found)
        elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
            numbers = [abs(each) for each in one if isinstance(each, (int, float))]
            for index, (left, right) in enumerate(zip(one, other)):
                differences(left, right, f"{place}/{index}", max(numbers, default=0.0), found)
        elif one != other:
            found.append((float("inf"), place))
        return
    size = max(abs(one), abs(other), scale)
    found.append((abs(one - other) / size if size else 0.0, place))


def scale_of(key, entries, place, scale):
    if "/influences/" in place:
        return 1.0
    if key in ("lower_error", "upper_error"):
        return abs(entries["median"]["value"])
    return scale if place.endswith("_error") else 0.0


def main():
    programs = sys.argv[1:]
    if len(programs) < 2:
        sys.exit(__doc__)
    missing = [each for each in programs if not pathlib.Path(each).exists()]
    if missing:
        print(f"left out: {', '.join(missing)} was not built")
        return 1 if os.environ.get("CI") else 77
    with tempfile.TemporaryDirectory() as folder:
        results = [artifacts_of(program, f"{folder}/{index}") for index, program in enumerate(programs)]
    status = 0
    for program, artifacts in zip(programs[1:], results[1:]):
        found = []
        differences(results[0], artifacts, "", 0.0, found)
        greatest, place = max(found)
        beyond = sorted((each for each in found if each[0] > (MOST_OF_CURVES if "/curves/" in each[1] else MOST)), reverse=True)
        print(f"{program}: {len(found)} numbers, greatest relative difference {greatest:.2g} at {place}; "
              f"{len(beyond)} beyond {MOST:g}")
        for difference, where in beyond[:20]:
            print(f"  {difference:.2g} at {where}")
        status |= bool(beyond)
    return status


if __name__ == "__main__":
    sys.exit(main())
