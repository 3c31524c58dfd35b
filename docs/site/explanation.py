#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""explanation.py PROGRAM RUN FOLDER: the computed pictures of docs/explanation.md, RUN being the folder of the built-in case."""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # nothing is left in the sources
from drawing import LEFT, RIGHT, Axes, Picture, coloured, label

# One particle for all pictures: 88 um of fly ash on steel.
PARTICLE = ["--radius", "44 um", "--density", "2600 kg/m3", "--contact-modulus", "90 GPa"]
ADHESION = ["--work-of-adhesion", "0.3 J/m2"]
DAMPING = ["--damping", "0.005 kg/s"]
DASHES = {"hertz": "", "dmt": "8 3", "brach-dunn": "2.5 2.5", "jkr": "9 3 2 3"}
COLOURS = {"hertz": "blue", "dmt": "red", "brach-dunn": "green", "jkr": "violet"}


class Program:
    def __init__(self, path, scratch):
        self.path, self.scratch = path, scratch

    def answer(self, command, law, *options):
        adhesion = [] if law == "hertz" else ADHESION
        words = [self.path, command, "--quiet", "--json", "--law", law, *PARTICLE, *adhesion, *options]
        return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)

    def impact(self, law, velocity, *options, points=161):
        """The columns of the trajectory, in SI, and what the program says of the impact."""
        path = f"{self.scratch}/trajectory.csv"
        said = self.answer("impact", law, "--velocity", repr(velocity), "--trajectory", path, "--points", str(points), *options)
        with open(path, encoding="utf-8", newline="") as file:
            rows = [{name.split(" [")[0]: float(cell) for name, cell in row.items()} for row in csv.DictReader(file)]
        return rows, said

    def critical_velocity(self, *options):
        return self.answer("critical-velocity", "jkr", *options)["critical_velocity"]["value"]


def static_force(row):
    return row["repulsive_force"] + row["attractive_force"]


def adhesion(program, _run):
    """Static force over overlap, from the rebound of an undamped impact."""
    picture = Picture("Static force over overlap for four contact laws", 308)
    axes = Axes(picture, 30, 262, (-2, 5), (-140, 260))
    axes.frame([-2, 0, 2, 4], [-100, 0, 100, 200], "overlap δ [nm]", "force [µN], positive where it pushes apart")
    picture.line([axes.at(-2, 0), axes.at(5, 0)], "soft", kind="thin")
    names = {"hertz": (0.5, 105, "Hertz"), "dmt": (4.1, 75, "DMT"), "brach-dunn": (2.5, -128, "Brach-Dunn"), "jkr": (2.3, 150, "JKR")}
    for law in ("hertz", "dmt", "brach-dunn", "jkr"):
        rows, _ = program.impact(law, 0.04)
        rebound = [row for row in rows if row["velocity"] <= 0.0 and row["overlap"] < 5e-9]
        overlaps, forces = [1e9 * row["overlap"] for row in rebound], [1e6 * static_force(row) for row in rebound]
        inside = [place for place, force in enumerate(forces) if force <= 260][0]
        axes.curve(overlaps[inside:], forces[inside:], COLOURS[law], DASHES[law])
        x, y, name = names[law]
        picture.text(*axes.at(x, y), coloured(name, COLOURS[law]))
        if law == "jkr":
            end = axes.at(overlaps[-1], forces[-1])
            picture.dot(*end, COLOURS[law])
            picture.text(end[0] - 22, end[1] - 26, "pull-off")
            picture.arrow((end[0], end[1] - 22), (end[0], end[1] - 6))
    return picture


