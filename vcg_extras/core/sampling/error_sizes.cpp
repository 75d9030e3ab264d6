// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_sizes.h"

#include "size_grading.h"
#include "target.h"

#include <vcg_extras/core/base/poller.h>
#include <vcg_extras/core/base/sort_unique.h>
#include <vcg_extras/core/mesh/line_cut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gpr {

namespace {

/// The number of disk radii, from the smallest size to the largest in geometric steps.
constexpr int radiusNum = 5;
/// Radius of the disk to be flat, over the edge: twice the radius takes longer and gives no smaller
/// distances.
constexpr float radiusOfEdge = 0.5f;
/// The smallest size, over the even size: smaller sizes gain nothing.
constexpr float smallestShare = 0.25f;
/// Disks for each square of an even edge. With three, some tips fall between the disks.
constexpr float disksPerSquare = 5;
/// The number of consecutive disks that are left out together on nearly flat ground.
constexpr std::size_t centresTogether = 8;
/// The number of disks for the first guess of ε, later corrected by all bent disks; the number of
/// vertices for the noise.
constexpr std::size_t guessingDiskNum = 1500, noiseVertexNum = 8000;
/// Least ε over the noise: a disk of noise has about four deviations from end to end.
constexpr float noiseFactor = 2.5f;
/// Grading adds small triangles, and ε usually grows for them by this factor.
constexpr float usualRaise = 1.35f;
/// If normals turn by the angle α from their mean, a disk rises by half of its radius times sin α
/// on a ridge, and by a quarter on round ground. In practice 1.6 misses one to three bent disks of
/// a hundred, only slightly bent, and saves three of four extents.
constexpr float sinePerSlope = 1.6f;
using Radii                  = std::array<float, radiusNum>;
using Flatness               = std::array<float, radiusNum>; ///< at each radius, never falling

Radii radiiFor(float even, float largest)
{
	Radii       radii;
	const float ratio = largest / (smallestShare * even);
	const float step  = std::sqrt(std::sqrt(ratio)); // the fourth root: five radii
	float       edge  = smallestShare * even;
	for (float& radius : radii) {
		radius = radiusOfEdge * edge;
		edge *= step;
	}
	return radii;
}

/// The area nearest to a vertex: a third of its faces.
float ownArea(const RingSum& ring)
{
	return ring.area / 6;
}
/// 1 on flat ground, less if the normals of the faces differ.
float flatnessOf(const RingSum& ring)
{
	return ring.area > 0 ? length(ring.normal) / ring.area : 1;
}

void ensureRings(Surface& surface, Workers& workers)
{
	const HalfEdgeMesh& m = surface.mesh;
	if (!surface.ring.empty()) return;
	surface.ring.reset(std::size_t(m.vertexNum));
	workers.forEach(surface.ring.size(), [&](int v) { surface.ring[v] = ringSum(m, v); });
}

/// The part of the surface within a ball round a vertex and connected to the vertex by edges inside
/// the ball. So a disk holds the other side of a thin sheet only round a rim. Edges that leave the
/// ball are cut there: a disk sees as much of long edges as of short edges.
class Disk {
public:
	struct Member {
		float squaredDistance;
		int   vertex;
		Vec3f place; ///< seen from the centre
	};

	explicit Disk(const HalfEdgeMesh& mesh) : mesh_(mesh), isMember_(std::size_t(mesh.vertexNum)) {}

	void collect(int centre, float radius, Poller& poller)
	{
		forget();
		const Vec3f middle = mesh_.position[centre];
		squaredRadius_     = radius * radius;
		add({0, centre, Vec3f()});
		for (std::size_t next = 0; next < members_.size(); ++next) {
			poller.count(); // a disk may be the whole surface
			const Member from = members_[next];
			forEachNeighbour(mesh_, from.vertex, [&](int w) {
				const Vec3f to       = mesh_.position[w] - middle;
				const float distance = squaredLength(to);
				if (distance <= squaredRadius_)
					add({distance, w, to});
				else
					edges_.push_back({from.place, to, from.squaredDistance, distance});
			});
		}
	}
	/// Collects all edges of the members from `first` to before `end`, each once, from its nearer
	/// end: the extent of a smaller disk needs the edges of its own members only.
	void collectEdges(std::size_t first, std::size_t end, Poller& poller)
	{
		const Vec3f middle = mesh_.position[members_[0].vertex];
		for (std::size_t i = first; i < end; ++i) {
			poller.count();
			const Member& from = members_[i];
			forEachNeighbour(mesh_, from.vertex, [&](int w) {
				const Vec3f to       = mesh_.position[w] - middle;
				const float distance = squaredLength(to);
				if (distance > from.squaredDistance)
					edges_.push_back({from.place, to, from.squaredDistance, distance});
			});
		}
	}
	void forgetEdges() { edges_.clear(); }
	void sortByDistance(Poller& poller)
	{
		std::sort(members_.begin() + 1, members_.end(), [&](const Member& a, const Member& b) {
			poller.count();
			return a.squaredDistance != b.squaredDistance ? a.squaredDistance < b.squaredDistance
														  : a.vertex < b.vertex;
		});
	}
	/// The vertices in the ball; the centre comes first.
	const std::vector<Member>& members() const { return members_; }

