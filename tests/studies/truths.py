# SPDX-License-Identifier: GPL-3.0-or-later
"""Laboratories for the study of v_c, written by someone who had not seen the estimator: truths.py FOLDER [REPETITIONS [SEED]]
writes a table of impacts each, as recorded, and FOLDER/truths.csv with their true v_c. No uncertainty is stated.

v_c is the normal velocity at which a median particle has e = 0, or at which half of the particles are captured if they differ.
Velocities, ends of ranges and shapes are drawn anew in each laboratory. Noise is a fraction of each velocity, scatter the
standard deviation of ln v_c. What a row can tell:
  interval  the impacts bracket v_c
  wide      a right interval exists and is wide
  bound     only one side is sure
  warn      nothing in the impacts fixes v_c: the right answer is a warning
  system    told up to a factor `alt` that the table does not show; between v_c and alt v_c counts as right
"""
import csv
import math
import os
import sys
from collections import namedtuple

import numpy as np

# ------------------------------------------------------------------ restitution curves e(u)
# u = v / v_c of the particle.  Each factory (rng) -> function of u, meant for u > 1 only.

def U(rng, a, b):
    return rng.uniform(a, b)

def LU(rng, a, b):
    return math.exp(rng.uniform(math.log(a), math.log(b)))

def power(einf=(0.6, 0.6), p=(2, 2), q=(1, 1)):
    """e = einf (1 - u^-p)^q"""
    def f(rng):
        E, P, Q = U(rng, *einf), U(rng, *p), U(rng, *q)
        return lambda u: E * (1 - u ** -P) ** Q
    return f

def tn(x):
    """Thornton & Ning (1998) elastic-perfectly plastic restitution, x = v_y / v."""
    x = np.minimum(x, 1.0)
    return (math.sqrt(6 * math.sqrt(3) / 5) * np.sqrt(1 - x * x / 6)
            * (x / (x + 2 * np.sqrt(1.2 - 0.2 * x * x))) ** 0.25)

def plastic(uy):
    """Thornton & Ning with adhesion; yield velocity uy * v_c; far above: e ~ v^-1/4"""
    def f(rng):
        y = U(rng, *uy)
        return lambda u: tn(y / u) * np.sqrt(1 - u ** -2.0)
    return f

def quarter(einf):
    """e = E u^-1/4 sqrt(1 - u^-2)"""
    def f(rng):
        E = U(rng, *einf)
        return lambda u: E * u ** -0.25 * np.sqrt(1 - u ** -2.0)
    return f

def kink(ek, uk, q, slope):
    """rise ~ (u-1)^q to ek at uk, then ek + slope ln(u/uk)"""
    def f(rng):
        E, K, Q, S = U(rng, *ek), U(rng, *uk), U(rng, *q), U(rng, *slope)
        return lambda u: np.where(u < K, E * (np.maximum(u - 1, 0) / (K - 1)) ** Q,
                                  np.clip(E + S * np.log(u / K), 0.05, 0.97))
    return f

def onset(einf, w, q):
    """e = E (1 - exp(-(u-1)/w))^q : onset ~ (v-vc)^q, plateau E"""
    def f(rng):
        E, W, Q = U(rng, *einf), U(rng, *w), U(rng, *q)
        return lambda u: E * (1 - np.exp(-(u - 1) / W)) ** Q
    return f

def visco(c):
    """viscoelastic losses growing with v: e_inf = 1 - c u^1/5 + 0.6 c^2 u^2/5"""
    def f(rng):
        C = U(rng, *c)
        return lambda u: (1 - C * u ** 0.2 + 0.6 * C * C * u ** 0.4) * np.sqrt(1 - u ** -2.0)
    return f

def softening(e0, e1, w):
    """damping falling with v: e_inf rises from e0 at v_c to e1 over w v_c"""
    def f(rng):
        A, B, W = U(rng, *e0), U(rng, *e1), U(rng, *w)
        return lambda u: (A + (B - A) * (1 - np.exp(-(u - 1) / W))) * np.sqrt(1 - u ** -2.0)
    return f

def oneof(*fs):
    return lambda rng: fs[rng.integers(len(fs))](rng)

