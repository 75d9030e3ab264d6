# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of features; read by scripts/release/screenshots.

# Where each model is seen from: position, looked at, what is up, angle of view.
declare -A camera=(
	[fandisk]="14,20,-7 2.4,15.2,-1.3 0,1,0 26"
	[rockerarm]="1.7,1.0,0.6 0,0,0 0,0,1 30"
	[fandisk_near]="14,20,-7 3.6,14.6,-1.7 0,1,0 13"
	[rockerarm_near]="1.7,1.0,0.6 -0.05,0.09,0.4 0,0,1 11"
)

models_are_there() {
	[ -r "${GPR_MODELS_DIR:-}/fandisk_13k_cad.ply" ] || {
		say "SKIPPED: $1.png, there is no GPR_MODELS_DIR with its models"
		return 77
	}
}

picture_features() {
	models_are_there features || return
	local name
	for name in fandisk_13k_cad rockerarm_20k; do
		"$build/bin/gpremesh" features "$GPR_MODELS_DIR/$name.ply" "$work/$name.ply" --quiet
		shot "${camera[${name%%_*}]}" $name.ply "${coloured[@]}"
	done
	show features 2 fandisk fandisk_13k_cad rockerarm rockerarm_20k
}

# One row of preservation.png into $row: none, automatic, by disks, by vertices.
preserved() { # model, number of vertices
	local ways=("none" "--preset fast" "lambda 2" "--preset fast --lambda 2"
		"region by disks" "--preset fast --feature-region detected"
		"region by vertices" "--preset paper --feature-region detected")
	local i name=${1%%_*}
	row=()
	for ((i = 0; i < ${#ways[@]}; i += 2)); do
		# Without what the default does for creases and for closeness.
		remesh "$GPR_MODELS_DIR/$1.ply" "${name}_$i.ply" --vertices "$2" --features off ${ways[i + 1]}
		shot "${camera[${name}_near]}" "${name}_$i.ply"
		row+=("$name, ${ways[i]}" "${name}_$i")
	done
}

picture_preservation() {
	models_are_there preservation || return
	local row fandisk
	preserved fandisk_13k_cad 1295
	fandisk=("${row[@]}")
	preserved rockerarm_20k 2009
	show preservation 4 "${fandisk[@]}" "${row[@]}"
}