	/// Half of the extent of the whole disk along a direction.
	float halfExtent(const Vec3f& direction) const
	{
		float least = 0, most = 0;
		for (const Member& m : members_) {
			const float height = dot(m.place, direction);
			least              = std::min(least, height);
			most               = std::max(most, height);
		}
		// An edge that leaves has a member at its other end: most such edges end between the
		// heights so far.
		for (const Edge& e : edges_) {
			const float beyond = dot(e.to, direction);
			if (beyond >= least && beyond <= most) continue;
			const float height = heightOfCut(e, squaredRadius_, direction, beyond);
			least              = std::min(least, height);
			most               = std::max(most, height);
		}
		return 0.5f * (most - least);
	}
	/// Half of the extent along a direction, of the disk whose members had their edges collected.
	float halfExtent(float radius, const Vec3f& direction) const
	{
		const float squared = radius * radius;
		float       least = 0, most = 0;
		for (const Edge& e : edges_) {
			float height = dot(e.to, direction);
			if (e.squaredTo > squared) height = heightOfCut(e, squared, direction, height);
			least = std::min(least, height);
			most  = std::max(most, height);
		}
		return 0.5f * (most - least);
	}

private:
	/// An edge from a member to a vertex farther from the centre; both ends are relative to the
	/// centre.
	struct Edge {
		Vec3f from, to;
		float squaredFrom, squaredTo;
	};
	const HalfEdgeMesh& mesh_;
	float               squaredRadius_ = 0;
	std::vector<Member> members_;
	std::vector<Edge>   edges_; ///< that leave the disk; or as collectEdges
	/// A bit for each vertex of the mesh. Vertices are in spatial order, so the bits of a disk lie
	/// in few lines of the cache.
	std::vector<bool> isMember_;

	/// The share of an edge inside the ball.
	static float shareInside(const Edge& e, float squaredRadius)
	{
		const Vec3f along   = e.to - e.from;
		const float squared = squaredLength(along), half = dot(e.from, along);
		const float root = half * half + squared * std::max(0.0f, squaredRadius - e.squaredFrom);
		return std::clamp((std::sqrt(root) - half) / squared, 0.0f, 1.0f);
	}
	/// The height at which an edge leaves the ball. beyond: the height of its far end.
	static float heightOfCut(const Edge& e, float squaredRadius, const Vec3f& direction,
							 float beyond)
	{
		const float before = dot(e.from, direction);
		return before + shareInside(e, squaredRadius) * (beyond - before);
	}
	void add(const Member& member)
	{
		if (isMember_[std::size_t(member.vertex)]) return;
		isMember_[std::size_t(member.vertex)] = true;
		members_.push_back(member);
	}
	void forget()
	{
		for (const Member& m : members_)
			isMember_[std::size_t(m.vertex)] = false;
		members_.clear();
		edges_.clear();
	}
};

/// Measures the flatness of disks of a mesh: half of their extent along their mean normal. A plane
/// fitted to the vertices would fail: round the rim of a thin sheet the fit is the sheet itself.
class FlatnessGauge {
public:
	/// worker: the thread that measures.
	FlatnessGauge(const HalfEdgeMesh& mesh, const Buffer<RingSum>& ring, const Radii& radii,
				  Workers& workers, int worker) :
			ring_(ring),
			radii_(radii), disk_(mesh), poller_(workers, worker)
	{
	}

