# SPDX-License-Identifier: GPL-3.0-or-later
"""Many impacts, critical velocities and dampings at once, on numpy's arrays."""

from __future__ import annotations

import functools
import inspect
import textwrap
import warnings
from dataclasses import dataclass
from decimal import Decimal
from numbers import Integral, Real
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, TypeVar, Union, cast

import numpy as np

from ashimpact import _core

if TYPE_CHECKING:
    import numpy.typing as npt  # from numpy 1.20 on
    import pandas

    Numbers = npt.NDArray[np.float64]
    Truths = npt.NDArray[np.bool_]
    NumbersLike = Union[float, npt.ArrayLike]

Function = TypeVar("Function", bound=Callable[..., Any])

_MANY = 100_000
"""Impacts from which on making a table saves time."""


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
    """First touch to greatest overlap; NaN if that is never reached; None if not asked for or with method="table" [s]."""
    maximum_overlap: Optional[Numbers]
    """Greatest overlap, or its limit if that is never reached; None if not asked for or with method="table" [m]."""
    tangential_restitution: Optional[Numbers] = None
    """e_t = v_t'/v_t; 0 for a capture, NaN without v_t. This and what follows: None for normal impacts [1]."""
    rebound_angle: Optional[Numbers] = None
    """From the normal, negative where v_t has turned; NaN for a capture [rad]."""
    tangential_velocity: Optional[Numbers] = None
    """Along the wall after the impact; NaN for a capture [m/s]."""
    spin: Optional[Numbers] = None
    """After the impact; NaN for a capture [rad/s]."""
    impulse_ratio: Optional[Numbers] = None
    """Impulse of friction over that normal to the wall; NaN for a capture [1]."""
    regime: Optional[npt.NDArray[np.str_]] = None
    """sliding, rolling, none or captured."""
    method: str = "integration"
    """How the restitutions were found: integration or table."""

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
    """Coefficient; NaN if no damping gives the restitution [unit of the damping law]."""
    greatest_restitution: Numbers
    """Restitution without damping, the greatest there is [1]."""


def laws() -> dict[str, tuple[str, list[str]]]:
    """Each contact law with its default detachment and those that are admissible for it."""
    return _core.laws()


def takes_law_parameters(function: Function) -> Function:
    """Completes a function with **parameters by the parameters of all laws.

    They are in its signature and, in place of the line "{law parameters}", in its documentation, where "{laws}",
    "{damping laws}" and "{damping units}" are replaced as well. Other names are refused as Python refuses an unknown
    argument.
    """
    table = _core.law_parameters()
    signature = inspect.signature(function)
    stated = [each for each in signature.parameters.values() if each.kind is not inspect.Parameter.VAR_KEYWORD]
    annotation = signature.parameters["parameters"].annotation
    own = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=annotation) for name in table]
    complete = signature.replace(parameters=[*stated, *own])

    @functools.wraps(function)
    def checked(*arguments: Any, **given: Any) -> Any:
        for name in given:
            if name not in complete.parameters:
                raise TypeError(f"{function.__name__}() got an unexpected keyword argument {name!r}")
        return function(*arguments, **given)

    lines = [
        textwrap.fill(f"{name}: {text} [{unit}]; law {', '.join(laws)}.", 110, initial_indent=8 * " ", subsequent_indent=12 * " ")
        for name, (unit, text, laws, _, _) in table.items()
    ]
    dampings = _core.damping_laws()
    documentation = function.__doc__ or ""
    for place, text in (
        (8 * " " + "{law parameters}", "\n".join(lines)),
        ("{laws}", ", ".join(_core.laws())),
        ("{damping laws}", ", ".join(dampings)),
        ("{damping units}", ", ".join(f"{unit} {name}" for name, unit in dampings.items())),
    ):
        documentation = documentation.replace(place, text)
    checked.__doc__ = documentation
    checked.__signature__ = complete  # type: ignore[attr-defined]
    return cast(Function, checked)


