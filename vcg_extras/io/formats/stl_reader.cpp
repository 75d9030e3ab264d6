// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_order.h"
#include "mesh_formats.h"
#include "stl_facets.h"

#include <vcg_extras/core/base/buffer.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh/face_list.h>
#include <vcg_extras/io/mesh/precision.h>
#include <vcg_extras/io/text/text_lines.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <unordered_map>

namespace gpr::app {

namespace {

using Position = std::array<double, 3>;

constexpr std::size_t stlHeaderBytes = 80;

bool beginsWithSolid(std::string_view file)
{
	return lowerCase(Words(file).next()) == "solid";
}

struct PositionHash {
	std::size_t operator()(const Position& p) const
	{
		std::size_t sum = 0;
		for (const double c : p)
			sum = 31 * sum + std::hash<double>()(c); // alike for both zeros
		return sum;
	}
};

/// Reads a file word by word, wherever its lines end: only the name of a solid ends with the line.
class AsciiStl {
public:
	explicit AsciiStl(std::string_view file) : words_(file) {}

	InputMesh read()
	{
		mesh_.doublePrecision = true;
		for (std::string word = nextWord(); !word.empty(); word = nextWord())
			readRecord(word);
		faces_.finish(mesh_);
		giveSolids();
		if (endNum_ < solidNum_)
			mesh_.notes.push_back("The STL file has no 'endsolid' and may be cut off.");
		settlePrecision(mesh_);
		return std::move(mesh_);
	}

private:
	Words                                                    words_;
	InputMesh                                                mesh_;
	FaceList                                                 faces_;
	std::unordered_map<Position, std::int64_t, PositionHash> vertexAt_;
	std::size_t                                              solidNum_ = 0, endNum_ = 0;
	NamesOfFaces                                             solids_;

	std::string nextWord() { return lowerCase(words_.next()); }

	[[noreturn]] static void fail()
	{
		failInput("a facet is malformed or the file ends too early");
	}

	/// Words of a facet outside of any facet are a sign of a damaged "facet".
	void readRecord(const std::string& word)
	{
		if (word == "vertex" || word == "endloop" || word == "endfacet") fail();
		if (word == "facet") readFacet();
		solidNum_ += word == "solid";
		endNum_ += word == "endsolid";
		if (word == "endsolid") words_.restOfLine();
		if (word != "solid") return;
		const std::string name(words_.restOfLine());
		if (name.empty())
			solids_.beginAnother(name);
		else
			solids_.begin(name);
	}

	/// A name alone is none of a region.
	void giveSolids()
	{
		MeshAttributes& a = mesh_.attributes;
		if (solids_.names().size() > 1)
			a.ofFaces.push_back({"solid", PlyType::Int32, solids_.numbers(), solids_.names()});
		else if (!solids_.names()[0].empty())
			a.lost.push_back("the name of the solid");
	}

	void readFacet()
	{
		std::array<std::int64_t, 3> corners;
		std::size_t                 cornerNum = 0;
		for (std::string word = nextWord(); word != "endfacet"; word = nextWord()) {
			if (word.empty() || (word == "vertex" && cornerNum == 3)) fail();
			if (word == "vertex") corners[cornerNum++] = readVertex();
		}
		if (cornerNum < 3) fail();
		faces_.add(corners.data(), cornerNum);
		solids_.addFace();
	}

	/// Corners at exactly the same position are one vertex; so are corners with the same
	/// coordinates that are no numbers.
	std::int64_t readVertex()
	{
		Position position;
		for (double& c : position) {
			if (!words_.nextCoordinate(c)) fail();
		}
		Position key = position;
		for (double& c : key)
			c = std::isnan(c) ? std::numeric_limits<double>::infinity() : c;
		const auto [place, isNew] = vertexAt_.try_emplace(key, std::int64_t(vertexAt_.size()));
		if (isNew) mesh_.doubles.insert(mesh_.doubles.end(), position.begin(), position.end());
		return place->second;
	}
};

/// Finds the first of all corners at the same place. A table with open addressing that threads fill
/// side by side: the number of a place only falls, so the outcome does not depend on the order of
/// the threads.
class FirstCorners {
public:
	FirstCorners(const StlFacets& facets, Workers& workers) :
			facets_(facets), workers_(workers), table_(sizeFor(facets.cornerNum()))
	{
		workers_.forEach(table_.size(), [&](std::size_t at) { table_[at] = none; });
	}

