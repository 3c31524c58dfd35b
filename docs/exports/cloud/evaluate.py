#!/usr/bin/env python3
"""Captured fraction by size in LAMMPS's cloud, beside v_c(d) of the exported table. Usage: evaluate.py WORK

Exit status 0: every particle stays or leaves as the table says, but for those within 0.1 % of their v_c, where the time
step of the cloud decides."""
import math
import os
import sys

WORK = sys.argv[1]
sys.path.insert(0, os.path.join(WORK, "table"))
import ash_table  # noqa: E402

BINS = 14
rows = []
with open(os.path.join(WORK, "lammps/cloud.csv")) as file:
    for line in file:
        words = line.split()
        if len(words) == 5 and words[0].isdigit():
            rows.append([float(word) for word in words[1:]])
low, high = ash_table.DIAMETERS[0], ash_table.DIAMETERS[-1]
counts = [[0, 0, 0.0] for _ in range(BINS)]
wrong, close, worst = 0, 0, 0.0
for diameter, velocity, height, speed in rows:
    diameter = min(max(diameter, low), high)
    critical = ash_table.start_velocity(diameter)
    stays = height < diameter / 2
    if stays != (velocity < critical):
        near = abs(velocity / critical - 1)
        worst = max(worst, near)
        close += near < 1e-3
        wrong += near >= 1e-3
    i = min(int(BINS * math.log(diameter / low) / math.log(high / low)), BINS - 1)
    counts[i][0] += 1
    counts[i][1] += stays
    counts[i][2] += velocity < critical
with open(os.path.join(WORK, "cloud.dat"), "w") as file:
    file.write("# d [um]   particles   captured in LAMMPS   captured by ashimpact\n")
    for i, (number, stayed, predicted) in enumerate(counts):
        if number:
            file.write("%8.2f %8d %10.6f %10.6f\n" % (1e6 * low * (high / low) ** ((i + 0.5) / BINS), number,
                                                     stayed / number, predicted / number))
print("%d particles, %.4f captured in LAMMPS, %.4f by ashimpact"
      % (len(rows), sum(c[1] for c in counts) / len(rows), sum(c[2] for c in counts) / len(rows)))
print("%d within 0.1 %% of their v_c and %d others differ; the furthest by %.2g of v_c" % (close, wrong, worst))
sys.exit(1 if wrong or not rows else 0)