def is_real(value: Any) -> bool:
    """Whether a single value is a real number: no truth value, date, text or missing one."""
    if type(value) is np.ndarray:
        return value.dtype.kind in "iuf"
    return isinstance(value, (Real, Decimal)) and not isinstance(value, bool)


def real_numbers(name: str, value: Any) -> Numbers:
    """An argument as float64. Refuses what is no real number in SI: masked values, dates, truth values, text, units."""
    fault = "has a unit of its own" if hasattr(value, "unit") or hasattr(value, "units") else None
    try:
        array = np.asanyarray(value, dtype=None if hasattr(value, "dtype") else object)
        if np.any(getattr(array, "mask", False)):
            fault = "has masked values"
        array = np.asarray(array)
        wrong = [each for each in array.flat if not is_real(each)] if array.dtype == object else []
        if wrong or array.dtype.kind not in "iufO":
            fault = fault or "holds " + (type(wrong[0]) if wrong else array.dtype.type).__name__
        if fault is None:
            return array.astype(np.float64, copy=False)
    except (TypeError, ValueError, OverflowError) as error:
        fault = f"is no number: {error}"
    raise _core.InputError(f"{name} {fault}; allowed: numbers in SI units")


def flat_arrays(arguments: Mapping[str, NumbersLike]) -> tuple[dict[str, Numbers], tuple[int, ...]]:
    """Flat arrays of one number, or of all numbers in their order, and the shape that the arguments broadcast to."""
    arrays = {name: real_numbers(name, value) for name, value in arguments.items()}
    tables: dict[str, Any] = {name: value for name, value in arguments.items() if hasattr(value, "index") and hasattr(value, "to_numpy")}
    first = next(iter(tables), "")
    for name, table in tables.items():
        if not table.index.equals(tables[first].index):
            raise _core.InputError(f"{first} and {name} have different indices; allowed: one index, or arrays (to_numpy())")
    try:
        shape = np.broadcast(*arrays.values()).shape
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items() if array.ndim)
        raise _core.InputError(f"shapes do not fit: {shapes}; allowed: shapes that broadcast") from None
    return {
        name: np.ascontiguousarray(array if array.size == 1 else np.broadcast_to(array, shape)).reshape(-1)
        for name, array in arrays.items()
    }, shape


def _warn_of_doubts(arrays: Mapping[str, Numbers]) -> None:
    """Warns the caller of impacts() and the like of numbers that are far from what particles of ash and walls have."""
    for name, array in arrays.items():
        positive = np.abs(array[array != 0.0])
        for value in {positive.min(), positive.max()} if positive.size else ():
            if doubt := _core.doubt_about(name, value):
                warnings.warn(doubt, UserWarning, stacklevel=5)
    for whose in ("", "partner_"):
        if f"{whose}mass" in arrays and np.all(arrays[f"{whose}radius"] > 0.0):
            radius, mass = np.broadcast_arrays(arrays[f"{whose}radius"], arrays[f"{whose}mass"])
            density = mass / radius**3
            for place in {int(np.nanargmin(density)), int(np.nanargmax(density))} if np.any(density > 0.0) else ():
                if doubt := _core.doubt_about_mass(radius[place], mass[place]):
                    warnings.warn(whose + doubt, UserWarning, stacklevel=5)


def _require_positive(name: str, values: Numbers) -> None:
    wrong = values[~(values > 0.0)]
    if wrong.size:
        raise _core.InputError(f"{name} is {wrong.flat[0]}; allowed: > 0")


def _mass(arrays: Mapping[str, Numbers], whose: str = "") -> Numbers:
    if f"{whose}mass" in arrays:
        return arrays[f"{whose}mass"]
    _require_positive(f"{whose}radius", arrays[f"{whose}radius"])
    diameter = 2.0 * arrays[f"{whose}radius"]
    # Multiplied in the order of the library, so that results agree bit by bit.
    mass: Numbers = arrays[f"{whose}density"] * np.pi / 6.0 * diameter * diameter * diameter
    return mass


def _joint(name: str, one: Numbers, other: Numbers) -> Numbers:
    """R* or m* of two spheres, 1/(1/one + 1/other)."""
    _require_positive(name, one)
    _require_positive(f"partner_{name}", other)
    return np.asarray(1.0 / (1.0 / one + 1.0 / other))