# ------------------------------------------------------------------ designs (multiples of v_c)
def loguni(lo, hi):
    """log-uniform; the ends themselves drawn in the ranges lo, hi"""
    def f(rng):
        a, b = math.log(LU(rng, *lo)), math.log(LU(rng, *hi))
        return lambda k: np.exp(rng.uniform(a, b, k))
    return f

def uni(lo, hi):
    def f(rng):
        a, b = LU(rng, *lo), LU(rng, *hi)
        return lambda k: rng.uniform(a, b, k)
    return f

def parts(*ws):
    """mixture of designs: (weight, design) ..."""
    def f(rng):
        w = np.array([x[0] for x in ws], float); w /= w.sum()
        d = [x[1](rng) for x in ws]
        def g(k):
            which = rng.choice(len(d), size=k, p=w)
            out = np.empty(k)
            for j in range(len(d)):
                m = which == j
                out[m] = d[j](int(m.sum()))
            return out
        return g
    return f

def settings(num, lo, hi, spread):
    """num launcher settings, evenly in ln v between drawn ends, shots spread about each"""
    def f(rng):
        c = np.exp(np.linspace(math.log(LU(rng, *lo)), math.log(LU(rng, *hi)), num))
        return lambda k: c[rng.integers(num, size=k)] * np.exp(spread * rng.standard_normal(k))
    return f

# ------------------------------------------------------------------ laboratory
Kind = namedtuple("Kind", "weight ratio scatter curve esd")   # esd: sd of ln e from particle to particle

def kind(curve, scatter=0.0, weight=1.0, ratio=1.0, esd=0.0):
    return Kind(weight, ratio, scatter, curve, esd)

def phi(x):
    return 0.5 * (1 + math.erf(x / math.sqrt(2)))

def half_capture(kinds):
    """velocity (in units of the first kind's median v_c) at which half are captured"""
    if len(kinds) == 1:
        return kinds[0].ratio
    tot = sum(k.weight for k in kinds)
    def p(lv):
        return sum(k.weight / tot * phi((math.log(k.ratio) - lv) / max(k.scatter, 1e-9)) for k in kinds)
    a, b = -5.0, 5.0
    for _ in range(200):
        m = 0.5 * (a + b)
        a, b = (m, b) if p(m) > 0.5 else (a, m)
    return math.exp(0.5 * (a + b))

