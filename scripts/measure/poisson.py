# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Poisson problem on a closed surface, with the cotangent Laplacian, and how hard it is to solve.

-Δu = f - mean(f), where f is the distance from the middle of the box along x + 2y + 3z: a smooth right side that is
the same for all meshes of a model. The matrix is that of linear finite elements (Pinkall, Polthier 1993), the mass is lumped.
Constants solve it with 0, one constant a component: so figures are those of what is perpendicular to them.
"""

import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import LinearOperator, cg, eigsh

TOLERANCE = 1e-8  # of the residual, relative to the right side
MOST_ITERATIONS = 20000
DIRECTION = np.array([1.0, 2.0, 3.0])


def cotangent_laplacian(vertices, faces):
    """The positive semi-definite matrix, and the lumped areas of the vertices."""
    size = len(vertices)
    weights, rows, columns = [], [], []
    for k in range(3):
        apex, left, right = (faces[:, (k + j) % 3] for j in range(3))
        a, b = vertices[left] - vertices[apex], vertices[right] - vertices[apex]
        twice_area = np.linalg.norm(np.cross(a, b), axis=1)
        if (twice_area == 0).any():
            raise ValueError("a face has no area")
        weights.append((a * b).sum(axis=1) / twice_area / 2)
        rows.append(left)
        columns.append(right)
    entries = (np.concatenate(weights), (np.concatenate(rows), np.concatenate(columns)))
    half = coo_matrix(entries, (size, size)).tocsr()
    off_diagonal = half + half.T
    laplacian = (diags(np.asarray(off_diagonal.sum(axis=1)).ravel()) - off_diagonal).tocsr()
    mass = np.bincount(faces.ravel(), np.repeat(twice_area / 6, 3), size)
    return laplacian, mass


def right_side(vertices, mass, component):
    """f times the mass, less its mean on each component."""
    heights = (vertices - vertices.mean(axis=0)) @ DIRECTION / np.ptp(vertices, axis=0).max()
    means = np.bincount(component, mass * heights) / np.bincount(component, mass)
    return mass * (heights - means[component])


def iterations(matrix, right, preconditioner=None):
    """Of conjugate gradients; None where they do not end."""
    count = 0

    def counted(_):
        nonlocal count
        count += 1

    _, problem = cg(matrix, right, rtol=TOLERANCE, maxiter=MOST_ITERATIONS, M=preconditioner, callback=counted)
    return None if problem else count


def condition_number(matrix, component_num):
    """The largest eigenvalue over the smallest one that is not that of constants."""
    start = np.cos(np.arange(matrix.shape[0]))  # the same in every run
    largest = eigsh(matrix, 1, which="LA", tol=1e-4, v0=start, return_eigenvectors=False)[0]
    below = -1e-8 * matrix.diagonal().mean()
    low = eigsh(matrix, component_num + 1, sigma=below, v0=start, return_eigenvectors=False)
    return largest / np.max(low)


def figures(vertices, faces, components):
    """components: their number, and that of each vertex."""
    component_num, component = components
    laplacian, mass = cotangent_laplacian(vertices, faces)
    right = right_side(vertices, mass, component)
    diagonal = laplacian.diagonal()
    jacobi = LinearOperator(laplacian.shape, lambda x: x.ravel() / diagonal)
    edges = (laplacian - diags(diagonal)).tocsr()
    edges.eliminate_zeros()
    return {
        "conditionNumber": float(condition_number(laplacian, component_num)),
        "iterations": iterations(laplacian, right),
        "iterationsJacobi": iterations(laplacian, right, jacobi),
        # Rounding makes weights of right angles a little negative.
        "negativeWeightsPercent": float(100 * (edges.data > 1e-9).sum() / edges.nnz)}
