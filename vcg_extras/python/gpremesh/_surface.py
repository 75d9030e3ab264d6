# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib
import threading

from . import _arrays, _core
from ._api import as_list, remesh_mesh
from ._table import with_parameters


class Surface:
    """A surface for many runs: work that all runs share is done once.

    Parameters
    ----------
    vertices, faces
        As for `gpremesh.remesh`. Arrays without a copy must not be written to while the surface is used.

    Notes
    -----
    A Surface saves time with many sizes, presets or seeds. It keeps about 80 bytes for each triangle.
    A run waits for the run of another thread. A copy, also by pickle, is prepared anew.

    Examples
    --------
    >>> import numpy as np, gpremesh
    >>> grid = np.stack(np.meshgrid(np.arange(50.), np.arange(50.)), axis=-1).reshape(-1, 2)
    >>> vertices = np.column_stack([grid, np.sin(grid[:, 0] / 8)])
    >>> corner = np.arange(49 * 50).reshape(49, 50)[:, :49].reshape(-1, 1)
    >>> surface = gpremesh.Surface(vertices, corner + [0, 1, 51, 50])
    >>> [len(surface.remesh(vertex_count=n).vertices) for n in (200, 300, 400)]
    [200, 300, 400]
    """

    def __init__(self, vertices, faces):
        self.__setstate__(_arrays.Mesh(vertices, faces))

    def __getstate__(self):
        return self._mesh

    def __setstate__(self, mesh):
        self._mesh = mesh
        self._prepared = _core.PreparedSurface()
        self._one_run = threading.Lock()
        self._runner = None

    @with_parameters("remesh")
    def remesh(self, *, selected=None, region=None, feature_edges=None, uv=None, image=None,
               regions=None, sizes=None, periodic=None, progress=None, **parameters):
        """Remeshes the surface: the same bytes as from `gpremesh.remesh`, in less time.

        Parameters
        ----------
        selected, region, feature_edges, uv, image, regions, sizes, periodic, progress
            As for `gpremesh.remesh`. Each run may have other values.
        PARAMETERS

        Returns
        -------
        RemeshResult
            As from `gpremesh.remesh`.

        Raises
        ------
        ValueError, gpremesh.Error, KeyboardInterrupt
            As `gpremesh.remesh`.
        RuntimeError
            If the progress function of a run starts another run.
        """
        with self._alone():
            return remesh_mesh(self._mesh, self._prepared, progress, parameters, selected=selected,
                               region=region, feature_edges=feature_edges, uv=uv, image=image,
                               regions=regions, sizes=sizes, periodic=periodic)

    @contextlib.contextmanager
    def _alone(self):
        """Waits for the run of another thread. A run inside of a run of the same thread would wait forever."""
        if self._runner == threading.get_ident():
            raise RuntimeError("The progress function of a run cannot remesh the same Surface; make another Surface.")
        with self._one_run:
            self._runner = threading.get_ident()
            try:
                yield
            finally:
                self._runner = None


def levels(vertices, faces, *, percent=None, vertex_count=None, face_count=None, progress=None, **parameters):
    """Remeshes a surface to several sizes, as levels of detail. The surface is prepared once.

    Parameters
    ----------
    vertices, faces
        As for `gpremesh.remesh`.
    percent, vertex_count, face_count : sequence of numbers
        The sizes. Exactly one of these is given.
    progress : callable(fraction, stage), optional
        As for `gpremesh.remesh`, over all levels.
    **parameters
        The other arguments of `gpremesh.Surface.remesh`, for all levels. `check` is True by default: the
        run proves the largest distance of each level from the input.

    Returns
    -------
    list of RemeshResult
        A result for each size, in order, as from `gpremesh.remesh`. The proven error of a level is
        `report["error"]["hausdorff"]["upper"]`.

    Raises
    ------
    ValueError, TypeError, gpremesh.Error, KeyboardInterrupt
        As `gpremesh.remesh`.

    Examples
    --------
    >>> import numpy as np, gpremesh
    >>> grid = np.stack(np.meshgrid(np.arange(50.), np.arange(50.)), axis=-1).reshape(-1, 2)
    >>> vertices = np.column_stack([grid, np.sin(grid[:, 0] / 8)])
    >>> corner = np.arange(49 * 50).reshape(49, 50)[:, :49].reshape(-1, 1)
    >>> made = gpremesh.levels(vertices, corner + [0, 1, 51, 50], percent=[20, 10, 5])
    >>> [len(level.vertices) for level in made]
    [500, 250, 125]
    """
    given = {"percent": percent, "vertex_count": vertex_count, "face_count": face_count}
    given = {name: as_list(name, sizes) for name, sizes in given.items() if sizes is not None}
    if len(given) != 1 or not all(given.values()):
        raise ValueError("levels needs one of percent, vertex_count and face_count, with a size for each level.")
    (name, sizes), = given.items()
    parameters.setdefault("check", True)
    surface = Surface(vertices, faces)
    return [surface.remesh(**{name: size}, progress=_part(progress, i, len(sizes)), **parameters)
            for i, size in enumerate(sizes)]


def _part(progress, i, num):
    """The progress function of run i, of `num` runs with a common progress."""
    if not callable(progress):
        return progress
    return lambda fraction, stage: progress((i + fraction) / num, stage)
