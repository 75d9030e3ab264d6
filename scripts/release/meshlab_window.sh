# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Works MeshLab's window as a user does, with keys and the mouse, on a display that has nothing else;
# read by `source` after common.sh, never run. Needs xvfb, openbox and xdotool.
#
# Nothing here sleeps for a guessed time and hopes: every step waits for a window or a line of the log.

window_programs=(xvfb-run openbox xdotool)
window_first_field=3 # steps with the Tab key from Apply
window_patience=120  # seconds that one step may take on a slow machine
window_log=""        # what MeshLab writes, set by open_window
window_process=""

# Waits until a command succeeds; ends the script where it does not, or where MeshLab has gone.
wait_until() {
	comes_within $window_patience "$@" || give_up "this did not happen in time: $*"
}

# Tries a command for as many seconds as $1 says.
comes_within() {
	local end=$((SECONDS + $1))
	until "${@:2}"; do
		kill -0 "$window_process" 2>/dev/null || give_up "MeshLab ended before: ${*:2}"
		[ $SECONDS -lt $end ] || return 1
		sleep 0.1
	done
}

# Ends the script, with the end of the log and a picture of the screen beside it.
give_up() {
	tail -20 "$window_log" >&2 || true
	import -window root "${window_log%.*}.png" 2>/dev/null || true
	fail "$*"
}

# True where the log has a line like $1, $2 times if that is given.
log_has() {
	[ -e "$window_log" ] && [ "$(grep -c -- "$1" "$window_log")" -ge "${2:-1}" ]
}

# The program of MeshLab 2025.07, where it was built with its window.
window_of_2025() {
	printf '%s\n' "$(cache_dir)/meshlab-2025.07/float/src/distrib/meshlab"
}

# Makes the state folder $1 of with_display a home in which 2025.07 finds the plugin $2, left there as
# by "Load Plugins", and does not greet its user first.
home_of_2025() {
	local extra=$1/home/.local/share/VCG/MeshLab_64bit_fp/MeshLabExtraPlugins/2025.07
	mkdir -p "$extra" "$1/home/.config/VCG"
	cp -f "$2" "$extra/"
	printf '[General]\ninformativeShown=true\n' >"$1/home/.config/VCG/MeshLab_64bit_fp.conf"
}

# Starts the MeshLab $1 with the log $2; further arguments are files that it opens.
open_window() {
	window_log=$2
	rm -f "$window_log" # what an earlier one wrote would be taken for this one's
	openbox >/dev/null 2>&1 &
	"$1" "${@:3}" >"$window_log" 2>&1 &
	window_process=$!
	wait_until log_has "All files opened"
	wait_until window_shows '^MeshLab 20'
	activate
}

close_window() {
	kill -9 "$window_process"
	wait "$window_process" 2>/dev/null || true
}

# Leaves in $window the uppermost window whose title is like $1.
window_shows() {
	window=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -n 1)
	[ -n "$window" ]
}

window_hides() {
	! window_shows "$1"
}

activate() {
	timeout $window_patience xdotool windowactivate --sync "$window" || give_up "the window took no focus"
}

# Waits for a window whose title is like $1 and presses keys in it.
press_in() {
	wait_until window_shows "$1"
	activate
	xdotool key "${@:2}"
}

# Opens the dialog of the filter $1 by typing part of its name, $2, into MeshLab's search. The list of
# what was found shows itself by no title, so a try that came too early is made again, more slowly. The
# filter may also be another one's second: MeshLab 2025.07 looks into the descriptions as well.
open_filter() {
	local try delay place
	for try in 0.5,1 0.5,2 1,1 1,2 4,1 4,2 8,1; do
		delay=${try%,*} place=${try#*,}
		press_in '^MeshLab 20' ctrl+f
		xdotool sleep "$delay" type "$2"
		xdotool sleep "$delay" key --repeat "$place" --delay 50 Down sleep 0.2 key Return
		if comes_within $((5 + ${delay%.*} * 5)) window_shows "^$1\$"; then
			activate
			return 0
		fi
		xdotool key Escape key Escape
	done
	give_up "the search does not find the filter $1"
}

# The number of steps with the Tab key from Apply, which has the focus at first, to the field of the
# parameter $2 in the dialog of the script $1, which lists the fields in the dialog's order. A length
# has two fields. Before the first one are frames and buttons.
tabs_to() {
	awk -v key="name=\"$2\"" -v steps="$window_first_field" '
		index($0, key) { found = 1; print steps; exit }
		/<Param / { steps += /RichAbsPerc/ ? 2 : 1 }
		END { exit !found }' "$1" || fail "$1 has no parameter $2"
}

# Goes to the field of a parameter (script, name), runs xdotool with what else is given, goes back to
# Apply.
in_field() {
	local steps
	steps=$(tabs_to "$1" "$2")
	xdotool key --repeat "$steps" --delay 20 Tab
	xdotool "${@:3}"
	xdotool key --repeat "$steps" --delay 20 shift+Tab
}

# Writes $3 into the field of a parameter (script, name).
fill_in() {
	in_field "$1" "$2" key ctrl+a type "$3"
}

# True where the whole dialog $window is on the screen; leaves its size in $WIDTH and $HEIGHT.
dialog_is_in_reach() {
	local X Y SCREEN most
	xdotool windowmove "$window" 0 20
	eval "$(xdotool getwindowgeometry --shell "$window")"
	most=$(xdotool getdisplaygeometry | cut -d ' ' -f 2)
	[ "$Y" -le 20 ] && [ $((Y + HEIGHT)) -le "$most" ]
}

# Presses Apply in the dialog $window; $@ are options of xdotool's click.
press_apply() {
	local WIDTH HEIGHT
	comes_within 30 dialog_is_in_reach ||
		give_up "Apply is below the end of the screen: $(xdotool getwindowgeometry "$window")"
	xdotool mousemove --window "$window" $((WIDTH * 74 / 100)) $((HEIGHT - 23)) click "$@" 1
}
