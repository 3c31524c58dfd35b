# SPDX-License-Identifier: GPL-3.0-or-later
"""Impacts of fly-ash particles: from an XRD result to the dynamic critical velocity.

Numbers are SI throughout: metres, kilograms, seconds, pascals. Arrays broadcast as in numpy. What is not
admissible raises InputError, a ValueError, with one line that says what is wrong and what is allowed.

    >>> import ashimpact
    >>> ash = dict(law="jkr", radius=22e-6, density=2160.0, contact_modulus=60e9, work_of_adhesion=0.3,
    ...            damping=1e-5)
    >>> critical = ashimpact.critical_velocities(**ash).critical_velocity
    >>> bool(ashimpact.impacts(velocity=0.9 * critical, **ash).captured)
    True
"""

import importlib.machinery as _machinery
import pathlib as _pathlib
import sys as _sys

_built = {path.name[5:] for path in _pathlib.Path(__file__).parent.glob("_core*.so")}
if _built and not _built.intersection(_machinery.EXTENSION_SUFFIXES):
    _versions = sorted(int(name.split("cpython-3")[1].split("-")[0]) for name in _built)
    raise ImportError(
        f"ashimpact is built for Python {', '.join(f'3.{minor}' for minor in _versions)},"
        f" not for {_sys.version_info[0]}.{_sys.version_info[1]}"
    )

from ashimpact._batch import (
    CriticalVelocities,
    Dampings,
    Impacts,
    critical_velocities,
    dampings,
    impacts,
    laws,
)
from ashimpact._core import ConvergenceError, InputError
from ashimpact._core import version as __version__
from ashimpact._program import (
    analyse_impacts,
    calibrate,
    columns,
    contact,
    deposit,
    export,
    figure,
    literature,
    modulus,
    run,
    sweep,
    to_pandas,
)

__all__ = [
    "ConvergenceError",
    "CriticalVelocities",
    "Dampings",
    "Impacts",
    "InputError",
    "__version__",
    "analyse_impacts",
    "calibrate",
    "columns",
    "contact",
    "critical_velocities",
    "dampings",
    "deposit",
    "export",
    "figure",
    "impacts",
    "laws",
    "literature",
    "modulus",
    "run",
    "sweep",
    "to_pandas",
]
