#!/usr/bin/env python3
"""Compares ash_wall, compiled against the stand-in for udf.h, with expected.json; asks it beyond its table, too.
Exit status 0: all agree, 1: some do not."""
import json
import os
import subprocess
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))


def asked(particles):
    text = "".join("%.17g %.17g\n" % particle for particle in particles)
    answer = subprocess.run([os.path.join(FOLDER, "stand_in/check")], input=text, stdout=subprocess.PIPE, check=True,
                            universal_newlines=True)
    rows = [line.split() for line in answer.stdout.splitlines() if not line.startswith("ash_wall")]
    return [float(row[2]) for row in rows]


def main():
    with open(os.path.join(FOLDER, "expected.json")) as file:
        expected = json.load(file)
    impacts = [(i["diameter"]["value"], i["velocity"]["value"], i["outcome"], i["restitution"]["value"])
               for i in expected["impacts"]]
    failures = 0
    print("   d [um]     v [m/s]   outcome      e expected    e of ash_wall   difference")
    for (d, v, outcome, e), found in zip(impacts, asked([impact[:2] for impact in impacts])):
        agrees = found >= 0 and (found > 0) == (outcome == "rebound") and abs(found - e) <= expected["tolerance"]
        failures += not agrees
        print("%9.4g %11.6g   %-8s %13.9f %16.9f   %10.1e%s"
              % (1e6 * d, v, outcome, e, found, found - e, "" if agrees else "   differs"))
    d, v = impacts[0][:2]
    for particle in ((100 * max(i[0] for i in impacts), v), (d, 1e9)):
        if asked([particle]) != [-1.0]:
            failures += 1
            print("a particle of %g m at %g m/s is not refused" % particle)
    print("%d of %d impacts agree within %g; beyond the table it refuses"
          % (len(impacts) - failures, len(impacts), expected["tolerance"]))
    return 1 if failures or not impacts else 0


if __name__ == "__main__":
    sys.exit(main())
