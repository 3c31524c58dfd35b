# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands that read files: each runs the program ashimpact, whose documents come back as dicts; tables of them.

They run in a process of their own: Python goes on in its other threads, and an interrupt ends them.
"""

from __future__ import annotations

import csv
import io
import json
import logging
import os
import re
import shutil
import subprocess
import tempfile
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np

from ashimpact import _core
from ashimpact._batch import _name, flat_arrays, is_real, real_numbers, takes_law_parameters

if TYPE_CHECKING:
    import numpy.typing as npt
    import pandas

PathLike = Union[str, "os.PathLike[str]"]
Document = dict[str, Any]

_log = logging.getLogger("ashimpact")

_WRONG_INPUT = 2
_NOT_CONVERGED = 3


def _program() -> str:
    """The program: $ASHIMPACT_PROGRAM, that of the build tree this module lies in, or the installed one."""
    named = os.environ.get("ASHIMPACT_PROGRAM")
    if named:
        return named
    beside = Path(__file__).resolve().parents[2] / "ashimpact"
    if beside.is_file():
        return str(beside)
    installed = shutil.which("ashimpact")
    if installed is None:
        raise RuntimeError("the program ashimpact is not installed: no such command on PATH")
    return installed


def _messages(text: str) -> list[str]:
    """The messages in what the program wrote; it breaks long ones into lines, of which all but the first are indented."""
    messages: list[str] = []
    for line in text.splitlines():
        if line.startswith("  ") and messages:
            messages[-1] += " " + line.strip()
        elif line.strip():
            messages.append(line.strip())
    return messages


_LINES = re.compile(r"\blines? \d+(?:(?:, | to | and )\d+)*")


def _of_table(message: str, hidden: str) -> str:
    """A message on a table that was written for the program: without its place, and with rows of the table, counted
    from 0, for lines of the file, whose first has the headings."""

    def rows(match: re.Match[str]) -> str:
        if match[0] == "line 1":
            return "the headings"
        return re.sub(r"\d+", lambda line: str(int(line[0]) - 2), match[0]).replace("line", "row")

    return _LINES.sub(rows, message.replace(hidden, "")) if hidden and hidden in message else message


def _call(command: str, *arguments: str, hidden: str = "") -> str:
    """Standard output of a command; its errors become exceptions, its warnings those of Python; how tables were read
    goes to the logger "ashimpact".

    Args:
        hidden: place of a table that was written for the program.
    """
    finished = subprocess.run(
        [_program(), command, *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
    )
    messages = [_of_table(message, hidden) for message in _messages(finished.stderr)]
    if finished.returncode == 0:
        for message in messages:
            if message.startswith("warning: "):
                warnings.warn(message.removeprefix("warning: "), UserWarning, stacklevel=3)
            else:
                _log.info(message)
        return finished.stdout
    message = messages[-1] if messages else f"ashimpact {command} ended with status {finished.returncode}"
    if finished.returncode == _WRONG_INPUT:
        raise _core.InputError(message)
    if finished.returncode == _NOT_CONVERGED:
        raise _core.ConvergenceError(message.removeprefix("not converged: "))
    raise RuntimeError(message)


def _options(function: Callable[..., Any], given: Mapping[str, Any]) -> list[str]:
    """Options of the command line from arguments of a function; those that are None are left out.

    Where the function takes a number, a text or a truth value, another kind of value is refused.
    """
    stated = function.__annotations__
    words: list[str] = []
    for name, value in given.items():
        kind = stated.get(name, stated.get("parameters", ""))
        is_flag = isinstance(value, (bool, np.bool_))
        if value is None:
            continue
        if ("float" in kind or "int" in kind) and not isinstance(value, str):
            real_numbers(name, value)
        elif kind and is_flag != (kind == "bool"):
            raise _core.InputError(f"{name} is {value!r}; allowed: {'a text' if is_flag else 'True or False'}")
        option = "--" + name.replace("_", "-")
        text = repr(float(value)) if isinstance(value, (float, np.floating)) else str(value)
        unit = "" if is_flag or isinstance(value, str) else _core.unit_of_quantity(name)  # numbers are SI here
        text += f" {unit}" if unit else ""
        if not is_flag:
            words += [f"{option}={text}"] if text else [option, ""]
        elif value:
            words.append(option)
    return words


def _path(value: PathLike) -> str:
    """A path that the command line cannot take for an option."""
    path = os.fsdecode(value)
    return os.path.join(".", path) if path.startswith("-") else path


def _read(path: Union[str, Path]) -> Document:
    with open(path, encoding="utf-8") as file:
        document: Document = json.load(file)
    return document


def modulus(
    file: Union[PathLike, "pandas.DataFrame"],
    *,
    amorphous_fraction: Union[float, str, None] = None,
    crystalline_total: Union[float, str, None] = None,
    internal_standard: Optional[str] = None,
    added_fraction: Union[float, str, None] = None,
    oxides: Optional[PathLike] = None,
    oxides_sample: Optional[str] = None,
    oxides_sheet: Optional[str] = None,
    glass: Optional[str] = None,
    glass_density: Union[float, str, None] = None,
    sample: Optional[str] = None,
    sheet: Optional[str] = None,
    decimal: Optional[str] = None,
    phase_set: Optional[str] = None,
    phases: Optional[PathLike] = None,
    rule: Optional[str] = None,
    porosity_law: Optional[str] = None,
    porosity: Optional[float] = None,
    porosity_coefficient: Optional[float] = None,
    particle_density: Union[float, str, None] = None,
) -> Document:
    """Young's modulus of an ash, with bounds, from an XRD result; as `ashimpact modulus --json`.

    Args:
        file: BGMN/Profex or GSAS-II .lst, CSV, TSV or JSON; or a pandas table whose headings are those of such a
            table ("Phase", "FA1 [wt%]"). Messages count the rows of a pandas table from 0.
        amorphous_fraction: weight fraction of the whole, such as 0.42, "42 +- 2 %", "none", "remainder".
        oxides: chemical analysis of the sample, CSV, .xlsx or .ods: the glass from its chemistry.
        glass: "from-chemistry" (with oxides) or "catalogue", the glass that counts.
        decimal: "point" or "comma", of all numbers of a table; without, the numbers decide.

    Returns:
        {"phases": [...], "young_modulus": {"value", "unit"}, "bounds": {...}, ...}; a file with several samples
        has {"samples": [...]} of these.

    Raises:
        InputError: naming file and line.
    """
    options = {**locals()}
    del options["file"]
    for name, other in (("phases", phases), ("oxides", oxides)):
        if other is not None:
            options[name] = _path(other)
    with tempfile.TemporaryDirectory() as scratch:
        table, hidden = os.path.join(scratch, "table.csv"), f"{scratch}{os.sep}table.csv: "
        if isinstance(file, (str, os.PathLike)):
            table = _path(file)
        else:
            Path(table).write_text(_pandas_text("file", file, "." if decimal != "comma" else ","), encoding="utf-8")
        document: Document = json.loads(_call("modulus", table, *_options(modulus, options), "--json", hidden=hidden))
        return document


def contact(
    *,
    radius: Union[float, str, None] = None,
    diameter: Union[float, str, None] = None,
    density: Union[float, str, None] = None,
    mass: Union[float, str, None] = None,
    partner_radius: Union[float, str, None] = None,
    partner_diameter: Union[float, str, None] = None,
    partner_density: Union[float, str, None] = None,
    partner_mass: Union[float, str, None] = None,
    contact_modulus: Union[float, str, None] = None,
    young_modulus: Union[float, str, None] = None,
    poisson_ratio: Optional[float] = None,
    wall_young_modulus: Union[float, str, None] = None,
    wall_poisson_ratio: Optional[float] = None,
    rigid_wall: bool = False,
    work_of_adhesion: Union[float, str, None] = None,
    surface_energy: Union[float, str, None] = None,
    wall_surface_energy: Union[float, str, None] = None,
    interfacial_energy: Union[float, str, None] = None,
    adhesion_rule: Optional[str] = None,
    roughness: Union[float, str, None] = None,
    soften: Optional[float] = None,
    contact_radius: Union[float, str, None] = None,
    force: Union[float, str, None] = None,
) -> Document:
    """E*, R*, m, w, W_s and v_s of a sphere on a wall; as `ashimpact contact --json`. Numbers are SI, or texts with a unit."""
    return json.loads(_call("contact", *_options(contact, locals()), "--json"))  # type: ignore[no-any-return]


def figure(name: str, artifacts: Union[PathLike, Sequence[PathLike]], file: PathLike, *, width: Optional[str] = None) -> Path:
    """One figure of a run for a paper; as `ashimpact figure`.

    Args:
        name: of the figure, such as "restitution".
        artifacts: folder of a run, or files of one.
        file: .svg, .pdf or .png.
        width: "single" (85 mm) or "double" (170 mm).

    Returns:
        The file.
    """
    several = [artifacts] if isinstance(artifacts, (str, os.PathLike)) else list(artifacts)
    _call("figure", _name(name), *map(_path, several), "-o", _path(file), *_options(figure, {"width": width}))
    return Path(os.fsdecode(file))


def export(code: str, run_folder: Optional[PathLike] = None, *, folder: PathLike, **options: Any) -> Path:
    """Runnable input for a DEM or CFD code; as `ashimpact export`.

    Args:
        code: "openfoam", "lammps", "liggghts", "yade", "fluent" or "table".
        run_folder: folder of a run; without one the options describe a contact, as those of impacts().
        folder: where the input is written.
        options: those of the command, with _ for -, such as sample="88 um" or soften=100.

    Returns:
        The folder.
    """
    words = [] if run_folder is None else [_path(run_folder)]
    _call("export", _name(code), *words, "-o", _path(folder), *_options(export, options))
    return Path(os.fsdecode(folder))


def deposit(
    run_folder: Optional[PathLike] = None,
    *,
    tube_diameter: Union[float, str],
    gas_velocity: Union[float, str],
    gas_temperature: Union[float, str],
    sizes: Union[PathLike, float],
    folder: Optional[PathLike] = None,
    **options: Any,
) -> Document:
    """What stays on a tube in a flow of ash; as `ashimpact deposit`. Numbers are SI, or texts with a unit.

    Args:
        run_folder: folder of a run; without one the options describe a contact, as those of impacts().
        sizes: "20 um", "rosin-rammler: 20 um, 1.2", "log-normal: 20 um, 1.8", or the file of a sieve table.
        folder: where artifact, page and tables are written; without one they are not kept.
        options: those of the command, with _ for -, such as ash_load="10 g/m3" or assumption="tsuji".

    Returns:
        The artifact deposit.json.
    """
    words = [] if run_folder is None else [_path(run_folder)]
    options |= {"tube_diameter": tube_diameter, "gas_velocity": gas_velocity, "gas_temperature": gas_temperature}
    options["sizes"] = os.fsdecode(sizes) if isinstance(sizes, os.PathLike) else sizes
    with tempfile.TemporaryDirectory() as scratch:
        target = Path(scratch) / "deposit" if folder is None else Path(os.fsdecode(folder))
        _call("deposit", *words, "-o", _path(target), *_options(deposit, options))
        return _read(target / "deposit.json")


def run(
    case: Optional[PathLike] = None,
    folder: Optional[PathLike] = None,
    *,
    start: Optional[str] = None,
    only: Optional[str] = None,
    temperature: Union[float, str, None] = None,
    allow_outside: bool = False,
) -> dict[str, Document]:
    """Every stage of a case, from XRD to the critical velocity; as `ashimpact run`.

    Args:
        case: case file; without one the built-in case, Dong et al. 2013.
        folder: where the artifacts are written; without one they are not kept.
        start: stage to start from, with the artifacts before it as they are in the folder.
        only: the one stage to run.
        temperature: of particle and wall, [K] or "900 C", instead of those of the case.
        allow_outside: the case may name files outside of its own folder.

    Returns:
        The artifacts by name: "1-modulus", "2-contact", ..., "comparison", "manifest".

    Raises:
        InputError: naming file and place; nothing is written then.
        ConvergenceError: where a computation did not converge.
    """
    with tempfile.TemporaryDirectory() as scratch:
        target = Path(scratch) / "run" if folder is None else Path(os.fsdecode(folder))
        words = [] if case is None else [_path(case)]
        options = {"only": only, "temperature": temperature, "allow_outside": allow_outside}
        options |= {"no_report": folder is None, "from": start}
        _call("run", *words, "-o", _path(target), *_options(run, options))
        return {path.stem: _read(path) for path in sorted(target.glob("*.json"))}


def literature(source: Optional[str] = None, **material: Any) -> Document:
    """Critical velocities that others measured; as `ashimpact literature --json`.

    Args:
        source: one of them, such as "arffman2015"; without, all.
        material: law, density, contact_modulus and what else the law takes, as impacts(): its velocities beside them.
    """
    words = [] if source is None else [_name(source)]
    document: Document = json.loads(_call("literature", *words, *_options(literature, material), "--json"))
    return document


def calibrate(
    case: Optional[PathLike] = None,
    *,
    free: Union[str, Sequence[str]] = (),
    sizes: Optional[PathLike] = None,
    compare: bool = False,
    allow_outside: bool = False,
    **material: Any,
) -> Document:
    """Unknown constants from published critical velocities; as `ashimpact calibrate --json`.

    Args:
        case: case file; without one the built-in case, Dong et al. 2013.
        free: constants to find, such as "work_of_adhesion" or ["density:each"]; without, what the case says.
        sizes: a table of critical velocities of several sizes instead of a case, or a source of literature(); with
        material: law, density, contact_modulus, what else the law takes as impacts() does, and uncertainty.
        compare: hypotheses beside one another instead of one calibration.
        allow_outside: the case may name files outside of its own folder.
    """
    words = [] if case is None else [_path(case)]
    for name in [free] if isinstance(free, str) else free:
        words.append(f"--free={name}")
    if sizes is not None:
        words.append(f"--sizes={_path(sizes)}")
    words += _options(calibrate, {"compare": compare, "allow_outside": allow_outside, **material})
    document: Document = json.loads(_call("calibrate", *words, "--json"))
    return document


def sweep(
    spec: Union[PathLike, Mapping[str, Any]],
    output: Optional[PathLike] = None,
    *,
    threads: int = 0,
    restart: bool = False,
) -> Document:
    """Many impacts: grids, Monte Carlo, sensitivity; as `ashimpact sweep`.

    Args:
        spec: a spec file, or what one holds as a dict; docs/sweep.md says all.
        output: JSON file for the result, with a table beside it where the spec asks for one; without, none is
            kept. A sweep with an output that is interrupted goes on where it was when it is called again.
        threads: 0 for one a core; no bit of a result depends on it.
        restart: begin anew though there is a checkpoint.

    Returns:
        The result file as a dict.
    """
    with tempfile.TemporaryDirectory() as scratch:
        if isinstance(spec, Mapping):
            spec_file = os.path.join(scratch, "spec.json")
            with open(spec_file, "w", encoding="utf-8") as file:
                json.dump(spec, file, default=_plain)
        else:
            spec_file = _path(spec)
        result = os.path.join(scratch, "sweep.json") if output is None else _path(output)
        _call("sweep", spec_file, "-o", result, *_options(sweep, {"threads": threads, "restart": restart}))
        return _read(result)


@takes_law_parameters
def analyse_impacts(
    impacts: Any = None,
    *,
    law: str,
    radius: float,
    contact_modulus: float,
    density: Optional[float] = None,
    mass: Optional[float] = None,
    work_of_adhesion: Optional[float] = None,
    detachment: Optional[str] = None,
    damping_law: Optional[str] = None,
    velocity: Optional[npt.ArrayLike] = None,
    rebound_velocity: Optional[npt.ArrayLike] = None,
    restitution: Optional[npt.ArrayLike] = None,
    captured: Optional[npt.ArrayLike] = None,
    frame_rate: Optional[float] = None,
    pixel_size: Optional[float] = None,
    frames: Optional[int] = None,
    size_scatter: Optional[float] = None,
    velocity_scale_uncertainty: Optional[float] = None,
    order: Optional[int] = None,
    robust: bool = False,
    bin: Optional[int] = None,
    sheet: Optional[str] = None,
    decimal: Optional[str] = None,
    **parameters: Optional[float],
) -> Document:
    """What measured impacts say of damping and critical velocity; as `ashimpact damping --impacts --json`.

    Args:
        impacts: a file, or a pandas table whose headings are those of such a file ("v_in [m/s]", ...); or
        velocity: of approach [m/s], with either
        rebound_velocity: magnitude, 0 for a capture [m/s]; or
        restitution: 0 for a capture [1].
        captured: truth values, whether the particle stayed; the reading of such an impact does not count.
        law, radius, contact_modulus, density, mass: as impacts(), one of each.
        work_of_adhesion, detachment, damping_law: as impacts(), one of each.
        frame_rate: of the camera, frames per second, with
        pixel_size: in the object [m]: the uncertainty of the velocities.
        frames: positions that each velocity is the slope of; 2 unless given.
        size_scatter: relative standard deviation of single diameters [1].
        velocity_scale_uncertainty: relative, of a factor that all velocities have in common [1].
        order: of the polynomial that is extrapolated; 2 unless given.
        robust: bisquare weights in that polynomial.
        bin: rebounds to be put into one point.
        sheet: of a spreadsheet with several tables.
        decimal: "point" or "comma", of all numbers of a file; without, the numbers decide.
        {law parameters}

    Returns:
        The document of the command: damping of each impact, fits, critical velocity with its interval.
    """
    options = {**locals(), **parameters}
    for name in ("impacts", "velocity", "rebound_velocity", "restitution", "captured", "parameters"):
        del options[name]
    columns = {"velocity": velocity, "rebound_velocity": rebound_velocity, "restitution": restitution, "captured": captured}
    given = {name: values for name, values in columns.items() if values is not None}
    if impacts is not None and given:
        raise _core.InputError(f"impacts, {', '.join(given)}: both are given; allowed: impacts, or velocity with its rebounds")
    words = _options(analyse_impacts, options)
    with tempfile.TemporaryDirectory() as scratch:
        file, hidden = os.path.join(scratch, "impacts.csv"), f"{scratch}{os.sep}impacts.csv: "
        if isinstance(impacts, (str, os.PathLike)):
            file = _path(impacts)
        else:
            if decimal is not None and given:
                raise _core.InputError("decimal is given with numbers; allowed: with a file, or a table that holds texts")
            text = _table_of(impacts, given, "," if decimal == "comma" else ".")
            with open(file, "w", encoding="utf-8") as out:
                out.write(text)
        document: Document = json.loads(_call("damping", *words, "--impacts", file, "--json", hidden=hidden))
        return document


def _plain(value: Any) -> Any:
    """A number or array of numpy as JSON has it."""
    if not hasattr(value, "tolist"):
        raise _core.InputError(f"a {type(value).__name__} is no value of a specification; allowed: what JSON has, and arrays")
    return value.tolist()


def _pandas_text(name: str, table: Any, mark: str, otherwise: str = "") -> str:
    """A pandas table as the program reads it."""
    if not hasattr(table, "columns") or not hasattr(table, "itertuples"):
        raise _core.InputError(f"{name} is a {type(table).__name__}; allowed: a file name, a pandas table{otherwise}")
    cells = table.astype(object).where(table.notna(), "")
    return _csv_text([str(heading) for heading in table.columns], list(cells.itertuples(index=False)), mark)


def _table_of(impacts: Any, given: Mapping[str, npt.ArrayLike], mark: str) -> str:
    """Measured impacts as a table for the program, with the decimal mark that its texts have."""
    if impacts is not None:
        return _pandas_text("impacts", impacts, mark, ", or velocity")
    headings = {"velocity": "v_in [m/s]", "rebound_velocity": "v_r [m/s]", "restitution": "e_n [1]"}
    readings = {name: values for name, values in given.items() if name != "captured"}
    if "velocity" not in readings or len(readings) != 2:
        raise _core.InputError(
            f"{', '.join(given) or 'nothing'} is given; allowed: a file, a pandas table, or velocity with rebound_velocity or restitution"
        )
    names = [headings[name] for name in readings]
    if "captured" not in given:
        return _csv_text(names, _rows_of(readings), mark)
    truths: Any = given["captured"] if hasattr(given["captured"], "astype") else np.asarray(given["captured"])
    count, kind = len(_rows_of(readings)), np.asanyarray(truths).dtype
    if kind != np.bool_ or truths.size != count:
        raise _core.InputError(f"captured is {truths.size} of {kind}; allowed: {count} truth values, one an impact")
    rows = _rows_of({**readings, "captured": truths.astype(float)})
    outcomes = [[velocity, "", "capture"] if stays else [velocity, reading, "rebound"] for velocity, reading, stays in rows]
    return _csv_text(names + ["outcome"], outcomes, mark)


def _rows_of(columns: Mapping[str, npt.ArrayLike]) -> list[list[Any]]:
    """Columns that broadcast, row by row."""
    arrays, shape = flat_arrays(columns)
    return [list(row) for row in zip(*(np.broadcast_to(array, int(np.prod(shape))) for array in arrays.values()))]


def _csv_text(headings: Sequence[str], rows: Sequence[Sequence[Any]], mark: str) -> str:
    """A table as the program reads it; numbers with all their digits."""

    def text_of(cell: Any) -> str:
        return repr(float(cell)).replace(".", mark) if is_real(cell) else cell if isinstance(cell, str) else repr(cell)

    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(headings)
    for row in rows:
        writer.writerow([text_of(cell) for cell in row])
    return text.getvalue()


def columns(node: Mapping[str, Any]) -> dict[str, npt.NDArray[np.float64]]:
    """The columns of a part of an artifact, {"values": [...], "unit": "..."}, by name, in SI.

    A value that there is not (null) becomes NaN.
    """
    found: dict[str, npt.NDArray[np.float64]] = {}
    for name, value in node.items():
        if isinstance(value, Mapping) and isinstance(value.get("values"), list):
            numbers = [np.nan if number is None else number for number in value["values"]]
            if all(isinstance(number, (int, float)) for number in numbers):
                found[name] = np.asarray(numbers, dtype=np.float64)
    return found


def _cells(row: Mapping[str, Any]) -> dict[str, Any]:
    """The single values of a row, by their headings."""
    cells = {}
    for name, value in row.items():
        if isinstance(value, Mapping) and "value" in value:
            cells[f"{name} [{value.get('unit', '1')}]"] = value["value"]
        elif value is not None and not isinstance(value, (Mapping, list)):
            cells[name] = value
    return cells


def to_pandas(node: Union[Mapping[str, Any], Sequence[Mapping[str, Any]]]) -> "pandas.DataFrame":
    """The columns of a part of an artifact, or its rows such as `by_size`, as a table, units in the headings. Needs pandas.

    Columns must have one length; those of another length than the first are left out. Of rows all single values count.
    """
    import pandas

    if not isinstance(node, Mapping):
        return pandas.DataFrame([_cells(row) for row in node])
    table: dict[str, Any] = {}
    length = None
    for name, numbers in columns(node).items():
        length = len(numbers) if length is None else length
        if len(numbers) == length:
            table[f"{name} [{node[name].get('unit', '1')}]"] = numbers
    return pandas.DataFrame(table)