class Lab:
    """One laboratory: population + design + measurement.  All lengths in units of v_c inside."""
    def __init__(self, rng, vc, n, kinds, design, noise, add=0.0, heavy=False, gross=0.0,
                 pixel=None, lost=None, booked=None, falsecap=0.0, cone=None, tilt=None, ncap=None):
        self.rng, self.n, self.noise, self.add = rng, n, noise, add
        self.heavy, self.gross, self.falsecap, self.ncap = heavy, gross, falsecap, ncap
        self.vc = LU(rng, *vc)
        self.kinds = kinds
        self.scale = half_capture(kinds)          # v_c in units of first kind's median
        self.curves = [k.curve(rng) for k in kinds]
        self.pick = design(rng)
        self.pixel = None if pixel is None else U(rng, *pixel)
        self.lost = None if lost is None else U(rng, *lost)
        self.booked = None if booked is None else U(rng, *booked)
        self.cone, self.tilt = cone, tilt

    def physics(self, u):
        """true normal velocities u (units of v_c) -> true rebound velocities (0 = captured)"""
        r, k = self.rng, len(u)
        w = np.array([x.weight for x in self.kinds], float); w /= w.sum()
        which = r.choice(len(w), size=k, p=w)
        vr = np.zeros(k)
        for j, kd in enumerate(self.kinds):
            m = which == j
            x = u[m] * self.scale / kd.ratio / np.exp(kd.scatter * r.standard_normal(m.sum()))
            up = x > 1
            e = np.zeros(len(x))
            e[up] = self.curves[j](x[up])
            if kd.esd:
                e = np.minimum(e * np.exp(kd.esd * r.standard_normal(len(x))), 0.99)
            vr[m] = e * u[m]
        return vr

    def shots(self, k):
        """k shots -> recorded rows (lost ones left out), units of v_c"""
        r = self.rng
        v = self.pick(k)
        if self.cone or self.tilt:
            if self.cone:      # directions uniform over the solid angle of a cone
                c = 1 - r.uniform(0, 1, k) * (1 - math.cos(math.radians(self.cone)))
            else:
                c = np.full(k, math.cos(math.radians(self.tilt)))
            vn, vt = v * c, v * np.sqrt(1 - c * c)
            vr = self.physics(vn)
            vr = np.where(vr > 0, np.hypot(vr, 5 / 7 * vt), 0.0)   # rolling at departure
        else:
            vr = self.physics(v)
        z = (lambda: r.standard_t(2, k)) if self.heavy else (lambda: r.standard_normal(k))
        a = v * np.maximum(1 + self.noise * z(), 0.05) + self.add * r.standard_normal(k)
        b = vr * np.maximum(1 + self.noise * z(), 0.05) + self.add * r.standard_normal(k)
        b = np.where(vr > 0, b, 0.0)
        if self.gross:         # wrong track paired: rebound of another particle
            m = (r.uniform(size=k) < self.gross) & (b > 0)
            pool = b[b > 0]
            if m.any():
                b[m] = r.choice(pool, m.sum())
        if self.booked is not None:
            b = np.where(b < self.booked, 0.0, b)
        if self.falsecap:      # rebound missed by the camera, booked as capture
            b = np.where(r.uniform(size=k) < self.falsecap, 0.0, b)
        keep = np.ones(k, bool)
        if self.lost is not None:   # row missing altogether; logistic in v_r, half lost at self.lost
            x = np.clip((b - self.lost) / (0.15 * self.lost), -50, 50)
            keep = ~((b > 0) & (r.uniform(size=k) > 1 / (1 + np.exp(-x))))
        if self.pixel:
            a = np.maximum(np.round(a / self.pixel), 1) * self.pixel
            b = np.round(b / self.pixel) * self.pixel
        b = np.maximum(b, 0.0)
        return np.column_stack([a, b])[keep & (a > 0)]

    def run(self):
        for _ in range(20000):
            rows = self.shots(self.n)
            while len(rows) < self.n:
                rows = np.vstack([rows, self.shots(self.n)])
            rows = rows[:self.n]
            c = int((rows[:, 1] == 0).sum())
            if self.ncap is None or self.ncap[0] <= c <= self.ncap[1]:
                break
        else:
            raise RuntimeError("condition on captures never met")
        rows = rows * self.vc
        rows = np.vectorize(lambda x: float("%.6g" % x))(rows)
        return rows, self.vc

Row = namedtuple("Row", "name function tells size n alt")
ROWS = []

def row(name, text, tells, size, vc, n, noise, kinds, design, alt=1.0, **more):
    def function(rng):
        return Lab(rng, vc, n, [kinds] if isinstance(kinds, Kind) else kinds, design, noise, **more).run()
    ROWS.append(Row(name, function, tells, size, n, alt))


# ---- A. bracketed, one kind of particle, unusual curves
BR = loguni((0.35, 0.7), (4, 9))
row("plastic_n30", "Thornton-Ning, plastic already at v_c, e_inf falls as v^-1/4; 30 impacts over 0.5-6 v_c",
    "interval", 20, (0.8, 3), 30, 0.03, kind(plastic((0.2, 0.6))), BR)
row("yield_above_n200", "elastic at v_c, yields at 2-4 v_c: e rises to ~0.95, then falls; n=200, noise 1 %",
    "interval", 40, (0.2, 0.8), 200, 0.01, kind(plastic((2, 4))), loguni((0.4, 0.7), (10, 20)))
row("quarter_n2000", "e = E v^-1/4 sqrt(1-(vc/v)^2), n=2000, noise 1 %: the data can see any wrong curve",
    "interval", 10, (1, 5), 2000, 0.01, kind(quarter((0.5, 0.9))), loguni((0.4, 0.8), (6, 15)))
row("wet_p1_n12", "e = 0.5-0.7 (1 - vc/v), liquid-like losses; 12 impacts",
    "interval", 80, (0.1, 0.4), 12, 0.03, kind(power((0.5, 0.7), (1, 1))), loguni((0.3, 0.7), (3, 6)), ncap=(1, 11))
row("sharp_p4_n30", "e = 0.95 (1 - (vc/v)^4): plateau near 0.95 reached at once; noise 3 %",
    "interval", 100, (0.05, 0.2), 30, 0.03, kind(power((0.93, 0.96), (3.5, 4))), BR)
