# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Made by vcg_extras/python/make_stubs --write from the engine's parameter table; do not edit.
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal, SupportsFloat, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike

from . import open3d as open3d
from . import pyvista as pyvista
from . import trimesh as trimesh
from ._errors import Error as Error
from ._results import Distance as Distance
from ._results import Features as Features
from ._results import OneWayDistance as OneWayDistance
from ._results import RemeshResult as RemeshResult
from ._results import Samples as Samples

__all__ = ['Distance', 'Error', 'Features', 'FileMesh', 'OneWayDistance', 'RemeshResult', 'Samples', 'Surface', 'distance', 'features', 'levels', 'read', 'remesh', 'remesh_together', 'sample', 'write']
__version__: str

class FileMesh:
    """A mesh with all values that a file can hold.

    Parameters
    ----------
    vertices, faces : array_like
        As for `gpremesh.remesh`.
    uv : array_like (n, 2) or (f, c, 2), optional
        Texture coordinates of the vertices, or of the corners of the faces, from the lower left corner
        of the image; c is the most corners of a face.
    image : array_like (f,) of int, optional
        With `uv`: the number of the material of each face.
    vertex_values, face_values : dict of str to array_like, optional
        A number for each vertex or face, by the names of PLY files: red, green, blue and alpha (uint8),
        nx, ny and nz, quality, and any other name without spaces.
    materials : FileMesh, optional
        A mesh from which the new mesh gets materials and images.

    Attributes
    ----------
    vertices, faces, uv, image, vertex_values, face_values
        As above. All may be changed.
    region : ndarray (n,) of bool, or None
        The vertices that a PLY file marks as selected; None if no vertex is selected.
    notes : list of str
        Sentences about oddities of the file.
    result : RemeshResult or None
        For a result of `remesh`: the place of each vertex on the input, and the report.
    """
    vertices: np.ndarray
    faces: np.ndarray
    uv: np.ndarray | None
    image: np.ndarray | None
    vertex_values: dict[str, np.ndarray]
    face_values: dict[str, np.ndarray]
    region: np.ndarray | None
    notes: list[str]
    result: RemeshResult | None

    def __init__(
        self,
        vertices: ArrayLike,
        faces: ArrayLike | Sequence[ArrayLike],
        *,
        uv: ArrayLike | None = None,
        image: ArrayLike | None = None,
        vertex_values: Mapping[str, ArrayLike] | None = None,
        face_values: Mapping[str, ArrayLike] | None = None,
        materials: FileMesh | None = None,
    ) -> None:
        ...

    def remesh(
        self,
        vertex_count: SupportsIndex | None = None,
        *,
        selected: ArrayLike | None = None,
        region: ArrayLike | None = None,
        feature_edges: ArrayLike | None = None,
        regions: ArrayLike | None = None,
        sizes: ArrayLike | None = None,
        periodic: ArrayLike | None = None,
        progress: Callable[[float, str], Any] | None = None,
        face_count: SupportsIndex | None = None,
        percent: SupportsFloat | None = None,
        edge_length: SupportsFloat | str | None = None,
        max_error: SupportsFloat | str | None = None,
        preset: Literal['default', 'fast', 'paper'] = 'default',
        adapt: SupportsFloat | Literal['auto'] = 'auto',
        lambda_: SupportsFloat = 0.0,
        features: Literal['auto', 'lines', 'off', 'selected'] = 'auto',
        feature_disk_scale: SupportsFloat = 0.0,
        boundary: Literal['resample', 'keep', 'free', 'smooth', 'match'] = 'resample',
        feature_region: Literal['none', 'detected', 'selection', 'auto'] = 'auto',
        feature_angle: SupportsFloat = 40.0,
        feature_support: SupportsFloat = 2.0,
        feature_strong: SupportsFloat = 40.0,
        feature_weak: SupportsFloat = 20.0,
        feature_length: SupportsFloat = 3.0,
        detail: Literal['off', 'coarse', 'normal', 'fine'] | None = None,
        allow_nearest: bool = False,
        min_edge: SupportsFloat | str = 0.0,
        max_edge: SupportsFloat | str = 0.0,
        growth: SupportsFloat = 1.15,
        symmetry: Literal['off', 'x', 'y', 'z', 'auto'] = 'off',
        sew: bool = True,
        junctions: Literal['cut', 'keep'] = 'cut',
        drop_components_below: SupportsIndex = 0,
        seed: SupportsIndex = 1,
        threads: SupportsIndex = 0,
        time_limit: SupportsFloat = 0.0,
        check: bool = False,
        relax: SupportsIndex = 3,
        flips: SupportsIndex = 1000,
    ) -> FileMesh:
        """Remeshes the mesh and transfers all values, by the rules of the command line.

        Parameters
        ----------
        vertex_count : int, optional
            Number of vertices of the result.
        selected, region, feature_edges, regions, sizes, periodic, progress
            As for `gpremesh.remesh`. The default of `region` is the region of the file. The default of
            `regions` are the face values whose names tell regions, as region and label; given labels are
            the face values "region" of the new mesh.
        face_count : int, optional
            The exact number of faces of the result. A closed surface has an even number, about twice
            the number of vertices. A surface with a border can have any number, unless all border
            vertices are kept. If the topology does not allow the number, the run is refused, and the
            message names the two nearest possible numbers.
        percent : float, optional
            The number of vertices in percent of the input's vertices, at most 10000. If the topology
            needs more vertices, the result has more.
        edge_length : float, optional
            The wanted mean edge length of the result in mesh units. If the topology needs more
            vertices, the result has more. A text with a percent sign ("0.2%") is a share of the
            diagonal.
        max_error : float, optional
            Searches the smallest number of vertices with a proven largest distance between result and
            input, in both directions, of at most this length in mesh units. The search makes at most
            five trials. The adaptivity is 1 unless another value is given. If a trial is too far from
            the input, vertices are added. An impossible error is refused. A text with a percent sign
            ("0.2%") is a share of the diagonal.
        preset : {'default', 'fast', 'paper'}, default 'default'
            The methods of a run. default: the most regular triangles, close to the input. The fit moves
            vertices a little off the surface to reduce the distance; vertices of borders and feature
            lines leave their curves by at most 8 % of an edge. fast: less than half the time, without
            the steps for regularity; one step raises each vertex over its neighbours in place of the
            fit. paper: each stage as in the paper; every vertex stays on the surface, and the number of
            vertices is not exact: about a tenth off on closed surfaces, more with borders and many
            components; a note tells the difference. A sampling is the same with default and fast.
        adapt : float or 'auto', default 'auto'
            Adaptivity of the local sizes to the error. 0: all triangles have one size. 0.1: a tenth of
            the vertices goes to ridges, rims and tips that are finer than the triangles. 1: all sizes
            follow the error. If feature lines take a third of the vertices, the sizes stay even. auto:
            0.1; 1 with a largest error; 0 with a lambda above 0, with the preset fast, and for a
            sampling alone. The preset paper has no adaptivity.
        lambda_ : float, default 0.0
            Additional density at curved places, eq. (4) of the paper. Distances are stretched by 1 +
            lambda |H| r, at most 4; H is the mean curvature and r the radius of the disks. 0: even
            density. Usual values are 1 to 5. The preset paper takes H with its sign, in 1/mesh unit,
            without a limit.
        features : {'auto', 'lines', 'off', 'selected'}, default 'auto'
            Feature lines are crease edges of the input that become edges of the result; corners and
            cone apexes become vertices. auto: clear crease edges, but not the noise of a scan; none
            with the preset paper, which never follows lines. lines: all edges above the angle of
            feature lines. off: none. selected: only the selected edges. feature_edges lists the
            selected edges.
        feature_disk_scale : float, default 0.0
            Makes the triangles of the feature region smaller: the radius of the disks in the region,
            divided by the radius elsewhere, 0.05 to 1. The selected vertices are the feature region; if
            no vertex is selected, the region is detected. 0: no feature region, unless the option
            feature region names one; then its disks have half the radius. With the preset paper 0 keeps
            each vertex of a named region.
        boundary : {'resample', 'keep', 'free', 'smooth', 'match'}, default 'resample'
            Treatment of the borders of the surface. resample: the curves and corners of the border
            stay, with new vertices. keep: each border vertex stays, and no vertex is added; the
            triangles grow from the spacing there to the wanted size. free: evenly spaced vertices,
            which cut corners off. smooth: for the ragged borders of scans; the border becomes a smooth
            curve within half an edge of the old border, corners are rounded, and the report tells the
            lost length. match: the vertices depend on the border and the edge length only; meshes with
            a common piece of border get the same vertices there, bit for bit, in separate runs with the
            same edge length.
        feature_region : {'none', 'detected', 'selection', 'auto'}, default 'auto'
            The part of the surface with denser vertices, section 3.1.1 of the paper. none: no region.
            detected: the region of the feature detection, by the strength of the edges. selection: the
            selected vertices; if no vertex is selected, the corners of the selected faces. auto: with a
            feature disk scale, the selected vertices, or the detected region if no vertex is selected;
            otherwise none. region marks the selected vertices.
        feature_angle : float, default 40.0
            A feature line begins at edges whose faces differ by this angle in degrees, 5 to 175, and
            continues from its ends down to half of the angle.
        feature_support : float, default 2.0
            The strength of an edge is the angle between the mean normals of its two sides. The support
            is the radius of the averages, in mean edges of the input; above 0, at most 100. A larger
            support suppresses more noise.
        feature_strong : float, default 40.0
            A detected feature begins at a strength of this angle in degrees; above 0, at most 180.
        feature_weak : float, default 20.0
            A detected feature continues down to a strength of this angle in degrees; above 0, at most
            the strong angle.
        feature_length : float, default 3.0
            Detected features shorter than this number of supports are dropped as noise. 0 keeps all
            features.
        detail : {'off', 'coarse', 'normal', 'fine'}, optional
            The number of vertices in words: 99.9 % of the surface is expected to be nearer than 1 % of
            the diagonal (coarse), 0.3 % (normal) or 0.1 % (fine). The program tells the number. This is
            a forecast; the largest error proves a distance, and takes several times as long. off:
            another option sets the size.
        allow_nearest : bool, default False
            If the topology does not allow the wanted number of vertices or faces, the nearest possible
            number is taken. Otherwise the run is refused.
        min_edge : float, default 0.0
            The smallest local size, in mesh units. A text with a percent sign ("0.2%") is a share of
            the diagonal.
        max_edge : float, default 0.0
            The largest local size, in mesh units. Without a size of the result, this is the size of all
            places that nothing else makes smaller, and decides the number of vertices. A local size is
            a mean: about a tenth of the edges are more than a fifth longer, single edges twice as long
            or more. A text with a percent sign ("0.2%") is a share of the diagonal.
        growth : float, default 1.15
            The largest ratio of the lengths of neighbouring edges, 1.05 to 2. Faster growth costs
            angles.
        symmetry : {'off', 'x', 'y', 'z', 'auto'}, default 'off'
            The result is its own mirror image: each vertex has an image across a plane with the same
            coordinates bit for bit, except the mirrored coordinate, and edges run along the plane. x,
            y, z: the plane through the middle of the bounding box, perpendicular to this axis. auto:
            the best of these planes and of the planes of the principal axes. The input must be
            symmetric to .1 % of the diagonal; otherwise the run is refused. Half of the input is
            remeshed and mirrored.
        sew : bool, default True
            Joins borders that coincide edge by edge, within a millionth of the bounding box. CAD parts,
            and games whose smooth patches have separate vertices, have such borders. Feature lines run
            along sharp seams. Edges with more than two borders stay cut. off: the pieces stay separate.
        junctions : {'cut', 'keep'}, default 'cut'
            Treatment of edges with more than two faces, and of places at which sheets only touch. cut:
            the smoothest two of the faces stay joined, the other faces get a border. keep: the edges
            are sampled once for all sheets, which share their vertices, such as walls between grains,
            strata or rooms.
        drop_components_below : int, default 0
            Components with fewer faces are left out, for instance the dust of a scan. Each such
            component would take four vertices. 0 keeps all components.
        seed : int, default 1
            The same seed gives the same mesh, byte for byte, with any number of threads. 0 takes a new
            seed; the report names the seed.
        threads : int, default 0
            The number of threads, at most 1024. 0 takes one for each core. The result is the same.
        time_limit : float, default 0.0
            A run that takes longer ends without a result and changes nothing. 0 is no limit. The limit
            counts the time of the engine, without the conversion of arrays.
        check : bool, default False
            Searches self-intersections and measures the distances from the input: root mean square,
            p99.9 (99.9 % of the surface is nearer) and the largest, with proven bounds, in both
            directions. This takes longer than the run itself. A result is withheld if faces intersect
            at places without intersections of the input, or if a vertex is farther from the input than
            the move of the fit.
        relax : int, default 3
            With the preset paper: the number of moves of the vertices by the second-order umbrella
            operator, 0 to 1000. Edges are flipped after each move.
        flips : int, default 1000
            With the preset paper: the largest number of passes of edge flips, each time, 0 to 1000.
            With 1000 the passes end when all edges are Delaunay, as without this preset.

        Returns
        -------
        FileMesh
            The new mesh, with places and report as `result`. The old mesh is not changed.

        Raises
        ------
        ValueError, gpremesh.Error, KeyboardInterrupt
            As `gpremesh.remesh`.
        """

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

    def __init__(
        self,
        vertices: ArrayLike,
        faces: ArrayLike | Sequence[ArrayLike],
    ) -> None:
        ...

    def remesh(
        self,
        *,
        selected: ArrayLike | None = None,
        region: ArrayLike | None = None,
        feature_edges: ArrayLike | None = None,
        uv: ArrayLike | None = None,
        image: ArrayLike | None = None,
        regions: ArrayLike | None = None,
        sizes: ArrayLike | None = None,
        periodic: ArrayLike | None = None,
        progress: Callable[[float, str], Any] | None = None,
        vertex_count: SupportsIndex | None = None,
        face_count: SupportsIndex | None = None,
        percent: SupportsFloat | None = None,
        edge_length: SupportsFloat | str | None = None,
        max_error: SupportsFloat | str | None = None,
        preset: Literal['default', 'fast', 'paper'] = 'default',
        adapt: SupportsFloat | Literal['auto'] = 'auto',
        lambda_: SupportsFloat = 0.0,
        features: Literal['auto', 'lines', 'off', 'selected'] = 'auto',
        feature_disk_scale: SupportsFloat = 0.0,
        boundary: Literal['resample', 'keep', 'free', 'smooth', 'match'] = 'resample',
        feature_region: Literal['none', 'detected', 'selection', 'auto'] = 'auto',
        feature_angle: SupportsFloat = 40.0,
        feature_support: SupportsFloat = 2.0,
        feature_strong: SupportsFloat = 40.0,
        feature_weak: SupportsFloat = 20.0,
        feature_length: SupportsFloat = 3.0,
        detail: Literal['off', 'coarse', 'normal', 'fine'] | None = None,
        allow_nearest: bool = False,
        min_edge: SupportsFloat | str = 0.0,
        max_edge: SupportsFloat | str = 0.0,
        growth: SupportsFloat = 1.15,
        symmetry: Literal['off', 'x', 'y', 'z', 'auto'] = 'off',
        sew: bool = True,
        junctions: Literal['cut', 'keep'] = 'cut',
        drop_components_below: SupportsIndex = 0,
        seed: SupportsIndex = 1,
        threads: SupportsIndex = 0,
        time_limit: SupportsFloat = 0.0,
        check: bool = False,
        relax: SupportsIndex = 3,
        flips: SupportsIndex = 1000,
    ) -> RemeshResult:
        """Remeshes the surface: the same bytes as from `gpremesh.remesh`, in less time.

        Parameters
        ----------
        selected, region, feature_edges, uv, image, regions, sizes, periodic, progress
            As for `gpremesh.remesh`. Each run may have other values.
        vertex_count : int, optional
            The number of vertices of the result: exact for a remeshing. A sampling is about a tenth off
            on closed surfaces with some hundred vertices, and more with fewer vertices, with a varying
            density, and if borders, components or feature lines need samples of their own; a note tells
            the difference. If the topology needs more vertices, the run is refused, and the message
            names the smallest possible number. If only the selected faces are remeshed, the number
            counts the vertices of this part.
        face_count : int, optional
            The exact number of faces of the result. A closed surface has an even number, about twice
            the number of vertices. A surface with a border can have any number, unless all border
            vertices are kept. If the topology does not allow the number, the run is refused, and the
            message names the two nearest possible numbers.
        percent : float, optional
            The number of vertices in percent of the input's vertices, at most 10000. If the topology
            needs more vertices, the result has more.
        edge_length : float, optional
            The wanted mean edge length of the result in mesh units. If the topology needs more
            vertices, the result has more. A text with a percent sign ("0.2%") is a share of the
            diagonal.
        max_error : float, optional
            Searches the smallest number of vertices with a proven largest distance between result and
            input, in both directions, of at most this length in mesh units. The search makes at most
            five trials. The adaptivity is 1 unless another value is given. If a trial is too far from
            the input, vertices are added. An impossible error is refused. A text with a percent sign
            ("0.2%") is a share of the diagonal.
        preset : {'default', 'fast', 'paper'}, default 'default'
            The methods of a run. default: the most regular triangles, close to the input. The fit moves
            vertices a little off the surface to reduce the distance; vertices of borders and feature
            lines leave their curves by at most 8 % of an edge. fast: less than half the time, without
            the steps for regularity; one step raises each vertex over its neighbours in place of the
            fit. paper: each stage as in the paper; every vertex stays on the surface, and the number of
            vertices is not exact: about a tenth off on closed surfaces, more with borders and many
            components; a note tells the difference. A sampling is the same with default and fast.
        adapt : float or 'auto', default 'auto'
            Adaptivity of the local sizes to the error. 0: all triangles have one size. 0.1: a tenth of
            the vertices goes to ridges, rims and tips that are finer than the triangles. 1: all sizes
            follow the error. If feature lines take a third of the vertices, the sizes stay even. auto:
            0.1; 1 with a largest error; 0 with a lambda above 0, with the preset fast, and for a
            sampling alone. The preset paper has no adaptivity.
        lambda_ : float, default 0.0
            Additional density at curved places, eq. (4) of the paper. Distances are stretched by 1 +
            lambda |H| r, at most 4; H is the mean curvature and r the radius of the disks. 0: even
            density. Usual values are 1 to 5. The preset paper takes H with its sign, in 1/mesh unit,
            without a limit.
        features : {'auto', 'lines', 'off', 'selected'}, default 'auto'
            Feature lines are crease edges of the input that become edges of the result; corners and
            cone apexes become vertices. auto: clear crease edges, but not the noise of a scan; none
            with the preset paper, which never follows lines. lines: all edges above the angle of
            feature lines. off: none. selected: only the selected edges. feature_edges lists the
            selected edges.
        feature_disk_scale : float, default 0.0
            Makes the triangles of the feature region smaller: the radius of the disks in the region,
            divided by the radius elsewhere, 0.05 to 1. The selected vertices are the feature region; if
            no vertex is selected, the region is detected. 0: no feature region, unless the option
            feature region names one; then its disks have half the radius. With the preset paper 0 keeps
            each vertex of a named region.
        boundary : {'resample', 'keep', 'free', 'smooth', 'match'}, default 'resample'
            Treatment of the borders of the surface. resample: the curves and corners of the border
            stay, with new vertices. keep: each border vertex stays, and no vertex is added; the
            triangles grow from the spacing there to the wanted size. free: evenly spaced vertices,
            which cut corners off. smooth: for the ragged borders of scans; the border becomes a smooth
            curve within half an edge of the old border, corners are rounded, and the report tells the
            lost length. match: the vertices depend on the border and the edge length only; meshes with
            a common piece of border get the same vertices there, bit for bit, in separate runs with the
            same edge length.
        feature_region : {'none', 'detected', 'selection', 'auto'}, default 'auto'
            The part of the surface with denser vertices, section 3.1.1 of the paper. none: no region.
            detected: the region of the feature detection, by the strength of the edges. selection: the
            selected vertices; if no vertex is selected, the corners of the selected faces. auto: with a
            feature disk scale, the selected vertices, or the detected region if no vertex is selected;
            otherwise none. region marks the selected vertices.
        feature_angle : float, default 40.0
            A feature line begins at edges whose faces differ by this angle in degrees, 5 to 175, and
            continues from its ends down to half of the angle.
        feature_support : float, default 2.0
            The strength of an edge is the angle between the mean normals of its two sides. The support
            is the radius of the averages, in mean edges of the input; above 0, at most 100. A larger
            support suppresses more noise.
        feature_strong : float, default 40.0
            A detected feature begins at a strength of this angle in degrees; above 0, at most 180.
        feature_weak : float, default 20.0
            A detected feature continues down to a strength of this angle in degrees; above 0, at most
            the strong angle.
        feature_length : float, default 3.0
            Detected features shorter than this number of supports are dropped as noise. 0 keeps all
            features.
        detail : {'off', 'coarse', 'normal', 'fine'}, optional
            The number of vertices in words: 99.9 % of the surface is expected to be nearer than 1 % of
            the diagonal (coarse), 0.3 % (normal) or 0.1 % (fine). The program tells the number. This is
            a forecast; the largest error proves a distance, and takes several times as long. off:
            another option sets the size.
        allow_nearest : bool, default False
            If the topology does not allow the wanted number of vertices or faces, the nearest possible
            number is taken. Otherwise the run is refused.
        min_edge : float, default 0.0
            The smallest local size, in mesh units. A text with a percent sign ("0.2%") is a share of
            the diagonal.
        max_edge : float, default 0.0
            The largest local size, in mesh units. Without a size of the result, this is the size of all
            places that nothing else makes smaller, and decides the number of vertices. A local size is
            a mean: about a tenth of the edges are more than a fifth longer, single edges twice as long
            or more. A text with a percent sign ("0.2%") is a share of the diagonal.
        growth : float, default 1.15
            The largest ratio of the lengths of neighbouring edges, 1.05 to 2. Faster growth costs
            angles.
        symmetry : {'off', 'x', 'y', 'z', 'auto'}, default 'off'
            The result is its own mirror image: each vertex has an image across a plane with the same
            coordinates bit for bit, except the mirrored coordinate, and edges run along the plane. x,
            y, z: the plane through the middle of the bounding box, perpendicular to this axis. auto:
            the best of these planes and of the planes of the principal axes. The input must be
            symmetric to .1 % of the diagonal; otherwise the run is refused. Half of the input is
            remeshed and mirrored.
        sew : bool, default True
            Joins borders that coincide edge by edge, within a millionth of the bounding box. CAD parts,
            and games whose smooth patches have separate vertices, have such borders. Feature lines run
            along sharp seams. Edges with more than two borders stay cut. off: the pieces stay separate.
        junctions : {'cut', 'keep'}, default 'cut'
            Treatment of edges with more than two faces, and of places at which sheets only touch. cut:
            the smoothest two of the faces stay joined, the other faces get a border. keep: the edges
            are sampled once for all sheets, which share their vertices, such as walls between grains,
            strata or rooms.
        drop_components_below : int, default 0
            Components with fewer faces are left out, for instance the dust of a scan. Each such
            component would take four vertices. 0 keeps all components.
        seed : int, default 1
            The same seed gives the same mesh, byte for byte, with any number of threads. 0 takes a new
            seed; the report names the seed.
        threads : int, default 0
            The number of threads, at most 1024. 0 takes one for each core. The result is the same.
        time_limit : float, default 0.0
            A run that takes longer ends without a result and changes nothing. 0 is no limit. The limit
            counts the time of the engine, without the conversion of arrays.
        check : bool, default False
            Searches self-intersections and measures the distances from the input: root mean square,
            p99.9 (99.9 % of the surface is nearer) and the largest, with proven bounds, in both
            directions. This takes longer than the run itself. A result is withheld if faces intersect
            at places without intersections of the input, or if a vertex is farther from the input than
            the move of the fit.
        relax : int, default 3
            With the preset paper: the number of moves of the vertices by the second-order umbrella
            operator, 0 to 1000. Edges are flipped after each move.
        flips : int, default 1000
            With the preset paper: the largest number of passes of edge flips, each time, 0 to 1000.
            With 1000 the passes end when all edges are Delaunay, as without this preset.

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

def remesh(
    vertices: ArrayLike,
    faces: ArrayLike | Sequence[ArrayLike],
    *,
    selected: ArrayLike | None = None,
    region: ArrayLike | None = None,
    feature_edges: ArrayLike | None = None,
    uv: ArrayLike | None = None,
    image: ArrayLike | None = None,
    regions: ArrayLike | None = None,
    sizes: ArrayLike | None = None,
    periodic: ArrayLike | None = None,
    progress: Callable[[float, str], Any] | None = None,
    vertex_count: SupportsIndex | None = None,
    face_count: SupportsIndex | None = None,
    percent: SupportsFloat | None = None,
    edge_length: SupportsFloat | str | None = None,
    max_error: SupportsFloat | str | None = None,
    preset: Literal['default', 'fast', 'paper'] = 'default',
    adapt: SupportsFloat | Literal['auto'] = 'auto',
    lambda_: SupportsFloat = 0.0,
    features: Literal['auto', 'lines', 'off', 'selected'] = 'auto',
    feature_disk_scale: SupportsFloat = 0.0,
    boundary: Literal['resample', 'keep', 'free', 'smooth', 'match'] = 'resample',
    feature_region: Literal['none', 'detected', 'selection', 'auto'] = 'auto',
    feature_angle: SupportsFloat = 40.0,
    feature_support: SupportsFloat = 2.0,
    feature_strong: SupportsFloat = 40.0,
    feature_weak: SupportsFloat = 20.0,
    feature_length: SupportsFloat = 3.0,
    detail: Literal['off', 'coarse', 'normal', 'fine'] | None = None,
    allow_nearest: bool = False,
    min_edge: SupportsFloat | str = 0.0,
    max_edge: SupportsFloat | str = 0.0,
    growth: SupportsFloat = 1.15,
    symmetry: Literal['off', 'x', 'y', 'z', 'auto'] = 'off',
    sew: bool = True,
    junctions: Literal['cut', 'keep'] = 'cut',
    drop_components_below: SupportsIndex = 0,
    seed: SupportsIndex = 1,
    threads: SupportsIndex = 0,
    time_limit: SupportsFloat = 0.0,
    check: bool = False,
    relax: SupportsIndex = 3,
    flips: SupportsIndex = 1000,
) -> RemeshResult:
    """Remeshes a surface to nearly equilateral triangles, with exactly the wanted number of vertices.

    Parameters
    ----------
    vertices : array_like (n, 3)
        Coordinates in any unit. Arrays of float32 and float64 in C order are not copied; other arrays are
        converted to float64.
    faces : array_like (f, 3), (f, k), or a list of polygons
        Triangles, polygons of k corners, or polygons of several sizes, as rows of `vertices`. Arrays of
        int32 in C order are not copied; other arrays are converted. Polygons are cut into triangles.
    selected : array_like (f,) of bool, optional
        Only the faces with True are remeshed. All other faces stay, bit for bit, and come first.
    region : array_like (n,) of bool, optional
        The feature region: the vertices around which triangles are smaller (`feature_disk_scale`).
    feature_edges : array_like (e, 2), optional
        Edges of the faces, as pairs of vertices. Edges of the result follow these edges. Without
        `features` the result follows no other edges; features='auto' adds the edges that are found.
    uv : array_like (n, 2) or (f, c, 2), optional
        Texture coordinates of the vertices, or of the corners of the faces; c is the most corners of a
        face, and the rest of the row of a smaller face is not used. Edges of the result follow the seams.
    image : array_like (f,) of int, optional
        With `uv`: the number of the image of each face, -1 without an image.
    regions : array_like (f,) of int, optional
        Labels of the faces, such as materials or patches. Edges of the result follow the borders between
        labels, and `regions` of the result has a label for each new face.
    sizes : array_like (n,), optional
        The wanted edge length at each vertex, in the unit of the coordinates. `sizes` alone determines
        the number of vertices; a given number or another size scales all lengths.
    periodic : (x, y, z), optional
        The lengths of a periodic cell, 0 along an axis without a period. Vertices at opposite borders
        match after adding the length; `boundary` is 'match' then. Refused if the borders are not
        translates of each other.
    progress : callable(fraction, stage), optional
        Called about every 50 ms with the share of the work done, from 0 to 1, and a short text. The run
        is cancelled if the function returns False or raises.
    vertex_count : int, optional
        The number of vertices of the result: exact for a remeshing. A sampling is about a tenth off
        on closed surfaces with some hundred vertices, and more with fewer vertices, with a varying
        density, and if borders, components or feature lines need samples of their own; a note tells
        the difference. If the topology needs more vertices, the run is refused, and the message
        names the smallest possible number. If only the selected faces are remeshed, the number
        counts the vertices of this part.
    face_count : int, optional
        The exact number of faces of the result. A closed surface has an even number, about twice
        the number of vertices. A surface with a border can have any number, unless all border
        vertices are kept. If the topology does not allow the number, the run is refused, and the
        message names the two nearest possible numbers.
    percent : float, optional
        The number of vertices in percent of the input's vertices, at most 10000. If the topology
        needs more vertices, the result has more.
    edge_length : float, optional
        The wanted mean edge length of the result in mesh units. If the topology needs more
        vertices, the result has more. A text with a percent sign ("0.2%") is a share of the
        diagonal.
    max_error : float, optional
        Searches the smallest number of vertices with a proven largest distance between result and
        input, in both directions, of at most this length in mesh units. The search makes at most
        five trials. The adaptivity is 1 unless another value is given. If a trial is too far from
        the input, vertices are added. An impossible error is refused. A text with a percent sign
        ("0.2%") is a share of the diagonal.
    preset : {'default', 'fast', 'paper'}, default 'default'
        The methods of a run. default: the most regular triangles, close to the input. The fit moves
        vertices a little off the surface to reduce the distance; vertices of borders and feature
        lines leave their curves by at most 8 % of an edge. fast: less than half the time, without
        the steps for regularity; one step raises each vertex over its neighbours in place of the
        fit. paper: each stage as in the paper; every vertex stays on the surface, and the number of
        vertices is not exact: about a tenth off on closed surfaces, more with borders and many
        components; a note tells the difference. A sampling is the same with default and fast.
    adapt : float or 'auto', default 'auto'
        Adaptivity of the local sizes to the error. 0: all triangles have one size. 0.1: a tenth of
        the vertices goes to ridges, rims and tips that are finer than the triangles. 1: all sizes
        follow the error. If feature lines take a third of the vertices, the sizes stay even. auto:
        0.1; 1 with a largest error; 0 with a lambda above 0, with the preset fast, and for a
        sampling alone. The preset paper has no adaptivity.
    lambda_ : float, default 0.0
        Additional density at curved places, eq. (4) of the paper. Distances are stretched by 1 +
        lambda |H| r, at most 4; H is the mean curvature and r the radius of the disks. 0: even
        density. Usual values are 1 to 5. The preset paper takes H with its sign, in 1/mesh unit,
        without a limit.
    features : {'auto', 'lines', 'off', 'selected'}, default 'auto'
        Feature lines are crease edges of the input that become edges of the result; corners and
        cone apexes become vertices. auto: clear crease edges, but not the noise of a scan; none
        with the preset paper, which never follows lines. lines: all edges above the angle of
        feature lines. off: none. selected: only the selected edges. feature_edges lists the
        selected edges.
    feature_disk_scale : float, default 0.0
        Makes the triangles of the feature region smaller: the radius of the disks in the region,
        divided by the radius elsewhere, 0.05 to 1. The selected vertices are the feature region; if
        no vertex is selected, the region is detected. 0: no feature region, unless the option
        feature region names one; then its disks have half the radius. With the preset paper 0 keeps
        each vertex of a named region.
    boundary : {'resample', 'keep', 'free', 'smooth', 'match'}, default 'resample'
        Treatment of the borders of the surface. resample: the curves and corners of the border
        stay, with new vertices. keep: each border vertex stays, and no vertex is added; the
        triangles grow from the spacing there to the wanted size. free: evenly spaced vertices,
        which cut corners off. smooth: for the ragged borders of scans; the border becomes a smooth
        curve within half an edge of the old border, corners are rounded, and the report tells the
        lost length. match: the vertices depend on the border and the edge length only; meshes with
        a common piece of border get the same vertices there, bit for bit, in separate runs with the
        same edge length.
    feature_region : {'none', 'detected', 'selection', 'auto'}, default 'auto'
        The part of the surface with denser vertices, section 3.1.1 of the paper. none: no region.
        detected: the region of the feature detection, by the strength of the edges. selection: the
        selected vertices; if no vertex is selected, the corners of the selected faces. auto: with a
        feature disk scale, the selected vertices, or the detected region if no vertex is selected;
        otherwise none. region marks the selected vertices.
    feature_angle : float, default 40.0
        A feature line begins at edges whose faces differ by this angle in degrees, 5 to 175, and
        continues from its ends down to half of the angle.
    feature_support : float, default 2.0
        The strength of an edge is the angle between the mean normals of its two sides. The support
        is the radius of the averages, in mean edges of the input; above 0, at most 100. A larger
        support suppresses more noise.
    feature_strong : float, default 40.0
        A detected feature begins at a strength of this angle in degrees; above 0, at most 180.
    feature_weak : float, default 20.0
        A detected feature continues down to a strength of this angle in degrees; above 0, at most
        the strong angle.
    feature_length : float, default 3.0
        Detected features shorter than this number of supports are dropped as noise. 0 keeps all
        features.
    detail : {'off', 'coarse', 'normal', 'fine'}, optional
        The number of vertices in words: 99.9 % of the surface is expected to be nearer than 1 % of
        the diagonal (coarse), 0.3 % (normal) or 0.1 % (fine). The program tells the number. This is
        a forecast; the largest error proves a distance, and takes several times as long. off:
        another option sets the size.
    allow_nearest : bool, default False
        If the topology does not allow the wanted number of vertices or faces, the nearest possible
        number is taken. Otherwise the run is refused.
    min_edge : float, default 0.0
        The smallest local size, in mesh units. A text with a percent sign ("0.2%") is a share of
        the diagonal.
    max_edge : float, default 0.0
        The largest local size, in mesh units. Without a size of the result, this is the size of all
        places that nothing else makes smaller, and decides the number of vertices. A local size is
        a mean: about a tenth of the edges are more than a fifth longer, single edges twice as long
        or more. A text with a percent sign ("0.2%") is a share of the diagonal.
    growth : float, default 1.15
        The largest ratio of the lengths of neighbouring edges, 1.05 to 2. Faster growth costs
        angles.
    symmetry : {'off', 'x', 'y', 'z', 'auto'}, default 'off'
        The result is its own mirror image: each vertex has an image across a plane with the same
        coordinates bit for bit, except the mirrored coordinate, and edges run along the plane. x,
        y, z: the plane through the middle of the bounding box, perpendicular to this axis. auto:
        the best of these planes and of the planes of the principal axes. The input must be
        symmetric to .1 % of the diagonal; otherwise the run is refused. Half of the input is
        remeshed and mirrored.
    sew : bool, default True
        Joins borders that coincide edge by edge, within a millionth of the bounding box. CAD parts,
        and games whose smooth patches have separate vertices, have such borders. Feature lines run
        along sharp seams. Edges with more than two borders stay cut. off: the pieces stay separate.
    junctions : {'cut', 'keep'}, default 'cut'
        Treatment of edges with more than two faces, and of places at which sheets only touch. cut:
        the smoothest two of the faces stay joined, the other faces get a border. keep: the edges
        are sampled once for all sheets, which share their vertices, such as walls between grains,
        strata or rooms.
    drop_components_below : int, default 0
        Components with fewer faces are left out, for instance the dust of a scan. Each such
        component would take four vertices. 0 keeps all components.
    seed : int, default 1
        The same seed gives the same mesh, byte for byte, with any number of threads. 0 takes a new
        seed; the report names the seed.
    threads : int, default 0
        The number of threads, at most 1024. 0 takes one for each core. The result is the same.
    time_limit : float, default 0.0
        A run that takes longer ends without a result and changes nothing. 0 is no limit. The limit
        counts the time of the engine, without the conversion of arrays.
    check : bool, default False
        Searches self-intersections and measures the distances from the input: root mean square,
        p99.9 (99.9 % of the surface is nearer) and the largest, with proven bounds, in both
        directions. This takes longer than the run itself. A result is withheld if faces intersect
        at places without intersections of the input, or if a vertex is farther from the input than
        the move of the fit.
    relax : int, default 3
        With the preset paper: the number of moves of the vertices by the second-order umbrella
        operator, 0 to 1000. Edges are flipped after each move.
    flips : int, default 1000
        With the preset paper: the largest number of passes of edge flips, each time, 0 to 1000.
        With 1000 the passes end when all edges are Delaunay, as without this preset.

    Returns
    -------
    RemeshResult
        The mesh, the place of each vertex on the input, and a report.

    Raises
    ------
    ValueError
        For an unusable argument. The message names the argument.
    gpremesh.Error
        If the engine gives no result. `status` gives the reason; `smallest_count` is the number of
        vertices that the surface needs, if fewer were asked for.
    KeyboardInterrupt
        After Ctrl+C, within 200 ms.

    Notes
    -----
    Without a size, the result has 10 % of the vertices. The result depends on the input, the parameters
    and the seed, not on the number of threads, and equals the result of the command line. Other Python
    threads continue during the run and must not write to the arrays. The time is linear in the size of
    the input, some seconds per million faces.

    Examples
    --------
    >>> import numpy as np, gpremesh
    >>> grid = np.stack(np.meshgrid(np.arange(50.), np.arange(50.)), axis=-1).reshape(-1, 2)
    >>> vertices = np.column_stack([grid, np.sin(grid[:, 0] / 8)])
    >>> corner = np.arange(49 * 50).reshape(49, 50)[:, :49].reshape(-1, 1)
    >>> result = gpremesh.remesh(vertices, corner + [0, 1, 51, 50], vertex_count=300)
    >>> len(result.vertices)
    300
    """

def remesh_together(
    pieces: Iterable[Sequence[Any] | Mapping[str, Any]],
    *,
    periodic: ArrayLike | None = None,
    progress: Callable[[float, str], Any] | None = None,
    vertex_count: SupportsIndex | None = None,
    face_count: SupportsIndex | None = None,
    percent: SupportsFloat | None = None,
    edge_length: SupportsFloat | str | None = None,
    max_error: SupportsFloat | str | None = None,
    preset: Literal['default', 'fast', 'paper'] = 'default',
    adapt: SupportsFloat | Literal['auto'] = 'auto',
    lambda_: SupportsFloat = 0.0,
    features: Literal['auto', 'lines', 'off', 'selected'] = 'auto',
    feature_disk_scale: SupportsFloat = 0.0,
    boundary: Literal['resample', 'keep', 'free', 'smooth', 'match'] = 'resample',
    feature_region: Literal['none', 'detected', 'selection', 'auto'] = 'auto',
    feature_angle: SupportsFloat = 40.0,
    feature_support: SupportsFloat = 2.0,
    feature_strong: SupportsFloat = 40.0,
    feature_weak: SupportsFloat = 20.0,
    feature_length: SupportsFloat = 3.0,
    detail: Literal['off', 'coarse', 'normal', 'fine'] | None = None,
    allow_nearest: bool = False,
    min_edge: SupportsFloat | str = 0.0,
    max_edge: SupportsFloat | str = 0.0,
    growth: SupportsFloat = 1.15,
    symmetry: Literal['off', 'x', 'y', 'z', 'auto'] = 'off',
    sew: bool = True,
    junctions: Literal['cut', 'keep'] = 'cut',
    drop_components_below: SupportsIndex = 0,
    seed: SupportsIndex = 1,
    threads: SupportsIndex = 0,
    time_limit: SupportsFloat = 0.0,
    check: bool = False,
    relax: SupportsIndex = 3,
    flips: SupportsIndex = 1000,
) -> list[RemeshResult]:
    """Remeshes several meshes as a single surface and returns a result for each mesh, without cracks.

    If borders of the meshes coincide, vertex by vertex, the results have the same vertices there, bit
    for bit.

    Parameters
    ----------
    pieces : list of (vertices, faces), of objects with both as attributes, or of dict
        The meshes. A dict has the arguments of `remesh` for a mesh: vertices, faces, region,
        feature_edges, uv, image, regions, sizes.
    periodic, progress
        As for `remesh`, for all meshes together.
    vertex_count : int, optional
        The number of vertices of the result: exact for a remeshing. A sampling is about a tenth off
        on closed surfaces with some hundred vertices, and more with fewer vertices, with a varying
        density, and if borders, components or feature lines need samples of their own; a note tells
        the difference. If the topology needs more vertices, the run is refused, and the message
        names the smallest possible number. If only the selected faces are remeshed, the number
        counts the vertices of this part.
    face_count : int, optional
        The exact number of faces of the result. A closed surface has an even number, about twice
        the number of vertices. A surface with a border can have any number, unless all border
        vertices are kept. If the topology does not allow the number, the run is refused, and the
        message names the two nearest possible numbers.
    percent : float, optional
        The number of vertices in percent of the input's vertices, at most 10000. If the topology
        needs more vertices, the result has more.
    edge_length : float, optional
        The wanted mean edge length of the result in mesh units. If the topology needs more
        vertices, the result has more. A text with a percent sign ("0.2%") is a share of the
        diagonal.
    max_error : float, optional
        Searches the smallest number of vertices with a proven largest distance between result and
        input, in both directions, of at most this length in mesh units. The search makes at most
        five trials. The adaptivity is 1 unless another value is given. If a trial is too far from
        the input, vertices are added. An impossible error is refused. A text with a percent sign
        ("0.2%") is a share of the diagonal.
    preset : {'default', 'fast', 'paper'}, default 'default'
        The methods of a run. default: the most regular triangles, close to the input. The fit moves
        vertices a little off the surface to reduce the distance; vertices of borders and feature
        lines leave their curves by at most 8 % of an edge. fast: less than half the time, without
        the steps for regularity; one step raises each vertex over its neighbours in place of the
        fit. paper: each stage as in the paper; every vertex stays on the surface, and the number of
        vertices is not exact: about a tenth off on closed surfaces, more with borders and many
        components; a note tells the difference. A sampling is the same with default and fast.
    adapt : float or 'auto', default 'auto'
        Adaptivity of the local sizes to the error. 0: all triangles have one size. 0.1: a tenth of
        the vertices goes to ridges, rims and tips that are finer than the triangles. 1: all sizes
        follow the error. If feature lines take a third of the vertices, the sizes stay even. auto:
        0.1; 1 with a largest error; 0 with a lambda above 0, with the preset fast, and for a
        sampling alone. The preset paper has no adaptivity.
    lambda_ : float, default 0.0
        Additional density at curved places, eq. (4) of the paper. Distances are stretched by 1 +
        lambda |H| r, at most 4; H is the mean curvature and r the radius of the disks. 0: even
        density. Usual values are 1 to 5. The preset paper takes H with its sign, in 1/mesh unit,
        without a limit.
    features : {'auto', 'lines', 'off', 'selected'}, default 'auto'
        Feature lines are crease edges of the input that become edges of the result; corners and
        cone apexes become vertices. auto: clear crease edges, but not the noise of a scan; none
        with the preset paper, which never follows lines. lines: all edges above the angle of
        feature lines. off: none. selected: only the selected edges. feature_edges lists the
        selected edges.
    feature_disk_scale : float, default 0.0
        Makes the triangles of the feature region smaller: the radius of the disks in the region,
        divided by the radius elsewhere, 0.05 to 1. The selected vertices are the feature region; if
        no vertex is selected, the region is detected. 0: no feature region, unless the option
        feature region names one; then its disks have half the radius. With the preset paper 0 keeps
        each vertex of a named region.
    boundary : {'resample', 'keep', 'free', 'smooth', 'match'}, default 'resample'
        Treatment of the borders of the surface. resample: the curves and corners of the border
        stay, with new vertices. keep: each border vertex stays, and no vertex is added; the
        triangles grow from the spacing there to the wanted size. free: evenly spaced vertices,
        which cut corners off. smooth: for the ragged borders of scans; the border becomes a smooth
        curve within half an edge of the old border, corners are rounded, and the report tells the
        lost length. match: the vertices depend on the border and the edge length only; meshes with
        a common piece of border get the same vertices there, bit for bit, in separate runs with the
        same edge length.
    feature_region : {'none', 'detected', 'selection', 'auto'}, default 'auto'
        The part of the surface with denser vertices, section 3.1.1 of the paper. none: no region.
        detected: the region of the feature detection, by the strength of the edges. selection: the
        selected vertices; if no vertex is selected, the corners of the selected faces. auto: with a
        feature disk scale, the selected vertices, or the detected region if no vertex is selected;
        otherwise none. region marks the selected vertices.
    feature_angle : float, default 40.0
        A feature line begins at edges whose faces differ by this angle in degrees, 5 to 175, and
        continues from its ends down to half of the angle.
    feature_support : float, default 2.0
        The strength of an edge is the angle between the mean normals of its two sides. The support
        is the radius of the averages, in mean edges of the input; above 0, at most 100. A larger
        support suppresses more noise.
    feature_strong : float, default 40.0
        A detected feature begins at a strength of this angle in degrees; above 0, at most 180.
    feature_weak : float, default 20.0
        A detected feature continues down to a strength of this angle in degrees; above 0, at most
        the strong angle.
    feature_length : float, default 3.0
        Detected features shorter than this number of supports are dropped as noise. 0 keeps all
        features.
    detail : {'off', 'coarse', 'normal', 'fine'}, optional
        The number of vertices in words: 99.9 % of the surface is expected to be nearer than 1 % of
        the diagonal (coarse), 0.3 % (normal) or 0.1 % (fine). The program tells the number. This is
        a forecast; the largest error proves a distance, and takes several times as long. off:
        another option sets the size.
    allow_nearest : bool, default False
        If the topology does not allow the wanted number of vertices or faces, the nearest possible
        number is taken. Otherwise the run is refused.
    min_edge : float, default 0.0
        The smallest local size, in mesh units. A text with a percent sign ("0.2%") is a share of
        the diagonal.
    max_edge : float, default 0.0
        The largest local size, in mesh units. Without a size of the result, this is the size of all
        places that nothing else makes smaller, and decides the number of vertices. A local size is
        a mean: about a tenth of the edges are more than a fifth longer, single edges twice as long
        or more. A text with a percent sign ("0.2%") is a share of the diagonal.
    growth : float, default 1.15
        The largest ratio of the lengths of neighbouring edges, 1.05 to 2. Faster growth costs
        angles.
    symmetry : {'off', 'x', 'y', 'z', 'auto'}, default 'off'
        The result is its own mirror image: each vertex has an image across a plane with the same
        coordinates bit for bit, except the mirrored coordinate, and edges run along the plane. x,
        y, z: the plane through the middle of the bounding box, perpendicular to this axis. auto:
        the best of these planes and of the planes of the principal axes. The input must be
        symmetric to .1 % of the diagonal; otherwise the run is refused. Half of the input is
        remeshed and mirrored.
    sew : bool, default True
        Joins borders that coincide edge by edge, within a millionth of the bounding box. CAD parts,
        and games whose smooth patches have separate vertices, have such borders. Feature lines run
        along sharp seams. Edges with more than two borders stay cut. off: the pieces stay separate.
    junctions : {'cut', 'keep'}, default 'cut'
        Treatment of edges with more than two faces, and of places at which sheets only touch. cut:
        the smoothest two of the faces stay joined, the other faces get a border. keep: the edges
        are sampled once for all sheets, which share their vertices, such as walls between grains,
        strata or rooms.
    drop_components_below : int, default 0
        Components with fewer faces are left out, for instance the dust of a scan. Each such
        component would take four vertices. 0 keeps all components.
    seed : int, default 1
        The same seed gives the same mesh, byte for byte, with any number of threads. 0 takes a new
        seed; the report names the seed.
    threads : int, default 0
        The number of threads, at most 1024. 0 takes one for each core. The result is the same.
    time_limit : float, default 0.0
        A run that takes longer ends without a result and changes nothing. 0 is no limit. The limit
        counts the time of the engine, without the conversion of arrays.
    check : bool, default False
        Searches self-intersections and measures the distances from the input: root mean square,
        p99.9 (99.9 % of the surface is nearer) and the largest, with proven bounds, in both
        directions. This takes longer than the run itself. A result is withheld if faces intersect
        at places without intersections of the input, or if a vertex is farther from the input than
        the move of the fit.
    relax : int, default 3
        With the preset paper: the number of moves of the vertices by the second-order umbrella
        operator, 0 to 1000. Edges are flipped after each move.
    flips : int, default 1000
        With the preset paper: the largest number of passes of edge flips, each time, 0 to 1000.
        With 1000 the passes end when all edges are Delaunay, as without this preset.

    Returns
    -------
    list of RemeshResult
        A result for each mesh, all with the report of the whole surface. A number of vertices or faces is
        the number of the whole surface; vertices on common borders count once.

    Raises
    ------
    ValueError, gpremesh.Error, KeyboardInterrupt
        As `remesh`.

    Examples
    --------
    >>> import numpy as np, gpremesh
    >>> grid = np.stack(np.meshgrid(np.arange(30.), np.arange(30.)), axis=-1).reshape(-1, 2)
    >>> west = np.column_stack([grid, np.sin(grid[:, 0] / 8)])
    >>> east = np.column_stack([58 - grid[:, 0], grid[:, 1], west[:, 2]])
    >>> corner = np.arange(29 * 30).reshape(29, 30)[:, :29].reshape(-1, 1)
    >>> a, b = gpremesh.remesh_together(
    ...     [(west, corner + [0, 1, 31, 30]), (east, corner + [0, 30, 31, 1])], vertex_count=400)
    >>> seam = {tuple(p) for p in a.vertices} & {tuple(p) for p in b.vertices}
    >>> len(a.vertices) + len(b.vertices) - len(seam)
    400
    """

def sample(
    vertices: ArrayLike,
    faces: ArrayLike | Sequence[ArrayLike],
    *,
    region: ArrayLike | None = None,
    feature_edges: ArrayLike | None = None,
    progress: Callable[[float, str], Any] | None = None,
    count: SupportsIndex | None = None,
    percent: SupportsFloat | None = None,
    edge_length: SupportsFloat | str | None = None,
    preset: Literal['default', 'fast', 'paper'] = 'default',
    adapt: SupportsFloat | Literal['auto'] = 'auto',
    lambda_: SupportsFloat = 0.0,
    features: Literal['auto', 'lines', 'off', 'selected'] = 'auto',
    feature_disk_scale: SupportsFloat = 0.0,
    boundary: Literal['resample', 'keep', 'free', 'smooth', 'match'] = 'resample',
    feature_region: Literal['none', 'detected', 'selection', 'auto'] = 'auto',
    feature_angle: SupportsFloat = 40.0,
    feature_support: SupportsFloat = 2.0,
    feature_strong: SupportsFloat = 40.0,
    feature_weak: SupportsFloat = 20.0,
    feature_length: SupportsFloat = 3.0,
    sew: bool = True,
    drop_components_below: SupportsIndex = 0,
    seed: SupportsIndex = 1,
    threads: SupportsIndex = 0,
    time_limit: SupportsFloat = 0.0,
) -> Samples:
    """Spreads points evenly over a surface: a geodesic Poisson-disk sampling.

    The distance of two points is at least about a disk radius, and each vertex of the input has a point
    within a disk radius. The number of points is right to about a tenth.

    Parameters
    ----------
    vertices, faces, region, feature_edges, progress
        As for `remesh`.
    count : int, optional
        The number of vertices of the result: exact for a remeshing. A sampling is about a tenth off
        on closed surfaces with some hundred vertices, and more with fewer vertices, with a varying
        density, and if borders, components or feature lines need samples of their own; a note tells
        the difference. If the topology needs more vertices, the run is refused, and the message
        names the smallest possible number. If only the selected faces are remeshed, the number
        counts the vertices of this part.
    percent : float, optional
        The number of vertices in percent of the input's vertices, at most 10000. If the topology
        needs more vertices, the result has more.
    edge_length : float, optional
        The wanted mean edge length of the result in mesh units. If the topology needs more
        vertices, the result has more. A text with a percent sign ("0.2%") is a share of the
        diagonal.
    preset : {'default', 'fast', 'paper'}, default 'default'
        The methods of a run. default: the most regular triangles, close to the input. The fit moves
        vertices a little off the surface to reduce the distance; vertices of borders and feature
        lines leave their curves by at most 8 % of an edge. fast: less than half the time, without
        the steps for regularity; one step raises each vertex over its neighbours in place of the
        fit. paper: each stage as in the paper; every vertex stays on the surface, and the number of
        vertices is not exact: about a tenth off on closed surfaces, more with borders and many
        components; a note tells the difference. A sampling is the same with default and fast.
    adapt : float or 'auto', default 'auto'
        Adaptivity of the local sizes to the error. 0: all triangles have one size. 0.1: a tenth of
        the vertices goes to ridges, rims and tips that are finer than the triangles. 1: all sizes
        follow the error. If feature lines take a third of the vertices, the sizes stay even. auto:
        0.1; 1 with a largest error; 0 with a lambda above 0, with the preset fast, and for a
        sampling alone. The preset paper has no adaptivity.
    lambda_ : float, default 0.0
        Additional density at curved places, eq. (4) of the paper. Distances are stretched by 1 +
        lambda |H| r, at most 4; H is the mean curvature and r the radius of the disks. 0: even
        density. Usual values are 1 to 5. The preset paper takes H with its sign, in 1/mesh unit,
        without a limit.
    features : {'auto', 'lines', 'off', 'selected'}, default 'auto'
        Feature lines are crease edges of the input that become edges of the result; corners and
        cone apexes become vertices. auto: clear crease edges, but not the noise of a scan; none
        with the preset paper, which never follows lines. lines: all edges above the angle of
        feature lines. off: none. selected: only the selected edges. feature_edges lists the
        selected edges.
    feature_disk_scale : float, default 0.0
        Makes the triangles of the feature region smaller: the radius of the disks in the region,
        divided by the radius elsewhere, 0.05 to 1. The selected vertices are the feature region; if
        no vertex is selected, the region is detected. 0: no feature region, unless the option
        feature region names one; then its disks have half the radius. With the preset paper 0 keeps
        each vertex of a named region.
    boundary : {'resample', 'keep', 'free', 'smooth', 'match'}, default 'resample'
        Treatment of the borders of the surface. resample: the curves and corners of the border
        stay, with new vertices. keep: each border vertex stays, and no vertex is added; the
        triangles grow from the spacing there to the wanted size. free: evenly spaced vertices,
        which cut corners off. smooth: for the ragged borders of scans; the border becomes a smooth
        curve within half an edge of the old border, corners are rounded, and the report tells the
        lost length. match: the vertices depend on the border and the edge length only; meshes with
        a common piece of border get the same vertices there, bit for bit, in separate runs with the
        same edge length.
    feature_region : {'none', 'detected', 'selection', 'auto'}, default 'auto'
        The part of the surface with denser vertices, section 3.1.1 of the paper. none: no region.
        detected: the region of the feature detection, by the strength of the edges. selection: the
        selected vertices; if no vertex is selected, the corners of the selected faces. auto: with a
        feature disk scale, the selected vertices, or the detected region if no vertex is selected;
        otherwise none. region marks the selected vertices.
    feature_angle : float, default 40.0
        A feature line begins at edges whose faces differ by this angle in degrees, 5 to 175, and
        continues from its ends down to half of the angle.
    feature_support : float, default 2.0
        The strength of an edge is the angle between the mean normals of its two sides. The support
        is the radius of the averages, in mean edges of the input; above 0, at most 100. A larger
        support suppresses more noise.
    feature_strong : float, default 40.0
        A detected feature begins at a strength of this angle in degrees; above 0, at most 180.
    feature_weak : float, default 20.0
        A detected feature continues down to a strength of this angle in degrees; above 0, at most
        the strong angle.
    feature_length : float, default 3.0
        Detected features shorter than this number of supports are dropped as noise. 0 keeps all
        features.
    sew : bool, default True
        Joins borders that coincide edge by edge, within a millionth of the bounding box. CAD parts,
        and games whose smooth patches have separate vertices, have such borders. Feature lines run
        along sharp seams. Edges with more than two borders stay cut. off: the pieces stay separate.
    drop_components_below : int, default 0
        Components with fewer faces are left out, for instance the dust of a scan. Each such
        component would take four vertices. 0 keeps all components.
    seed : int, default 1
        The same seed gives the same mesh, byte for byte, with any number of threads. 0 takes a new
        seed; the report names the seed.
    threads : int, default 0
        The number of threads, at most 1024. 0 takes one for each core. The result is the same.
    time_limit : float, default 0.0
        A run that takes longer ends without a result and changes nothing. 0 is no limit. The limit
        counts the time of the engine, without the conversion of arrays.

    Returns
    -------
    Samples
        Points, and the place of each point on the input.

    Raises
    ------
    ValueError, gpremesh.Error, KeyboardInterrupt
        As `remesh`.

    Examples
    --------
    >>> import numpy as np, gpremesh
    >>> vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.]])
    >>> faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    >>> samples = gpremesh.sample(vertices, faces, count=1000)
    >>> 900 < len(samples.points) < 1100
    True
    """

def features(
    vertices: ArrayLike,
    faces: ArrayLike | Sequence[ArrayLike],
    *,
    progress: Callable[[float, str], Any] | None = None,
    feature_support: SupportsFloat = 2.0,
    feature_strong: SupportsFloat = 40.0,
    feature_weak: SupportsFloat = 20.0,
    feature_length: SupportsFloat = 3.0,
    sew: bool = True,
    threads: SupportsIndex = 0,
    time_limit: SupportsFloat = 0.0,
) -> Features:
    """Finds creases and cone apexes of a surface.

    Parameters
    ----------
    vertices, faces, progress
        As for `remesh`.
    feature_support : float, default 2.0
        The strength of an edge is the angle between the mean normals of its two sides. The support
        is the radius of the averages, in mean edges of the input; above 0, at most 100. A larger
        support suppresses more noise.
    feature_strong : float, default 40.0
        A detected feature begins at a strength of this angle in degrees; above 0, at most 180.
    feature_weak : float, default 20.0
        A detected feature continues down to a strength of this angle in degrees; above 0, at most
        the strong angle.
    feature_length : float, default 3.0
        Detected features shorter than this number of supports are dropped as noise. 0 keeps all
        features.
    sew : bool, default True
        Joins borders that coincide edge by edge, within a millionth of the bounding box. CAD parts,
        and games whose smooth patches have separate vertices, have such borders. Feature lines run
        along sharp seams. Edges with more than two borders stay cut. off: the pieces stay separate.
    threads : int, default 0
        The number of threads, at most 1024. 0 takes one for each core. The result is the same.
    time_limit : float, default 0.0
        A run that takes longer ends without a result and changes nothing. 0 is no limit. The limit
        counts the time of the engine, without the conversion of arrays.

    Returns
    -------
    Features
        The strength of each vertex, and the crease edges.

    Raises
    ------
    ValueError, gpremesh.Error, KeyboardInterrupt
        As `remesh`.
    """

def distance(
    a: Any,
    b: Any,
    *,
    samples: SupportsIndex = 0,
    threads: SupportsIndex = 0,
    progress: Callable[[float, str], Any] | None = None,
) -> Distance:
    """Measures the distances of two surfaces from each other, like `gpremesh compare`.

    Parameters
    ----------
    a, b : pair (vertices, faces), or an object with both as attributes
        The two surfaces, in the same unit. Usually `a` is the input and `b` the result. A RemeshResult and
        a mesh of trimesh have the two attributes.
    samples : int, default 0
        Number of points on each surface, at most 100000000. 0 takes ten points for each face of `b`, at
        least 200000 and at most 2000000.
    threads : int, default 0
        Number of threads; 0: a thread for each core. The result does not depend on the threads.
    progress : callable(fraction, stage), optional
        As for `remesh`. The fraction stays 0.

    Returns
    -------
    Distance
        In the unit of the coordinates. All figures are 0 if a surface has no face with an area.

    Raises
    ------
    ValueError, gpremesh.Error, KeyboardInterrupt
        As `remesh`. During the construction of a search tree, cancelling waits for the end of the tree.
    """

def read(
    path: str | os.PathLike[str],
) -> FileMesh:
    """Reads a mesh with all values of its file, by the reader of the command line.

    Parameters
    ----------
    path : str or path-like
        A file in a format of the command line, by extension, such as .ply or .glb.

    Returns
    -------
    FileMesh
        Polygons are cut into triangles. A scene of binary glTF becomes a single mesh.

    Raises
    ------
    ValueError
        For another extension.
    OSError
        If the file does not exist or is not readable.
    gpremesh.Error
        If the file is no mesh, with the status "unusable input". Compressed binary glTF and morph
        targets are refused.

    Examples
    --------
    >>> import gpremesh
    >>> mesh = gpremesh.read("statue.glb")                # doctest: +SKIP
    >>> gpremesh.write("small.glb", mesh.remesh(5000))    # doctest: +SKIP
    """

def write(
    path: str | os.PathLike[str],
    mesh: Any,
) -> None:
    """Writes a mesh, by the writer of the command line.

    Parameters
    ----------
    path : str or path-like
        A file to write or replace, in a format of the command line, by extension, such as .ply or .glb.
        After a failure an older file is unchanged.
    mesh : FileMesh, RemeshResult, a pair (vertices, faces), or an object with both as attributes
        A FileMesh is written with all values that the format can hold, a RemeshResult with its texture
        coordinates, numbers of images, and regions (as values "region" of faces). A warning names the
        values that the format cannot hold.

    Raises
    ------
    ValueError
        For another extension, and for arrays of different lengths.
    OSError
        If the file cannot be written.
    """

def levels(
    vertices: ArrayLike,
    faces: ArrayLike | Sequence[ArrayLike],
    *,
    percent: ArrayLike | None = None,
    vertex_count: ArrayLike | None = None,
    face_count: ArrayLike | None = None,
    progress: Callable[[float, str], Any] | None = None,
    **parameters: Any,
) -> list[RemeshResult]:
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
