# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# What setup, test and demo share; read by `source`, never run.

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

# The one folder with fetched sources; scripts/cmake/FindMeshLabSources.cmake looks in the same.
cache_dir() {
	printf '%s\n' "${GPR_CACHE_DIR:-${XDG_CACHE_HOME:-$(caller_home)/.cache}/gpremesh}"
}

# Runs a program under a display of its own, drawn by software, away from the user's settings.
# $1 is a folder for home and run-time files.
with_display() {
	local state=$1
	shift
	mkdir -p "$state/home" "$state/run"
	chmod 700 "$state/run"
	env HOME="$state/home" XDG_RUNTIME_DIR="$state/run" LIBGL_ALWAYS_SOFTWARE=1 \
		xvfb-run -a -s "-screen 0 1280x900x24 -nolisten tcp" "$@" </dev/null
}
