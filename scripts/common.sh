# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# What the scripts share; read by `source`, never run.

say() { printf '%s: %s\n' "${0##*/}" "$*"; }

fail() {
	printf '%s: %s\n' "${0##*/}" "$*" >&2
	exit 1
}

# Who owns what the scripts leave behind: with `sudo scripts/...` the caller, not root.
caller_home() {
	if [ "$(id -u)" = 0 ] && [ -n "${SUDO_USER:-}" ] && [ "$SUDO_USER" != root ]; then
		getent passwd "$SUDO_USER" | cut -d: -f6
	else
		printf '%s\n' "$HOME"
	fi
}

# The one folder with fetched sources; cmake/FindMeshLabSources.cmake looks in the same.
cache_dir() {
	printf '%s\n' "${GPR_CACHE_DIR:-${XDG_CACHE_HOME:-$(caller_home)/.cache}/gpremesh}"
}

# Runs a program under a display of its own, drawn by software, away from the user's settings.
# $1 is a folder for home and run-time files, $screen the display's size if not 1280x900. The exit code is the program's: now and then xvfb-run
# fails at clearing away its own files, which is no matter.
with_display() {
	local state=$1
	shift
	mkdir -p "$state/home" "$state/run"
	chmod 700 "$state/run"
	rm -f "$state/exit_code"
	env HOME="$state/home" XDG_RUNTIME_DIR="$state/run" LIBGL_ALWAYS_SOFTWARE=1 \
		xvfb-run -a -s "-screen 0 ${screen:-1280x900}x24 -nolisten tcp" \
		sh -c 'code=$1; shift; "$@"; echo $? >"$code"' with_display "$state/exit_code" "$@" \
		</dev/null || true
	[ -s "$state/exit_code" ] || return 1
	return "$(cat "$state/exit_code")"
}

# Set-up, a build of the program and the plugin in the folder $1, and in $1/meshlab a MeshLab that has our
# plugin. The tests are not built, since they are no targets of this build; no option switches them off,
# since scripts/test goes on in the same folder. The build's words go to the file $2.
build_for_meshlab() {
	scripts/setup
	say "building"
	cmake -S . -B "$1" >"$2"
	cmake --build "$1" -j"$(nproc)" --target gpremesh gpremesh_manual_page filter_geodesic_poisson \
		edit_geodesic_poisson >>"$2" 2>&1 || {
		tail -40 "$2" >&2
		fail "the build failed"
	}
	scripts/release/private_meshlab "$1/meshlab" "$1"/lib/lib{filter,edit}_geodesic_poisson.so
}

# Runs the tests in the build folder $1, with further options for ctest. No tests at all are a failure.
# scripts/check/count_tests reads the results, which are written to $1/test_results.xml.
run_tests() {
	local build
	build=$(readlink -f "$1")
	shift
	rm -f "$build/test_results.xml"
	ctest --test-dir "$build" --no-tests=error --output-on-failure \
		--output-junit "$build/test_results.xml" "$@" </dev/null
}

# bunny.obj of Debian's glmark2-data as the PLY file $1: the OBJ reader of MeshLab 2020.09 ends with a
# failed assertion on this file.
bunny_as_ply() {
	local obj
	obj=$(dpkg -L glmark2-data | grep '/bunny\.obj$')
	awk '$1 == "v" { vertex[nv++] = $2 " " $3 " " $4 }
		$1 == "f" { face[nf++] = "3 " $2 - 1 " " $3 - 1 " " $4 - 1 }
		END {
			print "ply\nformat ascii 1.0\nelement vertex " nv
			print "property float x\nproperty float y\nproperty float z\nelement face " nf
			print "property list uchar int vertex_indices\nend_header"
			for (i = 0; i < nv; ++i) print vertex[i]
			for (i = 0; i < nf; ++i) print face[i]
		}' "$obj" >"$1"
}

# Runs a command and leaves its wall time in $seconds.
timed() {
	local start=$EPOCHREALTIME
	"$@"
	seconds=$(awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.3f", b - a }')
}

# A picture of a mesh, 640 pixels wide and high. $1 is as for with_display; then the mesh, the picture and
# the camera, "position looked-at [up [angle]]" with points as x,y,z; options of f3d follow that take the
# place of edges on light blue.
render() {
	local at=($4) look=("${@:5}")
	[ $# -gt 4 ] || look=(--edges --color 0.8,0.88,1)
	with_display "$1" f3d --dry-run --quiet --output "$3" --resolution 640,640 --bg-color 1,1,1 \
		--roughness 0.8 --camera-position "${at[0]}" --camera-focal-point "${at[1]}" \
		--camera-view-up "${at[2]:-0,1,0}" --camera-view-angle "${at[3]:-30}" "${look[@]}" "$2"
	convert "$3" -level 0,66% "$3" # f3d's one light leaves a white surface grey
}

# One picture of many, 1400 pixels wide: its name, the number of columns, then label and picture of each.
tiles() {
	local file=$1 columns=$2 list=()
	shift 2
	while [ $# -gt 0 ]; do
		list+=(-label "$1" "$2")
		shift 2
	done
	montage -font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf -pointsize 22 -background white \
		-geometry 640x640+4+4 -tile "${columns}x" "${list[@]}" miff:- |
		convert - -resize 1400x -colors 96 "PNG8:$file"
}

# A run in tiles on this machine, one step after the other: the program, the folder of the run, input, output,
# and options of the plan.
run_in_tiles() {
	local program=$1 folder=$2 input=$3 output=$4 tiles unit
	"$program" tile plan "$folder" "$input" "${@:5}" >"$output.plan"
	tiles=$(jq .tiles "$output.plan")
	rm "$output.plan"
	"$program" tile split "$folder" >/dev/null
	for ((unit = 0; unit < tiles; ++unit)); do
		"$program" tile part "$folder" --unit "$unit" >/dev/null
	done
	"$program" tile join "$folder" >/dev/null
	"$program" tile finish "$folder" "$output" --quiet
}

# Waits until a command succeeds; fails after ten minutes, with the words.
wait_until() {
	local words=$1 tries
	shift
	for ((tries = 0; tries < 6000; ++tries)); do
		! "$@" 2>/dev/null || return 0
		sleep 0.1
	done
	fail "$words"
}
