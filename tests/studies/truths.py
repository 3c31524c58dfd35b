# SPDX-License-Identifier: GPL-3.0-or-later
"""Laboratories for the study of v_c, from the list of someone who had not seen the estimator: truths.py FOLDER [REPETITIONS [SEED]]
writes the impacts of each as recorded, and FOLDER/truths.csv with their true v_c. No uncertainty is stated.

v_c is the normal velocity at which a median particle has e = 0, or at which half of the particles are captured if they differ.
It is drawn anew in each laboratory, as are ends of ranges and shapes. Inside, velocities are in units of it. What a row can tell:
interval  the impacts bracket v_c
wide      a right interval exists and is wide
bound     only one side is sure
warn      nothing in the impacts fixes v_c: the right answer is a warning
system    told up to a factor alt that the table does not show; between v_c and alt v_c counts as right
"""
import csv
import math
import os
import sys
from collections import namedtuple

import numpy as np

Kind = namedtuple("Kind", "curve scatter weight ratio spread", defaults=(0.0, 1.0, 1.0, 0.0))   # scatter of ln v_c, spread of ln e


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


# Restitution over u = v/v_c > 1: make(curve, range of each of its parameters)(rng) draws one.
def make(curve, *ranges):
    def drawn(rng):
        values = [rng.uniform(*r) for r in ranges]
        return lambda u: curve(u, *values)
    return drawn


def one_of(*curves):
    return lambda rng: curves[rng.integers(len(curves))](rng)


def power_law(u, e, p, q=1):
    return e * (1 - u ** -p) ** q


def quarter_law(u, e):
    return e * u ** -0.25 * np.sqrt(1 - u ** -2.0)


def plastic_law(u, y):
    """Thornton & Ning 1998, yield at y v_c, with adhesion"""
    x = np.minimum(y / u, 1.0)
    return (math.sqrt(6 * math.sqrt(3) / 5) * np.sqrt(1 - x * x / 6) * (x / (x + 2 * np.sqrt(1.2 - 0.2 * x * x))) ** 0.25
            * np.sqrt(1 - u ** -2.0))


def kink_law(u, e, k, q, slope):
    rise = e * (np.maximum(u - 1, 0) / (k - 1)) ** q
    return np.where(u < k, rise, np.clip(e + slope * np.log(u / k), 0.05, 0.97))


def onset_law(u, e, w, q):
    return e * (1 - np.exp(-(u - 1) / w)) ** q


def viscoelastic_law(u, c):
    return (1 - c * u ** 0.2 + 0.6 * c * c * u ** 0.4) * np.sqrt(1 - u ** -2.0)


def softening_law(u, a, b, w):
    return (a + (b - a) * (1 - np.exp(-(u - 1) / w))) * np.sqrt(1 - u ** -2.0)


def power(e, p, q=(1, 1)):
    return make(power_law, e, p, q)


def quarter(e):
    return make(quarter_law, e)


def plastic(y):
    return make(plastic_law, y)


def onset(e, w, q):
    return make(onset_law, e, w, q)


# Velocities that a laboratory aims at.
def evenly(low, high, logarithmic=True):
    def drawn(rng):
        a, b = log_uniform(rng, *low), log_uniform(rng, *high)
        return lambda k: np.exp(rng.uniform(math.log(a), math.log(b), k)) if logarithmic else rng.uniform(a, b, k)
    return drawn


def parts(*weighted):
    def drawn(rng):
        designs = [design(rng) for _, design in weighted]
        return lambda k: np.array([designs[i](1)[0] for i in rng.choice(len(designs), size=k, p=[w for w, _ in weighted])])
    return drawn


def settings(count, low, high, spread):
    def drawn(rng):
        centres = np.exp(np.linspace(math.log(log_uniform(rng, *low)), math.log(log_uniform(rng, *high)), count))
        return lambda k: centres[rng.integers(count, size=k)] * np.exp(spread * rng.standard_normal(k))
    return drawn


def half_captured(kinds):
    """The velocity at which half of the particles are captured, in units of the median v_c of the first kind."""
    if len(kinds) == 1:
        return kinds[0].ratio
    low, high = -5.0, 5.0
    for _ in range(100):
        middle = 0.5 * (low + high)
        captured = sum(k.weight * math.erfc((middle - math.log(k.ratio)) / k.scatter / math.sqrt(2)) / 2 for k in kinds)
        low, high = (low, middle) if captured < 0.5 * sum(k.weight for k in kinds) else (middle, high)
    return math.exp(low)


