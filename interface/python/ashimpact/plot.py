# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of a run, for matplotlib.

Every function draws into the axes it is given, or into new ones, and returns them. It takes the artifacts that
run() returns. Laws have the same colour and dash in every figure.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional

import numpy as np

from ashimpact import _batch
from ashimpact._core import InputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Artifacts = Mapping[str, Mapping[str, Any]]

__all__ = [
    "composition",
    "contact_time",
    "critical_velocity",
    "damping",
    "damping_fit",
    "energy",
    "histories",
    "restitution",
    "restitution_curve",
    "sizes",
]

# Okabe and Ito's colours, which those who see red and green as one tell apart; dashes for print without colour.
_STYLES = (
    ("#0072B2", "-"),
    ("#D55E00", "--"),
    ("#009E73", "-."),
    ("#CC79A7", ":"),
    ("#56B4E9", (0, (5, 1, 1, 1, 1, 1))),
    ("#E69F00", (0, (1, 1))),
    ("#000000", (0, (7, 2))),
)

_VELOCITY = "incident velocity [m/s]"


def _style(law: str) -> dict[str, Any]:
    place = list(_batch.laws()).index(law) if law in _batch.laws() else -1
    colour, dashes = _STYLES[place % len(_STYLES)]
    return {"color": colour, "linestyle": dashes}


def _axes(axes: Optional["Axes"]) -> "Axes":
    if axes is not None:
        return axes
    from matplotlib import pyplot

    return pyplot.figure(figsize=(5.5, 3.6), layout="constrained").add_subplot()


def _finished(axes: "Axes", **settings: Any) -> "Axes":
    axes.set(**settings)
    axes.legend()
    return axes


def _samples(artifacts: Artifacts, stage: str) -> list[Mapping[str, Any]]:
    if stage not in artifacts:
        raise InputError(f"no artifact {stage}; allowed: what ashimpact.run() returns")
    samples: list[Mapping[str, Any]] = artifacts[stage]["result"]["samples"]
    return samples


def _sample(artifacts: Artifacts, stage: str, name: Optional[str]) -> Mapping[str, Any]:
    samples = _samples(artifacts, stage)
    if name is None:
        return samples[0]
    for sample in samples:
        if sample["name"] == name:
            return sample
    raise InputError(f"no sample {name!r}; allowed: " + ", ".join(sample["name"] for sample in samples))


def _by_law(sample: Mapping[str, Any], key: str) -> Iterator[tuple[str, Any]]:
    """What a sample holds for each law, where that has the key."""
    for law in _batch.laws():
        node = sample.get(law)
        if isinstance(node, Mapping) and key in node:
            yield law, node


def _values(column: Mapping[str, Any]) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.asarray([np.nan if value is None else value for value in column["values"]], dtype=np.float64)


def composition(artifacts: Artifacts, axes: Optional["Axes"] = None) -> "Axes":
    """Volume fractions of the phases of each sample, as stacked bars."""
    axes = _axes(axes)
    samples = _samples(artifacts, "1-modulus")
    phases = list(dict.fromkeys(phase["name"] for sample in samples for phase in sample["phases"]))
    bottom = np.zeros(len(samples))
    hatches = ("", "//", "..", "xx", "\\\\", "++")
    for place, name in enumerate(phases):
        share = np.array([sum(each["volume_fraction"] for each in sample["phases"] if each["name"] == name) for sample in samples])
        look = {"color": _STYLES[place % len(_STYLES)][0], "hatch": hatches[place % len(hatches)], "edgecolor": "white"}
        axes.bar(range(len(samples)), share, bottom=bottom, label=name, **look)
        bottom += share
    axes.set_xticks(range(len(samples)), [sample["name"] for sample in samples])
    return _finished(axes, ylabel="volume fraction [1]")


