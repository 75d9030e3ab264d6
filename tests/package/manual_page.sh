# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Read by `source`, after scripts/common.sh.

# The options of a command, as its --help-all names them, one a line.
options_in_help() { # program, command
	"$1" "$2" --help-all | sed -n 's/^  \(-[^ ]*,\)\{0,1\}\(--[a-z-]*\).*/\2/p'
}

# The options of a command, as the manual page names them.
options_in_page() { # page, command
	zcat "$1" | awk -v command="${2^^}" '
		/^\.SH/ { on = $0 == ".SH \"" command "\"" }
		on && before == ".TP" && match($0, /\\-\\-([a-z]|\\-)*/) { print substr($0, RSTART, RLENGTH) }
		{ before = $0 }' | tr -d '\\'
}

# Every command and option of the program is in its manual page, and no other; where there is a
# formatter, it has nothing to say against it.
check_manual_page() { # program, page
	local command words
	for command in remesh info compare features; do
		[ "$(options_in_help "$1" $command | wc -l)" -gt 1 ] || fail "no options in the help of $command"
		# The help has its options in groups.
		diff <(options_in_help "$1" $command | sort) <(options_in_page "$2" $command | sort) ||
			fail "help and manual page of $command differ"
	done
	if command -v groff >/dev/null && command -v preconv >/dev/null; then
		words=$(zcat "$2" | preconv | groff -man -Tutf8 -ww 2>&1 >/dev/null)
		[ -z "$words" ] || fail "groff says: $words"
	fi
}