def rebounds(rng, kinds, curves, scale, u):
    which = rng.choice(len(kinds), size=len(u), p=[k.weight for k in kinds])
    result = np.zeros(len(u))
    for j, kind in enumerate(kinds):
        own = which == j
        x = u[own] * scale / kind.ratio / np.exp(kind.scatter * rng.standard_normal(own.sum()))
        e = np.zeros(len(x))
        e[x > 1] = curves[j](x[x > 1])
        result[own] = u[own] * np.minimum(e * np.exp(kind.spread * rng.standard_normal(len(x))), 0.99)
    return result


def shots(rng, row, curves, scale, aim, drawn):
    """As recorded; rows that are lost are left out."""
    flaws, k = row.flaws, row.n
    v = aim(k)
    cone = flaws.get("cone")
    cosine = 1 - rng.uniform(0, 1, k) * (1 - math.cos(math.radians(cone))) if cone else math.cos(math.radians(flaws.get("tilt", 0)))
    r = rebounds(rng, row.kinds, curves, scale, v * cosine)
    r = np.where(r > 0, np.hypot(r, 5 / 7 * v * np.sqrt(1 - cosine ** 2)), 0.0)    # it rolls when it leaves
    error = (lambda: rng.standard_t(2, k)) if flaws.get("heavy") else (lambda: rng.standard_normal(k))
    add = flaws.get("add", 0)
    a = v * np.maximum(1 + row.noise * error(), 0.05) + add * rng.standard_normal(k)
    b = np.where(r > 0, r * np.maximum(1 + row.noise * error(), 0.05) + add * rng.standard_normal(k), 0.0)
    wrong = (rng.uniform(size=k) < flaws.get("gross", 0)) & (b > 0)    # the rebound of another particle
    if wrong.any():
        b[wrong] = rng.choice(b[b > 0], wrong.sum())
    b = np.where((b < drawn.get("booked", 0)) | (rng.uniform(size=k) < flaws.get("missed", 0)), 0.0, b)
    keep = a > 0
    if "lost" in drawn:
        seen = 1 / (1 + np.exp(-np.clip((b / drawn["lost"] - 1) / 0.15, -50, 50)))
        keep &= (b <= 0) | (rng.uniform(size=k) < seen)
    if "pixel" in drawn:
        a = np.maximum(np.round(a / drawn["pixel"]), 1) * drawn["pixel"]
        b = np.round(b / drawn["pixel"]) * drawn["pixel"]
    return np.column_stack([a, np.maximum(b, 0.0)])[keep]


def laboratory(rng, row):
    critical = log_uniform(rng, *row.critical)
    curves = [kind.curve(rng) for kind in row.kinds]
    aim = row.design(rng)
    drawn = {name: rng.uniform(*row.flaws[name]) for name in ("pixel", "lost", "booked") if name in row.flaws}
    while True:
        table = np.empty((0, 2))
        while len(table) < row.n:
            table = np.vstack([table, shots(rng, row, curves, half_captured(row.kinds), aim, drawn)])
        table = table[:row.n]
        least, most = row.flaws.get("captures", (0, row.n))
        if least <= (table[:, 1] == 0).sum() <= most:
            return table * critical, critical


Row = namedtuple("Row", "name tells critical n noise kinds design flaws")
NEAR, FAR = evenly((0.35, 0.7), (4, 9)), evenly((3, 4), (15, 30))
ANY = one_of(power((0.5, 0.9), (1, 4), (0.25, 1)), quarter((0.6, 0.95)), make(viscoelastic_law, (0.25, 0.45)),
             onset((0.5, 0.9), (0.4, 1.5), (0.25, 1)))
