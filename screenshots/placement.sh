# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Where the paper puts the next sample, and where this program does; read by scripts/release/screenshots.

# Three samples with disks of radius r. Left: a border edge v1 v2 crosses the front, the new sample
# is where. Right: the new sample is where the circles of two samples intersect.
placement_drawing() {
	awk 'function disk(x, y) {
		printf "fill \"#dbe7f6b0\" stroke \"#3a6ea5\" circle %.1f,%.1f %.1f,%.1f\n", x, y, x + r, y
	}
	function dot(x, y, colour) {
		printf "stroke none fill \"%s\" circle %.1f,%.1f %.1f,%.1f\n", colour, x, y, x + 8, y
	}
	function line(x1, y1, x2, y2, colour) {
		printf "fill none stroke \"%s\" line %.1f,%.1f %.1f,%.1f\n", colour, x1, y1, x2, y2
	}
	function words(x, y, text) {
		printf "stroke none fill black text %.1f,%.1f \"%s\"\n", x, y, text
	}
	function samples(x) {
		disk(x - d / 2, y0); disk(x + d / 2, y0); disk(x, y0 + d)
		dot(x - d / 2, y0, blue); dot(x + d / 2, y0, blue); dot(x, y0 + d, blue)
	}
	BEGIN {
		r = 180; d = 208; y0 = 310; left = 360; right = 1040
		blue = "#1d3557"; red = "#c1121f"; grey = "#555555"
		print "stroke-width 3 font-size 30"
		samples(left)
		x1 = left + d / 2 + 100; y1 = y0 - 80; x2 = x1 + 90; y2 = y1 - 90; ex = left + d / 2
		for (t = 0; t < 1; t += 0.0001) {
			px = x1 + t * (x2 - x1); py = y1 + t * (y2 - y1)
			if ((px - ex) ^ 2 + (py - y0) ^ 2 >= r * r) break
		}
		line(x1, y1, x2, y2, grey); dot(x1, y1, grey); dot(x2, y2, grey)
		words(x1 - 50, y1 + 6, "v1"); words(x2 + 14, y2 + 4, "v2")
		line(ex, y0, px, py, red); dot(px, py, red); words((ex + px) / 2 + 14, (y0 + py) / 2 + 36, "r")
		words(left - 260, 840, "paper: a border edge, eq. (2) and (3)")

		samples(right)
		h = sqrt(r * r - d * d / 4)
		line(right - d / 2, y0, right, y0 - h, red); line(right + d / 2, y0, right, y0 - h, red)
		dot(right, y0 - h, red)
		words(right - d / 4 - 36, y0 - h / 2, "r"); words(right + d / 4 + 22, y0 - h / 2, "r")
		words(right - 240, 840, "here: where two circles intersect")
	}'
}

picture_placement() {
	convert -size 1400x880 xc:white -font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf \
		-draw "$(placement_drawing)" -resize 50% -colors 64 PNG8:screenshots/placement.png
}
