#!/usr/bin/env python3
"""Adds the rows of one contact law to impacts.json, by an integration that shares no line with the program.

    python3 impacts.py LAW [NAME=VALUE ...]     rows of LAW; NAME=VALUE: a parameter of its own, in SI
    python3 impacts.py --check                  recomputes the rows that impacts.json has, prints the worst

m x'' + eta x' + F(x) = 0 is integrated in time by scipy's DOP853 (rtol 1e-13) from first touch to zero overlap.
A new law is a line in FORCES. Rows of jkr and of the detachment zero-force came from the same integrator with
their own end of contact; --check leaves them out. Needs python3-scipy.
"""
import json
import math
import pathlib
import sys

from scipy.integrate import solve_ivp

FILE = pathlib.Path(__file__).with_name("impacts.json")

# Attraction F_a(x) [N] beside Hertz, from w [J/m2], R [m], E* [Pa] and the law's own parameters, written from the
# source of each law.
FORCES = {
    "hertz": lambda w, r, e, p: lambda x: 0.0,
    "dmt": lambda w, r, e, p: lambda x: 2 * math.pi * w * r,
    "brach-dunn": lambda w, r, e, p: lambda x: 2 * math.pi * (6 * w**2 * r * e / math.pi) ** (1 / 3) * math.sqrt(r * x),
    "sjkr": lambda w, r, e, p: lambda x: p["cohesion_energy_density"] * math.pi * r * x,
}


def impact(sphere, law, w, parameters, damping, velocity):
    """Outcome, restitution, contact time and greatest overlap of one impact."""
    m, r, e = sphere["mass"], sphere["radius"], sphere["contact_modulus"]
    attraction = FORCES[law](w, r, e, parameters)
    # Lengths in L and times in L/v: what the tolerances are relative to.
    length = (m * velocity**2 / (4 / 3 * e * math.sqrt(r))) ** 0.4
    unit = m * velocity**2 / length

    def motion(_, y):
        x = max(y[0], 0.0) * length
        force = 4 / 3 * e * math.sqrt(r) * x**1.5 - attraction(x)
        return [y[1], -(force + damping * y[1] * velocity) / unit]

    def turn(_, y):
        return y[1]

    def end(_, y):
        return y[0]

    turn.terminal = end.terminal = True
    turn.direction = end.direction = -1
    options = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-16}
    inward = solve_ivp(motion, (0, 100), [0.0, 1.0], events=turn, **options)
    top = inward.y_events[0][0][0]
    back = turn
    back.direction = 1  # a particle that turns again on its way out is captured
    outward = solve_ivp(motion, (0, 1000), [top, -1e-300], events=(end, back), **options)
    rebound = len(outward.t_events[0]) == 1
    seconds = (inward.t_events[0][0] + outward.t[-1]) * length / velocity
    return {"outcome": "rebound" if rebound else "capture",
            "restitution": -outward.y[1][-1] if rebound else 0.0,
            "contact_time": seconds if rebound else None,
            "maximum_overlap": top * length}


def check(data):
    worst = {}
    for row in data["cases"]:
        if row["law"] not in FORCES or row["detachment"] != "zero-overlap":
            continue
        own = impact(data["sphere"], row["law"], row["work_of_adhesion"], row.get("parameters", {}), row["damping"],
                     row["velocity"])
        assert own["outcome"] == row["outcome"], row
        for key in ("restitution", "contact_time", "maximum_overlap"):
            if row[key]:
                difference = abs(own[key] / row[key] - 1)
                worst[key] = max(worst.get(key, 0), difference)
    print(worst)


def main():
    data = json.loads(FILE.read_text())
    if sys.argv[1:] == ["--check"]:
        return check(data)
    law, *given = sys.argv[1:]
    parameters = {name: float(value) for name, value in (each.split("=") for each in given)}
    for damping in (0.0, 0.002, 0.0141):
        for velocity in (0.1, 0.5, 2.0, 10.0):
            row = {"law": law, "work_of_adhesion": 0.0 if parameters else 0.3}
            if parameters:
                row["parameters"] = parameters
            row |= {"detachment": "zero-overlap", "damping": damping, "velocity": velocity}
            row |= impact(data["sphere"], law, row["work_of_adhesion"], parameters, damping, velocity)
            data["cases"].append(row)
    FILE.write_text(json.dumps(data, indent=1) + "\n")


main()
