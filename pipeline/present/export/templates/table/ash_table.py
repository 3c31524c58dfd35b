"""Restitution of ash by diameter and normal velocity, and with friction rebounds at an angle, from critical_velocity.csv and table.csv beside this file."""
import bisect
import csv
import math
import os

FOLDER = os.path.dirname(os.path.abspath(__file__))
FRICTION = @friction@    # of the export
FROM_VELOCITY, TO_VELOCITY, CAPTURES = @from_velocity_exact@, @to_velocity_exact@, @captures@


def rows_of(name):
    with open(os.path.join(FOLDER, name)) as file:
        rows = csv.reader(file)
        next(rows)
        return list(rows)


SIZES = [[float(cell) for cell in row] for row in rows_of("critical_velocity.csv")]
DIAMETERS = [row[0] for row in SIZES]
TABLE = rows_of("table.csv")
NODES = len(TABLE) // len(DIAMETERS)
STEP = float(TABLE[1][1])
RESTITUTION, ATTRACTION = 4, 7    # columns of TABLE; the second is there with friction


def interval(diameter):
    """Number of the interval of diameters, the place in it from 0 to 1, its width in ln d."""
    if not DIAMETERS[0] <= diameter <= DIAMETERS[-1]:
        raise ValueError("diameter %g m; the table holds %g to %g m" % (diameter, DIAMETERS[0], DIAMETERS[-1]))
    if len(DIAMETERS) == 1:
        return 0, 0.0, 1.0
    i = min(max(bisect.bisect_right(DIAMETERS, diameter), 1), len(DIAMETERS) - 1) - 1
    width = math.log(DIAMETERS[i + 1] / DIAMETERS[i])
    return i, math.log(diameter / DIAMETERS[i]) / width, width


def start_velocity(diameter):
    """v_c [m/s], or where nothing is captured the smallest velocity of the table."""
    i, s, width = interval(diameter)
    low, high = SIZES[i], SIZES[min(i + 1, len(SIZES) - 1)]
    return math.exp((1 + 2 * s) * (1 - s) ** 2 * math.log(low[2]) + s * s * (3 - 2 * s) * math.log(high[2])
                    + s * (1 - s) * width * ((1 - s) * low[3] - s * high[3]))


def looked_up(column, diameter, velocity):
    """A column of the table, 0 for a capture."""
    if not FROM_VELOCITY <= velocity <= TO_VELOCITY:
        raise ValueError("velocity %g m/s; the table holds %g to %g m/s" % (velocity, FROM_VELOCITY, TO_VELOCITY))
    start = start_velocity(diameter)
    if CAPTURES and velocity < start:
        return 0.0
    place = math.asinh(math.sqrt(max(0.0, velocity / start - 1))) / STEP
    j = min(int(place), NODES - 2)
    b = place - j
    i, a, _ = interval(diameter)
    along = [(1 - b) * float(TABLE[k + j][column]) + b * float(TABLE[k + j + 1][column])
             for k in range(i * NODES, min(i + 2, len(DIAMETERS)) * NODES, NODES)]
    return along[0] if len(along) == 1 else (1 - a) * along[0] + a * along[1]


def restitution(diameter, velocity):
    """e, 0 for a capture."""
    return looked_up(RESTITUTION, diameter, velocity)


def oblique(diameter, velocity, along, spin=0.0):
    """Normal velocity, velocity along the wall and spin after an impact; None for a capture. The spin adds to the slip."""
    e = restitution(diameter, velocity)
    if e == 0.0:
        return None
    push = (1 + e + looked_up(ATTRACTION, diameter, velocity)) * velocity    # impulse over mass
    slip = along + spin * diameter / 2
    impulse = math.copysign(min(FRICTION * push, 2 / 7 * abs(slip)), slip) if slip else 0.0
    return e * velocity, along - impulse, spin - 5 * impulse / diameter
