# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which values of a mesh's faces tell the regions."""

import numpy as np

from . import _core

_MOST = 2**31 - 1


def _labels(values):
    """The values as whole numbers, one a face; None where they are something else."""
    array = np.asarray(values)
    if array.ndim != 1 or array.dtype.kind not in "biuf":
        return None
    if array.dtype.kind == "f" and not (np.isfinite(array) & (array == np.floor(array))).all():
        return None
    if array.size and not (-_MOST <= array.min() and array.max() <= _MOST):
        return None
    return array.astype(np.int32)


def _named(columns, name):
    if name not in columns:
        raise ValueError(f"regions names {name!r}, but the faces have no such values.")
    labels = _labels(columns[name])
    if labels is None:
        raise ValueError(f"regions names {name!r}, whose values are no whole numbers.")
    return labels


def find(columns, regions):
    """The labels of faces, or None.

    columns : the values of the faces, by their names
    regions : an array of labels; the name of a column; "off"; None for all columns whose names tell
        regions, as region, label and material, combined as the command line does it
    """
    if isinstance(regions, str):
        return None if regions == "off" else _named(columns, regions)
    if regions is not None:
        return regions
    found = [_labels(values) for name, values in columns.items() if _core.tells_regions(name)]
    found = [labels for labels in found if labels is not None]
    if len(found) < 2:
        return found[0] if found else None
    return np.unique(np.stack(found, axis=1), axis=0, return_inverse=True)[1].reshape(-1).astype(np.int32)


def is_array(regions):
    """Whether the caller gave labels that belong to no column."""
    return regions is not None and not isinstance(regions, str)