def damping(program, _run):
    """The loop of total force over overlap, whose area is the energy lost."""
    rows, said = program.impact("jkr", 2.0, *DAMPING)
    energy = said["energy"]
    overlaps = [1e9 * row["overlap"] for row in rows]
    forces = [1e3 * (static_force(row) + row["damping_force"]) for row in rows]
    picture = Picture("Force over overlap of one impact with damping", 308)
    axes = Axes(picture, 30, 262, (-5, 120), (-6, 36))
    picture.area([axes.at(x, y) for x, y in zip(overlaps, forces)], "red", 0.18)
    axes.frame([0, 40, 80, 120], [0, 10, 20, 30], "overlap δ [nm]", "force on the particle [mN]")
    picture.line([axes.at(-5, 0), axes.at(120, 0)], "soft", kind="thin")
    loading = [row for row in rows if row["velocity"] >= 0.0]
    axes.curve([1e9 * row["overlap"] for row in loading], [1e3 * static_force(row) for row in loading], "blue", "8 3")
    axes.curve(overlaps, forces, "red")
    picture.dot(*axes.at(overlaps[0], forces[0]), "red", 3.5)
    picture.text(*axes.at(22, 19), coloured("approach", "red"))
    picture.text(*axes.at(52, -3.5), coloured("rebound", "red"))
    picture.text(*axes.at(79, 30), coloured("spring", "blue"))
    picture.arrow(axes.at(93, 29), axes.at(100, 25.5), "blue")
    lost = (energy["dissipated"]["value"] + energy["plastic"]["value"]) / energy["incident"]["value"]
    picture.text(*axes.at(0, 32), f"area: {100 * lost:.0f} % of")
    picture.text(*axes.at(0, 28.8), "the energy is lost")
    return picture


def capture(program, _run):
    """Overlap over time just below and just above the critical velocity: the whole impact, and its end enlarged."""
    critical = program.critical_velocity(*DAMPING)
    below, _ = program.impact("jkr", 0.9 * critical, *DAMPING, points=321)
    above, _ = program.impact("jkr", 1.1 * critical, *DAMPING, points=321)
    picture = Picture("Overlap over time just below and just above the critical velocity", 308)
    axes = Axes(picture, 30, 262, (0, 1400), (-2, 10))
    axes.frame([0, 400, 800, 1200], [0, 4, 8], "time since first touch [ns]", "overlap δ [nm]")
    picture.line([axes.at(0, 0), axes.at(1400, 0)], "soft", kind="thin")
    for rows, colour, dash in ((below, "blue", ""), (above, "red", "8 3")):
        places = [(1e9 * row["time"], 1e9 * row["overlap"]) for row in rows if row["time"] < 1400e-9]
        axes.curve([x for x, _ in places], [y for _, y in places], colour, dash)
    end = axes.at(1e9 * above[-1]["time"], 1e9 * above[-1]["overlap"])
    picture.dot(*end, "red")
    picture.text(end[0] + 10, end[1] + 6, coloured(label("1.1 v", "c", ": it leaves"), "red"))
    picture.text(*axes.at(620, 3.2), coloured(label("0.9 v", "c", ": it stays"), "blue"))
    return picture


def restitution_over_velocity(program, _run):
    """Restitution over velocity, with damping and with adhesion alone, and where v_c lies."""
    picture = Picture("Restitution over incident velocity", 308)
    axes = Axes(picture, 30, 262, (0.005, 10), (0, 1.1), logarithmic=True)
    critical, alone = program.critical_velocity(*DAMPING), program.critical_velocity()
    picture.rectangle(LEFT, 30, axes.right_of(critical) - LEFT, 232, "shade")
    axes.frame([0.01, 0.1, 1, 10], [0, 0.5, 1], label("incident velocity v", "in", " [m/s]"), label("restitution e", "n"))
    for options, start, colour, dash in ((DAMPING, critical, "red", ""), ([], alone, "blue", "8 3")):
        velocities = [start * (10 / start) ** ((i / 24) ** 2) for i in range(1, 25)]
        answers = [program.answer("impact", "jkr", "--velocity", repr(velocity), *options) for velocity in velocities]
        axes.curve([start, *velocities], [0.0, *(answer["restitution"]["value"] for answer in answers)], colour, dash)
        picture.dot(*axes.at(start, 0), colour)
    picture.line([axes.at(0.005, 0), axes.at(critical, 0)], "red")
    picture.text(*axes.at(0.15, 1.03), coloured("adhesion alone", "blue"))
    picture.text(*axes.at(1, 0.68), coloured("with damping", "red"), "mid")
    picture.text(LEFT + 66, axes.at(1, 0.3)[1], "stays", "mid")
    picture.text(axes.right_of(2.2), axes.at(1, 0.3)[1], "rebounds", "mid")
    picture.text(axes.right_of(critical) + 8, axes.at(1, 0.05)[1], label("v", "c", f" = {critical:.2g} m/s"))
    return picture


