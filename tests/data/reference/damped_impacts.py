#!/usr/bin/env python3
"""Writes damped_impacts.json: impacts with damping that follows the force, integrated without a line of the program.

    python3 damped_impacts.py            writes the file (some minutes)
    python3 damped_impacts.py --check    compares it with a second method and a closed form, prints the worst

m d2(delta)/dt2 + D d(delta)/dt + F_r - F_a = 0 along the curve of a contact, q -> delta, F_r, F_a. The state (q, v, t,
W), W the work of damping, is followed over a parameter s with da = A v ds, a the contact radius: that is regular at
first touch, turn and fold. First method: Gragg-Bulirsch-Stoer extrapolation to 1e-17 in 64-bit mantissas. Second:
scipy's DOP853 in doubles, rtol 3e-14. SI units. Needs python3-scipy and a long double of 80 bits.
"""
import json
import math
import pathlib
import sys
from functools import reduce
from multiprocessing import Pool

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

FILE = pathlib.Path(__file__).with_name("damped_impacts.json")
OWN = {"thornton-ning": "yield_pressure", "sjkr": "cohesion_energy_density", "maugis-dugdale": "cohesive_stress"}
CONTACTS = [*((law, "zero-overlap") for law in ("hertz", "dmt", "brach-dunn", "sjkr")), ("jkr", "pull-off"),
            ("jkr", "zero-overlap"), ("maugis-dugdale", "pull-off"), ("maugis-dugdale", "zero-overlap"),
            ("thornton-ning", "pull-off")]
FOLLOWING = ("hunt-crossley", "brach-dunn-damping")
PI = np.longdouble("3.14159265358979323846264338")
TERMS = [(-1) ** (n + 1) * 2 * n / np.longdouble(str(math.factorial(2 * n + 1))) for n in range(22, 0, -1)]
exact = {"number": np.longdouble}  # the second method sets float
num = lambda x: exact["number"](x)
np.seterr(all="ignore")

# Curves of a contact: q -> (da/dq, d delta/dq, delta, F_r, F_a, a), with k = (4/3) E*.
def jkr_curve(r, k, w, shift=0, py=None, ay=0):
    """JKR with a permanent overlap `shift`. Beyond a_y F_r grows by p_y + sqrt(2 w E*/(pi a)) per contact area."""
    neck, punch = np.sqrt(2 * num(PI) * w / (k * 3 / 4)), np.sqrt(8 * num(PI) * w * k * 3 / 4)
    def curve(a):
        u, b = np.sqrt(np.abs(a)), a if py is None else ay
        hertz = k * b**3 / r + (py or 0) * num(PI) * (a * a - b * b) + punch * 2 / 3 * (a * u - b * np.sqrt(np.abs(b)))
        return 1, 2 * a / r - neck / (2 * u), a * a / r - neck * u + shift, hertz, punch * a * u, a
    return curve

def jkr_radius(r, k, w, part):  # a^3 = part 2 pi w r^2/E*: part 1 at zero overlap, 1/16 at the fold
    return np.cbrt(part * 2 * num(PI) * w * r * r / (k * 3 / 4))

def sine_moment(x):  # sin x - x cos x without cancellation
    return reduce(lambda total, term: total * x * x + num(term), TERMS, 0) * x**3

def dugdale_curves(r, k, w, stress):
    """Maugis 1992: curves of contact, q = arccos(a/c), and gap, q = c; c of their join and of the jump into the gap."""
    radius, overlap, force = np.cbrt(num(PI) * w * r * r / k), np.cbrt((num(PI) * w / k) ** 2 * r), num(PI) * w * r
    lam = 2 * stress * np.cbrt(r / (num(PI) * w * k * k))
    def contact(q):
        s, c = np.sin(q), np.cos(q)
        p, dp = lam / 4 * sine_moment(2 * q), 2 * lam * q * s * c
        g, dg = lam**2 * 4 / 3 * (q * s - 2 * np.sin(q / 2) ** 2), lam**2 * 4 / 3 * q * c
        edge = 2 / (g + np.sqrt(g * g + 4 * p))
        slope = -(dp * edge + dg) * edge / (2 * p * edge + g)
        a, da = edge * c, slope * c - edge * s
        d, dd = a * a - lam * 4 / 3 * edge * s, 2 * a * da - lam * 4 / 3 * (slope * s + edge * c)
        return radius * da, overlap * dd, overlap * d, force * a**3, force * lam * edge**2 * (q + s * c), radius * a
    def gap(q):
        c, fold = q / radius, 8 * lam / (3 * num(PI))
        delta = c * c / 2 - fold * c - 2 / (num(PI) * lam)
        return 1, overlap / radius * (c - fold), overlap * delta, 0, force * num(PI) / 2 * lam * c * c, 0
    half = (num(PI) / 2 - 1) * lam**2 * 4 / 3
    return contact, gap, radius * 2 / (half + np.sqrt(half**2 + num(PI) * lam)), 16 * lam / (3 * num(PI)) * radius

