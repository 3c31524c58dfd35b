# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters of contact laws as keyword arguments, from the table of the library."""

from __future__ import annotations

import functools
import inspect
import textwrap
from typing import Any, Callable, TypeVar, cast

from ashimpact import _core

Function = TypeVar("Function", bound=Callable[..., Any])


def takes_law_parameters(function: Function) -> Function:
    """Completes a function with **parameters by the parameters of all laws.

    They are in its signature and, in place of the line "{law parameters}", in its documentation. Other names are
    refused as Python refuses an unknown argument.
    """
    table = _core.law_parameters()
    signature = inspect.signature(function)
    stated = [each for each in signature.parameters.values() if each.kind is not inspect.Parameter.VAR_KEYWORD]
    annotation = signature.parameters["parameters"].annotation
    own = [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=annotation) for name in table
    ]
    complete = signature.replace(parameters=[*stated, *own])

    @functools.wraps(function)
    def checked(*arguments: Any, **given: Any) -> Any:
        for name in given:
            if name not in complete.parameters:
                raise TypeError(f"{function.__name__}() got an unexpected keyword argument {name!r}")
        return function(*arguments, **given)

    lines = [
        textwrap.fill(f"{name}: {text} [{unit}]; law {', '.join(laws)}.", 110, initial_indent=8 * " ", subsequent_indent=12 * " ")
        for name, (unit, text, laws) in table.items()
    ]
    checked.__doc__ = (function.__doc__ or "").replace(8 * " " + "{law parameters}", "\n".join(lines))
    checked.__signature__ = complete  # type: ignore[attr-defined]
    return cast(Function, checked)
