#!/usr/bin/env python3
"""Compares ash_wall, compiled against the stand-in for udf.h, with expected.json; asks it beyond its table and with
particles of another density, too.
Exit status 0: all agree, 1: some do not."""
import json
import os
import subprocess
import sys

FOLDER = os.path.dirname(os.path.abspath(__file__))


def asked(particles, density):
    """((e, tangential velocity after it) of each particle, messages)"""
    text = "".join("%.17g %.17g %.17g %.17g\n" % (*particle, density) for particle in particles)
    answer = subprocess.run([os.path.join(FOLDER, "stand_in/check")], input=text, stdout=subprocess.PIPE, check=True,
                            universal_newlines=True)
    lines = answer.stdout.splitlines()
    messages = [line for line in lines if line.startswith("ash_wall")]
    return [tuple(float(word) for word in line.split()[2:]) for line in lines if line not in messages], messages


def sideways(impact, key):
    """A tangential velocity [m/s]; 0 of a normal impact."""
    return impact.get(key, {"value": 0.0})["value"] or 0.0


def main():
    with open(os.path.join(FOLDER, "expected.json")) as file:
        expected = json.load(file)
    impacts = [(i["diameter"]["value"], i["velocity"]["value"], sideways(i, "tangential_velocity"), i["outcome"],
                i["restitution"]["value"], sideways(i, "rebound_tangential_velocity")) for i in expected["impacts"]]
    densities = expected["densities"]["values"]
    density = densities[0]
    particles = [impact[:3] for impact in impacts]
    found_all, _ = asked(particles, density)
    failures = 0
    print("   d [um]     v [m/s]   outcome      e expected    e of ash_wall   difference")
    for (d, v, v_t, outcome, e, after), (found, along) in zip(impacts, found_all):
        agrees = found >= 0 and (found > 0) == (outcome == "rebound") and abs(found - e) <= expected["tolerance"]
        agrees = agrees and (outcome == "capture" or abs(along - after) <= expected["tangential_tolerance"] * (v + v_t))
        failures += not agrees
        print("%9.4g %11.6g   %-8s %13.9f %16.9f   %10.1e%s"
              % (1e6 * d, v, outcome, e, found, found - e, "" if agrees else "   differs"))
    wrong = 0
    d, v = impacts[0][:2]
    for particle in ((100 * max(i[0] for i in impacts), v, 0.0), (d, 1e9, 0.0)):
        answers, message = asked([particle], density)
        if answers[0][0] != -1.0 or len(message) != 1:
            wrong += 1
            print("a particle of %g m at %g m/s is not refused" % particle)
    least, greatest = min(densities), max(densities)
    for of, warnings in ((least, 0), (0.995 * least, 0), (1.005 * greatest, 0), (0.98 * least, 1), (1.02 * greatest, 1)):
        answers, message = asked(particles, of)
        if answers != found_all or len(message) != warnings:
            wrong += 1
            print("particles of %g kg/m3: %d warnings, not %d" % (of, len(message), warnings))
    print("%d of %d impacts agree within %g; beyond the table and for another density it %s"
          % (len(impacts) - failures, len(impacts), expected["tolerance"],
             "does what it should not" if wrong else "says so"))
    return 1 if failures or wrong or not impacts else 0


if __name__ == "__main__":
    sys.exit(main())
