// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tile_part.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/output_file.h>

#include <unordered_map>

namespace gpr::app {

namespace {

class PartJoiner {
public:
	PartJoiner(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
			   const ProgressCallback& progress) :
			plan_(plan),
			folder_(folder), limit_(limit), progress_(progress)
	{
		for (int tile = 0; tile < plan.tileNum(); ++tile)
			addPart(tile);
		if (parts_.empty()) failInput("the inputs have no usable face.");
	}

	void run()
	{
		OutputFile out(folder_.joined(), limit_);
		out.text(headerText(parts_.front().layout, numberVertices(), faceNum_));
		writeVertices(out);
		writeFaces(out);
		out.commit();
	}

private:
	struct PartFile {
		int             tile;
		PartFacts       facts;
		PlyRecordLayout layout;
		std::uint64_t   first = 0; ///< number of the first vertex that no earlier part has
	};

	const TilePlan&         plan_;
	const RunFolder&        folder_;
	const RunLimit&         limit_;
	const ProgressCallback& progress_;
	std::vector<PartFile>   parts_;
	std::uint64_t           faceNum_ = 0;
	/// Per shared vertex, by its number in the input: the number in the joined mesh.
	std::unordered_map<SharedName, std::uint32_t, SharedName::Hash> newNumber_;

	void addPart(int tile)
	{
		const auto facts = readPart(plan_, tile, folder_);
		if (!facts)
			failUsage("Part " + std::to_string(tile) +
					  " was not made yet. Run 'gpremesh tile part'.");
		if (facts->faceNum == 0) return;
		requireStamp(folder_.part(tile), facts->mesh);
		requireStamp(folder_.partNames(tile), facts->names);
		parts_.push_back({tile, *facts, readRecordLayout(folder_.part(tile)), 0});
		if (!haveSameProperties(parts_.back().layout, parts_.front().layout))
			failInput("the parts have different properties.");
		faceNum_ += facts->faceNum;
	}

	void tell(double share) { limit_.tell(progress_, share, "Joining tiles"); }

	std::vector<SharedName> namesOf(const PartFile& part) const
	{
		return readNames(folder_.partNames(part.tile));
	}

	/// Numbers the vertices of all parts. Returns their number.
	std::uint64_t numberVertices()
	{
		std::uint64_t num = 0;
		for (PartFile& part : parts_) {
			part.first = num;
			for (const SharedName& name : namesOf(part)) {
				if (!name.isShared() || newNumber_.emplace(name, std::uint32_t(num)).second) ++num;
			}
		}
		return num;
	}

	/// Per vertex of a part: its number in the joined mesh. own: whether the part writes the
	/// vertex.
	std::vector<std::uint32_t> numbersOf(const PartFile& part, std::vector<char>* own) const
	{
		std::vector<std::uint32_t> numbers;
		std::uint64_t              next = part.first;
		for (const SharedName& name : namesOf(part)) {
			const std::uint32_t number =
				name.isShared() ? newNumber_.find(name)->second : std::uint32_t(next);
			const bool isOwn = number == next;
			next += isOwn;
			numbers.push_back(number);
			if (own != nullptr) own->push_back(isOwn);
		}
		return numbers;
	}

	void writeVertices(OutputFile& out)
	{
		for (const PartFile& part : parts_) {
			tell(0.4 * double(part.tile) / plan_.tileNum());
			std::vector<char> isOwn;
			numbersOf(part, &isOwn);
			PlyRecordReader reader(folder_.part(part.tile), part.layout);
			reader.toVertices();
			for (char own : isOwn) {
				const char* const record = reader.nextVertex();
				if (own) out.bytes(record, part.layout.vertexBytes);
			}
		}
	}

	void writeFaces(OutputFile& out)
	{
		FaceRecord  face;
		std::string bytes;
		for (const PartFile& part : parts_) {
			tell(0.4 + 0.6 * double(part.tile) / plan_.tileNum());
			const std::vector<std::uint32_t> numbers = numbersOf(part, nullptr);
			PlyRecordReader                  reader(folder_.part(part.tile), part.layout);
			reader.toFaces();
			for (std::uint64_t f = 0; f < part.facts.faceNum; ++f) {
				if ((f & pollMask) == 0) limit_.check();
				reader.nextFace(face);
				for (std::int64_t& v : face.corners)
					v = numbers[std::size_t(v)];
				bytes.clear();
				appendFace(face, part.layout, bytes);
				out.bytes(bytes.data(), bytes.size());
			}
		}
	}
};

} // namespace

void joinParts(const TilePlan& plan, const RunFolder& folder, const RunLimit& limit,
			   const ProgressCallback& progress)
{
	if (readRecord(folder.joinRecord(), plan.name)) return;
	PartJoiner(plan, folder, limit, progress).run();
	writeJson(folder.joinRecord(),
			  {{"plan", plan.name}, {"mesh", jsonOf(stampOf(folder.joined()))}});
}

} // namespace gpr::app
