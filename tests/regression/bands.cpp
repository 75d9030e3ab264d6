// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bands.h"

#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

namespace gpr::test {

namespace {

constexpr Target percent(double value)
{
	return {TargetMode::Percent, value};
}

constexpr Target vertices(double num)
{
	return {TargetMode::VertexNum, num};
}

/// A largest distance in percent of the diagonal, and the most vertices for this distance. If few
/// places decide, the count may differ by a factor of two between seeds.
constexpr Target error(double value, std::int64_t mostVertices)
{
	return {TargetMode::MaxError, value, mostVertices};
}

// Files of GPR_MODELS_DIR.
constexpr char igea[]      = "igea_269k.ply";
constexpr char facemask[]  = "facemask_62k_open.ply";
constexpr char laurana[]   = "laurana_50k_colour_open.ply";
constexpr char terrain[]   = "terrain_N44W072_2.9M_open.ply";
constexpr char iguana[]    = "iguana_ct_skin_1.9M.ply";
constexpr char casting[]   = "casting_10k_genus9.ply";
constexpr char cheese[]    = "cheese_18k_genus133.ply";
constexpr char rockerarm[] = "rockerarm_20k.ply";
constexpr char gargoyle[]  = "gargoyle_96k.ply";
constexpr char fandisk[]   = "fandisk_13k_cad.ply";
constexpr char adis[]      = "cad_adis_7k_genus24.stl";
constexpr char vessels[]   = "ct_vessels_1.5M_1803comp.ply.gz";
// A file of Debian's glmark2-data, which scripts/setup installs.
constexpr char bunny[] = "bunny.obj";

using Change = void (*)(RemeshOptions&);

const std::map<std::string, Change>& changes()
{
	static const std::map<std::string, Change> all = {
		{"fast", [](RemeshOptions& o) { o.preset = Preset::Fast; }},
		{"paper", [](RemeshOptions& o) { o.preset = Preset::Paper; }},
		{"even", [](RemeshOptions& o) { o.adapt = 0; }},
		{"adapt1", [](RemeshOptions& o) { o.adapt = 1; }},
		{"keep", [](RemeshOptions& o) { o.boundary = BoundaryMode::Keep; }},
		{"free", [](RemeshOptions& o) { o.boundary = BoundaryMode::Free; }},
		{"smooth", [](RemeshOptions& o) { o.boundary = BoundaryMode::Smooth; }},
		{"lines", [](RemeshOptions& o) { o.featureMode = FeatureMode::Lines; }},
		{"region", [](RemeshOptions& o) { o.featureRegion = FeatureRegion::Detected; }},
		{"open", [](RemeshOptions&) {}},
	};
	return all;
}

} // namespace

std::ostream& operator<<(std::ostream& out, const Band& band)
{
	return out << band.file << " " << band.options;
}

void applyWords(const char* words, RemeshOptions& options)
{
	std::istringstream in(words);
	for (std::string word; in >> word;) {
		const auto change = changes().find(word);
		if (change == changes().end()) throw std::logic_error("no option of a band: " + word);
		change->second(options);
	}
}

bool isOpened(const Band& band)
{
	return std::string(band.options).find("open") != std::string::npos;
}

// clang-format off
std::vector<Band> bands()
{
	return {
		// at least:                                           2r/R   aspect angle val6  at most: <30   inv   rms     p999  H     rim    creases
		{"BunnyTo10",         bunny, "",           percent(10),       .983,  .937,  31.5, 88.5,  0,     0,    .0425,  .22,  .41,  any,   any,  Apart | NoLines},
		{"BunnyTo10Even",     bunny, "even",       percent(10),       .985,  .942,  32,   90,   0,     0,    .0435,  .28,  .75,  any,   any,  Apart | NoLines},
		{"BunnyTo10Adapted",  bunny, "adapt1",     percent(10),       .972,  .915,  30,   86,   0,     0,    .0410,  .17,  .34,  any,   any,  Apart | NoLines},
		{"BunnyTo10Fast",     bunny, "fast",       percent(10),       .981,  .937,  32,   86.5, 0,     0,    .109,   .86,  1.35, any,   any,  Apart | NoLines},
		{"BunnyTo2",          bunny, "",           percent(2),        .962,  .9,    31.5, 79.5, 0,     0,    .18,    1.43, 2.3,  any,   any,  Apart | NoLines},
		{"BunnyTo10Paper",    bunny, "paper",      percent(10),       .937,  .859,  22, 46,   .43,   0,    .104,   .68,  1.13, any,   any,  NoLines},
		{"BunnyWithin02",     bunny, "",           error(.2, 2900),   .94,   .872,  18,   71.5,   .3,    0,    .057,   .177, any,  any,   any,  Apart | NoLines},
		{"BunnyTo10Region",   bunny, "region",     percent(10),       .976,  .92,   32,   84,   0,     0,    .048,   .206, .35,  any,   any,  Apart | NoLines},
		// The option 'lines' forbids the release of lines, even of noisy lines.
		{"BunnyTo10Lines",    bunny, "lines",      percent(10),       .942,  .886,  any,  78,   3.2,   any,  .046,   .29,  .52,  any,   any,  None},
		{"OpenBunnyTo10",     bunny, "open",       percent(10),       .981,  .935,  27,   88.5,  .021,  0,    .041,   .196,  .45,  .1,    any,  Apart | NoLines},
		{"OpenBunnyTo20Keep", bunny, "open keep",  percent(20),       .981,  .934,  31.5, 89.5, 0,     0,    .0275,  .131, .235, 0,     any,  Apart | NoLines},
		{"OpenBunnyTo10Free", bunny, "open free",  percent(10),       .981,  .936,  28,   88.5,  .021,    0,    .041,   .177, .33,  .1,    any,  Apart | NoLines},
		{"OpenBunnyTo10Smooth", bunny, "open smooth", percent(10),    .984,  .94,   31.5, 89,   0,     0,    .041,   .187, .58,  .28,   any,  Apart | NoLines},

		{"IgeaTo5",           igea, "even",        vertices(13434),   .9915, .96,   31,   94,   0,     0,    .0162,  any,  any,  any,   any,  None},
		{"IgeaTo5Adapted",    igea, "adapt1",      vertices(13434),   .98,   .935,  29.5, 90,   0,     0,    .0143,  any,  any,  any,   any,  None},
		{"FacemaskTo10",      facemask, "even",    percent(10),       .989,  .954,  32,   92,   0,     any,  .0143,  any,  any,  .15,   any,  None},
		// Its rim is ragged.
		{"LauranaTo10",       laurana, "even",     percent(10),       .981,  .935,  31,   90,   0,     any,  .06,    any,  any,  .105,  any,  None},
		{"TerrainTo10",       terrain, "even",     percent(10),       .993,  .966,  31,   94,   0,     any,  .0029,  any,  any,  .15,   any,  None},
		// Its feet are thinner than an edge.
		{"IguanaTo10",        iguana, "even",      percent(10),       .977,  any,   8,    89,   .02,   any,  .023,   any,  any,  any,   any,  None},
		// The crowded lines of this model are released; crease edges may be rounded there. Over ten
		// seeds the smallest angle is 24 to 32°, and 76.7 to 79.8 % of the vertices have six edges.
		{"CastingTo50",       casting, "even",     percent(50),       .952,  any,   24,   76,   .15,   any,  .105,   any,  any,  any,   .36,  None},
		// With every second seed, one or two of the thousand triangles stay poor; with some seeds,
		// a patch is made anew for one contact.
		{"CastingTo10",       casting, "even",     percent(10),       .88,   any,   15,   any,  2.5,   any,  .3,     any,  any,  any,   any,  None},
		// Half of its vertices are on creases.
		{"CheeseTo50",        cheese, "even",      percent(50),       .79,   any,   any,  any,  19,    any,  .27,    any,  any,  any,   any,  None},
		{"RockerarmTo100",    rockerarm, "even",   percent(100),      .991,  any,   31,   93,   any,   any,  .0252,  any,  any,  any,   any,  None},
		{"RockerarmTo200",    rockerarm, "even",   percent(200),      .992,  any,   31,   93,   any,   any,  .0178,  any,  any,  any,   any,  None},
		{"RockerarmTo10",     rockerarm, "even",   percent(10),       .967,  any,   31,   81,   any,   any,  .124,   any,  any,  any,   any,  NoLines},
		{"GargoyleTo10",      gargoyle, "even",    percent(10),       .965,  any,   31,   82,   any,   any,  .0905,  any,  any,  any,   any,  None},
		{"FandiskTo50",       fandisk, "even",     percent(50),       .975,  any,   22,   any,  .05,   any,  .0088,  any,  any,  any,   .1,   None},
		{"FandiskTo20",       fandisk, "even",     percent(20),       .965,  any,   22,   any,  .08,   any,  .0225,  any,  any,  any,   .1,   None},
		{"FandiskTo10",       fandisk, "even",     percent(10),       .944,  any,   22,   any,  .2,    any,  .0425,  any,  any,  any,   .1,   None},

		// Tunnels and walls thinner than the triangles, in models without self-intersections.
		{"AdisThin",          adis, "even",        vertices(2500),    .91,   any,   any,  any,  any,   12,   any,    any,  2.5,  any,   any,  Apart},
		{"AdisThinAdapted",   adis, "adapt1",      vertices(2500),    .87,   any,   any,  any,  any,   12,   any,    any,  2.5,  any,   any,  Apart},
		{"AdisThinFast",      adis, "fast even",   vertices(2500),    .9,    any,   any,  any,  any,   12,   any,    any,  2.5,  any,   any,  Apart},
		{"CastingThin",       casting, "even",     vertices(500),     .85,   any,   any,  any,  any,   12,   any,    any,  2.5,  any,   any,  Apart},
		{"CastingThinFastAdapted", casting, "fast adapt1", vertices(500), .77, any, any,  any,  any,   12,   any,    any,  2.5,  any,   any,  Apart},
		// A vessel of six edges was drawn together: 2.1 %.
		{"VesselsThin",       vessels, "",         vertices(75000),   .9,    any,   any,  any,  any,   1500, any,    any,  1.3,  any,   any,  Apart},

		{"CastingWithin01",   casting, "",         error(.1, 4800),  any,   any,   any,  any,  any,   any,  any,    any,  any,  any,   any,  None},
		{"FandiskWithin01",   fandisk, "",         error(.1, 1700),   any,   any,   any,  any,  any,   any,  any,    any,  any,  any,   any,  None},
		{"GargoyleWithin01",  gargoyle, "",        error(.1, 16000),  any,   any,   any,  any,  any,   any,  any,    any,  any,  any,   any,  None},
		{"IgeaWithin01",      igea, "",            error(.1, 6500),   any,   any,   any,  any,  any,   any,  any,    any,  any,  any,   any,  None},
		{"RangemapWithin03",  "rangemap_lato315_121k_open_32comp.ply", "", error(.3, 2200),  any,   any,   any,  any,  any,   any,  any,    any,  any,  any,   any,  None},

		// The paper's own Table 1 has .824 to .835.
		{"IgeaTo10Paper",     igea, "paper",       percent(10),       any,   .843,  any,  any,  any,   any,  any,    any,  any,  any,   any,  None},
		{"GargoyleTo10Paper", gargoyle, "paper",   percent(10),       any,   .843,  any,  any,  any,   any,  any,    any,  any,  any,   any,  None},
		{"HumanTo10Paper",    "human_49k.ply", "paper", percent(10),  any,   .843,  any,  any,  any,   any,  any,    any,  any,  any,   any,  None},
		{"FacemaskTo10Paper", facemask, "paper",   percent(10),       any,   .843,  any,  any,  any,   any,  any,    any,  any,  any,   any,  None},
		{"LauranaTo10Paper",  laurana, "paper",    percent(10),       any,   .843,  any,  any,  any,   any,  any,    any,  any,  any,   any,  None},

		{"AbominevoleTo30",   "abominevole_51k_nonmanifold.off", "",       percent(30), any, any, any, any, any, any, any, any, any, any, any, Repaired},
		{"MotorbikeTo30",     "motorbike_332k_nonmanifold.ply", "",        percent(30), any, any, any, any, any, any, any, any, any, any, any, Repaired},
		{"TripleVierbeinTo30", "triple_vierbein_nonmanifold_edges.obj", "", percent(30), any, any, any, any, any, any, any, any, any, any, any, Repaired},
		{"HourglassTo30",     "hourglass_nonmanifold_vertex.obj", "",      percent(30), any, any, any, any, any, any, any, any, any, any, any, Repaired},
	};
}
// clang-format on

} // namespace gpr::test
