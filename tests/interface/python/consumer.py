# SPDX-License-Identifier: GPL-3.0-or-later
"""A user's program, checked by mypy --strict against the module's types and run as it is."""

import math

import numpy as np
import numpy.typing as npt

import ashimpact


def captured_share(diameter: npt.NDArray[np.float64], velocity: float) -> float:
    result: ashimpact.Impacts = ashimpact.impacts(
        law="jkr",
        radius=diameter / 2,
        density=2160.0,
        contact_modulus=60e9,
        work_of_adhesion=0.3,
        damping=1e-6,
        velocity=velocity,
    )
    return float(np.mean(result.captured))


share = captured_share(np.geomspace(1e-6, 100e-6, 50), 0.5)
assert 0.0 < share < 1.0
threshold: ashimpact.CriticalVelocities = ashimpact.critical_velocities(
    law="hertz", radius=22e-6, density=2160.0, contact_modulus=60e9, damping=1e-5
)
assert math.isfinite(float(threshold.critical_velocity))