def root(f, low, high):
    low, high, sign = num(low), num(high), np.sign(f(num(low)))
    for _ in range(75):
        middle = (low + high) / 2
        low, high = (middle, high) if np.sign(f(middle)) == sign else (low, middle)
    return (low + high) / 2

def path(case):
    """[(curve, q of its start, of its end)] of the way in, of the way out after a turn (start None: at the turn)."""
    r, e, w = (num(case[n]) for n in ("effective_radius", "contact_modulus", "work_of_adhesion"))
    law, k, own = case["law"], e * 4 / 3, num(case[OWN[case["law"]]]) if case["law"] in OWN else None
    part = num(1) if case["detachment"] == "zero-overlap" else num(1) / 16
    touch, elastic = jkr_radius(r, k, w, num(1)), jkr_curve(r, k, w)
    if law == "jkr":
        return [(elastic, touch, np.inf)], lambda turn: [(elastic, None, jkr_radius(r, k, w, part))]
    if law == "thornton-ning":
        ay = root(lambda a: 2 * e * a / (num(PI) * r) - np.sqrt(2 * w * e / (num(PI) * a)) - own, touch / 100, r)
        yielding = jkr_curve(r, k, w, 0, own, ay)

        def unloading(turn):
            flat = r if turn < ay else k * turn**3 / yielding(turn)[3]
            return [(jkr_curve(flat, k, w, turn**2 / r * (1 - r / flat)), None, jkr_radius(flat, k, w, part))]
        return [(elastic, touch, ay), (yielding, ay, np.inf)], unloading
    if law == "maugis-dugdale":
        contact, gap, join, jump = dugdale_curves(r, k, w, own)
        low = num(PI) / 2 if jump / 2 < join else root(lambda q: contact(q)[1], num(0.01), num(PI) / 2)
        out = [(contact, None, low)] + ([(gap, join, jump / 2)] if jump / 2 < join else [])
        if case["detachment"] != "zero-overlap" and jump < join:
            return [(gap, jump, join), (contact, num(PI) / 2, -np.inf)], lambda turn: out
        reach = gap(num(0))[2] if case["detachment"] != "zero-overlap" else 0
        start = root(lambda q: contact(q)[2] - reach, num(0.01), low)
        return [(contact, start, -np.inf)], lambda turn: out if reach else [(contact, None, start)]
    rim = 2 * num(PI) * np.cbrt(6 * w * w * r * e / num(PI))
    attraction = {"hertz": lambda a: 0, "dmt": lambda a: 2 * num(PI) * w * r, "brach-dunn": lambda a: rim * a,
                  "sjkr": lambda a: own * num(PI) * a * a}[law]
    hertz = lambda a: (1, 2 * a / r, a * a / r, k * a**3 / r, attraction(a), a)
    return [(hertz, num(0), np.inf)], lambda turn: [(hertz, None, num(0))]

def damping(case):
    """D of F_d = D d(delta)/dt, from F_r, F_a and a."""
    m, r, k, c = (num(case[n]) for n in ("mass", "effective_radius", "contact_modulus", "damping"))
    tsuji, other = c * np.sqrt(m * k * 4 / 3 * np.sqrt(r)) / np.sqrt(np.sqrt(r)), num(case.get("adhesion_damping", 0))
    return {"constant": lambda fr, fa, a: c, "contact-radius": lambda fr, fa, a: c * a,
            "tsuji": lambda fr, fa, a: tsuji * np.sqrt(np.abs(a)), "hunt-crossley": lambda fr, fa, a: c * fr,
            "brach-dunn-damping": lambda fr, fa, a: c * fr + other * fa}[case["damping_law"]]