row("p1to4_n2000", "e = e_inf (1 - (vc/v)^p), p drawn in 1-4, n=2000, noise 3 %",
    "interval", 30, (0.3, 1.2), 2000, 0.03, kind(power((0.5, 0.9), (1, 4))), loguni((0.4, 0.8), (5, 12)))
row("kink_n200", "two regimes: fast rise to e~0.45 at 1.3-1.8 v_c, kink, slow rise after; n=200, noise 3 %",
    "interval", 15, (1, 4), 200, 0.03, kind(kink((0.35, 0.55), (1.3, 1.8), (0.5, 1), (0.05, 0.2))), BR)
row("slow_plateau03_n200", "slow onset e ~ (v-vc)^1, plateau 0.3, noise 10 %, additive noise 0.01 v_c",
    "interval", 50, (0.2, 0.8), 200, 0.10, kind(onset((0.28, 0.33), (0.6, 1.5), (1, 1))), BR, add=0.01)
row("steep_n12", "steep onset e ~ (v-vc)^(1/4), plateau 0.9-0.95, 12 impacts, noise 1 %",
    "interval", 60, (0.1, 0.4), 12, 0.01, kind(onset((0.9, 0.95), (0.3, 0.8), (0.25, 0.25))), loguni((0.4, 0.8), (2.5, 5)), ncap=(1, 11))
row("damping_rises_n30", "viscoelastic: damping grows with v, e passes a maximum near 3 v_c and falls; 150 um",
    "interval", 150, (0.05, 0.12), 30, 0.03, kind(visco((0.25, 0.45))), loguni((0.4, 0.7), (6, 15)))
row("damping_falls_n200", "damping falls with v: e_inf climbs from 0.35 at v_c to 0.85 beyond 5-10 v_c; n=200",
    "interval", 25, (0.4, 1.6), 200, 0.03, kind(softening((0.3, 0.4), (0.8, 0.9), (3, 6))), loguni((0.4, 0.7), (6, 15)))

# ---- B. particles differ
row("scatter05_n200", "v_c scatters 5 % from particle to particle, p=4 plateau 0.6, noise 1 %",
    "interval", 20, (0.5, 2), 200, 0.01, kind(power((0.55, 0.65), (3, 4)), 0.05), BR)
row("scatter15_n30", "v_c scatters 15 % and e 10 % (rough particles), plastic curve, noise 3 %",
    "interval", 12, (1.5, 6), 30, 0.03, kind(plastic((0.3, 1.0)), 0.15, esd=0.10), BR)
row("scatter30_n2000", "v_c scatters 30 %, e 10 %, wet curve p=1, n=2000, noise 3 %",
    "interval", 8, (3, 10), 2000, 0.03, kind(power((0.6, 0.8), (1, 1.5)), 0.30, esd=0.10), loguni((0.3, 0.6), (4, 9)))
row("scatter30_n12", "v_c scatters 30 %, 12 impacts, noise 10 %: capture and rebound velocities overlap",
    "wide", 8, (3, 10), 12, 0.10, kind(power((0.5, 0.9), (1, 3)), 0.30), loguni((0.3, 0.7), (2.5, 5)), ncap=(2, 10))
row("settings_scatter15_n200", "6 launcher settings with 3 % spread, v_c scatters 15 %: capture fractions with gaps between",
    "interval", 30, (0.3, 1.2), 200, 0.03, kind(onset((0.5, 0.8), (0.5, 1.5), (0.4, 1)), 0.15),
    settings(6, (0.45, 0.75), (2.2, 4), 0.03))
row("two_kinds_n200", "65 % of particles with median v_c 1, 35 % with 2.2, each scattering 8 %: half-captured v_c lies in the first group's upper tail",
    "interval", 35, (0.3, 1.2), 200, 0.03,
    [kind(power((0.5, 0.7), (2, 3)), 0.08, 0.65, 1.0), kind(plastic((0.3, 0.8)), 0.08, 0.35, 2.2)], loguni((0.4, 0.7), (5, 9)))
