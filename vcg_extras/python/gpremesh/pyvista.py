# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of PyVista: `mesh.gpremesh.remesh(5000)`. PyVista 0.48 and later find this module without an import.
Importing this imports PyVista."""

import numpy as np
import pyvista

from . import _api, _regions


def _unit(normals):
    """Scales vectors to length 1, because means of unit vectors are shorter."""
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.divide(normals, length, out=np.zeros_like(normals), where=length > 0)


def _faces(mesh):
    if mesh.n_strips:
        raise ValueError("The mesh has triangle strips; call its triangulate() first.")
    return mesh.regular_faces if mesh.is_all_triangles else list(mesh.irregular_faces)


@pyvista.register_dataset_accessor("gpremesh", pyvista.PolyData)
class Accessor:
    """gpremesh for a surface of PyVista.

    Parameters
    ----------
    mesh : pyvista.PolyData
        The surface: triangles and polygons of the mesh, without points and lines.
    """

    def __init__(self, mesh):
        self._mesh = mesh

    def remesh(self, vertex_count=None, *, regions=None, **parameters):
        """Remeshes the surface, with its point and cell data.

        Parameters
        ----------
        vertex_count : int, optional
            How many points the result has. Along the seams of a texture there are copies beyond that,
            as PyVista has one texture coordinate for each point.
        regions : str or array_like of int, optional
            What tells the regions of the cells: the name of cell data, an array of labels for the
            polygons, or "off". If not given: cell data whose names tell regions, as "region", "label",
            "material" and "CellEntityIds", combined. Edges of the result follow the borders between
            regions. Labels that were given as an array are the cell data "region" of the result.
        **parameters
            As for `gpremesh.remesh`, without `uv`, which is the active texture coordinates.

        Returns
        -------
        pyvista.PolyData
            The result, with the point, cell and field data of the mesh. Normals of points have the length 1
            again; normals of cells are left out.

        Raises
        ------
        ValueError, gpremesh.Error, KeyboardInterrupt
            As `gpremesh.remesh`.
        """
        mesh = self._mesh
        _api.check_mesh_of_host(mesh, (pyvista.PolyData,), parameters)
        texture = mesh.active_texture_coordinates
        result = _api.remesh(np.asarray(mesh.points), _faces(mesh), vertex_count=vertex_count,
                             uv=None if texture is None else np.asarray(texture)[:, :2],
                             regions=_regions.find(self._cell_data(), regions), **parameters)
        vertices, faces, vertex_index, uv = result.vertices, result.faces, slice(None), None
        if texture is not None:
            vertex_index, faces, uv = result.split_at_seams()
            vertices = vertices[vertex_index]
        remeshed = pyvista.PolyData.from_regular_faces(vertices, faces)
        self._carry_point_data(result, vertex_index, remeshed)
        for name, values in self._cell_data().items():
            remeshed.cell_data[name] = result.transfer(values, "face")
        if _regions.is_array(regions):
            remeshed.cell_data["region"] = result.regions
        remeshed.field_data.update(mesh.field_data)
        if uv is not None:
            name = mesh.point_data.active_texture_coordinates_name
            remeshed.point_data[name] = uv
            remeshed.point_data.active_texture_coordinates_name = name
        if mesh.active_scalars_name in remeshed.array_names:
            of = mesh.active_scalars_info.association.name.lower()
            remeshed.set_active_scalars(mesh.active_scalars_name, preference=of)
        return remeshed

    def _carry_point_data(self, result, vertex_index, remeshed):
        data = self._mesh.point_data
        left_out = data.active_texture_coordinates_name
        for name in data.keys():
            if name == left_out:
                continue
            values = result.transfer(np.asarray(data[name]), "vertex")[vertex_index]
            is_normal = name == data.active_normals_name
            remeshed.point_data[name] = _unit(values) if is_normal else values
        if data.active_normals_name in remeshed.point_data:
            remeshed.point_data.active_normals_name = data.active_normals_name

    def _cell_data(self):
        """What the polygons have beside normals."""
        data = self._mesh.cell_data
        first = self._mesh.n_verts + self._mesh.n_lines  # cells of points and lines come before faces
        return {name: np.asarray(data[name])[first:] for name in data.keys() if name != data.active_normals_name}

    def sample(self, count=None, **parameters):
        """Spreads points evenly over the surface.

        Parameters
        ----------
        count : int, optional
            Approximate number of points.
        **parameters
            As for `gpremesh.sample`.

        Returns
        -------
        pyvista.PolyData
            Points, with the disk radius as the point data "radius".
        """
        samples = _api.sample(np.asarray(self._mesh.points), _faces(self._mesh), count=count, **parameters)
        points = pyvista.PolyData(samples.points)
        points.point_data["radius"] = samples.radius
        return points

    def features(self, **parameters):
        """Finds the creases of the surface.

        Parameters
        ----------
        **parameters
            As for `gpremesh.features`.

        Returns
        -------
        pyvista.PolyData
            The crease edges as lines, with the cell data "strength" in degrees.
        """
        points = np.asarray(self._mesh.points)
        found = _api.features(points, _faces(self._mesh), **parameters)
        lines = np.column_stack([np.full(len(found.edges), 2), found.edges]).reshape(-1)
        edges = pyvista.PolyData(points, lines=lines)
        edges.cell_data["strength"] = found.edge_strength
        return edges