def scale_length(m, r, modulus, velocity):
    return (m * velocity**2 / (modulus * 4 / 3 * r**num(0.5))) ** num(0.4)

def extrapolate(f, y, h):
    """Gragg's midpoint rule, extrapolated in the square of its step; None if 10 rows do not suffice."""
    start, last = f(y), []
    for row in range(1, 11):
        a, b, n = y, y + h / (2 * row) * start, 2 * row
        for _ in range(n - 1):
            a, b = b, a + 2 * h / n * f(b)
        table = [(a + b + h / n * f(b)) / 2]
        for j, before in enumerate(last, 1):
            table.append(table[-1] + (table[-1] - before) / ((num(row) / (row - j)) ** 2 - 1))
        if last and np.all(np.abs(table[-1] - table[-2]) < 1e-17 * (1e-3 + np.abs(y))):
            return table[-1]
        last = table

def runge_kutta(f, y, h):
    return solve_ivp(lambda _, x: f(x), (0, h), y, method="DOP853", rtol=3e-14, atol=1e-17).y[:, -1]

def creeps(case, curve, y, end, sign):
    """q of the equilibrium if the motion must creep there: v below D x/(2m), x the way left, and D^2 >= 4m F/x."""
    m, drag, force = num(case["mass"]), damping(case), lambda q: curve(q)[3] - curve(q)[4]
    da, _, delta, repulsion, *_ = curve(y[0])
    if sign * force(y[0]) >= 0 or not repulsion:
        return None
    target = end if np.isfinite(end) else num(case["effective_radius"]) if da > 0 else num(0.01)
    if sign * force(target) <= 0 < sign:
        return None
    target = root(force, y[0], target) if sign * force(target) > 0 else target
    rest, points = curve(target)[2], [curve(y[0] + (target - y[0]) * num(i) / 50) for i in range(50)]
    least, stiff = min(drag(*p[3:]) for p in points), max(np.abs((p[3] - p[4]) / (p[2] - rest)) for p in points)
    below = np.abs(y[1]) * num(case["velocity"]) <= least / (2 * m) * np.abs(rest - delta)
    return target if below and least**2 >= 4 * m * stiff else None

def follow(case, curve, y, end, sign, advance):
    """Follows a curve inward (sign 1) or outward (-1) to its end, to a turn, or to rest at the equilibrium."""
    m, r, k, unit = (num(case[n]) for n in ("mass", "effective_radius", "contact_modulus", "velocity"))
    length, wide, drag = scale_length(m, r, k, unit), np.sqrt(r * scale_length(m, r, k, unit)), damping(case)
    def slope(y):
        da, dd, _, fr, fa, a = curve(y[0])
        d = drag(fr, fa, a) if a else 0  # damping acts only in contact
        step = wide / da * dd / length  # d delta = v step ds
        return np.array([wide / da * y[1], -(d * unit * y[1] + fr - fa) * length / (m * unit**2) * step, step,
                         d * y[1] ** 2 * length / (m * unit) * step], dtype=exact["number"])
    def reach(y, t):
        new = advance(slope, y, num(t)) if t else y
        return reach(reach(y, t / 2), t / 2) if new is None else new
    side, h = np.sign(y[0] - end), num(0.05)
    while True:
        now = slope(y)
        if np.abs(y[1]) < 1e-15 and np.abs(now[1]) < 1e-15:  # a turn lost in rounding
            return "rest", y
        h = min(h * 1.4, max(num(0.08), min(np.abs(y[i] / now[i]) / 5 for i in (0, 1) if now[i])))
        while (new := advance(slope, y, h)) is None:
            h /= 2
        t, event = float(h), None
        for i, target in ((1, 0), (0, end)):  # a turn beyond the end comes after it
            if (sign * new[1] if i else (new[0] - end) * side) <= 0:
                t = brentq(lambda t: float(reach(y, t)[i] - target), 0, t, xtol=1e-17, rtol=1e-15)
                new = reach(y, t)
                event = "turn" if i else "end", new + (target - new[i]) / slope(new)[i] * slope(new)
        if event:
            return event
        y = new
        if (target := creeps(case, curve, y, end, sign)) is not None:  # what energy is left there goes into damping
            x, weight = np.polynomial.legendre.leggauss(60)
            _, dd, _, fr, fa, _ = curve(y[0] + (target - y[0]) * (x + 1) / 2)
            work = np.sum(weight * (fr - fa) * dd) * (target - y[0]) / 2 / (m * unit**2)
            return "rest", np.array([target, 0, y[2], y[3] + y[1] ** 2 / 2 - work])