row("tacky_minority_n200", "12 % tacky particles with v_c 4 times larger: captures far above v_c",
    "interval", 45, (0.15, 0.6), 200, 0.03,
    [kind(power((0.7, 0.9), (1.5, 2.5), (0.5, 0.5)), 0.06, 0.88, 1.0), kind(power((0.4, 0.6), (1, 2)), 0.10, 0.12, 4.0)], BR)

# ---- C. the camera and the clerk
row("pixels_n30", "velocities rounded to 0.10-0.16 v_c (pixel per frame); slowest rebounds round to 0 = capture",
    "interval", 100, (0.05, 0.2), 30, 0.01, kind(power((0.6, 0.9), (2, 3), (0.5, 1))), uni((0.4, 0.7), (2, 3.5)), pixel=(0.10, 0.16))
row("lost_slow_n200", "rebounds slower than ~0.2-0.3 v_c mostly missing from the file (captures kept): empty stretch above v_c; onset e ~ (v-vc)^(1/2)",
    "wide", 30, (0.3, 1.2), 200, 0.01, kind(onset((0.5, 0.7), (0.6, 1.2), (0.5, 0.6))), BR, lost=(0.2, 0.3))
row("booked_slow_onset_n200", "rebounds slower than 0.10-0.20 v_c booked as captures, slow onset: apparent threshold 1.2-1.5 v_c; only the gap in v_r tells",
    "wide", 70, (0.1, 0.4), 200, 0.03, kind(power((0.5, 0.7), (1, 1.5))), BR, booked=(0.10, 0.20))
row("booked_steep_n200", "rebounds slower than 0.10-0.20 v_c booked as captures, steep onset (v-vc)^(1/4): hardly matters",
    "interval", 70, (0.1, 0.4), 200, 0.03, kind(onset((0.7, 0.9), (0.4, 0.8), (0.25, 0.25))), BR, booked=(0.10, 0.20))
row("false_captures_n200", "6 % of rebounds at any velocity missed and booked as captures; p in 1.5-3",
    "interval", 25, (0.4, 1.6), 200, 0.03, kind(power((0.6, 0.9), (1.5, 3)), 0.05), BR, falsecap=0.06)
row("heavy_tails_n200", "noise Student t (2 d.o.f.) of 3 %, 3 % of rebounds paired with another track",
    "interval", 18, (0.8, 3), 200, 0.03, kind(plastic((0.4, 1.5))), BR, heavy=True, gross=0.03)
row("oblique_cone_n30", "incidence within a 20 degree cone, full speeds recorded as normal (apparent v_c +1 to +3 %)",
    "interval", 20, (0.5, 2), 30, 0.03, kind(power((0.6, 0.8), (1.5, 3)), 0.05), BR, cone=20)
row("oblique_tilt25_n200", "target tilted 25 degrees, full speeds recorded as normal: apparent v_c +10 %, e jumps to ~0.3 at capture limit",
    "system", 20, (0.5, 2), 200, 0.03, kind(power((0.6, 0.8), (1.5, 3))), BR, tilt=25, alt=1 / math.cos(math.radians(25)))

# ---- D. few captures, small files, gaps
row("n5_noise10", "5 impacts, 2 captured, noise 10 %",
    "wide", 5, (6, 20), 5, 0.10, kind(oneof(plastic((0.3, 1)), power((0.5, 0.9), (1, 4)))), loguni((0.35, 0.7), (2.5, 6)), ncap=(2, 2))
row("n7_one_capture", "7 impacts, exactly 1 captured, slow onset, noise 3 %",
    "wide", 90, (0.06, 0.25), 7, 0.03, kind(onset((0.5, 0.8), (0.8, 2), (0.8, 1))), loguni((0.5, 0.9), (4, 9)), ncap=(1, 1))
row("n30_two_captures_rest_far", "2 captures below v_c, 28 rebounds nearly all above 3 v_c: v_c somewhere in the gap",
    "wide", 10, (2, 8), 30, 0.03, kind(oneof(quarter((0.6, 0.9)), power((0.5, 0.9), (1, 4)))),
    parts((0.08, loguni((0.3, 0.5), (0.9, 1.0))), (0.92, loguni((2.2, 3.5), (8, 15)))), ncap=(2, 2))