TWO = [Kind(power((0.5, 0.7), (2, 3)), 0.08, 0.65), Kind(plastic((0.3, 0.8)), 0.08, 0.35, 2.2)]
TACKY = [Kind(power((0.7, 0.9), (1.5, 2.5), (0.5, 0.5)), 0.06, 0.88), Kind(power((0.4, 0.6), (1, 2)), 0.10, 0.12, 4.0)]
ROWS = [Row(name, tells, critical, n, noise, kinds if isinstance(kinds, list) else [kinds], design, flaws)
        for name, tells, critical, n, noise, kinds, design, flaws in (
    # One kind of particle.
    ("plastic", "interval", (0.8, 3), 30, 0.03, Kind(plastic((0.2, 0.6))), NEAR, {}),
    ("yield-above", "interval", (0.2, 0.8), 200, 0.01, Kind(plastic((2, 4))), evenly((0.4, 0.7), (10, 20)), {}),
    ("quarter-2000", "interval", (1, 5), 2000, 0.01, Kind(quarter((0.5, 0.9))), evenly((0.4, 0.8), (6, 15)), {}),
    ("wet-12", "interval", (0.1, 0.4), 12, 0.03, Kind(power((0.5, 0.7), (1, 1))), evenly((0.3, 0.7), (3, 6)), {"captures": (1, 11)}),
    ("sharp-p4", "interval", (0.05, 0.2), 30, 0.03, Kind(power((0.93, 0.96), (3.5, 4))), NEAR, {}),
    ("p1to4-2000", "interval", (0.3, 1.2), 2000, 0.03, Kind(power((0.5, 0.9), (1, 4))), evenly((0.4, 0.8), (5, 12)), {}),
    ("kink", "interval", (1, 4), 200, 0.03, Kind(make(kink_law, (0.35, 0.55), (1.3, 1.8), (0.5, 1), (0.05, 0.2))), NEAR, {}),
    ("plateau-0.3", "interval", (0.2, 0.8), 200, 0.10, Kind(onset((0.28, 0.33), (0.6, 1.5), (1, 1))), NEAR, {"add": 0.01}),
    ("steep-12", "interval", (0.1, 0.4), 12, 0.01, Kind(onset((0.9, 0.95), (0.3, 0.8), (0.25, 0.25))),
     evenly((0.4, 0.8), (2.5, 5)), {"captures": (1, 11)}),
    ("damping-rises", "interval", (0.05, 0.12), 30, 0.03, Kind(make(viscoelastic_law, (0.25, 0.45))), evenly((0.4, 0.7), (6, 15)), {}),
    ("damping-falls", "interval", (0.4, 1.6), 200, 0.03, Kind(make(softening_law, (0.3, 0.4), (0.8, 0.9), (3, 6))),
     evenly((0.4, 0.7), (6, 15)), {}),
    # Particles differ.
    ("scatter-5%", "interval", (0.5, 2), 200, 0.01, Kind(power((0.55, 0.65), (3, 4)), 0.05), NEAR, {}),
    ("scatter-15%", "interval", (1.5, 6), 30, 0.03, Kind(plastic((0.3, 1.0)), 0.15, spread=0.10), NEAR, {}),
    ("scatter-30%-2000", "interval", (3, 10), 2000, 0.03, Kind(power((0.6, 0.8), (1, 1.5)), 0.30, spread=0.10),
     evenly((0.3, 0.6), (4, 9)), {}),
    ("scatter-30%-12", "wide", (3, 10), 12, 0.10, Kind(power((0.5, 0.9), (1, 3)), 0.30), evenly((0.3, 0.7), (2.5, 5)), {"captures": (2, 10)}),
    ("settings", "interval", (0.3, 1.2), 200, 0.03, Kind(onset((0.5, 0.8), (0.5, 1.5), (0.4, 1)), 0.15),
     settings(6, (0.45, 0.75), (2.2, 4), 0.03), {}),
    ("two-kinds", "interval", (0.3, 1.2), 200, 0.03, TWO, evenly((0.4, 0.7), (5, 9)), {}),
    ("tacky-minority", "interval", (0.15, 0.6), 200, 0.03, TACKY, NEAR, {}),
    # The camera and the clerk.
    ("pixels", "interval", (0.05, 0.2), 30, 0.01, Kind(power((0.6, 0.9), (2, 3), (0.5, 1))), evenly((0.4, 0.7), (2, 3.5), False), {"pixel": (0.10, 0.16)}),
    ("slow-lost", "wide", (0.3, 1.2), 200, 0.01, Kind(onset((0.5, 0.7), (0.6, 1.2), (0.5, 0.6))), NEAR, {"lost": (0.2, 0.3)}),
    ("booked-slow-onset", "wide", (0.1, 0.4), 200, 0.03, Kind(power((0.5, 0.7), (1, 1.5))), NEAR, {"booked": (0.10, 0.20)}),
    ("booked-steep", "interval", (0.1, 0.4), 200, 0.03, Kind(onset((0.7, 0.9), (0.4, 0.8), (0.25, 0.25))), NEAR, {"booked": (0.10, 0.20)}),
    ("false-captures", "interval", (0.4, 1.6), 200, 0.03, Kind(power((0.6, 0.9), (1.5, 3)), 0.05), NEAR, {"missed": 0.06}),
    ("heavy-tails", "interval", (0.8, 3), 200, 0.03, Kind(plastic((0.4, 1.5))), NEAR, {"heavy": True, "gross": 0.03}),
    ("cone-20-degrees", "interval", (0.5, 2), 30, 0.03, Kind(power((0.6, 0.8), (1.5, 3)), 0.05), NEAR, {"cone": 20}),
    ("tilt-25-degrees", "system", (0.5, 2), 200, 0.03, Kind(power((0.6, 0.8), (1.5, 3))), NEAR, {"tilt": 25}),
    # Few impacts, gaps, one outcome only.
    ("five", "wide", (6, 20), 5, 0.10, Kind(one_of(plastic((0.3, 1)), power((0.5, 0.9), (1, 4)))), evenly((0.35, 0.7), (2.5, 6)), {"captures": (2, 2)}),
    ("seven", "wide", (0.06, 0.25), 7, 0.03, Kind(onset((0.5, 0.8), (0.8, 2), (0.8, 1))), evenly((0.5, 0.9), (4, 9)), {"captures": (1, 1)}),
    ("two-captures-rest-far", "wide", (2, 8), 30, 0.03, Kind(one_of(quarter((0.6, 0.9)), power((0.5, 0.9), (1, 4)))),
     parts((0.08, evenly((0.3, 0.5), (0.9, 1.0))), (0.92, evenly((2.2, 3.5), (8, 15)))), {"captures": (2, 2)}),
    ("gap", "wide", (0.2, 0.8), 30, 0.03, Kind(one_of(plastic((0.5, 3)), power((0.4, 0.9), (1, 4), (0.25, 1)))),
     parts((0.4, evenly((0.25, 0.35), (0.5, 0.7))), (0.6, evenly((2, 3), (5, 8)))), {"captures": (5, 25)}),
    ("near-no-capture", "bound", (0.15, 0.6), 30, 0.03, Kind(onset((0.5, 0.9), (0.4, 1.5), (0.25, 1))), evenly((1.02, 1.08), (3, 6)), {"captures": (0, 0)}),
    ("all-captured", "bound", (4, 15), 12, 0.03, Kind(power((0.6, 0.6), (2, 2))), evenly((0.15, 0.3), (0.6, 1.0)), {"captures": (12, 12)}),
    ("far-1.5", "warn", (0.3, 1.2), 200, 0.03, Kind(ANY), evenly((1.5, 1.8), (8, 15)), {"captures": (0, 0)}),
    ("beyond-kink", "warn", (1, 4), 200, 0.01, Kind(make(kink_law, (0.35, 0.5), (1.3, 1.45), (0.5, 1), (0.15, 0.3))),
     evenly((1.5, 1.8), (5, 9)), {"captures": (0, 0)}),
    ("far-3-flat", "warn", (0.05, 0.2), 30, 0.03, Kind(power((0.93, 0.96), (3, 4))), evenly((3, 4), (12, 30)), {"captures": (0, 0)}),
    ("far-3-plastic-2000", "warn", (1, 5), 2000, 0.01, Kind(one_of(plastic((0.3, 2)), quarter((0.6, 0.95)))), FAR, {"captures": (0, 0)}))]


def main(folder, repetitions=1, seed=36):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "truths.csv"), "w", newline="") as truths:
        listing = csv.writer(truths)
        listing.writerow(["row", "tells", "file", "v_c", "alt"])
        for i, row in enumerate(ROWS):
            for k in range(max(1, int(repetitions) // 20) if row.n > 1000 else int(repetitions)):
                table, critical = laboratory(np.random.default_rng([int(seed), i, k]), row)
                file = "%s-%03d.csv" % (row.name, k)
                np.savetxt(os.path.join(folder, file), table, "%.6g", ",", header="v_in [m/s],v_r [m/s]", comments="")
                alt = 1 / math.cos(math.radians(row.flaws.get("tilt", 0)))
                listing.writerow([row.name, row.tells, file, "%.6g" % critical, "%.6g" % alt])


main(*sys.argv[1:])
