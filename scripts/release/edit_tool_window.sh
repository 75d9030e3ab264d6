# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Works the edit tool as a user does; read by `source` after meshlab_window.sh, never run. The tool's debug
# output, which QT_LOGGING_RULES="gpr.edit.debug=true" switches on, tells where its widgets are, what was
# asked for and what was drawn.

edit_icon_at=655 # x of the tool's icon in MeshLab 2020.09; 587 in 2025.07 without its own tools

# Presses the tool's icon in the toolbar, beside which are those of MeshLab's own tools.
press_icon() {
	xdotool mousemove "$edit_icon_at" 65 click 1
}

# MeshLab refuses the tool while it opens a further mesh.
open_tool() { # MESHLAB, LOG, MESHES
	open_window "$@"
	wait_until log_has "Opened mesh ${!#}"
	press_icon
	comes_within 5 log_has "Started Mode Geodesic Poisson Remeshing" || press_icon
	wait_until log_has "Started Mode Geodesic Poisson Remeshing"
	wait_until log_has "gpr.edit: widget Apply "
	wait_until log_has "gpr.edit: full drawn"
}

# Left edge, top edge, width and height of a widget of the panel.
place_of() {
	sed -n "s/^gpr.edit: widget $1 //p" "$window_log" | tail -n 1
}

click_on() { # WIDGET [SHARE OF ITS WIDTH IN PERCENT]
	local x y width height
	read -r x y width height < <(place_of "$1")
	xdotool mousemove $((x + 2 + (width - 4) * ${2:-3} / 100)) $((y + height / 2)) click 1
}

choose() { # WIDGET, NUMBER OF THE CHOICE FROM 0
	click_on "$1" 50
	xdotool sleep 0.3 key Home
	[ "$2" = 0 ] || xdotool key --repeat "$2" --delay 30 Down
	xdotool key Return
}

# Drags the slider from where it is pressed to another place, in percent of its width.
drag_slider() { # FROM TO
	local x y width height at
	read -r x y width height < <(place_of TargetVertexNumSlider)
	xdotool mousemove $((x + width * $1 / 100)) $((y + height / 2)) mousedown 1
	for at in 1 2 3 4 5 6 7 8; do
		xdotool mousemove $((x + width * ($1 + ($2 - $1) * at / 8) / 100)) $((y + height / 2)) sleep 0.05
	done
	xdotool mouseup 1
}

count_asked() {
	sed -n 's/^gpr.edit: asked for \([0-9]*\) vertices/\1/p' "$window_log" | tail -n 1
}

full_is_drawn_as_asked() {
	grep 'gpr.edit: \(draft\|full\) drawn' "$window_log" | tail -n 1 |
		grep -q "full drawn $(count_asked) vertices"
}