row("gap_n30", "captures at 0.3-0.6 v_c and rebounds beyond 2-3 v_c, nothing between (two launchers); noise 3 %",
    "wide", 40, (0.2, 0.8), 30, 0.03, kind(oneof(plastic((0.5, 3)), power((0.4, 0.9), (1, 4), (0.25, 1)))),
    parts((0.4, loguni((0.25, 0.35), (0.5, 0.7))), (0.6, loguni((2, 3), (5, 8)))), ncap=(5, 25))

# ---- E. no captures or nothing but captures
row("near_no_capture_n30", "no captures, rebounds from 1.02-1.15 v_c on, onset of any steepness: upper bound sure, lower from the fall of e",
    "bound", 50, (0.15, 0.6), 30, 0.03, kind(onset((0.5, 0.9), (0.4, 1.5), (0.25, 1))), loguni((1.02, 1.08), (3, 6)), ncap=(0, 0))
row("all_captured_n12", "12 impacts, all captured, fastest 0.6-1 v_c: lower bound only",
    "bound", 6, (4, 15), 12, 0.03, kind(power((0.6, 0.6), (2, 2))), loguni((0.15, 0.3), (0.6, 1.0)), ncap=(12, 12))
row("far15_n200", "all above 1.5 v_c, no captures; curve of any kind, noise 3 %: v_c rests on the assumed curve",
    "warn", 30, (0.3, 1.2), 200, 0.03,
    kind(oneof(power((0.5, 0.9), (1, 4), (0.25, 1)), quarter((0.6, 0.95)), visco((0.25, 0.45)), onset((0.5, 0.9), (0.4, 1.5), (0.25, 1)))),
    loguni((1.5, 1.8), (8, 15)), ncap=(0, 0))
row("kink_beyond_n200", "all data beyond the kink (above 1.5 v_c): the smooth upper branch extrapolates to a wrong v_c",
    "warn", 15, (1, 4), 200, 0.01, kind(kink((0.35, 0.5), (1.3, 1.45), (0.5, 1), (0.15, 0.3))), loguni((1.5, 1.8), (5, 9)), ncap=(0, 0))
row("far3_flat_n30", "all above 3 v_c on a plateau 0.95, p=3-4: e constant within noise 3 %",
    "warn", 100, (0.05, 0.2), 30, 0.03, kind(power((0.93, 0.96), (3, 4))), loguni((3, 4), (12, 30)), ncap=(0, 0))
row("far3_plastic_n2000", "all above 3 v_c, plastic v^-1/4, n=2000, noise 1 %: tight fits, v_c not in the data",
    "warn", 10, (1, 5), 2000, 0.01, kind(oneof(plastic((0.3, 2)), quarter((0.6, 0.95)))), loguni((3, 4), (15, 30)), ncap=(0, 0))

CORE = tuple("""plastic_n30 wet_p1_n12 sharp_p4_n30 p1to4_n2000 kink_n200 slow_plateau03_n200 steep_n12
damping_rises_n30 damping_falls_n200 scatter05_n200 scatter15_n30 scatter30_n2000 two_kinds_n200
pixels_n30 lost_slow_n200 booked_slow_onset_n200 heavy_tails_n200 oblique_cone_n30 n5_noise10
n7_one_capture n30_two_captures_rest_far near_no_capture_n30 far15_n200 kink_beyond_n200
far3_plastic_n2000""".split())
assert len(CORE) == 25 and set(CORE) <= {r.name for r in ROWS}


def write(folder, repetitions, seed):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "truths.csv"), "w", newline="") as truths:
        table = csv.writer(truths)
        table.writerow(["row", "tells", "file", "v_c", "alt", "diameter"])
        for i, r in enumerate(ROWS):
            for k in range(max(1, repetitions // 20) if r.n > 1000 else repetitions):
                impacts, critical = r.function(np.random.default_rng([seed, i, k]))
                name = "%s_%03d.csv" % (r.name, k)
                with open(os.path.join(folder, name), "w") as file:
                    file.write("v_in [m/s],v_r [m/s]\n")
                    file.writelines("%.6g,%.6g\n" % tuple(impact) for impact in impacts)
                table.writerow([r.name, r.tells, name, "%.6g" % critical, "%.6g" % r.alt, "%g" % (1e-6 * r.size)])


write(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1, int(sys.argv[3]) if len(sys.argv) > 3 else 36)
