# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of the study of simulation, from its record."""

from dataclasses import dataclass
from statistics import geometric_mean

from . import circumstances
from .pages import page, table

TOOL_NAMES = {"tetgen-kept": "TetGen, surface kept", "tetgen-free": "TetGen, surface may be split",
              "ftetwild": "fTetWild"}


@dataclass
class Figure:
    """One column: where it stands in the record, how it is written, and whether small is good."""

    title: str
    step: str
    key: str
    form: str
    best: object = None  # min or max; None: neither is better

    def value(self, result):
        """None where the step failed, or has no such figure."""
        figures = result.get(self.step, {"failure": ""})
        return None if "failure" in figures else figures[self.key]

    def text(self, result):
        value = self.value(result)
        if value is None:
            return "–" if "failure" in result.get(self.step, {"failure": ""}) else "no end"
        return self.form.format(value)


SMALLEST_ANGLE = Figure("smallest angle", "surface", "smallestAngle", "{:.1f}°", max)
E_RMS = Figure("E_RMS, % of the diagonal", "surface", "rmsPercent", "{:.4f}", min)
CONDITION_NUMBER = Figure("condition number", "surface", "conditionNumber", "{:.3g}", min)
ITERATIONS = Figure("iterations", "surface", "iterations", "{}", min)
SURFACE = (
    Figure("vertices", "surface", "vertices", "{}"),
    Figure("faces", "surface", "faces", "{}"),
    SMALLEST_ANGLE,
    Figure("largest angle", "surface", "largestAngle", "{:.1f}°", min),
    Figure("faces below 30°", "surface", "below30Percent", "{:.3g} %", min),
    E_RMS,
    Figure("largest distance, % of the diagonal", "surface", "largestDistancePercent", "{:.3f}", min),
)
POISSON = (
    CONDITION_NUMBER,
    ITERATIONS,
    Figure("iterations with Jacobi", "surface", "iterationsJacobi", "{}", min),
    Figure("edges of negative weight", "surface", "negativeWeightsPercent", "{:.3g} %", min),
)


def volume_figures(tool):
    return (
        Figure("tetrahedra", tool, "tetrahedra", "{}", min),
        Figure("points", tool, "points", "{}"),
        Figure("smallest dihedral angle", tool, "smallestDihedral", "{:.2f}°", max),
        Figure("largest dihedral angle", tool, "largestDihedral", "{:.1f}°", min),
        Figure("tetrahedra below 10°", tool, "below10Percent", "{:.3g} %", min),
        Figure("seconds", tool, "seconds", "{:.2f}"),
    )


# ---- rows


def failure_of(result, step):
    """A sentence where a step has no figures, else an empty string."""
    if "failure" in result:
        return f"no surface: {result['failure']}"
    return result[step].get("failure", "")


def rows_of(data, step, figures):
    rows = []
    for mesh in data["meshes"]:
        for key, label in data["methods"]:
            result = mesh["results"][key]
            failure = failure_of(result, step)
            texts = [figure.text(result) for figure in figures]
            rows.append([mesh["name"], label, failure.replace("|", "/") or "yes", *texts])
    return rows


def closed_text(result):
    figures = result.get("surface", {"failure": ""})
    return "–" if "failure" in figures else "yes" if figures["closed"] else "NO"


# ---- over all models


def ratio(data, key, figure):
    """Geometric mean over the models of the figure over gpremesh's, where both have it."""
    pairs = [(figure.value(mesh["results"][key]), figure.value(mesh["results"]["gpremesh"]))
             for mesh in data["meshes"]]
    ratios = [ours and other / ours for other, ours in pairs if other and ours]
    return f"{geometric_mean(ratios):.2f}" if ratios else "–"


def done_count(data, key, step):
    done = sum(not failure_of(mesh["results"][key], step) for mesh in data["meshes"])
    return f"{done} of {len(data['meshes'])}"


