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
