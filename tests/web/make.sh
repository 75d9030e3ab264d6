#!/bin/sh
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the page and the npm package in the folder $1, with build files in the folder $2.
for program in emcc node; do
	command -v $program >/dev/null && continue
	echo "SKIPPED: $program is missing; the page that remeshes is not built (scripts/test --web)"
	exit 77
done
GPR_WEB_BUILD=$2 exec "$(dirname "$0")/../../scripts/release/make_page" "$1"
