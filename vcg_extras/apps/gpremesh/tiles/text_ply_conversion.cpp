// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion.h"
#include "ply_records.h"

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/formats/ply_header.h>
#include <vcg_extras/io/formats/ply_source.h>
#include <vcg_extras/io/mesh/face_list.h>
#include <vcg_extras/io/text/text_pieces.h>

#include <limits>

namespace gpr::app {

namespace {

/// The layout of a binary file that can hold all values of the text: words of the text may exceed
/// the types of the header, see TextSource.
PlyRecordLayout binaryLayout(PlyRecordLayout layout)
{
	PlyElement&                vertices = layout.header.elements[layout.vertexElement];
	const CoordinateProperties c        = findCoordinates(vertices);
	const PlyType           type = needsDouble(vertices, c) ? PlyType::Float64 : PlyType::Float32;
	constexpr std::uint64_t mostOfInt = std::numeric_limits<std::int32_t>::max();
	for (const int i : {c.x, c.y, c.z})
		vertices.properties[std::size_t(i)].type = type;
	PlyElement& faces = layout.header.elements[layout.faceElement];
	faces.properties[layout.indexList].type =
		vertices.count <= mostOfInt ? PlyType::Int32 : PlyType::UInt32;
	return layout;
}

class TextPlyConverter {
public:
	explicit TextPlyConverter(const Conversion& job) :
			job_(job), text_(readPlyLayout(job.source)), binary_(binaryLayout(text_)),
			pieces_(job.source, text_.header.byteNum, text_.header.lineNum), source_(pieces_),
			allBytes_(double(pieces_.bytesLeft()) + 1)
	{
	}

	void run()
	{
		if (text_.faces().count == 0)
			source_.fail("the file has no faces (" + std::to_string(text_.vertices().count) +
						 " vertices)");
		OutputFile out(job_.target, job_.limit);
		out.text(headerText(binary_, text_.vertices().count, text_.faces().count));
		for (std::size_t e = 0; e <= text_.faceElement; ++e) {
			const PlyElement& element = text_.header.elements[e];
			if (element.count > source_.recordsLeft(element)) failTruncated(element);
			for (std::uint64_t i = 0; i < element.count; ++i) {
				if ((i & pollMask) == 0) job_.tell(1 - double(pieces_.bytesLeft()) / allBytes_);
				record_.clear();
				copyRecord(e);
				if (e == text_.vertexElement || e == text_.faceElement) out.text(record_);
			}
		}
		out.commit();
	}

private:
	const Conversion& job_;
	PlyRecordLayout   text_, binary_;
	TextPieces        pieces_;
	TextSource        source_;
	double            allBytes_;
	std::string       record_;

	void copyRecord(std::size_t e)
	{
		const std::vector<PlyProperty>& properties = binary_.header.elements[e].properties;
		for (std::size_t i = 0; i < properties.size(); ++i) {
			if (!properties[i].isList)
				copyValue(e, properties[i]);
			else if (e == text_.faceElement && i == text_.indexList)
				copyCorners(properties[i]);
			else
				copyList(properties[i]);
		}
	}

	void copyValue(std::size_t e, const PlyProperty& p)
	{
		const bool isCoordinate =
			e == text_.vertexElement && (p.name == "x" || p.name == "y" || p.name == "z");
		const double value = source_.real(p.type);
		appendValue(p.type, isCoordinate ? TextSource::coordinate(value) : value, record_);
	}

	std::uint64_t copyLength(const PlyProperty& list)
	{
		const std::uint64_t num  = listLength(list, source_);
		const std::size_t   bits = 8 * plyTypeSize(list.countType);
		if (num >> bits != 0) source_.fail("a list is longer than its type allows");
		appendValue(list.countType, double(num), record_);
		return num;
	}

	void copyList(const PlyProperty& list)
	{
		const std::uint64_t num = copyLength(list);
		for (std::uint64_t i = 0; i < num; ++i)
			appendValue(list.type, source_.real(list.type), record_);
	}

	void copyCorners(const PlyProperty& list)
	{
		const std::uint64_t num = copyLength(list), vertexNum = text_.vertices().count;
		for (std::uint64_t i = 0; i < num; ++i) {
			const std::int64_t v = source_.whole(list.type);
			if (v < 0 || std::uint64_t(v) >= vertexNum) failNoSuchVertex(vertexNum);
			appendValue(list.type, double(v), record_);
		}
	}
};

} // namespace

std::vector<std::string> convertTextPly(const Conversion& job)
{
	TextPlyConverter(job).run();
	return {};
}

} // namespace gpr::app