def _require_one(given: Mapping[str, Any], first: str, second: str) -> None:
    if (first in given) == (second in given):
        fault = "both are" if first in given else "neither is"
        raise _core.InputError(f"{first}, {second}: {fault} given; allowed: one of the two")


def _name(value: Any) -> str:
    """A name as the library looks it up, or refuses it: what is no text as Python shows it, escaped where needed."""
    return ascii(str.__str__(value) if isinstance(value, str) else str(value))[1:-1]


def _take_diameter(arguments: dict[str, Any], whose: str) -> None:
    """Replaces a diameter by its radius."""
    diameter = arguments.pop(f"{whose}diameter", None)
    if diameter is None:
        return
    if arguments[f"{whose}radius"] is not None:
        raise _core.InputError(f"{whose}radius, {whose}diameter: both are given; allowed: one of the two")
    table = hasattr(diameter, "index") and hasattr(diameter, "to_numpy")
    arguments[f"{whose}radius"] = 0.5 * (diameter if table else real_numbers(f"{whose}diameter", diameter))


def _warn_of_one_damping(radius: Numbers, damping: Numbers) -> None:
    """Warns of one constant damping for sizes that differ; an array of dampings, one a sphere, states it on purpose."""
    if damping.size != 1 or not damping[0] > 0.0 or radius.size < 2 or not radius.max() > 1.1 * radius.min() > 0.0:
        return
    warnings.warn(
        f"damping: one coefficient for radii of {radius.min():.3g} m to {radius.max():.3g} m; with it v_c of small spheres"
        " grows without bound; give one for each sphere, or choose another damping_law",
        UserWarning,
        stacklevel=5,
    )


def _call(arguments: dict[str, Any], *numbers: str) -> tuple[_core.Call, tuple[int, ...]]:
    """The call of a function's arguments, with these numbers beside the contact, and the shape of its results."""
    for whose in ("", "partner_"):
        _take_diameter(arguments, whose)
    given = {name: value for name, value in arguments.items() if value is not None}
    if "radius" not in given:
        raise _core.InputError("radius, diameter: neither is given; allowed: one of the two")
    _require_one(given, "density", "mass")
    if "partner_radius" in given:
        _require_one(given, "partner_density", "partner_mass")
    elif "partner_density" in given or "partner_mass" in given:
        raise _core.InputError("partner_radius is not given; allowed: a radius [m] for the second sphere")
    needed = ("contact_modulus", *numbers)
    own = [name for name in ("work_of_adhesion", *_core.law_parameters()) if name in given]
    spheres = [name for name in ("density", "mass", "partner_radius", "partner_density", "partner_mass") if name in given]
    arrays, shape = flat_arrays({name: arguments[name] for name in ("radius", *needed, *spheres, *own)})
    _warn_of_doubts(arrays)
    radius, mass = arrays["radius"], _mass(arrays)
    spinning = {"sphere_radius": radius, "sphere_mass": mass} if "friction" in numbers else {}
    if "partner_radius" in arrays:
        mass = _joint("mass", mass, _mass(arrays, "partner_"))
        radius = _joint("radius", radius, arrays["partner_radius"])
    damps = any(np.any(arrays[name]) for name in ("damping", *own) if name in arrays and name.startswith(("damping", "adhesion_damping")))
    if arguments["damping_law"] != "constant" and "damping" in needed and not damps:
        warnings.warn("damping_law: there is no damping, so it changes nothing", UserWarning, stacklevel=4)
    if arguments["damping_law"] == "constant" and "damping" in needed:
        _warn_of_one_damping(radius, arrays["damping"])
    varied = [name for name in ("radius", "partner_radius", "work_of_adhesion", "contact_modulus") if arrays.get(name, radius[:1]).size > 1]
    if "tabor" in given and arrays["tabor"].size == 1 and varied:
        text = f"tabor: stays the same while {varied[0]} varies; cohesion_range or cohesive_stress is one for all"
        warnings.warn(text, UserWarning, stacklevel=4)
    columns = {"mass": mass, "effective_radius": radius, **spinning, **{name: arrays[name] for name in (*needed, *own)}}
    count = int(np.prod(shape, dtype=np.int64))
    detachment, threads = arguments["detachment"], arguments["threads"]
    if not isinstance(threads, Integral) or isinstance(threads, bool) or not 0 <= int(threads) < 2**16:
        raise _core.InputError(f"threads is {threads!r}; allowed: a whole number, 0 for one a core")
    choice = (_name(arguments["law"]), None if detachment is None else _name(detachment), _name(arguments["damping_law"]))
    return _core.Call(*choice, columns, count, int(threads)), shape


