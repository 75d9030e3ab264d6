// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline.h"

#include <tests/support/mesh_audit.h>
#include <vcg_extras/core/remesh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace gpr::test {

namespace {

/// Returns bytes from the front; zeros when there are none left.
class Bytes {
public:
	Bytes(const std::uint8_t* data, std::size_t size) : at_(data), left_(size) {}

	std::size_t left() const { return left_; }
	int         next()
	{
		if (left_ == 0) return 0;
		--left_;
		return *at_++;
	}
	/// In [0, n).
	int below(int n) { return next() % n; }

private:
	const std::uint8_t* at_;
	std::size_t         left_;
};

/// Mostly 0 to 7; now and then a number that no file should hold.
double coordinate(int byte)
{
	switch (byte) {
	case 255:
		return std::numeric_limits<double>::quiet_NaN();
	case 254:
		return std::numeric_limits<double>::infinity();
	case 253:
		return 1000;
	case 252:
		return 1e-7;
	default:
		return byte & 7;
	}
}

void readSize(Bytes& bytes, RemeshOptions& o)
{
	const int size = bytes.next();
	if (size < 128) {
		o.targetMode      = TargetMode::VertexNum;
		o.targetVertexNum = 1 + size;
	}
	else if (size < 192) {
		o.targetPercent = 10 * (size - 127);
	}
	else {
		o.targetMode    = TargetMode::EdgeLength;
		o.targetEdgeLen = 0.1 * (size - 191);
	}
}

void readOptions(Bytes& bytes, RemeshOptions& o)
{
	o.preset = Preset(bytes.below(3));
	readSize(bytes, o);
	const int bits = bytes.next();
	o.allowNearest = bits & 1;
	o.lambda       = (bits & 4) ? 1 : 0;
	if (bits & 2) o.adapt = (bits & 8) ? 1 : 0;
	o.featureMode      = (bits & 16) ? FeatureMode::Lines : o.featureMode;
	o.featureDiskScale = (bits & 32) ? 0.4 : 0;
	o.guard            = !(bits & 64);
	o.check            = bits & 128;
	const int more     = bytes.next();
	o.featureRegion    = FeatureRegion(more % 3);
	o.umbrellaSteps    = more / 3 % 7;
	if (more & 64) o.dropComponentsBelow = 3;
	o.seed    = 1 + std::uint32_t(bytes.next());
	o.threads = 1;
}

std::string complaintsAboutStatus(Status status, const std::string& message)
{
	const bool isRefusal = status == Status::CountTooSmall || status == Status::UnusableInput ||
						   status == Status::BadOptions || status == Status::OutOfMemory;
	// A result may be withheld if only degenerate faces hold the surface together, if a check finds
	// self-intersections, if sheets lie at one place, or if no mesh meets the error bound.
	const bool isWithheld = status == Status::PromiseBroken &&
							(message.find("degenerate faces") != std::string::npos ||
							 message.find("self-intersecting") != std::string::npos ||
							 message.find("other junctions") != std::string::npos ||
							 message.find("was not reached") != std::string::npos);
	if (!isRefusal && !isWithheld) return std::string(statusName(status)) + ": " + message;
	return message.empty() || message.back() != '.' ? "no sentence" : "";
}

std::string complaintsAboutMesh(const RemeshResult& r, const RemeshOptions& o)
{
	const SurfaceFacts facts = factsOf(r.mesh);
	const MeshFigures& input = r.report.cleanedInput;
	std::string        text  = facts.complaints();
	if (facts.components != input.components) text += " components";
	if (facts.boundaryLoops != input.boundaryLoops) text += " boundary loops";
	if (facts.euler() != input.eulerCharacteristic) text += " Euler";
	const bool promised = !isPaper(o) && r.sampleOf.empty();
	if (promised && std::int64_t(r.mesh.vertexNum()) != r.report.targetVertexNum) text += " count";
	return text;
}

/// Complaints about a result with junctions, which is no manifold.
std::string complaintsAboutSheets(const RemeshResult& r, const RemeshOptions& o)
{
	const SurfaceFacts facts = factsOf(r.mesh);
	std::string        text;
	if (facts.indicesOutOfRange + facts.repeatedCorners + facts.duplicateFaces > 0)
		text += " faces";
	if (facts.unusedVertices + facts.notFinite > 0) text += " vertices";
	if (facts.zeroAreaFaces > 0) text += " without area";
	if (!r.report.audit.junctionsKept) text += " junctions";
	const bool isOrder = !o.allowNearest; // sheets at one place may change the count of a wish
	if (isOrder && std::int64_t(r.mesh.vertexNum()) != r.report.targetVertexNum) {
		text += " " + std::to_string(r.mesh.vertexNum()) + " vertices in place of " +
				std::to_string(r.report.targetVertexNum);
	}
	return text;
}

std::string complaintsAboutRegions(const MeshView& view, const RemeshResult& r)
{
	if (view.region == nullptr) return r.region.empty() ? "" : " regions of nothing";
	if (r.region.size() != r.mesh.faceNum()) return " regions";
	const std::set<std::int32_t> labels(view.region, view.region + view.faceNum);
	for (const std::int32_t label : r.region) {
		if (labels.count(label) == 0) return " a label that is not there";
	}
	return "";
}

/// Complaints about a periodic result: along an axis with a period, the result is at least a period
/// wide.
std::string complaintsAboutPeriod(const RemeshResult& r, const RemeshOptions& o)
{
	const double period[3] = {o.period.x, o.period.y, o.period.z};
	std::string  text;
	for (int axis = 0; axis < 3; ++axis) {
		if (!(period[axis] > 0)) continue;
		double least = HUGE_VAL, most = -HUGE_VAL;
		for (const Vec3d& p : r.mesh.positions) {
			const double x = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
			least          = std::min(least, x);
			most           = std::max(most, x);
		}
		if (most - least < period[axis] * (1 - 1e-9)) text += " period";
	}
	return text;
}

std::string runRemesh(const MeshView& view, const RemeshOptions& o)
{
	const RemeshResult r = remesh(view, o);
	if (r.status != Status::Ok) return complaintsAboutStatus(r.status, r.message);
	const bool        meets = o.junctions == JunctionMode::Keep && !isPaper(o);
	const std::string text  = meets ? complaintsAboutSheets(r, o) : complaintsAboutMesh(r, o);
	return text + complaintsAboutRegions(view, r) + complaintsAboutPeriod(r, o);
}

std::string runSample(const MeshView& view, const RemeshOptions& o)
{
	const SamplingResult r = samplePoissonDisks(view, o);
	if (r.status != Status::Ok) return complaintsAboutStatus(r.status, r.message);
	for (const Vec3d& p : r.points) {
		if (!std::isfinite(p.x + p.y + p.z)) return "a point that is not finite";
	}
	return r.points.empty() ? "no points" : "";
}

/// Every third vertex, a little off the surface.
std::string runRetriangulate(const FuzzCase& c, const MeshView& view)
{
	std::vector<Vec3d> points;
	for (std::size_t v = 0; v < c.mesh.vertexNum(); v += 3) {
		const Vec3d& p = c.mesh.positions[v];
		if (std::isfinite(p.x + p.y + p.z)) points.push_back(p + Vec3d(0.1, 0.2, -0.1));
	}
	const RemeshResult r = retriangulate(view, points, c.options);
	if (r.status != Status::Ok) return complaintsAboutStatus(r.status, r.message);
	return complaintsAboutMesh(r, c.options);
}

std::string runDetect(const FuzzCase& c, const MeshView& view)
{
	const FeatureResult r = detectFeatures(view, c.options);
	if (r.status != Status::Ok) return complaintsAboutStatus(r.status, r.message);
	const bool complete = r.vertexStrength.size() == c.mesh.vertexNum() &&
						  r.vertexFeature.size() == c.mesh.vertexNum() &&
						  r.faceMark.size() == c.mesh.faceNum();
	return complete ? "" : "arrays of another length";
}

/// Makes a case small: few vertices, none so far off that splits of long edges make thousands of
/// faces.
void makeSmall(FuzzCase& c)
{
	RemeshOptions& o  = c.options;
	o.targetVertexNum = 1 + o.targetVertexNum % 16;
	o.targetPercent   = 5 * (1 + std::int64_t(o.targetPercent) / 10 % 16);
	o.targetEdgeLen   = 2 + o.targetEdgeLen;
	for (Vec3d& p : c.mesh.positions) {
		for (double* x : {&p.x, &p.y, &p.z}) {
			if (std::isfinite(*x)) *x = std::min(*x, 20.0);
		}
	}
}

} // namespace

