# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of MeshLab's windows, worked with keys and the mouse; read by scripts/release/screenshots. Of each,
# picture_NAME starts a display, and window_NAME is what happens in it.

remeshing="Remeshing: Geodesic Poisson Disk"
comparison="Compare: Geodesic Poisson Disk vs Quadric Edge Collapse"

in_display() { # picture, size of the screen
	local program
	for program in "${window_programs[@]}"; do
		command -v "$program" >/dev/null && continue
		say "SKIPPED: $1.png, $program is not installed"
		return 77
	done
	screen=${2:-1600x900} with_display "$work/window_$1" scripts/release/screenshots inside "$1"
}

# What the screen shows but for the lowest part, where MeshLab counts the pictures it draws a second.
screen_sum() {
	import -window root -gravity north -crop 100%x80%+0+0 rgb:- | md5sum
}

# Takes the picture when nothing moves any more.
photograph() { # picture
	local before="" now i
	sleep 5 # so long does MeshLab show its last word in the status bar
	for ((i = 0; i < 20; ++i)); do
		sleep 1
		now=$(screen_sum)
		[ "$now" != "$before" ] || break
		before=$now
	done
	import -window root miff:- | convert - -colors 128 "PNG8:$pictures_dir/$1.png"
	close_window
}

# The scan in the window of the MeshLab $1, with its edges, for which there is a button at x = $2.
open_bunny() {
	open_window "$1" "$work/window.log" bunny.ply
	xdotool mousemove "$2" 65 click 1
}

window_of_2020() {
	printf '%s\n' "$build/meshlab/bin/meshlab"
}

window_meshlab_search() {
	open_bunny "$(window_of_2020)" 380
	press_in '^MeshLab 20' ctrl+f
	xdotool sleep 1 type "geodesic poisson"
	photograph meshlab_search
}

# The filter's dialog after a press of Apply, the scan beside it.
remesh_in_window() { # MeshLab, the edges' button, picture
	open_bunny "$1" "$2"
	xdotool mousemove 600 480 mousedown 2 sleep 0.3 mousemove 700 480 sleep 0.3 mousemove 870 480 sleep 0.3 mouseup 2
	open_filter "$remeshing" "remeshing geodesic poisson disk"
	press_apply
	wait_until log_has "Applied filter:* $remeshing"
	photograph "$3"
}

window_meshlab_dialog() { remesh_in_window "$(window_of_2020)" 380 meshlab_dialog; }
window_meshlab_2025_dialog() { remesh_in_window "$(window_of_2025)" 425 meshlab_2025_dialog; }
# The filter that compares; the window shows the two new layers, coloured, and the log with the table.
window_meshlab_compare() {
	open_window "$(window_of_2020)" "$work/window.log" bunny.ply
	open_filter "$comparison" "quadric edge collapse geodesic"
	press_apply
	wait_until log_has "Applied filter $comparison"
	xdotool windowclose "$window"
	xdotool mousemove 590 400 click 5                        # nearer
	xdotool mousemove 1390 960 click --repeat 4 --delay 200 4 # to the table's begin
	photograph meshlab_compare
}

picture_meshlab_compare() { in_display meshlab_compare 1600x1100; }
picture_meshlab_search() { in_display meshlab_search; }
picture_meshlab_dialog() { in_display meshlab_dialog; }

# The window is no part of what scripts/setup builds.
build_window_of_2025() {
	local tree
	tree=$(cache_dir)/meshlab-2025.07/float
	[ ! -x "$(window_of_2025)" ] || return 0
	cmake "$tree" -DMESHLAB_BUILD_ONLY_LIBRARIES=OFF >/dev/null
	cmake --build "$tree" -j"$(nproc)" --target meshlab
}

picture_meshlab_2025_dialog() {
	local plugin=${GPR_BUILD_2025_DIR:-build-2025.07}/lib/float/libfilter_geodesic_poisson.so
	[ -r "$plugin" ] || {
		say "SKIPPED: meshlab_2025_dialog.png, there is no $plugin"
		return 77
	}
	build_window_of_2025
	home_of_2025 "$work/window_meshlab_2025_dialog" "$plugin"
	GPR_CACHE_DIR=$(cache_dir) in_display meshlab_2025_dialog
}
