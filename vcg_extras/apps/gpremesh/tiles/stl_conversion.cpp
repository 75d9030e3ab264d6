// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion.h"
#include "ply_records.h"
#include "ranked_set.h"
#include "spill_files.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/formats/stl_facets.h>
#include <vcg_extras/io/text/text_pieces.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <unordered_map>

namespace gpr::app {

namespace {

/// Facets read at once.
constexpr std::uint64_t blockFacets = 20000;

/// Bytes of memory per corner of a share, if each corner has a place of its own. Usually six
/// corners have the same place, which takes less than half of the memory.
constexpr double bytesPerCorner = 80;

/// The division of all corners into shares.
struct Shares {
	int           num         = 1;
	std::uint64_t cornersEach = 0;
	std::size_t   flushBytes  = 0;

	Shares(std::uint64_t cornerNum, double memoryBytes)
	{
		constexpr int    mostShares = 10000;
		constexpr double leastBytes = 1 << 20, leastFlush = 1 << 12, mostFlush = 1 << 18;
		const double     bytes = std::max(leastBytes, memoryBytes / 2);
		num         = int(std::clamp(std::ceil(double(cornerNum) * bytesPerCorner / bytes), 1.0,
									 double(mostShares)));
		cornersEach = cornerNum / std::uint64_t(num) + 1;
		// A buffer grows to twice its size.
		flushBytes = std::size_t(std::clamp(bytes / 4 / num, leastFlush, mostFlush));
	}
};

/// A corner and its place, without the gap that a number of eight bytes would make.
struct PlacedCorner {
	StlCornerKey  place;
	std::uint32_t low = 0, high = 0;

	PlacedCorner() = default;
	PlacedCorner(const StlCornerKey& key, std::uint64_t corner) :
			place(key), low(std::uint32_t(corner)), high(std::uint32_t(corner >> 32))
	{
	}
	std::uint64_t corner() const { return std::uint64_t(high) << 32 | low; }
};

/// A corner, and the first corner at the same place.
struct SamePlace {
	std::uint64_t corner, first;
};

struct HashOfKey {
	std::size_t operator()(const StlCornerKey& key) const { return std::size_t(key.hash()); }
};

class StlConverter {
public:
	StlConverter(const Conversion& job, std::uint64_t facetNum) :
			job_(job), facetNum_(facetNum), shares_(3 * facetNum, job.memoryBytes),
			isFirst_(3 * facetNum),
			corners_(job.scratch, "corners", shares_.num, shares_.flushBytes),
			found_(job.scratch, "found", shares_.num, shares_.flushBytes)
	{
	}

	/// Returns whether a facet has attribute bytes, which are lost.
	bool run()
	{
		shareOutPlaces();
		for (int share = 0; share < shares_.num; ++share)
			findFirstCorners(share);
		isFirst_.finish();
		OutputFile out(job_.target, job_.limit);
		out.text(header());
		writeVertices(out);
		for (int share = 0; share < shares_.num; ++share)
			writeFaces(share, out);
		out.commit();
		return hasAttributes_;
	}

private:
	const Conversion& job_;
	std::uint64_t     facetNum_;
	Shares            shares_;
	RankedSet         isFirst_;
	SpillFiles        corners_; ///< by place
	SpillFiles        found_;   ///< by corner
	bool              hasAttributes_ = false;

	/// Calls visit(facets, c, number) for each corner of the file, which is corner c of some
	/// facets. from, share: of the work.
	template <class Visit>
	void forEachCorner(double from, double share, const Visit& visit) const
	{
		std::ifstream     file(job_.source, std::ios::binary);
		std::vector<char> block;
		file.seekg(std::streamoff(stlFacetsAt));
		for (std::uint64_t done = 0; done < facetNum_; done += blockFacets) {
			job_.tell(from + share * double(done) / double(facetNum_));
			const auto num = std::size_t(std::min(facetNum_ - done, blockFacets));
			block.resize(num * stlFacetBytes);
			if (!file.read(block.data(), std::streamsize(block.size())))
				failInput("the file cannot be read to its end");
			const StlFacets facets({block.data(), block.size()});
			for (std::size_t c = 0; c < facets.cornerNum(); ++c)
				visit(facets, c, 3 * done + c);
		}
	}

