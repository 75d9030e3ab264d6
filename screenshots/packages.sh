# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures by Python packages and by Chromium; read by scripts/release/screenshots.

python=$(cache_dir)/python/bin/python

# The script runs with the package of the build. A picture without its Python packages is skipped.
drawn_by_python() { # picture, its packages, script and its arguments
	local package
	for package in $2; do
		PYTHONPATH=$build/python "$python" -c "import $package" 2>"$work/$1.log" && continue
		say "SKIPPED: $1.png, $python cannot import $package"
		return 77
	done
	# PyVista renders into a window of a display.
	PYTHONPATH=$build/python with_display "$work/display_$1" "$python" "${@:3}" >>"$work/$1.log" 2>&1
}

needs_chromium() { # picture
	command -v chromium >/dev/null && return
	say "SKIPPED: $1.png, chromium is not installed"
	return 77
}

picture_python_pyvista() {
	drawn_by_python python_pyvista "pyvista gpremesh" scripts/release/python_pictures "$bunny" pyvista
}

picture_python_trimesh() {
	drawn_by_python python_trimesh "pyvista trimesh gpremesh" scripts/release/python_pictures "$bunny" trimesh
}

picture_python_open3d() {
	drawn_by_python python_open3d "pyvista open3d gpremesh" scripts/release/python_pictures "$bunny" open3d
}

picture_blender() {
	drawn_by_python blender "bpy gpremesh" scripts/release/blender_picture
}

picture_tiles() {
	remesh "$bunny" dense_bunny.ply --percent 400 --preset fast
	drawn_by_python tiles "pyvista scipy" scripts/release/tile_picture "$work/dense_bunny.ply" "$build/bin/gpremesh"
}

picture_compare_page() {
	needs_chromium compare_page || return
	[ -r "${GPR_MODELS_DIR:-}/igea_269k.ply" ] || {
		say "SKIPPED: compare_page.png, there is no igea_269k.ply in GPR_MODELS_DIR"
		return 77
	}
	drawn_by_python compare_page "" scripts/release/page_picture "$build/bin/gpremesh" "$GPR_MODELS_DIR/igea_269k.ply"
}

picture_dask() {
	needs_chromium dask || return
	"$build/bin/gpr_big_mesh" stone "$work/dask_stone.ply" 2400000
	drawn_by_python dask "distributed bokeh gpremesh" scripts/release/dask_picture "$work/dask_stone.ply" "$build/bin/gpremesh"
}
