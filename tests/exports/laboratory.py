# SPDX-License-Identifier: GPL-3.0-or-later
"""A made-up laboratory of three sieve sizes, by an integrator of its own: Hertz and DMT, m x'' = -k x^(3/2) + 2 pi w R - eta x',
with a damping that falls with the velocity of approach above the critical one, and differs from particle to particle.
Nothing here comes from ashimpact."""
import json
import math
import os
import random

DENSITY, CONTACT_MODULUS, WORK_OF_ADHESION = 2300.0, 90e9, 0.3
DAMPING = {60e-6: 0.0066, 90e-6: 0.0148, 130e-6: 0.0305}    # at capture [kg/s]
NOISE = 0.012      # of each velocity [m/s]
SCATTER = 0.004    # of ln(damping) between particles
IMPACTS = 60       # of each size


def restitution(diameter, velocity, damping):
    """By Runge-Kutta steps in scaled time; 0: the sphere stays."""
    radius, mass = diameter / 2, DENSITY * math.pi / 6 * diameter ** 3
    stiffness = 4 / 3 * CONTACT_MODULUS * math.sqrt(radius)
    pull = 2 * math.pi * WORK_OF_ADHESION * radius

    def acceleration(x, u):
        return (pull - stiffness * max(x, 0.0) ** 1.5 - damping * u) / mass

    step = 3.2 * (mass ** 2 / (stiffness ** 2 * velocity)) ** 0.2 / 1500
    x, u = 0.0, velocity
    for _ in range(30000):
        k1x, k1u = u, acceleration(x, u)
        k2x, k2u = u + step / 2 * k1u, acceleration(x + step / 2 * k1x, u + step / 2 * k1u)
        k3x, k3u = u + step / 2 * k2u, acceleration(x + step / 2 * k2x, u + step / 2 * k2u)
        k4x, k4u = u + step * k3u, acceleration(x + step * k3x, u + step * k3u)
        before, speed = x, u
        x += step / 6 * (k1x + 2 * k2x + 2 * k3x + k4x)
        u += step / 6 * (k1u + 2 * k2u + 2 * k3u + k4u)
        if x <= 0:
            share = before / (before - x)
            return max(0.0, -(speed + share * (u - speed)) / velocity)
        if speed < 0 <= u:
            return 0.0    # it turns back inside
    return 0.0


def critical_velocity(diameter):
    """Of the damping at capture [m/s]"""
    low, high = 1e-3, 50.0
    for _ in range(40):
        middle = math.sqrt(low * high)
        if restitution(diameter, middle, DAMPING[diameter]) > 0:
            high = middle
        else:
            low = middle
    return high


def damping(diameter, velocity, critical):
    excess = max(0.0, velocity / critical - 1)
    return DAMPING[diameter] * (0.52 + 0.48 / (1 + 0.9 * excess ** 0.6))


class Laboratory:
    def __init__(self):
        self.critical = {d: critical_velocity(d) for d in DAMPING}

    def true_restitution(self, diameter, velocity):
        return restitution(diameter, velocity, damping(diameter, velocity, self.critical[diameter]))

    def scatter(self, diameter, velocity):
        """Standard deviation of one measured e: of both velocities, and of the particles."""
        eta = damping(diameter, velocity, self.critical[diameter])
        e, other = restitution(diameter, velocity, eta), restitution(diameter, velocity, eta * math.exp(SCATTER))
        return math.hypot(NOISE * math.sqrt(1 + e * e) / velocity, e - other)

    def write_case(self, folder, law):
        """case.json with the measured impacts of the three sizes."""
        draw = random.Random(20261126)
        samples = []
        for diameter, critical in self.critical.items():
            incident, rebound = [], []
            for i in range(IMPACTS):
                velocity = critical * 0.8 * (6.5 / 0.8) ** ((i + draw.random()) / IMPACTS)
                eta = damping(diameter, velocity, critical) * math.exp(draw.gauss(0, SCATTER))
                back = velocity * restitution(diameter, velocity, eta)
                incident.append(velocity + draw.gauss(0, NOISE))
                rebound.append(max(0.0, back + draw.gauss(0, NOISE)) if back > 0 else 0.0)
            samples.append({"name": "%.0f um" % (1e6 * diameter), "diameter": diameter,
                            "composition": {"weight_fractions": {"quartz": 0.4, "mullite": 0.6}, "amorphous": 0},
                            "contact_modulus": CONTACT_MODULUS, "density": DENSITY,
                            "restitution": {"velocity": {"values": incident, "unit": "m/s"},
                                            "rebound_velocity": {"values": rebound, "unit": "m/s"},
                                            "velocity_uncertainty": [NOISE] * IMPACTS,
                                            "rebound_uncertainty": [NOISE] * IMPACTS}})
        path = os.path.join(folder, "laboratory.json")
        with open(path, "w") as file:
            json.dump({"name": "made-up laboratory", "laws": [law], "work_of_adhesion": WORK_OF_ADHESION,
                       "samples": samples}, file, indent=1)
        return path