	/// Flatness of the largest disk about a vertex; 0 if its normals prove flatness within epsilon.
	float ofLargest(int v, float epsilon)
	{
		disk_.collect(v, radii_.back(), poller_);
		if (areNormalsClose(sinePerSlope * epsilon / radii_.back())) return 0;
		Vec3f sum;
		for (const Disk::Member& m : disk_.members())
			sum += ring_[m.vertex].normal;
		return disk_.halfExtent(normalized(sum));
	}
	/// Flatness of all disks about the vertex of the last ofLargest. A disk larger than a disk less
	/// flat than `enough` is not measured and gets the value before.
	Flatness ofAll(float enough)
	{
		disk_.forgetEdges();
		disk_.sortByDistance(poller_);
		const std::vector<Disk::Member>& members = disk_.members();
		Flatness                         flatness;
		Vec3f                            sum;
		std::size_t                      num   = 0;
		float                            soFar = 0;
		for (int k = 0; k < radiusNum; ++k) {
			if (soFar <= enough) {
				const float       squared = radii_[k] * radii_[k];
				const std::size_t before  = num;
				while (num < members.size() && members[num].squaredDistance <= squared)
					sum += ring_[members[num++].vertex].normal;
				disk_.collectEdges(before, num, poller_);
				soFar = std::max(soFar, disk_.halfExtent(radii_[k], normalized(sum)));
			}
			flatness[k] = soFar;
		}
		return flatness;
	}

private:
	const Buffer<RingSum>& ring_;
	const Radii&           radii_;
	Disk                   disk_;
	Poller                 poller_;

	/// Whether all normals of the disk turn from the normal of its centre by at most the angle with
	/// this sine.
	bool areNormalsClose(float sine) const
	{
		constexpr std::size_t            leastNum = 7; // fewer say nothing about long edges
		const std::vector<Disk::Member>& members  = disk_.members();
		if (members.size() < leastNum) return false;
		const Vec3f centre = normalized(ring_[members[0].vertex].normal);
		const float least  = std::max(0.0f, 1 - sine * sine);
		for (const Disk::Member& m : members) {
			const Vec3f normal = ring_[m.vertex].normal;
			const float along  = dot(normal, centre);
			if (!(along > 0 && along * along >= least * squaredLength(normal))) return false;
		}
		return true;
	}
};

/// The largest edge whose disk is flat within epsilon, linear between the radii.
float edgeFor(const Flatness& flatness, const Radii& radii, float epsilon)
{
	if (flatness[0] > epsilon) return radii[0] / radiusOfEdge;
	for (int k = 1; k < radiusNum; ++k) {
		if (flatness[k] <= epsilon) continue;
		const float share = (epsilon - flatness[k - 1]) / (flatness[k] - flatness[k - 1]);
		return (radii[k - 1] + share * (radii[k] - radii[k - 1])) / radiusOfEdge;
	}
	return radii.back() / radiusOfEdge;
}

/// Distance of a vertex, along its normal, from the place predicted by its ring and the rings
/// round. Smooth shape cancels out; noise remains.
float roughnessAt(const HalfEdgeMesh& m, const Vec3f& direction, int v)
{
	const auto offsetOf = [&](int w) {
		Vec3f sum;
		int   num = 0;
		forEachNeighbour(m, w, [&](int x) {
			sum += m.position[x];
			++num;
		});
		return num > 0 ? dot(m.position[w] - sum * (1 / float(num)), direction) : 0.0f;
	};
	float sum = 0;
	int   num = 0;
	forEachNeighbour(m, v, [&](int w) {
		sum += offsetOf(w);
		++num;
	});
	return num > 0 ? std::abs(offsetOf(v) - sum / float(num)) : 0.0f;
}

/// A vertex as the centre of a disk.
struct Centre {
	int   vertex;
	float squaredTurn; ///< squared sine of the turn of normals near the vertex from their mean
};

/// Chooses vertices evenly spread over the surface: of every square the least flat vertex, so that
/// no ridge and no tip is missed. Vertices are in spatial order: consecutive vertices lie side by
/// side.
class CentreSpreader {
public:
	CentreSpreader(const Buffer<RingSum>& ring, float square, std::vector<Centre>& out) :
			ring_(ring), square_(square), out_(out)
	{
	}