	/// Puts all corners of a place into the same share, in their order.
	void shareOutPlaces()
	{
		forEachCorner(0, 0.25, [&](const StlFacets& facets, std::size_t c, std::uint64_t number) {
			hasAttributes_           = hasAttributes_ || facets.hasAttribute(c / 3);
			const StlCornerKey key   = facets.key(c);
			const int          share = int((key.hash() >> 32) % std::uint64_t(shares_.num));
			corners_.addValue(share, PlacedCorner(key, number));
		});
	}

	void findFirstCorners(int share)
	{
		job_.tell(0.25 + 0.4 * share / shares_.num);
		std::unordered_map<StlCornerKey, std::uint64_t, HashOfKey> firstAt;
		for (const PlacedCorner& placed : corners_.takeValues<PlacedCorner>(share)) {
			const std::uint64_t corner = placed.corner();
			const auto [at, isNew]     = firstAt.emplace(placed.place, corner);
			if (isNew) isFirst_.insert(corner);
			found_.addValue(int(corner / shares_.cornersEach), SamePlace{corner, at->second});
		}
	}

	std::string header() const
	{
		return plyHeaderText(ownHeader({elementWithPositions(PlyType::Float32, isFirst_.size()),
										elementOfFaces(PlyType::UInt8, indexType(), facetNum_)}),
							 "");
	}

	PlyType indexType() const
	{
		constexpr std::uint64_t mostOfInt = std::numeric_limits<std::int32_t>::max();
		return isFirst_.size() <= mostOfInt ? PlyType::Int32 : PlyType::UInt32;
	}

	void writeVertices(OutputFile& out)
	{
		forEachCorner(0.65, 0.1, [&](const StlFacets& facets, std::size_t c, std::uint64_t number) {
			if (!isFirst_.has(number)) return;
			const std::array<float, 3> p = facets.position(c);
			out.bytes(reinterpret_cast<const char*>(p.data()), sizeof p);
		});
	}

	/// Writes the faces of the corners of a share; the share may begin and end within a face.
	void writeFaces(int share, OutputFile& out)
	{
		job_.tell(0.75 + 0.25 * share / shares_.num);
		const std::vector<SamePlace> found = found_.takeValues<SamePlace>(share);
		const std::uint64_t          begin = std::uint64_t(share) * shares_.cornersEach;
		std::vector<std::uint64_t>   first(found.size());
		for (const SamePlace& f : found)
			first[std::size_t(f.corner - begin)] = f.first;
		std::string bytes;
		for (std::size_t i = 0; i < first.size(); ++i) {
			bytes.clear();
			if ((begin + i) % 3 == 0) appendValue(PlyType::UInt8, 3, bytes);
			appendValue(indexType(), double(isFirst_.rank(first[i])), bytes);
			out.text(bytes);
		}
	}
};

} // namespace

std::vector<std::string> convertBinaryStl(const Conversion& job)
{
	const std::string   begin     = beginOfFile(job.source, stlFacetsAt);
	const std::uint64_t fileBytes = std::filesystem::file_size(job.source);
	requireAllFacets(begin, fileBytes);
	const std::uint64_t facetNum = (promisedStlBytes(begin) - stlFacetsAt) / stlFacetBytes;
	if (facetNum == 0) failInput("the file has no faces (0 vertices)");
	std::vector<std::string> notes = notesOfStl(begin, fileBytes);
	if (StlConverter(job, facetNum).run())
		notes.push_back(
			"Not carried through tiles from an STL file: " + std::string(stlAttributes) + ".");
	return notes;
}

} // namespace gpr::app