def interval(_program, run):
    """v_c of one sample by every law with what its inputs leave open, and where that comes from."""
    with open(f"{run}/7-critical-velocity.json", encoding="utf-8") as file:
        sample = [each for each in json.load(file)["result"]["samples"] if each["name"] == "104 um"][0]
    picture = Picture("Critical velocities, what their inputs leave open, and where one of these intervals comes from", 420)
    axes = Axes(picture, 30, 182, (0.4, 0.76), (0, 6))
    left, right = 130, RIGHT

    def across(velocity):
        return left + (velocity - 0.4) / (0.76 - 0.4) * (right - left)

    for tick in (0.4, 0.5, 0.6, 0.7):
        picture.line([(across(tick), axes.top), (across(tick), axes.bottom)], "soft", kind="grid")
        picture.text(across(tick), axes.bottom + 18, f"{tick:g}", "soft mid")
    picture.rectangle(left, axes.top, right - left, axes.bottom - axes.top, "thin")
    picture.text(8, 22, label("v", "c", " [m/s] and what the inputs leave open"), "bold")
    names = {"hertz": "Hertz", "dmt": "DMT", "brach-dunn": "Brach-Dunn", "jkr": "JKR", "maugis-dugdale": "Maugis-Dugdale", "measured": "measured"}
    for place, (key, name) in enumerate(names.items()):
        y = axes.top + 18 + 23.5 * place
        value, ends = sample[key]["critical_velocity"]["value"], sample[key]["interval"]
        colour = "ink" if key == "measured" else "red" if key == "maugis-dugdale" else "blue"
        picture.text(left - 8, y + 5, name, "end")
        if ends["lower"]:    # the measured one states no uncertainty
            picture.line([(across(ends["lower"]["value"]), y), (across(ends["upper"]["value"]), y)], colour)
            for end in ("lower", "upper"):
                x = across(ends[end]["value"])
                picture.line([(x, y - 5), (x, y + 5)], colour)
        picture.dot(across(value), y, colour, 3.5)
    picture.text(8, 234, "What the red one comes from", "bold")
    influences = sample["maugis-dugdale"]["uncertainty"]["influences"]
    shares = {"the fit": 0.0, "density": 0.0, "adhesion": 0.0, "moduli": 0.0}
    of = {"damping fit": "the fit", "density": "density", "work of adhesion": "adhesion"}
    for influence in influences:
        shares[of.get(influence["factor"], "moduli")] += max(0.0, influence["first"])
    for place, (name, share) in enumerate(shares.items()):
        y = 262 + 36 * place
        picture.text(left - 8, y + 5, name, "end")
        end = left + (RIGHT - left - 50) * share / 0.6
        picture.area([(left, y - 11), (end, y - 11), (end, y + 11), (left, y + 11)], "red", 1)
        picture.text(end + 6, y + 5, f"{100 * share:.0f} %")
    picture.text(8, 408, label("shares of the variance of v", "c"), "soft")
    return picture


def make(path, run, folder):
    makers = {"adhesion": adhesion, "damping": damping, "capture": capture,
              "restitution-over-velocity": restitution_over_velocity, "interval": interval}
    with tempfile.TemporaryDirectory() as scratch:
        program = Program(path, scratch)
        for name, maker in makers.items():
            (folder / f"{name}.svg").write_text(str(maker(program, run)), encoding="utf-8")
    figure = folder / "regime-map.svg"
    subprocess.run([path, "figure", "regime-map", run, "--width", "single", "-o", str(figure)], check=True, capture_output=True)
    # Made for print: its small numbers are enlarged for small screens.
    figure.write_text(figure.read_text(encoding="utf-8").replace(".tick{font-size:11px}", ".tick{font-size:12px}"), encoding="utf-8")


if __name__ == "__main__":
    make(sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]))
