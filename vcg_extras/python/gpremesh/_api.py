# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
import json

import numpy as np

from . import _arrays, _core
from ._errors import check
from ._results import Distance, Features, OneWayDistance, RemeshResult, Samples
from ._table import with_parameters


def check_progress(progress):
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be a function or None, not {type(progress).__name__}")


def without_none(parameters):
    """The parameters without None, which means not given."""
    return {name: value for name, value in parameters.items() if value is not None}


def check_mesh_of_host(mesh, kinds, parameters):
    """Refuses a mesh of another type, and arguments that come from the mesh."""
    if not isinstance(mesh, kinds):
        package = kinds[0].__module__.split(".")[0]
        raise TypeError(f"mesh must be a {kinds[0].__name__} of {package}, not a {type(mesh).__name__}.")
    for name in {"uv", "image"} & parameters.keys():
        raise TypeError(f"remesh() takes no {name} here, since texture coordinates come from the mesh.")


def as_list(name, values):
    try:
        return list(values)
    except TypeError:
        raise ValueError(f"{name} must be a list, not {type(values).__name__}.") from None


def _imply(parameters, name, choice, argument, values):
    """A given array implies the choice that reads the array; the choice needs the array."""
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


def all_extras(mesh, parameters, *, selected=None, region=None, feature_edges=None, uv=None,
                image=None, regions=None, sizes=None, periodic=None):
    """The arguments of `remesh` beside the mesh and the parameters, as arrays for the engine."""
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
    """Runs `remesh` on a checked mesh, with a prepared surface or None."""
    check_progress(progress)
    parameters = without_none(parameters)
    given = all_extras(mesh, parameters, **beside)
    given.prepared = prepared
    outcome = _core.remesh(mesh.vertices, mesh.faces, given, parameters, progress)
    check(outcome)
    return RemeshResult(mesh, outcome, json.loads(outcome["report"]))


@with_parameters("remesh")
def remesh(vertices, faces, *, selected=None, region=None, feature_edges=None, uv=None,
           image=None, regions=None, sizes=None, periodic=None, progress=None, **parameters):
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
    PARAMETERS

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
    return remesh_mesh(_arrays.Mesh(vertices, faces), None, progress, parameters, selected=selected,
                       region=region, feature_edges=feature_edges, uv=uv, image=image,
                       regions=regions, sizes=sizes, periodic=periodic)


def _piece(name, piece):
    return dict(piece) if isinstance(piece, dict) else dict(zip(("vertices", "faces"), vertices_and_faces(name, piece)))


@with_parameters("remesh")
def remesh_together(pieces, *, periodic=None, progress=None, **parameters):
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
    PARAMETERS

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
    check_progress(progress)
    parameters = without_none(parameters)
    pieces = [_piece(f"pieces[{k}]", piece) for k, piece in enumerate(as_list("pieces", pieces))]
    if not pieces:
        raise ValueError("pieces must have at least one mesh.")
    unknown = {name for piece in pieces for name in piece} - {
        "vertices", "faces", "region", "feature_edges", "uv", "image", "regions", "sizes"}
    if unknown:
        raise ValueError(f"pieces have no {' and no '.join(sorted(unknown))}.")
    if parameters.get("sew") is False:
        raise ValueError("sew=False is not possible for several meshes, which are joined along coinciding borders.")
    if len({piece.get("sizes") is None for piece in pieces}) > 1:
        raise ValueError("sizes must be given for all meshes, or for none.")
    if any(piece.get(name) is None for piece in pieces for name in ("vertices", "faces")):
        raise ValueError("each of the pieces needs vertices and faces.")
    meshes = [_arrays.Mesh(piece.pop("vertices"), piece.pop("faces"), (f"pieces[{k}].vertices", f"pieces[{k}].faces"))
              for k, piece in enumerate(pieces)]
    choices = [dict(parameters) for _ in pieces]  # a choice implied by any mesh holds for all
    given = [all_extras(mesh, own, **piece) for mesh, own, piece in zip(meshes, choices, pieces)]
    parameters = {name: value for own in choices for name, value in own.items()}
    given[0].period = _arrays.period("periodic", periodic)  # the engine takes it from the first mesh
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

    The distance of two points is at least about a disk radius, and each vertex of the input has a point
    within a disk radius. The number of points is right to about a tenth.

    Parameters
    ----------
    vertices, faces, region, feature_edges, progress
        As for `remesh`.
    PARAMETERS

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
    check_progress(progress)
    parameters = without_none(parameters)
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
        As for `remesh`.
    PARAMETERS

    Returns
    -------
    Features
        The strength of each vertex, and the crease edges.

    Raises
    ------
    ValueError, gpremesh.Error, KeyboardInterrupt
        As `remesh`.
    """
    check_progress(progress)
    mesh = _arrays.Mesh(vertices, faces)
    outcome = _core.features(mesh.vertices, mesh.faces, without_none(parameters), progress)
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
    check_progress(progress)
    samples = _whole_number("samples", samples, 0, 100_000_000)
    threads = _whole_number("threads", threads, 0, 1024)
    first, second = _mesh_of("a", a), _mesh_of("b", b)
    outcome = _core.distance(first.vertices, first.faces, second.vertices, second.faces, samples, threads,
                             progress)
    check(outcome)
    return Distance(OneWayDistance(**outcome["a_to_b"]), OneWayDistance(**outcome["b_to_a"]))
