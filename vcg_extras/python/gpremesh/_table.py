# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Signatures and docstrings, made from the parameter table of the engine when the package is imported."""

import inspect
import textwrap
import typing

from . import _core

_INDENT = " " * 4
_TYPES = {"count": int, "number": float, "length": float, "switch": bool}


def type_of(entry):
    """The type of a parameter, as an annotation."""
    if entry["kind"] != "choice":
        plain = _TYPES[entry["kind"]]
        if entry["default"] == "auto":
            return typing.Union[plain, typing.Literal["auto"]]
        return typing.Union[plain, str] if entry["kind"] == "length" else plain
    return typing.Literal[tuple(entry["choices"])]


def type_text(entry):
    """The type of a parameter, in the style of NumPy's docstrings."""
    if entry["kind"] == "choice":
        return "{" + ", ".join(repr(choice) for choice in entry["choices"]) + "}"
    return _TYPES[entry["kind"]].__name__ + (" or 'auto'" if entry["default"] == "auto" else "")


def documentation(tool, names):
    """The parameters of a tool with these names, as a section of a docstring."""
    lines = []
    for entry in _core.parameters(tool):
        if entry["name"] not in names:
            continue
        default = "optional" if entry["default"] is None else f"default {entry['default']!r}"
        lines.append(f"{entry['name']} : {type_text(entry)}, {default}")
        lines.append(textwrap.fill(entry["help"], 96, initial_indent=_INDENT, subsequent_indent=_INDENT))
    return "\n".join(lines)


def with_parameters(tool):
    """Decorates a function with the parameters of a tool as `**parameters`: the signature and the docstring, at the
    line PARAMETERS, name each parameter that is no argument of the function itself. Unknown parameters raise a
    TypeError."""

    def decorate(function):
        def call(*args, **keywords):
            for keyword in keywords:
                if keyword not in accepted:
                    raise TypeError(f"{function.__name__}() has no parameter {keyword!r}")
            return function(*args, **keywords)

        own = {p.name: p for p in inspect.signature(function).parameters.values() if p.kind != p.VAR_KEYWORD}
        of_table = {
            entry["name"]: inspect.Parameter(entry["name"], inspect.Parameter.KEYWORD_ONLY, default=entry["default"],
                                             annotation=type_of(entry))
            for entry in _core.parameters(tool)
        }
        for name in own.keys() & of_table.keys():
            own[name] = own[name].replace(annotation=of_table.pop(name).annotation)
        accepted = {**own, **of_table}
        call.__name__ = call.__qualname__ = function.__name__
        call.__module__ = function.__module__
        call.__doc__ = inspect.cleandoc(function.__doc__).replace("PARAMETERS", documentation(tool, of_table))
        call.__signature__ = inspect.Signature(list(accepted.values()))
        return call

    return decorate
