// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Colours, texture coordinates and selections of real models; see real_meshes_test.cpp.

#include <tests/support/mesh_audit.h>
#include <tests/support/model_files.h>
#include <tests/support/random_source.h>
#include <tests/support/stages.h>
#include <vcg_extras/core/carry_over.h>
#include <vcg_extras/core/remesh.h>
#include <vcg_extras/core/surface/barycentric_point.h>
#include <vcg_extras/core/surface/nearest_on_mesh.h>
#include <vcg_extras/core/surface/surface_point.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

namespace gpr::test {

namespace {

app::InputMesh readWithAttributes(const std::string& path)
{
	app::WantedAttributes wanted;
	wanted.carried = true;
	return app::readMesh(path, wanted);
}

/// Nearest points of a mesh, as points of its faces.
class NearestPoints {
public:
	explicit NearestPoints(const MeshView& view) :
			workers_(2, nullptr), view_(view), surface_(surfaceOf(triangleMeshOf(view), workers_)),
			tree_(surface_.mesh, workers_)
	{
	}
	BarycentricPoint of(const Vec3d& p) const
	{
		return barycentricPoint(view_, surface_, tree_.nearest(surface_.frame.toWorking(p)));
	}

private:
	Workers       workers_;
	MeshView      view_;
	Surface       surface_;
	NearestOnMesh tree_;
};

using Colour = std::array<double, 3>;

Colour colourAt(const app::MeshAttributes& a, const std::int32_t* triangles,
				const BarycentricPoint& at)
{
	Colour            colour;
	const char* const names[] = {"red", "green", "blue"};
	for (std::size_t i = 0; i < 3; ++i) {
		const app::ValueColumn& column = *a.ofVertex(names[i]);
		colour[i]                      = meanOfCorners(
								 at, [&](int k) { return column.values[std::size_t(triangles[3 * at.face + k])]; });
	}
	return colour;
}

double difference(const Colour& a, const Colour& b)
{
	double sum = 0;
	for (std::size_t i = 0; i < 3; ++i)
		sum += std::abs(a[i] - b[i]) / 3;
	return sum;
}

BarycentricPoint randomPoint(const TriangleMesh& mesh, Random& random)
{
	BarycentricPoint at;
	at.face        = std::int32_t(random.below(int(mesh.faceNum())));
	const double s = std::sqrt(random.unit()), t = random.unit();
	at.weight[0] = float(1 - s);
	at.weight[1] = float(s * (1 - t));
	at.weight[2] = float(s * t);
	return at;
}

Vec3d positionOf(const TriangleMesh& mesh, const BarycentricPoint& at)
{
	Vec3d p;
	for (int k = 0; k < 3; ++k)
		p += mesh.positions[std::size_t(mesh.triangles[std::size_t(3 * at.face + k)])] *
			 double(at.weight[k]);
	return p;
}

TEST(RealAttributes, LauranaKeepsHerColours)
{
	const ModelFile model = findModel("laurana_50k_colour_open.ply");
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	const app::InputMesh      input = readWithAttributes(model.path);
	const app::MeshAttributes truth = input.attributes;
	const RemeshResult        r     = remesh(input.view(), RemeshOptions());
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	app::MeshAttributes       source  = truth;
	const app::MeshAttributes carried = carryAttributes(source, input.view(), nullptr, r);
	const NearestPoints       nearest(input.view());

	// vcglib's own transfer gives a vertex the colour of the nearest point.
	app::MeshAttributes vcglibs = carried;
	double              sum     = 0;
	for (std::size_t v = 0; v < r.mesh.vertexNum(); ++v) {
		const Colour there =
			colourAt(truth, input.triangles.data(), nearest.of(r.mesh.positions[v]));
		std::size_t i = 0;
		Colour      here;
		for (app::ValueColumn& column : vcglibs.ofVertices) {
			if (column.name != "red" && column.name != "green" && column.name != "blue") continue;
			here[i]          = column.values[v];
			column.values[v] = there[i++];
		}
		sum += difference(here, there);
	}
	const double atVertices = sum / double(r.mesh.vertexNum());
	EXPECT_LE(atVertices, 2);

	double    ours = 0, theirs = 0;
	Random    random(1);
	const int pointNum = 20000;
	for (int i = 0; i < pointNum; ++i) {
		const BarycentricPoint at = randomPoint(r.mesh, random);
		const Colour           wanted =
			colourAt(truth, input.triangles.data(), nearest.of(positionOf(r.mesh, at)));
		ours += difference(wanted, colourAt(carried, r.mesh.triangles.data(), at)) / pointNum;
		theirs += difference(wanted, colourAt(vcglibs, r.mesh.triangles.data(), at)) / pointNum;
	}
	EXPECT_LE(ours, theirs + 0.1);
	std::printf("mean difference of 255: %.3f at vertices; %.3f at random points, %.3f by vcglib's "
				"transfer\n",
				atVertices, ours, theirs);
}

using TexturePoint = std::array<double, 2>;

TexturePoint textureAt(const CornerTexture& texture, const BarycentricPoint& at)
{
	TexturePoint p;
	for (std::size_t i = 0; i < 2; ++i) {
		p[i] = meanOfCorners(at, [&](int k) {
			return texture.uv[6 * std::size_t(at.face) + 2 * std::size_t(k) + i];
		});
	}
	return p;
}

double distance(const TexturePoint& a, const TexturePoint& b)
{
	return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Whether all corners have the texture of their places, as in faces without a seam.
bool isAwayFromSeams(const RemeshResult& r, const CornerTexture& carried,
					 const CornerTexture& truth, std::size_t f)
{
	for (std::size_t k = 0; k < 3; ++k) {
		const BarycentricPoint& at = r.surfacePoints[std::size_t(r.mesh.triangles[3 * f + k])];
		const TexturePoint      here{double(carried.uv[6 * f + 2 * k]),
                                double(carried.uv[6 * f + 2 * k + 1])};
		if (distance(here, textureAt(truth, at)) > 1e-5) return false;
	}
	return true;
}

TEST(RealAttributes, BunnyKeepsItsTexture)
{
	const ModelFile model = findModel("bunny10k_uv_open.obj");
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	app::InputMesh input = readWithAttributes(model.path);
	ASSERT_TRUE(input.attributes.hasTexture());
	const CornerTexture truth = input.attributes.texture;
	const TextureSource source(input.view(), truth);
	ASSERT_TRUE(source.hasSeams());
	const NearestPoints nearest(input.view());
	// 190 charts: few vertices cannot follow all seams, 100 percent of the vertices can.
	for (const double percent : {10.0, 30.0, 100.0}) {
		SCOPED_TRACE(percent);
		MeshView view = input.view();
		view.line     = source.seams().data();
		RemeshOptions options;
		options.targetPercent        = percent;
		options.surfacePointsOfFaces = true;
		const RemeshResult r         = remesh(view, options);
		ASSERT_EQ(r.status, Status::Ok) << r.message;
		const CornerTexture carried = source.carriedTo(r);

		// A face across a seam would be stretched over the space between two charts.
		double longest = 0;
		for (std::size_t c = 0; c < r.mesh.triangles.size(); ++c) {
			const std::size_t  next = c % 3 == 2 ? c - 2 : c + 1;
			const TexturePoint a{double(carried.uv[2 * c]), double(carried.uv[2 * c + 1])};
			const TexturePoint b{double(carried.uv[2 * next]), double(carried.uv[2 * next + 1])};
			longest = std::max(longest, distance(a, b));
		}
		Random random(2);
		double sum = 0;
		int    num = 0, beyond = 0;
		for (int i = 0; i < 20000; ++i) {
			const BarycentricPoint at = randomPoint(r.mesh, random);
			if (!isAwayFromSeams(r, carried, truth, std::size_t(at.face))) continue;
			const BarycentricPoint there = nearest.of(positionOf(r.mesh, at));
			const double           miss = distance(textureAt(carried, at), textureAt(truth, there));
			// The nearest point of a place beside a seam may lie beyond the seam.
			beyond += miss > 0.1;
			if (miss > 0.1) continue;
			sum += miss;
			++num;
		}
		ASSERT_GT(num, 500);
		EXPECT_LE(sum / num, 0.005);
		EXPECT_LE(beyond, num / 50);
		EXPECT_LE(longest, 0.15);
		std::printf(
			"%g %%: mean miss %.5f at %d points away from seams (%d taken beyond one), longest "
			"edge %.3f, %lld edges of lines\n",
			percent, sum / num, num, beyond, longest,
			static_cast<long long>(r.report.featureEdgeNum));
	}
}

TEST(RealAttributes, HalfOfIgeaStaysBitForBit)
{
	const ModelFile model = findModel("igea_269k.ply");
	if (!model.isThere()) GTEST_SKIP() << model.missing;
	app::InputMesh            input = app::readMesh(model.path);
	std::vector<std::uint8_t> selected;
	MeshView                  view = input.view();
	for (std::size_t f = 0; f < view.faceNum; ++f)
		selected.push_back(view.position(std::size_t(view.vertexOf(3 * f))).x > 0);
	view.selectedFace = selected.data();
	RemeshOptions options;
	options.selectedOnly = true;
	const RemeshResult r = remesh(view, options);
	ASSERT_EQ(r.status, Status::Ok) << r.message;
	EXPECT_TRUE(isSoundSurface(r.mesh));
	std::size_t next = 0;
	for (std::size_t f = 0; f < view.faceNum; ++f) {
		if (selected[f]) continue;
		for (std::size_t k = 0; k < 3; ++k) {
			const Vec3d a = view.position(std::size_t(view.vertexOf(3 * f + k)));
			const Vec3d b = r.mesh.positions[std::size_t(r.mesh.triangles[3 * next + k])];
			ASSERT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z);
		}
		++next;
	}
	EXPECT_LT(r.report.quality.below30Percent, 3);
	EXPECT_GT(r.report.quality.radiusRatioMean, 0.95);
}

} // namespace

} // namespace gpr::test
