# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Optional

import numpy as np
import numpy.typing as npt

_Numbers = npt.NDArray[np.float64]
_Contact = tuple[_Numbers, _Numbers, _Numbers, _Numbers, _Numbers, dict[str, _Numbers]]

version: str

class InputError(ValueError): ...
class ConvergenceError(ArithmeticError): ...

class Choice:
    def __init__(self, law: str, detachment: Optional[str], damping_law: str) -> None: ...

def laws() -> dict[str, tuple[str, list[str]]]: ...
def law_parameters() -> dict[str, tuple[str, str, list[str]]]: ...
def impacts(
    choice: Choice,
    contact: _Contact,
    damping: _Numbers,
    velocity: _Numbers,
    count: int,
    method: str,
    threads: int,
    /,
) -> tuple[_Numbers, _Numbers, _Numbers, _Numbers]: ...
def critical_velocities(
    choice: Choice, contact: _Contact, damping: _Numbers, count: int, threads: int, /
) -> _Numbers: ...
def dampings(
    choice: Choice, contact: _Contact, velocity: _Numbers, restitution: _Numbers, count: int, threads: int, /
) -> tuple[_Numbers, _Numbers]: ...
