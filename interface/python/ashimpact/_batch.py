# SPDX-License-Identifier: GPL-3.0-or-later
"""Many impacts, critical velocities and dampings at once, on numpy's arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ashimpact import _core
from ashimpact._laws import takes_law_parameters

if TYPE_CHECKING:
    import pandas

Numbers = npt.NDArray[np.float64]
Truths = npt.NDArray[np.bool_]
NumbersLike = Union[float, npt.ArrayLike]

__all__ = [
    "CriticalVelocities",
    "Dampings",
    "Impacts",
    "critical_velocities",
    "dampings",
    "impacts",
    "laws",
]


@dataclass(frozen=True)
class Impacts:
    """What impacts did. Every array has the shape that the arguments broadcast to."""

    restitution: Numbers
    """Coefficient of restitution e_n = v_r/v_in; 0 for a capture [1]."""
    contact_time: Numbers
    """First touch to detachment; NaN for a capture [s]."""
    captured: Truths
    """Whether the particle stays on the wall."""
    approach_time: Optional[Numbers]
    """First touch to greatest overlap; NaN if that is never reached; None with method="table" [s]."""
    maximum_overlap: Optional[Numbers]
    """Greatest overlap, or its limit if that is never reached; None with method="table" [m]."""

    def to_pandas(self) -> "pandas.DataFrame":
        """The impacts as a table, one a row, units in the headings. Needs pandas."""
        import pandas

        table = {
            "restitution [1]": self.restitution.ravel(),
            "contact_time [s]": self.contact_time.ravel(),
            "captured": self.captured.ravel(),
        }
        if self.approach_time is not None and self.maximum_overlap is not None:
            table["approach_time [s]"] = self.approach_time.ravel()
            table["maximum_overlap [m]"] = self.maximum_overlap.ravel()
        return pandas.DataFrame(table)


@dataclass(frozen=True)
class CriticalVelocities:
    """Velocities below which a particle is captured."""

    critical_velocity: Numbers
    """v_c; 0 if every impact rebounds, infinite if every impact is captured [m/s]."""

    @property
    def never_captured(self) -> Truths:
        """Whether a particle rebounds at every velocity."""
        return np.asarray(self.critical_velocity == 0.0)

    @property
    def always_captured(self) -> Truths:
        """Whether a particle is captured at every velocity."""
        return np.asarray(np.isinf(self.critical_velocity))


@dataclass(frozen=True)
class Dampings:
    """Damping coefficients that give measured restitutions back."""

    damping: Numbers
    """Coefficient; NaN if no damping gives the restitution
    [kg/s constant, Pa s contact-radius, 1 tsuji]."""
    greatest_restitution: Numbers
    """Restitution without damping, the greatest there is [1]."""


def laws() -> dict[str, tuple[str, list[str]]]:
    """Each contact law with its default detachment and those that are admissible for it."""
    return _core.laws()


class _Columns:
    """Arguments brought to one shape: arrays of one number, or of all numbers in their order."""

    def __init__(self, **arguments: NumbersLike) -> None:
        self._arrays = {}
        for name, value in arguments.items():
            try:
                self._arrays[name] = np.asarray(value, dtype=np.float64)
            except (TypeError, ValueError) as error:
                raise _core.InputError(f"{name} is no number: {error}; allowed: numbers in SI units") from None
        try:
            self.shape = np.broadcast_shapes(*(array.shape for array in self._arrays.values()))
        except ValueError:
            shapes = ", ".join(f"{name} {array.shape}" for name, array in self._arrays.items() if array.ndim)
            raise _core.InputError(f"shapes do not fit: {shapes}; allowed: shapes that broadcast") from None
        self.count = int(np.prod(self.shape, dtype=np.int64))

    def __getitem__(self, name: str) -> Numbers:
        array = self._arrays[name]
        if array.size == 1 or array.shape == self.shape:
            return np.ascontiguousarray(array).reshape(-1)
        return np.ascontiguousarray(np.broadcast_to(array, self.shape)).reshape(-1)

    def shaped(self, numbers: Numbers) -> Numbers:
        return numbers.reshape(self.shape)

    def _mass(self, whose: str) -> Numbers:
        if f"{whose}mass" in self._arrays:
            return self[f"{whose}mass"]
        diameter = 2.0 * self[f"{whose}radius"]
        # Multiplied in the order of the library, so that results agree bit by bit.
        mass: Numbers = self[f"{whose}density"] * np.pi / 6.0 * diameter * diameter * diameter
        return mass

    def contact(self) -> tuple[Numbers, Numbers, Numbers, Numbers, Numbers, dict[str, Numbers]]:
        radius, mass = self["radius"], self._mass("")
        if "partner_radius" in self._arrays:
            mass = _joint("mass", mass, self._mass("partner_"))
            radius = _joint("radius", radius, self["partner_radius"])
        return (
            mass,
            radius,
            self["contact_modulus"],
            self["work_of_adhesion"],
            self["yield_pressure"],
            {name: self[name] for name in _core.law_parameters() if name in self._arrays},
        )


def _joint(name: str, one: Numbers, other: Numbers) -> Numbers:
    """R* or m* of two spheres, 1/(1/one + 1/other)."""
    for whose, values in (("", one), ("partner_", other)):
        if not np.all(values > 0.0):
            raise _core.InputError(f"{whose}{name} is not positive; allowed: > 0")
    return np.asarray(1.0 / (1.0 / one + 1.0 / other))


def _columns(arguments: dict[str, Any], *numbers: str) -> _Columns:
    """The columns of a call's arguments: those of the contact and these numbers. None was not given."""
    given = {name: value for name, value in arguments.items() if value is not None}
    _require_one(given, "density", "mass")
    if "partner_radius" in given:
        _require_one(given, "partner_density", "partner_mass")
    elif "partner_density" in given or "partner_mass" in given:
        raise _core.InputError("partner_radius is not given; allowed: a radius [m] for the second sphere")
    columns = {name: arguments[name] for name in ("radius", "contact_modulus", "work_of_adhesion", *numbers)}
    spheres = ("density", "mass", "partner_radius", "partner_density", "partner_mass")
    columns |= {name: given[name] for name in (*spheres, *_core.law_parameters()) if name in given}
    return _Columns(yield_pressure=given.get("yield_pressure", np.inf), **columns)