def impact(case, advance=extrapolate):
    m, r, k, unit = (num(case[n]) for n in ("mass", "effective_radius", "contact_modulus", "velocity"))
    inward, outward = path(case)
    kind, y = "turn", np.array([0, 1, 0, 0], dtype=exact["number"])
    for sign in (1, -1):
        for curve, start, end in inward if sign > 0 else outward(y[0]) if kind == "turn" else []:
            y[0] = y[0] if start is None else start
            kind, y = follow(case, curve, y, end, sign, advance)
            if kind != "end":
                break
        if sign > 0:
            top, work, y[1] = curve(y[0])[2], y[3], 0
    rebound, seconds = kind == "end", scale_length(m, r, k, unit) / unit
    return {"outcome": "rebound" if rebound else "capture", "restitution": float(-y[1]) if rebound else 0.0,
            "contact_time": float(y[2] * seconds) if rebound else None, "maximum_overlap": float(top),
            "dissipated": float((y[3] if rebound else work) * m * unit**2)}

digits = lambda x: float(f"{x:.12e}") if isinstance(x, float) else x

def contact(random, law, detachment):
    """A random contact, and the velocity at which its adhesion counts: v_s of JKR for the work of adhesion drawn."""
    radius, density = 10 ** random.uniform(-6, math.log10(200e-6)), random.uniform(1000, 4000)
    w, e = 10 ** random.uniform(-2, 0), 10 ** random.uniform(10, math.log10(200e9))
    case = {"law": law, "detachment": detachment, "mass": digits(4 / 3 * math.pi * radius**3 * density),
            "effective_radius": digits(radius), "contact_modulus": digits(e),
            "work_of_adhesion": digits(w) if law not in ("hertz", "sjkr") else 0.0}
    touch = (2 * math.pi * w * radius**2 / e) ** (1 / 3)
    if law == "sjkr":
        case[OWN[law]] = digits(2 * w * radius / touch**2 * 10 ** random.uniform(-0.3, 0.3))
    if law == "maugis-dugdale":  # Tabor parameters from 0.1 to 10
        case[OWN[law]] = digits(16 * w / (9 * 3**0.5) * 10 ** random.uniform(-1, 1) / (radius * w**2 / e**2) ** (1 / 3))
    if law == "thornton-ning":  # yields at 1.1 to 5 times the radius of first touch
        a = touch * 10 ** random.uniform(0.04, 0.7)
        case[OWN[law]] = digits(2 * e * a / (math.pi * radius) - (2 * w * e / (math.pi * a)) ** 0.5)
    return case, (2 * 7.0922 * (w**5 * radius**4 / e**2) ** (1 / 3) / case["mass"]) ** 0.5

def dampen(random, case, law, velocity, low, high):
    """Adds a damping law with zeta v, for the older laws a scaled coefficient, from low to high."""
    m, r, number = case["mass"], case["effective_radius"], 10 ** random.uniform(math.log10(low), math.log10(high))
    length = float(scale_length(m, r, case["contact_modulus"], velocity))
    unit = m * velocity / length
    unit = {"constant": unit, "contact-radius": unit / (r * length) ** 0.5, "tsuji": 1}.get(law, 1 / velocity)
    case |= {"damping_law": law, "damping": digits(number * unit)}
    if law == "brach-dunn-damping":
        case["adhesion_damping"] = digits(case["damping"] * random.uniform(0, 10))

