# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of the edit tool in MeshLab's window; read by scripts/release/screenshots after windows.sh.

edit_frames=$work/edit_frames
edit_part=1136x706+0+90 # of the screen: the panel and the view

in_display_with_tool() { # picture
	QT_LOGGING_RULES="gpr.edit.debug=true" in_display "$1"
}

open_tool_on_bunny() {
	open_tool "$(window_of_2020)" "$work/window.log" bunny.ply
}

# The wipe line, Quadric Edge Collapse to its left, both coloured by the quality of the triangles.
window_edit_tool() {
	open_tool_on_bunny
	choose Colours 1
	click_on Wipe
	choose OtherSide 1
	wait_until log_has "gpr.edit: quadric drawn"
	photograph edit_tool
}

# Frame after frame of the panel and the view, while the slider is dragged and then the wipe line.
take_frame() {
	import -window root -crop "$edit_part" +repage "$edit_frames/$(printf '%03d' "$frame").miff"
	frame=$((frame + 1))
}

window_edit_tool_moving() {
	local x y width height at frame=0
	mkdir -p "$edit_frames"
	rm -f "$edit_frames"/*
	open_tool_on_bunny
	click_on TargetVertexNumSlider 85
	wait_until full_is_drawn_as_asked
	read -r x y width height < <(place_of TargetVertexNumSlider)
	xdotool mousemove $((x + width * 85 / 100)) $((y + height / 2)) mousedown 1
	for at in 85 80 76 72 68 64 60 56 52 48 44 40 44 48 52 56 60; do
		xdotool mousemove $((x + width * at / 100)) $((y + height / 2)) sleep 0.4
		take_frame
	done
	xdotool mouseup 1
	wait_until full_is_drawn_as_asked
	sleep 1
	take_frame
	choose Colours 1
	click_on Wipe
	sleep 1
	take_frame
	read -r x y width height < <(place_of View)
	xdotool mousemove $((x + width / 2)) 600 mousedown 1
	for at in 45 40 34 28 22 28 36 44 52 60 68 76 84; do
		xdotool mousemove $((x + width * at / 100)) 600 sleep 0.3
		take_frame
	done
	xdotool mouseup 1
	close_window
}

picture_edit_tool() { in_display_with_tool edit_tool; }

picture_edit_tool_moving() {
	in_display_with_tool edit_tool_moving
	convert -delay 22 "$edit_frames"/*.miff -resize 720x +dither -colors 56 -loop 0 \
		-fuzz 2% -layers OptimizePlus "$pictures_dir/edit_tool_moving.gif"
	[ "$(stat -c %s "$pictures_dir/edit_tool_moving.gif")" -lt 2000000 ] || fail "the moving picture has 2 MB or more"
}
