#!/usr/bin/env python3
"""Captured fraction by size in LAMMPS's cloud, beside sweeps of ashimpact and v_c(d) of the exported table.
Usage: evaluate.py WORK ASHIMPACT

Exit status 0: every particle stays or leaves as the table says, but for those within 0.1 % of their v_c, where the time
step of the cloud decides; and the fraction of each size is that of a sweep within what chance allows."""
import json
import math
import os
import subprocess
import sys

WORK, ASHIMPACT = sys.argv[1:3]
# As in run.sh: the damping goes with (diameter/88 um)^1.5, velocities are uniform.
IMPACT = {"laws": ["dmt"], "density": 2179.5, "contact_modulus": 89e9, "work_of_adhesion": 0.3}
DAMPING, REFERENCE, EXPONENT, VELOCITIES = 0.0151, 88e-6, 1.5, (0.001, 5)
sys.path.insert(0, os.path.join(WORK, "table"))
import ash_table  # noqa: E402

BINS = 14
CHANCE, WIDTH = 4.5, 2e-3   # standard errors; what the sizes of one bin may make of the fraction, which is no line


def swept(diameter):
    """Captured fraction of that size by `ashimpact sweep`."""
    spec = {"impact": dict(IMPACT, radius=diameter / 2, damping=DAMPING * (diameter / REFERENCE) ** EXPONENT),
            "variables": {"velocity": {"distribution": "uniform", "from": VELOCITIES[0], "to": VELOCITIES[1]}},
            "sampling": {"method": "quasi-random", "samples": 16384, "seed": 1}}
    with open(os.path.join(WORK, "sweep-spec.json"), "w") as file:
        json.dump(spec, file)
    result = os.path.join(WORK, "sweep.json")
    subprocess.run([ASHIMPACT, "-q", "sweep", file.name, "-o", result, "--no-report"], check=True,
                   stdout=subprocess.DEVNULL)
    with open(result) as file:
        return json.load(file)["result"]["laws"][0]["capture_fraction"]["value"]


rows = []
with open(os.path.join(WORK, "lammps/cloud.csv")) as file:
    for line in file:
        words = line.split()
        if len(words) == 5 and words[0].isdigit():
            rows.append([float(word) for word in words[1:]])
low, high = ash_table.DIAMETERS[0], ash_table.DIAMETERS[-1]
counts = [[0, 0, 0.0] for _ in range(BINS)]     # particles, stayed, sum of their diameters
wrong, close, worst, predicted, furthest = 0, 0, 0.0, 0, 0.0
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
    counts[i][2] += diameter
    predicted += velocity < critical
with open(os.path.join(WORK, "cloud.dat"), "w") as file:
    file.write("# mean d [um]   particles   captured in LAMMPS   captured by a sweep\n")
    for number, stayed, diameters in counts:
        if not number:
            continue
        mean = diameters / number
        fraction = swept(mean)
        allowed = CHANCE * math.sqrt(max(fraction * (1 - fraction), 1 / number) / number) + WIDTH
        furthest = max(furthest, abs(stayed / number - fraction) / allowed)
        file.write("%8.2f %8d %10.6f %10.6f\n" % (1e6 * mean, number, stayed / number, fraction))
print("%d particles, %.4f captured in LAMMPS, %.4f by v_c of each"
      % (len(rows), sum(c[1] for c in counts) / len(rows), predicted / len(rows)))
print("%d within 0.1 %% of their v_c and %d others differ; the furthest by %.2g of v_c" % (close, wrong, worst))
print("fractions by size are at most %.2f of what chance allows away from those of sweeps" % furthest)
sys.exit(1 if wrong or furthest > 1 or not rows else 0)