	void pass(int v)
	{
		if (group_.empty()) firstNew_ = out_.size();
		group_.push_back(v);
		const float flatness = flatnessOf(ring_[v]);
		if (flatness < least_) {
			least_    = flatness;
			sharpest_ = v;
		}
		passed_ += ownArea(ring_[v]);
		if (passed_ < square_) return;
		choose();
		if (out_.size() - firstNew_ == centresTogether) closeGroup();
	}
	void finish()
	{
		if (passed_ > 0) choose();
		closeGroup();
	}

private:
	const Buffer<RingSum>& ring_;
	float                  square_;
	std::vector<Centre>&   out_;
	std::vector<int>       group_;        ///< vertices passed since the last group
	std::size_t            firstNew_ = 0; ///< first centre of the group
	float                  passed_   = 0; ///< area of the square at hand
	float                  least_    = HUGE_VALF;
	int                    sharpest_ = 0;

	void choose()
	{
		out_.push_back({sharpest_, 0});
		passed_ = 0;
		least_  = HUGE_VALF;
	}

	void closeGroup()
	{
		const float turn = squaredTurn();
		for (std::size_t i = firstNew_; i < out_.size(); ++i)
			out_[i].squaredTurn = turn;
		group_.clear();
		firstNew_ = out_.size();
	}

	/// The squared sine of the largest turn from the mean in the group; 2 beyond a right angle.
	float squaredTurn() const
	{
		Vec3f sum;
		for (int v : group_)
			sum += ring_[v].normal;
		const Vec3f mean = normalized(sum);
		float       turn = 0;
		for (int v : group_) {
			const float along = dot(ring_[v].normal, mean), whole = squaredLength(ring_[v].normal);
			if (!(along > 0)) return 2;
			turn = std::max(turn, 1 - along * along / whole);
		}
		return turn;
	}
};

/// Computes the sizes of a surface for several ε in turn.
class SizeSearch {
public:
	/// surface: with rings.
	SizeSearch(const Surface& surface, float even, const ErrorSizeRange& range, Workers& workers) :
			mesh_(surface.mesh), ring_(surface.ring), even_(even), largest_(range.largest * even),
			slope_(range.slope), workers_(workers), radii_(radiiFor(even, largest_)),
			ofLargest_(trianglesAt(largest_)), wanted_(1 - ofLargest_), centre_(spreadCentres())
	{
	}

	/// About the ε of run(), from a part of the disks and without grading.
	float roughEpsilon() { return std::max(leastEpsilon(), usualRaise * guessedEpsilon()); }

	ErrorSizes run()
	{
		// With little to grade ε may shrink, as the disks lie at the sharpest places.
		constexpr float leastRaise = 0.8f, fewRaise = 1, mostRaise = 2.2f;
		const float     flat = guessedEpsilon(), noise = leastEpsilon();
		const float     least = std::max(noise, leastRaise * flat);
		const float     most  = std::max(noise, mostRaise * flat);
		const float     few   = std::max(noise, fewRaise * flat);
		gatherBent(few, most);

		ErrorSizes sizes;
		sizes.edge.reset(mesh_.vertexNum);
		workers_.forEach(sizes.edge.size(), [&](int v) { sizes.edge[v] = largest_; });
		sizes.epsilon = std::max(noise, usualRaise * flat);
		makeSizes(sizes.epsilon, sizes.edge);
		float corrected = std::clamp(correctedEpsilon(sizes), least, most);
		if (!isFarFrom(sizes.epsilon, corrected)) return sizes;
		if (corrected < few) {
			gatherBent(least, most);
			corrected = std::clamp(correctedEpsilon(sizes), least, most);
		}
		sizes.epsilon = corrected;
		makeSizes(sizes.epsilon, sizes.edge);
		return sizes;
	}

private:
	/// A vertex whose largest disk is not flat.
	struct Bent {
		int      vertex;
		Flatness flatness;
	};

	const HalfEdgeMesh&       mesh_;
	const Buffer<RingSum>&    ring_;
	const float               even_;    ///< edge of equal triangles
	const float               largest_; ///< edge on flat ground
	const float               slope_;
	Workers&                  workers_;
	const Radii               radii_;
	const double              ofLargest_; ///< share of triangles if all had the largest size
	const double              wanted_;    ///< share of triangles left for small sizes
	const std::vector<Centre> centre_;    ///< the centres of the disks
	std::vector<Bent>         bent_;
	std::vector<int>          lowered_; ///< vertices below the largest size

