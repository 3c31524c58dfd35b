#!/usr/bin/env python3
"""Holds ash_table.py against expected.json. Exit status 0: all agree, 1: some do not."""
import json
import os
import sys

import ash_table


def main():
    with open(os.path.join(ash_table.FOLDER, "expected.json")) as file:
        expected = json.load(file)
    failures = 0
    print("   d [um]     v [m/s]   outcome      e expected      e of table   difference")
    for impact in expected["impacts"]:
        diameter, velocity = impact["diameter"]["value"], impact["velocity"]["value"]
        found = ash_table.restitution(diameter, velocity)
        difference = found - impact["restitution"]["value"]
        agrees = (found > 0) == (impact["outcome"] == "rebound") and abs(difference) <= expected["tolerance"]
        if "spin" in impact:
            v_t = impact["tangential_velocity"]["value"]
            _, along, spin = ash_table.oblique(diameter, velocity, v_t) or (0.0, 0.0, 0.0)
            scale = expected["tangential_tolerance"] * (velocity + v_t)
            agrees = (agrees and abs(along - impact["rebound_tangential_velocity"]["value"]) <= scale
                      and abs(spin - impact["spin"]["value"]) * diameter / 5 <= scale)
        failures += not agrees
        print("%9.4g %11.6g   %-8s %13.9f %15.9f   %10.1e%s"
              % (1e6 * diameter, velocity, impact["outcome"], impact["restitution"]["value"], found, difference,
                 "" if agrees else "   differs"))
    print("%d of %d impacts agree within %g" % (len(expected["impacts"]) - failures, len(expected["impacts"]),
                                                expected["tolerance"]))
    return 1 if failures or not expected["impacts"] else 0


if __name__ == "__main__":
    sys.exit(main())