def restitution(artifacts: Artifacts, sample: Optional[str] = None, axes: Optional["Axes"] = None) -> "Axes":
    """Restitution against incident velocity, as measured or reconstructed."""
    axes = _axes(axes)
    for series in _sample(artifacts, "4-restitution", sample)["series"]:
        label = ", ".join(series["laws"]) if series["origin"] == "reconstructed" else series["origin"]
        axes.plot(_values(series["velocity"]), _values(series["restitution"]), "o", label=label, markersize=4)
    return _finished(axes, xlabel=_VELOCITY, ylabel="restitution $e_n$ [1]", ylim=(0.0, 1.0))


def restitution_curve(
    *, velocity: _batch.NumbersLike, axes: Optional["Axes"] = None, label: Optional[str] = None, **contact: Any
) -> "Axes":
    """Restitution against velocity of one contact, with v_c marked; arguments are those of impacts()."""
    axes = _axes(axes)
    speeds = np.atleast_1d(_batch.real_numbers("velocity", velocity))
    result = _batch.impacts(velocity=speeds, **contact)
    order = np.argsort(speeds)
    style = _style(contact["law"])
    axes.plot(speeds[order], result.restitution[order], label=label or contact["law"], **style)
    threads_free = {key: value for key, value in contact.items() if key != "method"}
    critical = float(_batch.critical_velocities(**threads_free).critical_velocity)
    if 0.0 < critical < np.inf:
        axes.axvline(critical, linewidth=0.8, **style)
    return _finished(axes, xlabel=_VELOCITY, ylabel="restitution $e_n$ [1]")


def _curves(axes: "Axes", nodes: Iterator[tuple[str, Any]], key: str, quantity: str) -> "Axes":
    """Draws a column of each law's node against incident velocity; its unit is that of the artifact."""
    unit = "1"
    for law, node in nodes:
        unit = node[key]["unit"]
        axes.plot(_values(node["velocity"]), _values(node[key]), marker="o", markersize=3, label=law, **_style(law))
    return _finished(axes, xlabel=_VELOCITY, ylabel=f"{quantity} [{unit}]")


def damping(artifacts: Artifacts, sample: Optional[str] = None, axes: Optional["Axes"] = None) -> "Axes":
    """Damping of each impact against incident velocity, by law."""
    return _curves(_axes(axes), _by_law(_sample(artifacts, "5-damping", sample), "damping"), "damping", r"damping $\eta$")


def damping_fit(artifacts: Artifacts, sample: Optional[str] = None, axes: Optional["Axes"] = None) -> "Axes":
    """Damping against restitution with the fit eta = a e^2 + b e + c of each law, drawn down to e = 0."""
    axes = _axes(axes)
    points = dict(_by_law(_sample(artifacts, "5-damping", sample), "damping"))
    unit = "1"
    for law, fit in _by_law(_sample(artifacts, "6-fit", sample), "c"):
        style, unit = _style(law), fit["c"]["unit"]
        e = np.linspace(0.0, max(fit["restitution_range"]), 100)
        curve = (fit["a"]["value"] * e + fit["b"]["value"]) * e + fit["c"]["value"]
        axes.plot(e, curve, label=law, **style)
        if law in points:
            node = points[law]
            axes.plot(_values(node["restitution"]), _values(node["damping"]), "o", markersize=3, color=style["color"])
    return _finished(axes, xlabel="restitution $e_n$ [1]", ylabel=rf"damping $\eta$ [{unit}]")


def contact_time(artifacts: Artifacts, sample: Optional[str] = None, axes: Optional["Axes"] = None) -> "Axes":
    """Contact time of each impact against incident velocity, by law."""
    nodes = _by_law(_sample(artifacts, "5-damping", sample), "contact_time")
    return _curves(_axes(axes), nodes, "contact_time", "contact time")


