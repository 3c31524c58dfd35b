#!/usr/bin/env python3
"""Writes tube_paths.json: paths of particles in potential flow across a tube, by an integration that shares no line with
the program.

    python3 tube_paths.py           computes all rows
    python3 tube_paths.py --check   recomputes them, prints the worst difference

x'' = (u - x')(1 + c Re^(2/3))/S in radii of the tube and velocities of the gas, u + iv the conjugate of 1 - 1/z^2, by scipy's DOP853
(rtol 1e-12) from 1000 radii upstream, where a particle lags behind its streamline by 2 S/1000^3 of its offset. The
critical offset is the root of the gap of paths that pass, and of the square of the normal velocity of those that arrive.
Needs python3-scipy.
"""
import json
import math
import pathlib
import sys

from scipy.integrate import solve_ivp
from scipy.optimize import brentq

FILE = pathlib.Path(__file__).with_name("tube_paths.json")
START = 1000.0
CASES = [(0.2, 0, 0), (0.5, 0, 0), (1, 0, 0), (2, 0, 0), (5, 0, 0), (20, 0, 0),  # S, Re, c
         (0.5, 10, 0.158), (1, 100, 0.158), (5, 300, 0.158), (2, 50, 1 / 6)]
OFFSETS = (0.1, 0.5, 0.9)  # of the critical one


def passage(stokes, reynolds, drag, offset):
    """Normal velocity, angle from the front and velocity along the wall where a path arrives; of one that passes its gap, negative."""
    def motion(_, s):
        w = 1 - 1 / complex(s[0], s[1]) ** 2
        slip = w.real - s[2], -w.imag - s[3]
        rate = (1 + drag * (reynolds * math.hypot(*slip)) ** (2 / 3)) / stokes
        return s[2], s[3], rate * slip[0], rate * slip[1]

    x, y = -START, offset * (1 - 2 * stokes / START**3)
    for _ in range(6):
        y = offset * (1 - 2 * stokes / START**3) / (1 - 1 / (x * x + y * y))
    w = 1 - 1 / complex(x, y) ** 2
    options = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-14}
    near = lambda _, s: s[0] + 3
    near.terminal = True
    start = solve_ivp(motion, (0, 1e5), (x, y, w.real, -w.imag), events=near, **options).y[:, -1]
    hit = lambda _, s: s[0] ** 2 + s[1] ** 2 - 1
    hit.terminal, hit.direction = True, -1
    turn = lambda _, s: s[0] * s[2] + s[1] * s[3]
    turn.direction = 1
    gone = lambda _, s: s[0] - 1
    gone.terminal = True
    path = solve_ivp(motion, (0, 1e4), start, events=[hit, turn, gone], max_step=0.02, **options)
    if len(path.t_events[0]):
        s = path.y_events[0][0]
        return -(s[0] * s[2] + s[1] * s[3]), math.atan2(s[1], -s[0]), s[1] * s[2] - s[0] * s[3]
    return (-min(math.hypot(s[0], s[1]) - 1 for s in path.y_events[1]),)


def row(stokes, reynolds, drag):
    def excess(offset):
        reached = passage(stokes, reynolds, drag, offset)[0]
        return reached * abs(reached) if reached > 0 else reached

    critical = brentq(excess, 1e-3, 1, xtol=1e-12, rtol=1e-11)
    arrivals = []
    for share in OFFSETS:
        normal, angle, tangent = passage(stokes, reynolds, drag, share * critical)
        arrivals.append({"share": share, "normal": normal, "angle": angle, "tangent": tangent})
    return {"stokes": stokes, "reynolds": reynolds, "drag": drag, "critical_offset": critical, "arrivals": arrivals}


if __name__ == "__main__":
    rows = [row(*case) for case in CASES]
    if sys.argv[1:] == ["--check"]:
        before = json.loads(FILE.read_text())["rows"]
        print(max(abs(a["critical_offset"] / b["critical_offset"] - 1) for a, b in zip(rows, before)))
    else:
        FILE.write_text(json.dumps({"source": "tube_paths.py, scipy DOP853", "rows": rows}, indent=1) + "\n")
