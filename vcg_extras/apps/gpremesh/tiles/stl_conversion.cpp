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
constexpr std::size_t blockFacets = 20000;

/// Bytes of memory per corner of a share, if each corner has a place of its own. Usually six
/// corners have the same place, which takes a sixth of the memory.
constexpr double bytesPerCorner = 60;

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

/// Reads the facets of a file in turn.
class FacetFile {
public:
	FacetFile(const std::string& path, std::uint64_t facetNum) :
			file_(path, std::ios::binary), left_(facetNum)
	{
		file_.seekg(std::streamoff(stlFacetsAt));
	}

	/// The next facets; none at the end.
	StlFacets next()
	{
		const std::size_t num = std::size_t(std::min<std::uint64_t>(left_, blockFacets));
		block_.resize(num * stlFacetBytes);
		file_.read(block_.data(), std::streamsize(block_.size()));
		if (std::size_t(file_.gcount()) != block_.size())
			failInput("the file cannot be read to its end");
		left_ -= num;
		return StlFacets({block_.data(), block_.size()});
	}

private:
	std::ifstream     file_;
	std::uint64_t     left_;
	std::vector<char> block_;
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

	void run()
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
	}

private:
	const Conversion& job_;
	std::uint64_t     facetNum_;
	Shares            shares_;
	RankedSet         isFirst_;
	SpillFiles        corners_; ///< by place
	SpillFiles        found_;   ///< by corner

	/// Puts all corners of a place into the same share, in their order.
	void shareOutPlaces()
	{
		FacetFile     file(job_.source, facetNum_);
		std::uint64_t before = 0;
		for (StlFacets block = file.next(); block.cornerNum() > 0; block = file.next()) {
			job_.tell(0.25 * double(before) / double(3 * facetNum_));
			for (std::size_t c = 0; c < block.cornerNum(); ++c) {
				const StlCornerKey key   = block.key(c);
				const int          share = int((key.hash() >> 32) % std::uint64_t(shares_.num));
				corners_.addValue(share, PlacedCorner(key, before + c));
			}
			before += block.cornerNum();
		}
	}

	void findFirstCorners(int share)
	{
		job_.tell(0.25 + 0.4 * share / shares_.num);
		std::unordered_map<StlCornerKey, std::uint64_t, HashOfKey> firstAt;
		corners_.takeEach<PlacedCorner>(share, [&](const PlacedCorner& placed) {
			const std::uint64_t corner = placed.corner();
			const auto [at, isNew]     = firstAt.emplace(placed.place, corner);
			if (isNew) isFirst_.insert(corner);
			found_.addValue(int(corner / shares_.cornersEach), SamePlace{corner, at->second});
		});
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
		FacetFile     file(job_.source, facetNum_);
		std::uint64_t before = 0;
		for (StlFacets block = file.next(); block.cornerNum() > 0; block = file.next()) {
			job_.tell(0.65 + 0.1 * double(before) / double(3 * facetNum_));
			for (std::size_t c = 0; c < block.cornerNum(); ++c) {
				if (!isFirst_.has(before + c)) continue;
				const std::array<float, 3> p = block.position(c);
				out.bytes(reinterpret_cast<const char*>(p.data()), sizeof p);
			}
			before += block.cornerNum();
		}
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
	const std::string begin = beginOfFile(job.source, stlFacetsAt);
	requireAllFacets(begin, std::filesystem::file_size(job.source));
	const std::uint64_t facetNum = (promisedStlBytes(begin) - stlFacetsAt) / stlFacetBytes;
	if (facetNum == 0) failInput("the file has no faces (0 vertices)");
	StlConverter(job, facetNum).run();
	return {};
}

} // namespace gpr::app
