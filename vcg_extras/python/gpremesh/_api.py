# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
import json

import numpy as np

from . import _arrays, _core
from ._errors import check
from ._results import Distance, Features, OneWayDistance, RemeshResult, Samples
from ._table import with_parameters


def _check_progress(progress):
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be a function or None, not {type(progress).__name__}")


def _given(parameters):
    """None stands for what was not given."""
    return {name: value for name, value in parameters.items() if value is not None}


def checked(tool, parameters, progress):
    """The parameters of a tool that were given; others are a TypeError."""
    _check_progress(progress)
    names = {entry["name"] for entry in _core.parameters(tool)}
    for name in parameters:
        if name not in names:
            raise TypeError(f"{tool}() has no parameter {name!r}")
    return _given(parameters)


def _imply(parameters, name, choice, argument, values):
    """An array that is given implies the choice that reads it; the choice needs the array."""
    if values is not None:
        parameters.setdefault(name, choice)
    elif isinstance(parameters.get(name), str) and parameters[name] == choice:
        raise ValueError(f"{name}={choice!r} needs {argument}.")


def extras(mesh, parameters, region, feature_edges):
    vertex_num = len(mesh.vertices)
    made = _core.Extras()
    made.region = _arrays.mask("region", region, vertex_num, "vertices")
    made.feature_edges = _arrays.edges("feature_edges", feature_edges, vertex_num)
    _imply(parameters, "feature_region", "selection", "region", region)
    _imply(parameters, "features", "selected", "feature_edges", feature_edges)
    return made


def _all_extras(mesh, parameters, *, selected=None, region=None, feature_edges=None, uv=None,
                image=None, regions=None, sizes=None, periodic=None):
    """What the arguments of `remesh` beside the mesh and the parameters say."""
    if image is not None and uv is None:
        raise ValueError("image needs uv.")
    given = extras(mesh, parameters, region, feature_edges)
    given.selected = mesh.per_triangle(_arrays.mask("selected", selected, mesh.face_num, "faces"))
    given.sizes = _arrays.lengths("sizes", sizes, len(mesh.vertices))
    given.uv = mesh.corner_uv("uv", uv)
    given.images = mesh.images("image", image)
    given.regions = mesh.labels("regions", regions)
    given.period = _arrays.period("periodic", periodic)
    return given


def remesh_mesh(mesh, prepared, progress, parameters, **beside):
    """The run of `remesh` on a mesh that was taken over, and maybe prepared."""
    _check_progress(progress)
    parameters = _given(parameters)
    given = _all_extras(mesh, parameters, **beside)
    given.prepared = prepared
    outcome = _core.remesh(mesh.vertices, mesh.faces, given, parameters, progress)
    check(outcome)
    return RemeshResult(mesh, outcome, json.loads(outcome["report"]))


