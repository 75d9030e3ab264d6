# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Pictures of single stages; read by scripts/release/screenshots.

# Seen from, looked at: the bunny as a whole, its flank, other meshes.
whole="0,0,4.5 0,0,0"
flank="0.25,-0.2,2.1 0.25,-0.2,0"
patch="0.2,-0.16,2.4 0.2,-0.16,0.1"
sheets="0.8,2.4,3.4 0,-0.15,0.1"
cube="2.1,1.7,2.4 0,-0.02,0"

# From an OFF file and a file with the colour of each vertex to a PLY file.
with_colours() { # off, colours, ply
	awk 'NR == FNR { colour[n++] = $0; next }
		FNR == 2 {
			nv = $1
			print "ply\nformat ascii 1.0\nelement vertex " nv
			print "property float x\nproperty float y\nproperty float z"
			print "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha"
			print "element face " $2 "\nproperty list uchar int vertex_indices\nend_header"
		}
		FNR > 2 && NF > 0 { print row < nv ? $0 " " colour[row + 0] " 255" : $0; ++row }' "$2" "$1" >"$3"
}

# A round piece of the bunny's flank: faces cut off without care, so with a ragged border.
cut_patch() {
	awk 'BEGIN { kept = 0; nf = 0 }
		function index_of(v) {
			if (!(v in place)) { place[v] = kept; line[kept++] = vertex[v] }
			return place[v]
		}
		$1 == "element" && $2 == "vertex" { nv = $3 }
		body && row < nv {
			inside[row] = ($1 - 0.2) ^ 2 + ($2 + 0.1) ^ 2 < 0.16 && $3 > 0.1
			vertex[row++] = $0
			next
		}
		body && inside[$2] && inside[$3] && inside[$4] {
			face[nf++] = "3 " index_of($2) " " index_of($3) " " index_of($4)
		}
		$1 == "end_header" { body = 1 }
		END {
			print "ply\nformat ascii 1.0\nelement vertex " kept
			print "property float x\nproperty float y\nproperty float z\nelement face " nf
			print "property list uchar int vertex_indices\nend_header"
			for (i = 0; i < kept; ++i) print line[i]
			for (i = 0; i < nf; ++i) print face[i]
		}' "$bunny" >"$work/patch.ply"
}

# The mesh after each stage, all triangles of one size: retriangulated, flipped, counted, repaired, fitted.
stage_meshes() { # percent
	"$build/bin/gpr_stage_meshes" "$bunny" "$1" "$work"
}

picture_stages() {
	stage_meshes 10
	remesh "$bunny" relaxed.off
	mv "$work/flipped.off" "$work/sampled.off"
	local mesh
	shot "$flank" bunny.ply
	for mesh in sampled counted relaxed; do
		shot "$flank" $mesh.off
	done
	show stages 2 "input" bunny "sampled, retriangulated, flipped" sampled "exact count" counted \
		"relaxed, fitted" relaxed
}

picture_boundary() {
	cut_patch
	remesh "$work/patch.ply" patch_remeshed.ply --vertices 300
	shot "$patch" patch.ply
	shot "$patch" patch_remeshed.ply
	show boundary 2 "input" patch "300 vertices" patch_remeshed
}

picture_split() {
	awk 'BEGIN {
		print "OFF\n8 12 0"
		for (i = 0; i < 8; ++i) print i % 2 - 0.5, int(i / 2) % 2 - 0.5, int(i / 4) - 0.5
		n = split("0 2 3 0 3 1 4 5 7 4 7 6 0 1 5 0 5 4 2 6 7 2 7 3 0 4 6 0 6 2 1 3 7 1 7 5", c, " ")
		for (i = 1; i <= n; i += 3) print 3, c[i], c[i + 1], c[i + 2]
	}' >"$work/cube.off"
	remesh "$work/cube.off" cube_remeshed.off --vertices 600
	shot "$cube" cube.off
	shot "$cube" cube_remeshed.off
	show split 2 "input, 12 faces" cube "600 vertices" cube_remeshed
}

picture_density() {
	remesh "$bunny" even.ply --percent 5
	remesh "$bunny" lambda.ply --percent 5 --lambda 3
	remesh "$bunny" adapt.ply --percent 5 --adapt 1
	local mesh
	for mesh in even lambda adapt; do
		shot "$whole" $mesh.ply
	done
	show density 3 "evenly" even "lambda 3" lambda "adapt 1" adapt
}