FuzzCase caseOf(const std::uint8_t* data, std::size_t size, CaseSize caseSize)
{
	const bool isSmall = caseSize == CaseSize::Small;
	const int  most    = isSmall ? 40 : 200;
	Bytes      bytes(data, size);
	FuzzCase   c;
	c.tool = FuzzCase::Tool(std::max(0, bytes.below(8) - 4)); // the remeshing most often
	readOptions(bytes, c.options);
	const int vertexNum = bytes.below(48);
	for (int v = 0; v < vertexNum; ++v) {
		const double x = coordinate(bytes.next()), y = coordinate(bytes.next());
		c.mesh.positions.push_back({x, y, coordinate(bytes.next())});
		c.selected.push_back(v % 4 == 0);
	}
	while (vertexNum > 0 && bytes.left() >= 3 && int(c.mesh.faceNum()) < most) {
		for (int k = 0; k < 3; ++k) {
			const int v = bytes.next();
			c.mesh.triangles.push_back(v == 255 ? -1 : v % vertexNum);
		}
	}
	if (isSmall) makeSmall(c);
	return c;
}

FuzzCase caseOfParts(const std::uint8_t* data, std::size_t size)
{
	FuzzCase       c    = caseOf(data, size, CaseSize::Small);
	RemeshOptions& o    = c.options;
	const int      bits = size > 0 ? data[size - 1] : 0;
	c.tool              = FuzzCase::Tool::Remesh;
	o.featureRegion     = FeatureRegion::None;
	o.junctions         = (bits & 1) ? JunctionMode::Keep : JunctionMode::Cut;
	if (bits & 2) o.boundary = BoundaryMode::Match;
	if ((bits & 12) == 12) o.period = {7, (bits & 16) ? 7.0 : 0, 0};
	for (std::size_t f = 0; f < c.mesh.faceNum(); ++f)
		c.region.push_back((c.mesh.triangles[3 * f] + bits) % (1 + bits / 64));
	return c;
}

std::string complaintsAbout(const FuzzCase& c)
{
	MeshView view = c.mesh.view();
	view.selected = c.selected.data();
	if (!c.region.empty()) view.region = c.region.data();
	switch (c.tool) {
	case FuzzCase::Tool::Remesh:
		return runRemesh(view, c.options);
	case FuzzCase::Tool::Sample:
		return runSample(view, c.options);
	case FuzzCase::Tool::Retriangulate:
		return runRetriangulate(c, view);
	case FuzzCase::Tool::Detect:
		return runDetect(c, view);
	}
	return "";
}

} // namespace gpr::test
