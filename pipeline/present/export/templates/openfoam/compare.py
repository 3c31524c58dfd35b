#!/usr/bin/env python3
"""Compares the parcels of check/ with expected.json: what the model recorded at the wall, and the velocity with which
each parcel flies away in the end. Usage: compare.py [TOLERANCE]. Exit status 0: all agree, 1: some do not."""
import csv
import glob
import json
import os
import re
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))


def field(path):
    """The list of a lagrangian field in ASCII, each entry a list of numbers."""
    with open(path) as file:
        text = re.sub(r"FoamFile\s*\{.*?\}|//[^\n]*|/\*.*?\*/", "", file.read(), flags=re.S)
    size, bracket, body = re.search(r"(\d+)\s*([({])(.*)[)}]", text, re.S).groups()
    entries = re.findall(r"\([^()]*\)|[-+0-9.eE]+", body)
    entries = [[float(x) for x in entry.strip("()").split()] for entry in entries]
    return entries * int(size) if bracket == "{" else entries


def main():
    with open(os.path.join(FOLDER, "expected.json")) as file:
        expected = json.load(file)
    records = []
    for path in glob.glob(os.path.join(FOLDER, "check/postProcessing/ashImpact/kinematicCloud/impacts_*.csv")):
        with open(path) as file:
            records += list(csv.DictReader(file))
    place = os.path.join(FOLDER, "check/0.001/lagrangian/kinematicCloud")
    left = {}    # velocities in the end, by the rank that injected a parcel and its number there
    if os.path.isdir(place):
        origins = zip(*([int(x[0]) for x in field("%s/%s" % (place, name))] for name in ("origProcId", "origId")))
        left = dict(zip(origins, field(place + "/U")))
    nowhere = [float("nan")] * 3
    tolerance = float(sys.argv[1]) if len(sys.argv) > 1 else expected["tolerance"]
    failures = 0
    print("   d [um]     v [m/s]   outcome      e expected       e at wall   difference   e of flight")
    for impact in expected["impacts"]:
        d, v, e = (impact[key]["value"] for key in ("diameter", "velocity", "restitution"))
        v_t, after = (impact.get(key, {"value": 0.0})["value"] or 0.0
                      for key in ("tangential_velocity", "rebound_tangential_velocity"))
        mine = [row for row in records if abs(float(row["diameter [m]"]) / d - 1) < 1e-9
                and abs(float(row["velocity [m/s]"]) / v - 1) < 1e-6
                and abs(float(row["tangential_velocity [m/s]"]) - v_t) < 1e-6 * (v + v_t)]
        found = float(mine[0]["restitution [1]"]) if mine else float("nan")
        away = left.get((int(mine[0]["origProc"]), int(mine[0]["origId"])), nowhere) if mine else nowhere
        flight = abs(away[2]) / v
        agrees = (len(mine) == 1 and (found > 0) == (impact["outcome"] == "rebound") and abs(found - e) <= tolerance
                  and abs(flight - found) <= 1e-9
                  and (found == 0 or abs(away[0] - after) <= expected["tangential_tolerance"] * (v + v_t)))
        failures += not agrees
        print("%9.4g %11.6g   %-8s %13.9f %15.9f   %10.1e %13.9f%s"
              % (1e6 * d, v, impact["outcome"], e, found, found - e, flight, "" if agrees else "   differs"))
    print("%d of %d parcels agree within %g" % (len(expected["impacts"]) - failures, len(expected["impacts"]),
                                                tolerance))
    return 1 if failures or not expected["impacts"] else 0


if __name__ == "__main__":
    sys.exit(main())