@with_parameters("remesh")
def remesh(vertices, faces, *, selected=None, region=None, feature_edges=None, uv=None,
           image=None, regions=None, sizes=None, periodic=None, progress=None, **parameters):
    """Remeshes a surface to nearly equilateral triangles with exactly as many vertices as asked for.

    Parameters
    ----------
    vertices : array_like (n, 3)
        Coordinates in any unit. Arrays of float32 and float64 in C order are not copied; others are
        converted to float64.
    faces : array_like (f, 3), (f, k), or a list of polygons
        Triangles, polygons of k corners, or polygons of several sizes, as rows of `vertices`. Arrays of
        int32 in C order are not copied; int64 and others are converted. Polygons are cut into triangles.
    selected : array_like (f,) of bool, optional
        Only the faces with True are remeshed. All others stay bit for bit as they are and come first.
    region : array_like (n,) of bool, optional
        The feature region: the vertices around which triangles are smaller (`feature_disk_scale`).
    feature_edges : array_like (e, 2), optional
        Edges of the faces, as pairs of vertices, that edges of the result shall follow. With `features`
        not given they are the only ones; with features='auto' those that are found come beside them.
    uv : array_like (n, 2) or (f, 3, 2), optional
        Texture coordinates of the vertices, or of the corners of the faces. Edges of the result follow
        the seams.
    image : array_like (f,) of int, optional
        With `uv`: the number of the image of each face.
    regions : array_like (f,) of int, optional
        Labels of the faces, as of materials or patches. Edges of the result follow the borders between
        labels, and `regions` of the result has a label for each of its faces.
    sizes : array_like (n,), optional
        The edge length wanted at each vertex, in the unit of the coordinates. With `sizes` alone the
        number of vertices follows; with a number or another size they are scaled to it.
    periodic : (x, y, z), optional
        The lengths of a periodic cell, 0 along an axis without a period. Vertices at opposite borders
        match after adding the length; `boundary` is 'match' then. Refused where the borders are no
        translates of one another.
    progress : callable(fraction, stage), optional
        Called about every 50 ms with the share of the work done, from 0 to 1, and a short text. The run
        is cancelled where it returns False, and where it raises.
    PARAMETERS

    Returns
    -------
    RemeshResult
        The mesh, where each of its vertices lies on the input, and a report.

    Raises
    ------
    ValueError
        For an argument that cannot be meant. The message names it.
    gpremesh.Error
        Where the engine gives no result. `status` says why, and `smallest_count` how many vertices the
        surface needs where fewer were asked for.
    KeyboardInterrupt
        After Ctrl+C, within 200 ms.

    Notes
    -----
    10 % of the vertices are made where no size is given. The result depends on the input, the parameters
    and the seed, not on the number of threads, and is that of the command line. Other Python threads go on
    meanwhile; they must not write to the arrays. The time is linear in the size of the input, some
    seconds per million faces.

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
    return remesh_mesh(_arrays.Mesh(vertices, faces), None, progress, parameters, selected=selected,
                       region=region, feature_edges=feature_edges, uv=uv, image=image,
                       regions=regions, sizes=sizes, periodic=periodic)


@with_parameters("remesh")
def remesh_together(pieces, *, progress=None, **parameters):
    """Remeshes several meshes as one surface and returns them one by one, without a crack between them.

    Where borders of the meshes coincide, vertex by vertex, the results have the same vertices there, bit
    for bit.

    Parameters
    ----------
    pieces : list of (vertices, faces), or of dict
        The meshes. A dict has the arguments of `remesh` that belong to a mesh: vertices, faces, region,
        feature_edges, uv, image, regions, sizes.
    progress
        As that of `remesh`.
    PARAMETERS

    Returns
    -------
    list of RemeshResult
        One for each of the meshes. Each has the report of all of them together. A number of vertices or
        faces is that of all of them together, where vertices on common borders are counted once.

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
    _check_progress(progress)
    parameters = _given(parameters)
    pieces = [dict(zip(("vertices", "faces"), p, strict=True)) if not isinstance(p, dict) else dict(p)
              for p in pieces]
    if not pieces:
        raise ValueError("pieces must have one mesh at least.")
    unknown = {name for piece in pieces for name in piece} - {
        "vertices", "faces", "region", "feature_edges", "uv", "image", "regions", "sizes"}
    if unknown:
        raise ValueError(f"pieces have no {' and no '.join(sorted(unknown))}.")
    if parameters.get("sew") is False:
        raise ValueError("sew=False is not for several meshes, which are joined where borders coincide.")
    if len({piece.get("sizes") is None for piece in pieces}) > 1:
        raise ValueError("sizes must be given for all meshes, or for none.")
    if any(piece.get(name) is None for piece in pieces for name in ("vertices", "faces")):
        raise ValueError("each of the pieces needs vertices and faces.")
    meshes = [_arrays.Mesh(piece.pop("vertices"), piece.pop("faces")) for piece in pieces]
    choices = [dict(parameters) for _ in pieces]  # each mesh implies its own; those of any are for all
    given = [_all_extras(mesh, own, **piece) for mesh, own, piece in zip(meshes, choices, pieces)]
    parameters = {name: value for own in choices for name, value in own.items()}
    outcomes = _core.remesh_pieces([mesh.vertices for mesh in meshes], [mesh.faces for mesh in meshes],
                                   given, parameters, progress)
    for outcome in outcomes:
        check(outcome)
    return [RemeshResult(mesh, outcome, json.loads(outcome["report"]))
            for mesh, outcome in zip(meshes, outcomes)]


