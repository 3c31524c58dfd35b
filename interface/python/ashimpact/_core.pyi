# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Optional

import numpy as np
import numpy.typing as npt

_Numbers = npt.NDArray[np.float64]

version: str

class InputError(ValueError): ...
class ConvergenceError(ArithmeticError): ...

class Call:
    def __init__(
        self,
        law: str,
        detachment: Optional[str],
        damping_law: str,
        numbers: dict[str, _Numbers],
        count: int,
        threads: int,
        /,
    ) -> None: ...
    def impacts(
        self, turning_point: bool, /
    ) -> tuple[_Numbers, _Numbers, Optional[_Numbers], Optional[_Numbers]]: ...
    def critical_velocities(self) -> _Numbers: ...
    def dampings(self) -> tuple[_Numbers, _Numbers]: ...

def laws() -> dict[str, tuple[str, list[str]]]: ...
def law_parameters() -> dict[str, tuple[str, str, list[str], float, int]]: ...
def damping_laws() -> dict[str, str]: ...