def critical_velocity(artifacts: Artifacts, axes: Optional["Axes"] = None) -> "Axes":
    """Critical velocities of each sample: by law with its interval, analytic, measured; logarithmic."""
    axes = _axes(axes)
    samples = _samples(artifacts, "comparison")
    for index, law in enumerate(_batch.laws()):
        points = []
        for place, sample in enumerate(samples):
            velocity = sample["dynamic_critical_velocity"].get(law)
            if velocity is None:
                continue
            value = velocity["value"]
            ends = sample.get("interval", {}).get(law) or {}
            lower, upper = ((ends.get(end) or velocity)["value"] for end in ("lower", "upper"))
            points.append((place + 0.08 * index - 0.16, value, abs(value - lower), abs(upper - value)))
        if points:
            places, values, *errors = zip(*points)
            axes.errorbar(places, values, yerr=errors, fmt="o", label=law, color=_style(law)["color"])
    for key, mark, label in (("analytic_critical_velocity", "x", "analytic"), ("measured_critical_velocity", "_", "measured")):
        there = [(place, sample[key]["value"]) for place, sample in enumerate(samples) if sample.get(key)]
        if there:
            axes.plot(*zip(*there), mark, color="black", markersize=10, label=label)
    axes.set_xticks(range(len(samples)), [sample["name"] for sample in samples])
    axes.set(ylabel="critical velocity [m/s]", yscale="log")
    axes.legend(fontsize="small")
    return axes


def histories(
    artifacts: Artifacts,
    sample: Optional[str] = None,
    quantity: str = "overlap",
    part: str = "critical",
    axes: Optional["Axes"] = None,
) -> "Axes":
    """A quantity of one impact against time, by law: overlap, velocity, contact_radius, ..._force."""
    axes = _axes(axes)
    node = _sample(artifacts, "8-histories", sample)
    unit = "1"
    for law in _batch.laws():
        for impact in node.get(law, []):
            if impact["part"] != part:
                continue
            path = impact["trajectory"]
            if quantity not in path:
                raise InputError(f"unknown quantity {quantity!r}; allowed: " + ", ".join(path))
            unit = path[quantity]["unit"]
            axes.plot(_values(path["time"]), _values(path[quantity]), label=law, **_style(law))
    return _finished(axes, xlabel="time [s]", ylabel=f"{quantity.replace('_', ' ')} [{unit}]")


def energy(artifacts: Artifacts, sample: Optional[str] = None, axes: Optional["Axes"] = None) -> "Axes":
    """Where the energy of an impact at v_c goes, by law: damping, detachment, yielding."""
    axes = _axes(axes)
    nodes = list(_by_law(_sample(artifacts, "7-critical-velocity", sample), "dissipated"))
    bottom = np.zeros(len(nodes))
    for place, key in enumerate(("dissipated", "detachment_energy", "plastic")):
        share = np.array([node[key]["value"] if node[key] else 0.0 for _, node in nodes])
        axes.bar(range(len(nodes)), share, bottom=bottom, label=key.replace("_", " "), color=_STYLES[place][0])
        bottom += share
    axes.set_xticks(range(len(nodes)), [law for law, _ in nodes])
    return _finished(axes, ylabel="energy at $v_c$ [J]")


def sizes(
    *, radius: _batch.NumbersLike, axes: Optional["Axes"] = None, label: Optional[str] = None, **contact: Any
) -> "Axes":
    """Critical velocity against diameter of one contact; arguments are those of critical_velocities()."""
    axes = _axes(axes)
    radii = np.atleast_1d(_batch.real_numbers("radius", radius))
    critical = _batch.critical_velocities(radius=radii, **contact).critical_velocity
    shown = np.where((critical > 0.0) & np.isfinite(critical), critical, np.nan)
    order = np.argsort(radii)
    axes.plot(2e6 * radii[order], shown[order], label=label or contact["law"], **_style(contact["law"]))
    return _finished(axes, xlabel="diameter [µm]", ylabel="critical velocity [m/s]", xscale="log", yscale="log")