def _take_tangential(arguments: dict[str, Any]) -> list[str]:
    """Names of the numbers of impacts at an angle, none if they are normal; an angle becomes two velocities."""
    given = [name for name in ("angle", "tangential_velocity", "spin") if arguments[name] is not None]
    if not given:
        if arguments["friction"] is not None:
            warnings.warn("friction: the impacts are normal and without spin, so it changes nothing", UserWarning, stacklevel=4)
        return []
    if arguments["friction"] is None:
        raise _core.InputError(f"friction is not given; allowed: a coefficient beside {given[0]}, 0 for none")
    if "angle" in given:
        if "tangential_velocity" in given:
            raise _core.InputError("angle, tangential_velocity: both are given; allowed: one of the two")
        angle = real_numbers("angle", arguments["angle"])
        wrong = angle[~((angle >= 0.0) & (angle < np.pi / 2.0))]
        if wrong.size:
            raise _core.InputError(f"angle is {wrong.flat[0]} rad; allowed: 0 to below pi/2, from the normal")
        total = real_numbers("velocity", arguments["velocity"])
        arguments["velocity"], arguments["tangential_velocity"] = total * np.cos(angle), total * np.sin(angle)
    for name in ("tangential_velocity", "spin"):
        if arguments[name] is None:
            arguments[name] = 0.0
    return ["tangential_velocity", "spin", "friction"]


@takes_law_parameters
def impacts(
    *,
    law: str,
    contact_modulus: NumbersLike,
    velocity: NumbersLike,
    radius: Optional[NumbersLike] = None,
    diameter: Optional[NumbersLike] = None,
    density: Optional[NumbersLike] = None,
    mass: Optional[NumbersLike] = None,
    work_of_adhesion: Optional[NumbersLike] = None,
    damping: NumbersLike = 0.0,
    partner_radius: Optional[NumbersLike] = None,
    partner_diameter: Optional[NumbersLike] = None,
    partner_density: Optional[NumbersLike] = None,
    partner_mass: Optional[NumbersLike] = None,
    detachment: Optional[str] = None,
    damping_law: str = "constant",
    angle: Optional[NumbersLike] = None,
    tangential_velocity: Optional[NumbersLike] = None,
    spin: Optional[NumbersLike] = None,
    friction: Optional[NumbersLike] = None,
    method: str = "auto",
    turning_point: bool = True,
    threads: int = 0,
    **parameters: Optional[NumbersLike],
) -> Impacts:
    """Impacts of spheres on a flat wall, or on a second sphere; every number may be an array.

    Args:
        law: contact law, {laws}.
        radius: of the sphere; or its diameter [m].
        contact_modulus: E* of both bodies, not a Young's modulus [Pa].
        velocity: of approach, normal to the wall, > 0; with an angle that of the sphere [m/s].
        density: of the sphere [kg/m3]; or
        mass: of the sphere [kg].
        work_of_adhesion: energy to separate unit area, not a surface energy; needed with adhesion, 0 for none [J/m2].
        damping: coefficient of the damping law [{damping units}].
        partner_radius: of a second sphere in place of the wall; or its partner_diameter. Velocities are then relative [m].
        partner_density: of the second sphere [kg/m3]; or
        partner_mass: of the second sphere [kg].
        detachment: where the contact ends; without it as the law does by default.
        damping_law: {damping laws}.
        angle: from the normal, 0 to below pi/2 [rad]; or
        tangential_velocity: along the wall [m/s].
        spin: positive where it adds to the slip of a positive tangential velocity [rad/s].
        friction: coefficient of Coulomb friction, needed with the three before [1].
        method: integration; table, some ten times as fast from 100,000 impacts on (maugis-dugdale: 2 million), which has
            neither approach times nor overlaps and does not exist for every law; or auto, table for so many impacts
            without a turning point if the law has one, else integration. What was used is in the result.
        turning_point: whether to compute approach times and greatest overlaps.
        threads: 0 for one a core; no bit of a result depends on it.
        {law parameters}

    Raises:
        InputError: naming the first impact it concerns.
        ConvergenceError: where an impact could not be solved.

    Warns (UserWarning) of numbers far from what particles of ash and walls have, such as a radius of 44 m.
    """
    if str(method) not in ("auto", "integration", "table"):
        raise _core.InputError(f"unknown method '{method}'; allowed: auto, integration, table")
    arguments = {**locals(), **parameters}
    oblique = _take_tangential(arguments)
    call, shape = _call(arguments, "velocity", "damping", *oblique)
    used = str(method)
    if used == "auto":
        worth = not turning_point and np.prod(shape, dtype=np.int64) >= _MANY and call.tables_pay()
        used = "table" if worth else "integration"
    solved = call.impacts(used, bool(turning_point) and used == "integration", bool(oblique))
    columns = {name: column.reshape(shape) for name, column in solved.items()}
    regime = np.array(_core.sliding_regimes())[columns.pop("regime").astype(np.intp)] if oblique else None
    approach_time, maximum_overlap = columns.pop("approach_time", None), columns.pop("maximum_overlap", None)
    return Impacts(
        captured=columns["restitution"] == 0.0,
        approach_time=approach_time,
        maximum_overlap=maximum_overlap,
        regime=regime,
        method=used,
        **columns,
    )