	/// The centres depend on the pieces, whose size is fixed here.
	std::vector<Centre> spreadCentres()
	{
		constexpr std::size_t grain  = 4096;
		const float           square = even_ * even_ / disksPerSquare;
		const auto            spread = [&](std::size_t begin, std::size_t end, auto& out) {
            CentreSpreader spreader(ring_, square, out);
            for (std::size_t v = begin; v < end; ++v)
                spreader.pass(int(v));
            spreader.finish();
		};
		return workers_.collect<Centre>(std::size_t(mesh_.vertexNum), spread, grain);
	}

	double area()
	{
		return workers_.sumEach<double>(
			ring_.size(), [&](int v, double& sum) { sum += double(ownArea(ring_[v])); });
	}

	double trianglesAt(float edge) const
	{
		const double ratio = double(even_ / edge);
		return ratio * ratio;
	}
	static bool isFarFrom(float epsilon, float other)
	{
		constexpr float far = 0.05f; // a tenth of the small triangles, a three-hundredth of all
		return std::abs(other - epsilon) > far * epsilon;
	}

	/// The deviation of the vertices from a smooth surface, by its median.
	float noiseLevel()
	{
		constexpr float    ofMedian = 1 / 0.6745f; // a deviation over the median amount
		const int          step     = std::max(1, mesh_.vertexNum / int(noiseVertexNum));
		std::vector<float> roughness =
			workers_.collectEach<float>(std::size_t(mesh_.vertexNum / step), [&](int i, auto& out) {
				const int v = i * step;
				out.push_back(roughnessAt(mesh_, normalized(ring_[v].normal), v));
			});
		if (roughness.empty()) return 0;
		const auto middle = roughness.begin() + std::ptrdiff_t(roughness.size() / 2);
		std::nth_element(roughness.begin(), middle, roughness.end());
		return ofMedian * *middle;
	}

	float leastEpsilon() { return noiseFactor * noiseLevel(); }

	/// A first guess of ε, from a part of the disks.
	float guessedEpsilon()
	{
		const std::size_t       step = std::max<std::size_t>(1, centre_.size() / guessingDiskNum);
		const std::size_t       num  = centre_.size() / step;
		const std::vector<Bent> some =
			gather(num, [&](std::size_t i, FlatnessGauge& gauge, std::vector<Bent>& out) {
				const int v = centre_[i * step].vertex;
				gauge.ofLargest(v, 0);
				out.push_back({v, gauge.ofAll(even_)});
			});
		return epsilonFor(some, num, wanted_);
	}

	/// The number of triangles above the number at the largest size, over the wanted number,
	/// without grading. Every disk represents the same area; the diskNum disks that are not in
	/// `bent` add nothing.
	double smallTriangles(const std::vector<Bent>& bent, std::size_t diskNum, float epsilon) const
	{
		double more = 0;
		for (const Bent& b : bent)
			more += trianglesAt(edgeFor(b.flatness, radii_, epsilon)) - ofLargest_;
		return diskNum > 0 ? more / double(diskNum) : 0;
	}
	/// The ε that gives the wanted number of small triangles.
	float epsilonFor(const std::vector<Bent>& bent, std::size_t diskNum, double wanted)
	{
		float low = 0, high = even_;
		for (int halving = 0; halving < 20; ++halving) {
			workers_.poll();
			const float middle                                            = 0.5f * (low + high);
			(smallTriangles(bent, diskNum, middle) > wanted ? low : high) = middle;
		}
		return high;
	}

	/// Measures all radii of the disks that are less flat than `least`, and keeps these in `bent_`.
	/// Most of a surface is flat at the scale of its triangles. ε will be between least and most.
	void gatherBent(float least, float most)
	{
		const float sine     = sinePerSlope * least / radii_.back();
		const float flatTurn = sine * sine;
		bent_                = gather(centre_.size(),
									  [&](std::size_t i, FlatnessGauge& gauge, std::vector<Bent>& out) {
                           if (centre_[i].squaredTurn < flatTurn) return;
                           const int v = centre_[i].vertex;
                           if (gauge.ofLargest(v, least) > least)
                               out.push_back({v, gauge.ofAll(most)});
                       });
	}