def worst(data, key, figure):
    values = [figure.value(mesh["results"][key]) for mesh in data["meshes"]]
    there = [value for value in values if value is not None]
    return figure.form.format(min(there)) if there else "–"


def overview_of_surfaces(data):
    rows = []
    for key, label in data["methods"]:
        closed = sum(closed_text(mesh["results"][key]) == "yes" for mesh in data["meshes"])
        rows.append([label, f"{closed} of {len(data['meshes'])}", worst(data, key, SMALLEST_ANGLE),
                     *(ratio(data, key, figure) for figure in (E_RMS, CONDITION_NUMBER, ITERATIONS))])
    return table(["method", "closed and manifold", "smallest angle of all", "E_RMS ×", "condition number ×",
                  "iterations of conjugate gradients ×"], rows)


def overview_of_volumes(data):
    titles = ["method"]
    for tool in data["tools"]:
        titles += [f"{TOOL_NAMES[tool]}: done", "tetrahedra ×", "smallest dihedral angle of all"]
    rows = []
    for key, label in data["methods"]:
        rows.append([label])
        for tool in data["tools"]:
            tetrahedra, _, dihedral, *_ = volume_figures(tool)
            rows[-1] += [done_count(data, key, tool), ratio(data, key, tetrahedra), worst(data, key, dihedral)]
    return table(titles, rows)


# ---- who is best


def best_methods(mesh, methods, figure):
    """Those whose figure is the best one as it is written; none where there is no figure."""
    values = {key: figure.value(mesh["results"][key]) for key, _ in methods}
    there = [value for value in values.values() if value is not None]
    if not there:
        return []
    best = figure.form.format(figure.best(there))
    return [key for key, value in values.items() if value is not None and figure.form.format(value) == best]


def best_counts(data):
    """Pairs of a figure's name and, by method, on how many models it is the best one."""
    counts = []
    parts = [("surface", (*SURFACE, *POISSON))] + [(TOOL_NAMES[t], volume_figures(t)) for t in data["tools"]]
    for part, figures in parts:
        for figure in figures:
            if figure.best:
                best = [best_methods(mesh, data["methods"], figure) for mesh in data["meshes"]]
                counts.append((f"{part}: {figure.title}",
                               {key: sum(key in keys for keys in best) for key, _ in data["methods"]}))
    return counts


def best_table(data):
    rows = [[name, *(str(counts[key]) for key, _ in data["methods"])] for name, counts in best_counts(data)]
    return table(["figure", *(label for _, label in data["methods"])], rows)


def others_better(data):
    """The figures in which another method is the best one more often than either result of gpremesh."""
    labels = dict(data["methods"])
    lines = []
    for name, counts in best_counts(data):
        ours = max(count for key, count in counts.items() if key.startswith("gpremesh"))
        better = [f"{labels[key]} on {count}" for key, count in counts.items() if count > ours]
        if better:
            lines.append(f"- {name}: {', '.join(better)}; gpremesh on {ours} of {len(data['meshes'])} models\n")
    return "In these figures another method is the best more often than gpremesh:\n\n" + ("".join(lines) or "- none\n")


# ---- the page