def _require_one(given: dict[str, Any], first: str, second: str) -> None:
    if (first in given) == (second in given):
        fault = "both are" if first in given else "neither is"
        raise _core.InputError(f"{first}, {second}: {fault} given; allowed: one of the two")


@takes_law_parameters
def impacts(
    *,
    law: str,
    radius: NumbersLike,
    contact_modulus: NumbersLike,
    velocity: NumbersLike,
    density: Optional[NumbersLike] = None,
    mass: Optional[NumbersLike] = None,
    work_of_adhesion: NumbersLike = 0.0,
    damping: NumbersLike = 0.0,
    yield_pressure: Optional[NumbersLike] = None,
    partner_radius: Optional[NumbersLike] = None,
    partner_density: Optional[NumbersLike] = None,
    partner_mass: Optional[NumbersLike] = None,
    detachment: Optional[str] = None,
    damping_law: str = "constant",
    method: str = "integration",
    threads: int = 0,
    **parameters: Optional[NumbersLike],
) -> Impacts:
    """Normal impacts of spheres on a flat wall, or on a second sphere; every number may be an array.

    Args:
        law: contact law: hertz, dmt, brach-dunn, jkr, ...; laws() lists them.
        radius: of the sphere [m].
        contact_modulus: E* of both bodies, not a Young's modulus [Pa].
        velocity: of approach, normal to the wall, > 0 [m/s].
        density: of the sphere [kg/m3]; or
        mass: of the sphere [kg].
        work_of_adhesion: energy to separate unit area, not a surface energy [J/m2].
        damping: coefficient of the damping law [kg/s constant, Pa s contact-radius, 1 tsuji].
        yield_pressure: p_y, for the law thornton-ning; without it the sphere never yields [Pa].
        partner_radius: of a second sphere in place of the wall; velocities are relative ones then [m].
        partner_density: of the second sphere [kg/m3]; or
        partner_mass: of the second sphere [kg].
        detachment: where the contact ends; without it as the law does by default.
        damping_law: constant, contact-radius, tsuji.
        method: integration, or table, some ten times as fast from 100,000 impacts on; a table has neither
            approach times nor overlaps.
        threads: 0 for one a core; no bit of a result depends on it.
        {law parameters}

    Raises:
        InputError: naming the first impact it concerns.
        ConvergenceError: where an impact could not be solved.
    """
    columns = _columns({**locals(), **parameters}, "velocity", "damping")
    restitution, contact_time, approach_time, maximum_overlap = _core.impacts(
        _core.Choice(law, detachment, damping_law),
        columns.contact(),
        columns["damping"],
        columns["velocity"],
        columns.count,
        method,
        threads,
    )
    tabulated = method == "table"
    return Impacts(
        restitution=columns.shaped(restitution),
        contact_time=columns.shaped(contact_time),
        captured=columns.shaped(restitution) == 0.0,
        approach_time=None if tabulated else columns.shaped(approach_time),
        maximum_overlap=None if tabulated else columns.shaped(maximum_overlap),
    )