# The input's vertices coloured by the sample next to them; samples are dark.
picture_retriangulation() {
	stage_meshes 4
	mv "$work/retriangulated.off" "$work/contracted.off"
	remesh "$bunny" fine.off --percent 300
	awk 'FNR == 2 { if (NR == FNR) ns = $1; else nv = $1; next }
		NR == FNR { if (FNR > 2 && n < ns && NF > 0) { x[n] = $1; y[n] = $2; z[n++] = $3 }; next }
		FNR > 2 && NF > 0 && row < nv {
			++row
			if ($3 < 0 || $1 < -0.5) { print 200, 210, 220; next }
			best = 9
			for (i = 0; i < ns; ++i) {
				dx = x[i] - $1
				if (dx > 0.1 || dx < -0.1) continue
				d = dx * dx + (y[i] - $2) ^ 2 + (z[i] - $3) ^ 2
				if (d < best) { best = d; at = i }
			}
			if (best < 0.00004) print 20, 20, 60
			else print 150 + at * 37 % 105, 150 + at * 71 % 105, 150 + at * 113 % 105
		}' "$work/contracted.off" "$work/fine.off" >"$work/cells.txt"
	with_colours "$work/fine.off" "$work/cells.txt" "$work/cells.ply"
	shot "$flank" cells.ply "${coloured[@]}"
	shot "$flank" contracted.off
	shot "$flank" flipped.off
	show retriangulation 3 "samples and their cells" cells "contracted" contracted \
		"edges flipped" flipped
}

# Vertices without six neighbours: blue for fewer, red for more.
valences() { # off, colours
	awk 'FNR == 2 { nv = $1 }
		FNR > 2 && NF > 0 && row++ >= nv { for (i = 2; i <= 4; ++i) ++count[$i] }
		END {
			for (v = 0; v < nv; ++v)
				print (count[v] < 6 ? "30 90 230" : count[v] > 6 ? "220 40 30" : "225 230 240")
		}' "$1" >"$2"
}

picture_regularity() {
	stage_meshes 10
	remesh "$bunny" relaxed.off --preset fast
	mv "$work/repaired.off" "$work/regular.off"
	local mesh
	for mesh in counted relaxed regular; do
		valences "$work/$mesh.off" "$work/$mesh.txt"
		with_colours "$work/$mesh.off" "$work/$mesh.txt" "$work/$mesh.ply"
		shot "$flank" $mesh.ply --edges "${coloured[@]}"
	done
	show regularity 3 "exact count" counted "relaxed, --preset fast" relaxed \
		"made regular, before the fit" regular
}

# Every face by its smallest angle: red up to 30 degrees, white for 60.
angles_as_colours() { # off, ply
	awk 'function square(a, b) { return (x[a] - x[b]) ^ 2 + (y[a] - y[b]) ^ 2 + (z[a] - z[b]) ^ 2 }
		# The smallest angle, in degrees, is that against the shortest side.
		function smallest(a, b, c,   p, q, r, t, cosine) {
			p = square(a, b); q = square(b, c); r = square(c, a)
			if (q < p) { t = p; p = q; q = t }
			if (r < p) { t = p; p = r; r = t }
			cosine = (q + r - p) / (2 * sqrt(q * r))
			return atan2(sqrt(1 - cosine * cosine), cosine) * 57.29578
		}
		FNR == 2 {
			nv = $1
			print "ply\nformat ascii 1.0\nelement vertex " 3 * $2
			print "property float x\nproperty float y\nproperty float z\nproperty uchar red"
			print "property uchar green\nproperty uchar blue\nproperty uchar alpha"
			print "element face " $2 "\nproperty list uchar int vertex_indices\nend_header"
		}
		FNR > 2 && NF > 0 && n < nv { x[n + 0] = $1; y[n + 0] = $2; z[n++] = $3; next }
		FNR > 2 && NF > 0 {
			white = int(255 * (smallest($2, $3, $4) - 30) / 30)
			white = white < 0 ? 0 : white > 255 ? 255 : white
			for (i = 2; i <= 4; ++i) print x[$i], y[$i], z[$i], 225, white, white, 255
			++nf
		}
		END { for (i = 0; i < nf; ++i) print 3, 3 * i, 3 * i + 1, 3 * i + 2 }' "$1" >"$2"
}

picture_angles() {
	stage_meshes 10
	remesh "$bunny" fast.off --preset fast
	remesh "$bunny" whole_way.off
	local mesh
	for mesh in counted fast whole_way; do
		angles_as_colours "$work/$mesh.off" "$work/${mesh}_angles.ply"
		shot "$whole" ${mesh}_angles.ply --edges "${coloured[@]}"
	done
	show angles 3 "exact count" counted_angles "--preset fast" fast_angles "default" whole_way_angles
}