@with_parameters("sample")
def sample(vertices, faces, *, region=None, feature_edges=None, progress=None,
           **parameters):
    """Spreads points evenly over a surface: a geodesic Poisson-disk sampling.

    Points are at least about a disk's radius apart, and each vertex of the input is within a radius of
    one. The number of points is hit to about a tenth.

    Parameters
    ----------
    vertices, faces, region, feature_edges, progress
        As those of `remesh`.
    PARAMETERS

    Returns
    -------
    Samples
        Points, and where each lies on the input.

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
    _check_progress(progress)
    parameters = _given(parameters)
    mesh = _arrays.Mesh(vertices, faces)
    given = extras(mesh, parameters, region, feature_edges)
    outcome = _core.sample(mesh.vertices, mesh.faces, given, parameters, progress)
    check(outcome)
    return Samples(
        points=outcome["points"].astype(mesh.vertices.dtype, copy=False),
        face_index=mesh.callers_face(outcome["face_index"]),
        barycentric=outcome["barycentric"],
        radius=outcome["radius"],
        disk_radius=outcome["disk_radius"],
        seed=outcome["seed"],
        notes=outcome["notes"],
    )


@with_parameters("features")
def features(vertices, faces, *, progress=None, **parameters):
    """Finds creases and cone apexes of a surface.

    Parameters
    ----------
    vertices, faces, progress
        As those of `remesh`.
    PARAMETERS

    Returns
    -------
    Features
        The strength of each vertex, and the feature edges.

    Raises
    ------
    ValueError, gpremesh.Error, KeyboardInterrupt
        As `remesh`.
    """
    _check_progress(progress)
    mesh = _arrays.Mesh(vertices, faces)
    outcome = _core.features(mesh.vertices, mesh.faces, _given(parameters), progress)
    check(outcome)
    faces_marked = np.zeros(mesh.face_num, bool)
    triangles = np.flatnonzero(outcome["face"])
    faces_marked[triangles if mesh.face_of is None else mesh.face_of[triangles]] = True
    return Features(
        strength=outcome["strength"],
        vertex=outcome["vertex"],
        face=faces_marked,
        edges=outcome["edges"].astype(mesh.index_dtype, copy=False),
        edge_strength=outcome["edge_strength"],
        report=json.loads(outcome["report"]),
    )


def vertices_and_faces(name, mesh):
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return mesh
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    raise ValueError(f"{name} must be a pair (vertices, faces), or have these two as attributes.")


def _mesh_of(name, mesh):
    return _arrays.Mesh(*vertices_and_faces(name, mesh), (f"{name}.vertices", f"{name}.faces"))


def _whole_number(name, value, least, most):
    if isinstance(value, (bool, np.bool_)) or not hasattr(value, "__index__") or not least <= value <= most:
        raise ValueError(f"{name} takes a whole number from {least} to {most}, not {value!r}.")
    return int(value)


def distance(a, b, *, samples=0, threads=0, progress=None):
    """Measures the distances of two surfaces from each other, as `gpremesh compare` does.

    Parameters
    ----------
    a, b : pair (vertices, faces), or an object that has them as attributes
        The two surfaces, in one unit. Usually `a` is the input and `b` the result. A RemeshResult and a
        mesh of trimesh have the two attributes.
    samples : int, default 0
        How many points are spread over each surface, at most 100000000. 0 takes ten for each face of
        `b`, at least 200000 and at most 2000000.
    threads : int, default 0
        How many threads work. 0 takes one for each core. The result is the same.
    progress : callable(fraction, stage), optional
        As that of `remesh`. The fraction stays 0.

    Returns
    -------
    Distance
        In the unit of the coordinates. All figures are 0 where a surface has no face with an area.

    Raises
    ------
    ValueError, gpremesh.Error, KeyboardInterrupt
        As `remesh`. While a search tree is built, cancelling waits for its end.
    """
    _check_progress(progress)
    samples = _whole_number("samples", samples, 0, 100_000_000)
    threads = _whole_number("threads", threads, 0, 1024)
    first, second = _mesh_of("a", a), _mesh_of("b", b)
    outcome = _core.distance(first.vertices, first.faces, second.vertices, second.faces, samples, threads,
                             progress)
    check(outcome)
    return Distance(OneWayDistance(**outcome["a_to_b"]), OneWayDistance(**outcome["b_to_a"]))
