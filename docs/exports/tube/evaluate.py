#!/usr/bin/env python3
"""Deposition on the tube by size and position, from what ashImpact recorded. Usage: evaluate.py WORK

Efficiency: particles stuck over particles that fly at the tube's projected area, of which there are the fraction of the
size distribution times half the diameter over the height of the jet. Writes size.dat and angle.dat. The run with a
constant restitution knows no sizes of what stuck; its log says how many did, which is none at any size."""
import csv
import glob
import math
import os
import re
import sys

WORK = sys.argv[1]
SMALLEST, LARGEST, SCALE, EXPONENT = 2e-6, 120e-6, 25e-6, 1.2   # constant/kinematicCloudProperties
INJECTED, JET = 100000, 0.707107                                # particles; height in diameters of the tube
BINS = 12


def below(diameter):
    """Fraction of the injected particles below a diameter, as OpenFOAM draws its Rosin-Rammler distribution."""
    tail = [1 - math.exp(-((d - SMALLEST) / SCALE) ** EXPONENT) for d in (diameter, LARGEST)]
    return tail[0] / tail[1]


def impacts(case):
    rows = []
    for path in sorted(glob.glob(os.path.join(WORK, case, "postProcessing/ashImpact/kinematicCloud/impacts_*.csv"))):
        with open(path) as file:
            for row in csv.DictReader(file):
                rows.append((float(row["time [s]"]), (row["origProc"], row["origId"]), float(row["diameter [m]"]),
                             float(row["restitution [1]"]), float(row["x [m]"]), float(row["y [m]"])))
    return sorted(rows)


def counted(values, edges):
    counts = [0] * (len(edges) - 1)
    for value in values:
        for i in range(len(counts)):
            if edges[i] <= value < edges[i + 1]:
                counts[i] += 1
    return counts


edges = [SMALLEST * (LARGEST / SMALLEST) ** (i / BINS) for i in range(BINS + 1)]
flying = [INJECTED * 0.5 / JET * (below(high) - below(low)) for low, high in zip(edges, edges[1:])]
angles = list(range(0, 95, 5))
results = {}
for case in ("ash", "mpi"):
    rows = impacts(case)
    hit = {row[1]: row for row in reversed(rows)}           # the first impact of each particle
    stuck = [row for row in rows if row[3] == 0]
    results[case] = (len(rows), len(hit), counted([row[2] for row in hit.values()], edges),
                     counted([row[2] for row in stuck], edges),
                     counted([math.degrees(math.atan2(row[5], -row[4])) for row in hit.values()], angles),
                     counted([math.degrees(math.atan2(row[5], -row[4])) for row in stuck], angles), len(stuck))
    print("%s: %d impacts of %d particles, %d stuck, %d of them at their first impact"
          % (case, len(rows), len(hit), len(stuck), sum(row[3] == 0 for row in hit.values())))
with open(os.path.join(WORK, "constant/log.parcels")) as file:
    kept = int(re.findall(r"mass\) tube\s+- escape[^\n]*\n\s+- stick\s+= (\d+)", file.read())[-1])
print("constant: %d stuck" % kept)
with open(os.path.join(WORK, "size.dat"), "w") as file:
    file.write("# d [um]   hit   stuck   stuck on 2 ranks   standard error   stuck at constant e\n")
    for i in range(BINS):
        stuck = results["ash"][3][i]
        file.write("%8.2f %8.4f %8.4f %8.4f %8.4f %8.4f\n"
                   % (1e6 * math.sqrt(edges[i] * edges[i + 1]), results["ash"][2][i] / flying[i], stuck / flying[i],
                      results["mpi"][3][i] / flying[i], math.sqrt(max(stuck, 1)) / flying[i], kept))
with open(os.path.join(WORK, "angle.dat"), "w") as file:
    file.write("# angle from the front [deg]   particles that hit   stuck   stuck on 2 ranks\n")
    for i in range(len(angles) - 1):
        file.write("%6.1f %8d %8d %8d\n" % (angles[i] + 2.5, results["ash"][4][i], results["ash"][5][i],
                                            results["mpi"][5][i]))
difference = abs(results["ash"][6] - results["mpi"][6]) / math.sqrt(results["ash"][6] + results["mpi"][6] + 1)
print("one process and two ranks differ by %.1f standard errors" % difference)
sys.exit(0 if results["ash"][6] > 0 and difference < 4 and kept == 0 else 1)