# Three sheets at one edge; of the result each component has its own colour.
picture_repair() {
	awk 'function place(sheet, i, j) { return j == 0 ? i : n + sheet * n * (n - 1) + i * (n - 1) + j - 1 }
		BEGIN {
			n = 13
			print "OFF"
			print n + 3 * n * (n - 1), 3 * 2 * (n - 1) ^ 2, 0
			for (i = 0; i < n; ++i) print 0, i / (n - 1) - 0.5, 0
			for (s = 0; s < 3; ++s)
				for (i = 0; i < n; ++i)
					for (j = 1; j < n; ++j)
						print sin(2.1 * s + 0.5) * j / (n - 1), i / (n - 1) - 0.5, cos(2.1 * s + 0.5) * j / (n - 1)
			for (s = 0; s < 3; ++s)
				for (i = 0; i + 1 < n; ++i)
					for (j = 0; j + 1 < n; ++j) {
						print 3, place(s, i, j), place(s, i + 1, j), place(s, i + 1, j + 1)
						print 3, place(s, i, j), place(s, i + 1, j + 1), place(s, i, j + 1)
					}
		}' >"$work/sheets.off"
	remesh "$work/sheets.off" sheets_cut.off --vertices 260
	awk 'function root(v) { while (up[v] != v) v = up[v]; return v }
		FNR == 2 { nv = $1; for (v = 0; v < nv; ++v) up[v] = v }
		FNR > 2 && NF > 0 && row++ >= nv {
			for (i = 3; i <= 4; ++i) { a = root($2); b = root($i); if (a < b) up[b] = a; else up[a] = b }
		}
		END { for (v = 0; v < nv; ++v) print root(v) == 0 ? "230 150 60" : "70 120 200" }' \
		"$work/sheets_cut.off" >"$work/sheets_cut.txt"
	with_colours "$work/sheets_cut.off" "$work/sheets_cut.txt" "$work/sheets_cut.ply"
	shot "$sheets" sheets.off
	shot "$sheets" sheets_cut.ply --edges "${coloured[@]}"
	show repair 2 "input: three sheets at one edge" sheets "result: two components" sheets_cut
}

# The input coloured by its distance from a result, by MeshLab: red for none, blue from 0.015 on.
distances() { # result, ply
	cat >"$work/distance.mlx" <<END
<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Distance from Reference Mesh">
  <Param name="MeasureMesh" type="RichMesh" value="0"/>
  <Param name="RefMesh" type="RichMesh" value="1"/>
  <Param name="SignedDist" type="RichBool" value="false"/>
  <Param name="MaxDist" type="RichAbsPerc" value="0.2" min="0" max="4"/>
 </filter>
 <filter name="Change the current layer"><Param name="layer" type="RichMesh" value="0"/></filter>
 <filter name="Colorize by vertex Quality">
  <Param name="minVal" type="RichFloat" value="0"/>
  <Param name="maxVal" type="RichFloat" value="0.015"/>
  <Param name="perc" type="RichDynamicFloat" value="0" min="0" max="100"/>
  <Param name="zeroSym" type="RichBool" value="false"/>
 </filter>
</FilterScript>
END
	with_display "$work/display" "$build/meshlab/bin/meshlabserver" -i "$bunny" "$work/$1" -o "$2" -m vc \
		-s "$work/distance.mlx" >"$work/distance.log" 2>&1 || {
		tail -5 "$work/distance.log" >&2
		fail "meshlabserver failed"
	}
}

picture_fit() {
	remesh "$bunny" unfitted.ply --percent 3 --preset fast
	remesh "$bunny" fitted.ply --percent 3
	local mesh
	for mesh in unfitted fitted; do
		distances $mesh.ply "$work/far_$mesh.ply"
		shot "$whole" far_$mesh.ply "${coloured[@]}"
	done
	show fit 2 "--preset fast" far_unfitted "default" far_fitted
}

# Stripes round the bunny, and what is left of them.
picture_attributes() {
	remesh "$bunny" same.off --percent 100
	awk 'FNR == 2 { nv = $1 }
		FNR > 2 && NF > 0 && row++ < nv {
			print int(8 * ($2 + 2 * $3 + 9)) % 2 ? "230 120 30" : "40 70 160"
		}' "$work/same.off" >"$work/stripes.txt"
	with_colours "$work/same.off" "$work/stripes.txt" "$work/striped.ply"
	remesh "$work/striped.ply" striped_small.ply
	shot "$whole" striped.ply "${coloured[@]}"
	shot "$whole" striped_small.ply --edges "${coloured[@]}"
	show attributes 2 "input" striped "10 %% of the vertices" striped_small
}