@takes_law_parameters
def critical_velocities(
    *,
    law: str,
    contact_modulus: NumbersLike,
    radius: Optional[NumbersLike] = None,
    diameter: Optional[NumbersLike] = None,
    density: Optional[NumbersLike] = None,
    mass: Optional[NumbersLike] = None,
    work_of_adhesion: Optional[NumbersLike] = None,
    damping: NumbersLike = 0.0,
    partner_radius: Optional[NumbersLike] = None,
    partner_diameter: Optional[NumbersLike] = None,
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
    call, shape = _call({**locals(), **parameters}, "damping")
    velocities = call.critical_velocities().reshape(shape)
    if doubt := _core.doubt_about_velocity(np.max(velocities, where=np.isfinite(velocities), initial=0.0)):
        warnings.warn(doubt, UserWarning, stacklevel=3)
    return CriticalVelocities(velocities)


@takes_law_parameters
def dampings(
    *,
    law: str,
    contact_modulus: NumbersLike,
    velocity: NumbersLike,
    restitution: NumbersLike,
    radius: Optional[NumbersLike] = None,
    diameter: Optional[NumbersLike] = None,
    density: Optional[NumbersLike] = None,
    mass: Optional[NumbersLike] = None,
    work_of_adhesion: Optional[NumbersLike] = None,
    partner_radius: Optional[NumbersLike] = None,
    partner_diameter: Optional[NumbersLike] = None,
    partner_density: Optional[NumbersLike] = None,
    partner_mass: Optional[NumbersLike] = None,
    detachment: Optional[str] = None,
    damping_law: str = "constant",
    threads: int = 0,
    **parameters: Optional[NumbersLike],
) -> Dampings:
    """Damping coefficients that give measured restitutions back; arguments as those of impacts().

    Args:
        restitution: as measured, 0 <= e_n <= 1; 0 gives the smallest damping that captures [1].

    Raises:
        InputError: naming the first impact it concerns.
        ConvergenceError: if a damping could not be found.
    """
    call, shape = _call({**locals(), **parameters}, "velocity", "restitution")
    damping, greatest = call.dampings()
    return Dampings(damping.reshape(shape), greatest.reshape(shape))