def random_case(seed):
    """Case number `seed`; drops cases within 1e-6 of the boundary, overlaps above 0.3 R, and every second capture."""
    random, (turn, place) = np.random.default_rng([35, seed]), divmod(seed, len(CONTACTS))
    law = (*FOLLOWING, *FOLLOWING, ("constant", "contact-radius", "tsuji")[turn // 5 % 3])[turn % 5]
    while True:
        case, scale = contact(random, *CONTACTS[place])
        velocity = scale * 10 ** random.uniform(math.log10(0.3), math.log10(30))
        dampen(random, case, law, velocity, *((0.01, 10) if law in FOLLOWING else (0.02, 1.0)))
        case["velocity"] = digits(velocity)
        result, *sides = (impact(case | {"velocity": case["velocity"] * f}) for f in (1, 1 - 1e-6, 1 + 1e-6))
        dropped = turn % 2 and result["outcome"] == "capture" or any(s["outcome"] != result["outcome"] for s in sides)
        if not dropped and result["maximum_overlap"] < 0.3 * case["effective_radius"]:
            return case | {n: digits(x) for n, x in result.items()}

def random_critical(seed):
    """A contact with one change from capture to rebound between 0.1 and 100 times the scale, and where it is."""
    random, law = np.random.default_rng([36, seed]), [*dict(CONTACTS)][1 + seed % 6]
    ends = [end for name, end in CONTACTS if name == law]
    while True:
        case, scale = contact(random, law, ends[seed // 12 % len(ends)])
        dampen(random, case, FOLLOWING[seed // 6 % 2], scale, 0.01, 0.5)
        rebounds = lambda v: impact(case | {"velocity": v})["outcome"] == "rebound"
        grid = [scale * 10**x for x in np.linspace(-1, 2, 10)]
        seen = [rebounds(v) for v in grid]
        if not seen[0] and seen[-1] and sorted(seen) == seen:
            low, high = grid[seen.index(True) - 1], grid[seen.index(True)]
            while high / low - 1 > 2e-11:
                middle = (low + high) / 2
                low, high = (low, middle) if rebounds(middle) else (middle, high)
            return case | {"critical_velocity": digits((low + high) / 2)}

def second(case):
    """Worst relative difference of a case by the second method; of a critical velocity: is it one within 1e-10?"""
    exact["number"] = float
    if v := case.get("critical_velocity"):
        sides = [impact(case | {"velocity": v * f}, runge_kutta)["outcome"] for f in (1 - 1e-10, 1 + 1e-10)]
        return sides == ["capture", "rebound"]
    other = impact(case, runge_kutta)
    assert case["outcome"] == other["outcome"], case
    return max(abs(other[n] / case[n] - 1) for n in other if n != "outcome" and case[n])

def closed_form():
    """Worst difference to zeta v (1+e) = ln[(1 + zeta v)/(1 - zeta v e)], exact for hertz with hunt-crossley."""
    case = {"mass": 1e-9, "effective_radius": 4.4e-5, "contact_modulus": 9e10, "work_of_adhesion": 0, "velocity": 2,
            "law": "hertz", "detachment": "zero-overlap", "damping_law": "hunt-crossley"}
    worst = 0
    for z in (0.01, 0.1, 0.4, 1, 2, 5, 10):
        e = impact(case | {"damping": z / 2})["restitution"]
        worst = max(worst, abs(z * (1 + e) + math.log1p(-z * e) - math.log1p(z)) * (1 - z * e) / (z * e) ** 2)
    return worst

def main():
    with Pool() as pool:
        if sys.argv[1:] == ["--check"]:
            data, worst = json.loads(FILE.read_text()), {"closed form": closed_form()}
            for case, found in zip(data["cases"], pool.imap(second, data["cases"])):
                worst[case["law"]] = max(worst.get(case["law"], 0), found)
            return print(worst, sum(pool.imap(second, data["critical_velocities"])), "critical velocities met")
        cases = list(map(json.dumps, pool.imap(random_case, range(200))))
        critical = list(map(json.dumps, pool.imap(random_critical, range(60))))
    what = "Impacts on a flat wall, SI units; dissipated: work of damping, of a capture up to its greatest overlap."
    FILE.write_text(f'{{"what": "{what}",\n"cases": [\n' + ",\n".join(cases) + '\n],\n"critical_velocities": [\n'
                    + ",\n".join(map(", ".join, zip(critical[::2], critical[1::2]))) + "\n]}\n")

if __name__ == "__main__":
    main()
