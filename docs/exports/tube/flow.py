#!/usr/bin/env python3
"""Writes the potential flow around a cylinder at the cell centres of 0/C into 0/U."""
import re

SPEED, RADIUS = 10.0, 0.019     # far upstream [m/s]; of the tube [m]

with open("0/C") as file:
    text = file.read()
body = text[text.index("internalField"):text.index("boundaryField")]
lines = []
for x, y, _ in (map(float, entry.split()) for entry in re.findall(r"\(([-+.e0-9]+ [-+.e0-9]+ [-+.e0-9]+)\)", body)):
    share = RADIUS ** 2 / (x * x + y * y) ** 2
    lines.append("(%.9g %.9g 0)" % (SPEED * (1 - share * (x * x - y * y)), -2 * SPEED * share * x * y))
with open("0/U") as file:
    text = file.read()
with open("0/U", "w") as file:
    file.write(text.replace("internalField uniform (10 0 0);",
                            "internalField nonuniform List<vector>\n%d\n(\n%s\n);" % (len(lines), "\n".join(lines))))