	/// Of every corner.
	Buffer<int> find()
	{
		const std::size_t num = facets_.cornerNum();
		Buffer<int>       slot(num);
		workers_.forEach(num, [&](std::size_t c) { slot[c] = put(c); });
		workers_.forEach(num, [&](std::size_t c) { slot[c] = table_[slot[c]]; });
		return slot;
	}

private:
	static constexpr int none = -1;
	const StlFacets&     facets_;
	Workers&             workers_;
	Buffer<int>          table_; ///< a power of two, at most two thirds full

	static std::size_t sizeFor(std::size_t cornerNum)
	{
		std::size_t size = 64;
		while (2 * size < 3 * cornerNum)
			size *= 2;
		return size;
	}

	/// The place in the table of corner c's vertex.
	int put(std::size_t c)
	{
		const StlCornerKey key  = facets_.key(c);
		const std::size_t  mask = table_.size() - 1;
		for (std::size_t at = std::size_t(key.hash()) & mask;; at = (at + 1) & mask) {
			int seen = __atomic_load_n(&table_[at], __ATOMIC_RELAXED);
			if (seen == none && __atomic_compare_exchange_n(&table_[at], &seen, int(c), false,
															__ATOMIC_RELAXED, __ATOMIC_RELAXED))
				return int(at);
			if (!(facets_.key(std::size_t(seen)) == key)) continue;
			while (int(c) < seen &&
				   !__atomic_compare_exchange_n(&table_[at], &seen, int(c), true, __ATOMIC_RELAXED,
												__ATOMIC_RELAXED)) {}
			return int(at);
		}
	}
};

/// Numbers the vertices in the order of their first corners.
void numberVertices(const StlFacets& facets, Buffer<int>& first, InputMesh& mesh)
{
	mesh.triangles.resize(facets.cornerNum());
	int next = 0;
	for (std::size_t c = 0; c < facets.cornerNum(); ++c) {
		const std::size_t f = std::size_t(first[c]);
		if (f < c) {
			mesh.triangles[c] = mesh.triangles[f];
			continue;
		}
		mesh.triangles[c] = next++;
		for (const float x : facets.position(c))
			mesh.floats.push_back(x);
	}
}

/// A binary file of at least the promised length.
InputMesh readBinaryStl(std::string_view file)
{
	constexpr std::size_t mostCorners = std::numeric_limits<std::int32_t>::max();
	const std::size_t     end         = std::size_t(promisedStlBytes(file));
	const StlFacets       facets(file.substr(stlFacetsAt, end - stlFacetsAt));
	if (facets.cornerNum() > mostCorners) failInput("the file has more than 715827882 faces");
	Workers     workers(0, nullptr);
	Buffer<int> first = FirstCorners(facets, workers).find();
	InputMesh   mesh;
	numberVertices(facets, first, mesh);
	const auto attributeNum = workers.sumEach<std::int64_t>(
		facets.cornerNum() / 3,
		[&](std::size_t f, std::int64_t& num) { num += facets.hasAttribute(f); });
	if (attributeNum > 0) mesh.attributes.lost.push_back(stlAttributes);
	mesh.notes = notesOfStl(file, file.size());
	return mesh;
}

} // namespace

std::uint64_t promisedStlBytes(std::string_view begin)
{
	const std::uint64_t faceNum = loadLittleEndian<std::uint32_t>(&begin[stlHeaderBytes]);
	return stlFacetsAt + stlFacetBytes * faceNum;
}

// The first word decides, but binary files may begin with "solid" too: so the size by the count
// goes first, and zero bytes are a sign as well.
bool isBinaryStl(std::string_view begin, std::uint64_t fileBytes)
{
	if (begin.size() < stlFacetsAt) return false;
	if (fileBytes == promisedStlBytes(begin)) return true;
	return !beginsWithSolid(begin) || begin.substr(0, 1024).find('\0') != begin.npos;
}

void requireAllFacets(std::string_view begin, std::uint64_t fileBytes)
{
	if (promisedStlBytes(begin) <= fileBytes) return;
	failInput("the file ends too early: its header promises " +
			  std::to_string(promisedStlBytes(begin)) + " bytes");
}

std::vector<std::string> notesOfStl(std::string_view begin, std::uint64_t fileBytes)
{
	const std::uint64_t promised = promisedStlBytes(begin), more = fileBytes - promised;
	if (more < stlFacetBytes) return {};
	return {"The STL file has " + std::to_string(more) + " bytes behind the " +
			std::to_string((promised - stlFacetsAt) / stlFacetBytes) +
			" facets that its header promises; facets there were left out."};
}

InputMesh readStl(std::string_view file)
{
	if (isBinaryStl(file, file.size())) {
		requireAllFacets(file, file.size());
		return readBinaryStl(file);
	}
	if (!beginsWithSolid(file)) failInput("neither an ASCII nor a binary STL file");
	return AsciiStl(file).read();
}

} // namespace gpr::app