@takes_law_parameters
def critical_velocities(
    *,
    law: str,
    radius: NumbersLike,
    contact_modulus: NumbersLike,
    density: Optional[NumbersLike] = None,
    mass: Optional[NumbersLike] = None,
    work_of_adhesion: NumbersLike = 0.0,
    damping: NumbersLike = 0.0,
    yield_pressure: Optional[NumbersLike] = None,
    partner_radius: Optional[NumbersLike] = None,
    partner_density: Optional[NumbersLike] = None,
    partner_mass: Optional[NumbersLike] = None,
    detachment: Optional[str] = None,
    damping_law: str = "constant",
    threads: int = 0,
    **parameters: Optional[NumbersLike],
) -> CriticalVelocities:
    """Velocities below which spheres are captured; arguments as those of impacts().

    Raises:
        InputError: naming the first sphere it concerns.
        ConvergenceError: if a velocity could not be found.
    """
    columns = _columns({**locals(), **parameters}, "damping")
    velocity = _core.critical_velocities(
        _core.Choice(law, detachment, damping_law),
        columns.contact(),
        columns["damping"],
        columns.count,
        threads,
    )
    return CriticalVelocities(columns.shaped(velocity))


@takes_law_parameters
def dampings(
    *,
    law: str,
    radius: NumbersLike,
    contact_modulus: NumbersLike,
    velocity: NumbersLike,
    restitution: NumbersLike,
    density: Optional[NumbersLike] = None,
    mass: Optional[NumbersLike] = None,
    work_of_adhesion: NumbersLike = 0.0,
    yield_pressure: Optional[NumbersLike] = None,
    partner_radius: Optional[NumbersLike] = None,
    partner_density: Optional[NumbersLike] = None,
    partner_mass: Optional[NumbersLike] = None,
    detachment: Optional[str] = None,
    damping_law: str = "constant",
    threads: int = 0,
    **parameters: Optional[NumbersLike],
) -> Dampings:
    """Damping coefficients that give measured restitutions back; arguments as those of impacts().

    Args:
        restitution: as measured, 0 <= e_n < 1; 0 gives the smallest damping that captures [1].

    Raises:
        InputError: naming the first impact it concerns.
        ConvergenceError: if a damping could not be found.
    """
    columns = _columns({**locals(), **parameters}, "velocity", "restitution")
    damping, greatest = _core.dampings(
        _core.Choice(law, detachment, damping_law),
        columns.contact(),
        columns["velocity"],
        columns["restitution"],
        columns.count,
        threads,
    )
    return Dampings(columns.shaped(damping), columns.shaped(greatest))
