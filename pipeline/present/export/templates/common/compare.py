#!/usr/bin/env python3
"""Compares what the code made of the impacts with expected.json. Usage: python3 compare.py [LOG]

The log holds, for each run, a line "impact NUMBER RESOLUTION TIME_STEP" and rows "step position velocity",
with friction "step position velocity along spin".
The contact ends where the sphere is back at the height at which it touched: extrapolated over the overlap. Where adhesion holds
on beyond that ("end": "free-flight" in expected.json), it has ended if the velocity no longer changes. A code
with a finite time step is off by a series in that step; each restitution is extrapolated to step zero.
Exit status 0: all agree, 1: some do not."""
import json
import math
import sys


def read_log(path):
    """Yields (number, resolution, time step, rows) of each run."""
    runs = []
    with open(path, errors="replace") as log:
        for line in log:
            words = line.split()
            if len(words) == 4 and words[0] == "impact" and words[1].isdigit():
                runs.append((int(words[1]), int(words[2]), float(words[3]), []))
            elif runs and len(words) in (3, 5) and words[0].isdigit():
                try:
                    runs[-1][3].append((int(words[0]), *map(float, words[1:])))
                except ValueError:    # a line in words
                    pass
    return runs


def end_of_contact(rows, powers):
    """Velocity with which the sphere is back at the height of first touch; None: it stays below.

    Its square is extrapolated over the overlap, in which it is a series of these powers, also where little velocity is
    left. The last row is left out: where the force
    ends with a root of the overlap, the error of the last step depends on where in it the contact ends."""
    start = rows[0][1]
    turned = next((i for i, row in enumerate(rows) if row[2] > 0), None)
    end = None if turned is None else next((i for i in range(turned, len(rows)) if rows[i][1] >= start), None)
    if end is None:
        return None
    inside = rows[max(0, end - 2 - len(powers)):end - 1]
    return max(0.0, at_step_zero([start - row[1] for row in inside], [row[2] ** 2 for row in inside], powers)) ** 0.5


def end_of_flight(rows):
    """Velocity that no longer changes; None: a force still acts, or the sphere is at rest."""
    return rows[-1][2] if rows[-1][2] > 0 and rows[-1][2] == rows[-2][2] else None


def at_step_zero(steps, values, powers):
    """c0 of value(h) = c0 + c1 h^p1 + ... through all points."""
    largest = max(steps)
    rows = [[1.0] + [(h / largest) ** p for p in powers[:len(steps) - 1]] + [v] for h, v in zip(steps, values)]
    size = len(rows)
    for column in range(size):
        pivot = max(range(column, size), key=lambda i: abs(rows[i][column]))
        rows[column], rows[pivot] = rows[pivot], rows[column]
        for i in range(size):
            if i != column:
                factor = rows[i][column] / rows[column][column]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[column])]
    return rows[0][size] / rows[0][0]


def along(impact, rows):
    """(e_t, rebound angle [deg], spin) of the code, and how far v_t' and spin are off, relative to each or to its change."""
    _, _, away, found, spin = rows[-1]
    before, after, turned = (impact[key]["value"] for key in
                             ("tangential_velocity", "rebound_tangential_velocity", "spin"))
    off = max(abs(found - after) / max(abs(after), abs(before - after)), abs(spin / turned - 1))
    return found / before, math.degrees(math.atan2(found, away)), spin, off


def main():
    with open("expected.json") as file:
        expected = json.load(file)
    runs = read_log(sys.argv[1] if len(sys.argv) > 1 else expected["log"])
    failures = 0
    print("   d [um]     v [m/s]   outcome      e expected         e found   difference")
    for number, impact in enumerate(expected["impacts"], 1):
        mine = [run for run in runs if run[0] == number and run[3]]
        velocity = impact["velocity"]["value"]
        ends = [(run[2], end_of_flight(run[3]) if expected.get("end") == "free-flight"
                 else end_of_contact(run[3], expected["end_powers"])) for run in mine]
        captured = [end is None for _, end in ends]
        outcome = "none" if not ends else "capture" if all(captured) else "rebound" if not any(captured) else "both"
        found = 0.0
        if outcome == "rebound":
            found = at_step_zero([h for h, _ in ends], [v / velocity for _, v in ends], expected["powers"])
        difference = found - impact["restitution"]["value"]
        agrees = outcome == impact["outcome"] and abs(difference) <= expected["tolerance"]
        sideways = ""
        if "spin" in impact and found > 0:
            *numbers, off = along(impact, mine[-1][3])
            agrees = agrees and off <= expected["tangential_tolerance"]
            sideways = "   e_t %.5f for %.5f, rebound %.3f for %.3f deg, spin %.6g for %.6g rad/s" % (
                numbers[0], impact["tangential_restitution"]["value"], numbers[1],
                math.degrees(impact["rebound_angle"]["value"]), numbers[2], impact["spin"]["value"])
        failures += not agrees
        print("%9.4g %11.6g   %-8s %13.9f %15.9f   %10.1e%s"
              % (1e6 * impact["diameter"]["value"], velocity, outcome, impact["restitution"]["value"], found,
                 difference, sideways + ("" if agrees else "   differs: expected " + impact["outcome"])))
    print("%d of %d impacts agree within %g" % (len(expected["impacts"]) - failures, len(expected["impacts"]),
                                                expected["tolerance"]))
    return 1 if failures or not expected["impacts"] else 0


if __name__ == "__main__":
    sys.exit(main())