	/// The disks that measure(i, gauge, out) appends for i in [0, num), in order.
	template <class Measure>
	std::vector<Bent> gather(std::size_t num, const Measure& measure)
	{
		constexpr std::size_t grain = 16; // disks may be large
		// A gauge has a bit for each vertex, so each thread keeps its gauge.
		std::vector<FlatnessGauge> gauges;
		gauges.reserve(std::size_t(workers_.threadNum()));
		for (int worker = 0; worker < workers_.threadNum(); ++worker)
			gauges.emplace_back(mesh_, ring_, radii_, workers_, worker);
		std::vector<std::vector<Bent>> part((num + grain - 1) / grain);
		workers_.forTasks(part.size(), [&](std::size_t p, int worker) {
			for (std::size_t i = p * grain; i < std::min(num, (p + 1) * grain); ++i)
				measure(i, gauges[std::size_t(worker)], part[p]);
		});
		std::vector<Bent> all;
		for (const std::vector<Bent>& own : part)
			all.insert(all.end(), own.begin(), own.end());
		return all;
	}

	/// Makes the sizes for an ε. Every other vertex has the largest size.
	void makeSizes(float epsilon, Buffer<float>& edge)
	{
		for (int v : lowered_)
			edge[v] = largest_;
		lowered_.clear();
		for (const Bent& b : bent_) {
			edge[b.vertex] = edgeFor(b.flatness, radii_, epsilon);
			if (edge[b.vertex] < largest_) lowered_.push_back(b.vertex);
		}
		gradeSizes(mesh_, slope_, workers_, lowered_, edge);
	}

	/// The ε corrected for grading: as grading adds small triangles, the number without grading is
	/// reduced by the same factor.
	float correctedEpsilon(const ErrorSizes& sizes)
	{
		const double more     = workers_.sumEach<double>(lowered_.size(), [&](int i, double& sum) {
            const int v = lowered_[i];
            sum += double(ownArea(ring_[v])) * (trianglesAt(sizes.edge[v]) - ofLargest_);
        });
		const double ungraded = smallTriangles(bent_, centre_.size(), sizes.epsilon);
		const double got      = more / area();
		return got > 0 ? epsilonFor(bent_, centre_.size(), wanted_ * ungraded / got)
					   : sizes.epsilon;
	}
};

/// Makes the sizes of a surface from the sizes of the surface cut along lines: a vertex of a line
/// gets the smaller size of its sides. copyOf: see LineCut.
Buffer<float> joined(const Buffer<float>& ofCut, const std::vector<int>& copyOf,
					 const HalfEdgeMesh& mesh, float slope, Workers& workers)
{
	Buffer<float> edge(std::size_t(mesh.vertexNum));
	std::copy(ofCut.begin(), ofCut.begin() + mesh.vertexNum, edge.begin());
	for (std::size_t i = 0; i < copyOf.size(); ++i)
		edge[copyOf[i]] = std::min(edge[copyOf[i]], ofCut[std::size_t(mesh.vertexNum) + i]);
	std::vector<int> onLine = copyOf;
	sortUnique(onLine);
	gradeSizes(mesh, slope, workers, onLine, edge);
	return edge;
}

} // namespace

ErrorSizes sizesByError(Surface& surface, const Buffer<char>& lines, float even,
						const ErrorSizeRange& range, Workers& workers)
{
	ensureRings(surface, workers);
	LineCut                cut(surface, lines, workers);
	ErrorSizes             sizes  = SizeSearch(surface, even, range, workers).run();
	const std::vector<int> copyOf = cut.copyOf();
	cut.close();
	if (!copyOf.empty())
		sizes.edge = joined(sizes.edge, copyOf, surface.mesh, range.slope, workers);
	return sizes;
}

std::int64_t countForFlatness(Surface& surface, const Buffer<char>& lines,
							  const ErrorSizeRange& range, double area, std::int64_t first,
							  double error, std::int64_t most, Workers& workers)
{
	// Wanted flatness of disks over the error bound. The places that then miss the bound are few
	// enough to be refined one by one.
	constexpr double flatnessShare = 0.75;
	constexpr int    steps         = 3;
	const double     wanted        = flatnessShare * error * surface.frame.scale;
	double           num           = double(first);
	ensureRings(surface, workers);
	const LineCut cut(surface, lines, workers);
	for (int i = 0; i < steps; ++i) {
		const float even = evenEdge(area, first) * float(std::sqrt(double(first) / num));
		SizeSearch  search(surface, even, range, workers);
		const bool  isLast = i + 1 == steps; // the steps before only lead near
		const float flat   = isLast ? search.run().epsilon : search.roughEpsilon();
		num *= std::clamp(double(flat) / wanted, 0.1, 10.0);
		num = std::clamp(num, 4.0, double(most));
	}
	return std::int64_t(num);
}

} // namespace gpr