HOW_MEASURED = """\
- The models are closed and connected, and TetGen finds no self-intersection in the models. Vertices at the same place are merged.
- gpremesh makes {percent} % of a model's vertices, at least {least} and at most {most}. The other methods get the same number of
  vertices or faces as their goal. CGAL takes an edge length: the program tries up to eight lengths.
- **CGAL**: `isotropic_remeshing`, five iterations, edges of 60° and more kept. **Quadric Edge Collapse**: of PyMeshLab, with the values of
  its dialog. **pyacvd**: with the recommended subdivision. **meshoptimizer**: `meshopt_simplify` of the package almeshopt, without an error
  bound, with and without `meshopt_SimplifyRegularize`, which the package meshoptimizer of PyPI lacks.
- **TetGen**: radius-edge ratio at most 1.414, dihedral angles of 10° wanted. "Surface kept" keeps the surface (switch Y). Otherwise TetGen may
  split its edges and faces. **fTetWild**: the defaults of pytetwild, on one thread.
- A step is **done** if there are tetrahedra after at most {longest} s of processor time, with a volume within 2 % of the volume
  inside the surface.
- **×**: the figure divided by the figure of gpremesh's default, geometric mean over the models with both figures.
- **E_RMS**, **largest distance**: from 100,000 samples of the model to the result, by MeshLab's filter.
- **condition number**: of the cotangent Laplacian, the largest eigenvalue divided by the smallest nonzero eigenvalue. **iterations**: of
  conjugate gradients, until the residual is 1e-8 of the right side, without a preconditioner and with Jacobi's; "no end" after 20,000.
  **edges of negative weight**: at such edges the discrete maximum principle can fail.
- **seconds**: processor time of the tool alone, one run.
- [Sources of the models](models.md).
"""

INTRODUCTION = """\
gpremesh and other methods remesh closed models to the same number of vertices. The results go to two tetrahedral meshers,
TetGen and fTetWild, and to a solver of the Poisson problem on the surface. TetGen must keep or split the given triangles. fTetWild makes
its own triangles, within 0.1 % of the diagonal.
"""


def surface_part(data):
    rows = []
    for mesh in data["meshes"]:
        for key, label in data["methods"]:
            result = mesh["results"][key]
            said = failure_of(result, "surface").replace("|", "/") or closed_text(result)
            rows.append([mesh["name"], label, said, *(figure.text(result) for figure in SURFACE)])
    return table(["model", "method", "closed", *(figure.title for figure in SURFACE)], rows, 3)


def step_part(data, step, figures):
    titles = ["model", "method", "done", *(figure.title for figure in figures)]
    return table(titles, rows_of(data, step, figures), 3)


def done_by_all(data, tool):
    """The models of which every method's result was meshed by a tool."""
    return [mesh for mesh in data["meshes"]
            if not any(failure_of(mesh["results"][key], tool) for key, _ in data["methods"])]


def picture_part(data, picture):
    names = {TOOL_NAMES[tool]: [mesh["name"] for mesh in done_by_all(data, tool)] for tool in data["tools"]}
    models = [f"{tool}: {', '.join(found)}" for tool, found in names.items() if found]
    return (f"![Dihedral angles of the tetrahedra by method]({picture})\n\n"
            f"Only models that every method has done: {'. '.join(models)}.\n")


def machine(data):
    facts = data["circumstances"]
    commits = sorted({mesh["commit"] for mesh in data["meshes"]})
    packages = ", ".join(f"{name} {version}" for name, version in data["versions"].items())
    return (f"{circumstances.sentence_on_machine(facts)}, {circumstances.sentence_on_build(facts)}; {packages}; "
            f"commit {', '.join(commits)}; {facts['date']}.\n")


def text(data, picture):
    """picture: the name of the file, or an empty string."""
    from .commands import PERCENT
    from .simulation import LEAST_VERTICES, MOST_VERTICES

    shown = [picture_part(data, picture)] if picture else []
    volumes = [f"## {TOOL_NAMES[tool]}\n\n{step_part(data, tool, volume_figures(tool))}" for tool in data["tools"]]
    return page(
        "scripts/measure/run simulation", "Simulation", INTRODUCTION, overview_of_surfaces(data),
        overview_of_volumes(data), machine(data), others_better(data), *shown,
        HOW_MEASURED.format(percent=PERCENT, least=f"{LEAST_VERTICES:,}", most=f"{MOST_VERTICES:,}",
                            longest=data["longest"]),
        "## Number of models with the best figure\n\nMethods with equal figures all count; of "
        f"{len(data['meshes'])} models.\n\n{best_table(data)}",
        f"## Surfaces\n\n{surface_part(data)}",
        f"## Poisson problem on the surface\n\n{step_part(data, 'surface', POISSON)}", *volumes)
