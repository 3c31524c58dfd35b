# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of results and of measured impacts, from and to pandas where it is installed."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING, Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    import pandas

__all__ = ["columns", "csv_text", "to_pandas"]


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


def to_pandas(node: Mapping[str, Any]) -> "pandas.DataFrame":
    """The columns of a part of an artifact as a table, units in the headings. Needs pandas.

    Columns must have one length; those of another length than the first are left out.
    """
    import pandas

    table: dict[str, Any] = {}
    length = None
    for name, numbers in columns(node).items():
        length = len(numbers) if length is None else length
        if len(numbers) == length:
            table[f"{name} [{node[name].get('unit', '1')}]"] = numbers
    return pandas.DataFrame(table)


def csv_text(headings: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    """A table of measured impacts as the program reads it; numbers with all their digits."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(headings)
    for row in rows:
        writer.writerow([repr(float(cell)) if isinstance(cell, (int, float)) else cell for cell in row])
    return text.getvalue()
