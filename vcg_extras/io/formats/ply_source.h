// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_PLY_SOURCE_H
#define VCG_EXTRAS_IO_FORMATS_PLY_SOURCE_H

#include "byte_order.h"
#include "ply_header.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/text/text_pieces.h>

#include <string>
#include <string_view>

namespace gpr::app {

/// A value of a binary file as an S.
template <class S>
S loadValue(PlyType type, const char* at, bool swap)
{
	return withType(type, [&](auto zero) { return S(loadAs<decltype(zero)>(at, swap)); });
}

/// The values of a binary file of either byte order, value after value. Never reads beyond the end.
class BinarySource {
public:
	BinarySource(std::string_view body, bool littleEndian) :
			at_(body.data()), end_(body.data() + body.size()),
			swap_(littleEndian != hostIsLittleEndian())
	{
	}

	double real(PlyType type) { return loadValue<double>(type, take(plyTypeSize(type)), swap_); }
	std::int64_t whole(PlyType type)
	{
		return loadValue<std::int64_t>(type, take(plyTypeSize(type)), swap_);
	}
	/// A value as a coordinate.
	static double coordinate(double value) { return value; }

	std::uint64_t recordsLeft(const PlyElement& e) const
	{
		return bytesLeft() / e.smallestRecordBytes();
	}
	std::uint64_t valuesLeft(PlyType type) const { return bytesLeft() / plyTypeSize(type); }

	[[noreturn]] void fail(const std::string& sentence) const { failInput(sentence); }

	std::size_t bytesLeft() const { return std::size_t(end_ - at_); }
	bool        swapped() const { return swap_; }
	const char* peek() const { return at_; }
	const char* take(std::size_t byteNum)
	{
		if (byteNum > bytesLeft()) failCut();
		const char* const here = at_;
		at_ += byteNum;
		return here;
	}

private:
	const char* at_;
	const char* end_;
	bool        swap_;

	[[noreturn]] void failCut() const { fail("the file ends too early and seems to be cut off"); }
};

/// The same for the words of an ASCII file. The types of the header do not matter for the stored
/// values. Text after a '#' on a line is passed over.
class TextSource {
public:
	/// lineNum: of the lines before the body.
	TextSource(std::string_view body, std::size_t lineNum) :
			body_(body), at_(body.data()), end_(body.data() + body.size()), lineNum_(lineNum)
	{
	}
	/// For a file in pieces. The pieces must outlive the source.
	explicit TextSource(TextPieces& pieces) : TextSource(pieces.next(), pieces.linesBefore())
	{
		pieces_ = &pieces;
	}

	/// NaN for words such as nan(ind).
	double       real(PlyType type);
	std::int64_t whole(PlyType type);
	/// NaN for infinite values, too.
	static double coordinate(double value);

	/// Each value takes a character and a blank, the last value no blank.
	std::uint64_t recordsLeft(const PlyElement& e) const
	{
		return (bytesLeft() + 1) / (2 * e.properties.size());
	}
	std::uint64_t valuesLeft(PlyType) const { return (bytesLeft() + 1) / 2; }

	/// Names the line of the last word.
	[[noreturn]] void fail(const std::string& sentence) const;

private:
	std::string_view body_;
	const char*      at_;
	const char*      end_;
	const char*      word_ = nullptr; ///< begin of the last word
	std::size_t      lineNum_;
	TextPieces*      pieces_ = nullptr; ///< null: the body is all there is

	std::uint64_t bytesLeft() const
	{
		return std::uint64_t(end_ - at_) + (pieces_ != nullptr ? pieces_->bytesLeft() : 0);
	}
	bool             takeNextPiece();
	void             skipBlanks();
	std::string_view takeWord();
};

// A source is a BinarySource or a TextSource.

/// The length of a list; fails for a list longer than the rest of the file.
template <class Source>
std::uint64_t listLength(const PlyProperty& list, Source& source)
{
	const std::int64_t num = source.whole(list.countType);
	if (num < 0) source.fail("a list of negative length");
	if (std::uint64_t(num) > source.valuesLeft(list.type))
		source.fail("a list is longer than the rest of the file, which seems to be cut off");
	return std::uint64_t(num);
}

/// A record of an element: its scalars by property, and the values of two lists.
struct PlyRecord {
	std::vector<double>       scalars;
	std::vector<std::int64_t> corners;
	std::vector<float>        texture;
};

/// Which lists of an element are kept; -1: none.
struct KeptLists {
	int corners = -1, texture = -1;
};

template <class Source, class Keep>
void readList(const PlyProperty& list, Source& source, const Keep& keep)
{
	const std::uint64_t num = listLength(list, source);
	for (std::uint64_t i = 0; i < num; ++i)
		keep();
}

template <class Source>
void readRecord(const PlyElement& e, const KeptLists& kept, Source& source, PlyRecord& record)
{
	record.scalars.resize(e.properties.size());
	record.corners.clear();
	record.texture.clear();
	for (std::size_t i = 0; i < e.properties.size(); ++i) {
		const PlyProperty& p = e.properties[i];
		if (!p.isList) {
			record.scalars[i] = source.real(p.type);
		}
		else if (int(i) == kept.corners) {
			readList(p, source, [&] { record.corners.push_back(source.whole(p.type)); });
		}
		else if (int(i) == kept.texture) {
			readList(p, source, [&] { record.texture.push_back(float(source.real(p.type))); });
		}
		else {
			readList(p, source, [&] { source.real(p.type); });
		}
	}
}

/// Steps over records of the same length; false for records of several lengths.
inline bool skipRecords(const PlyElement& e, BinarySource& source)
{
	if (e.hasList()) return false;
	source.take(std::size_t(e.count) * e.smallestRecordBytes());
	return true;
}

inline bool skipRecords(const PlyElement&, TextSource&)
{
	return false;
}

/// Steps over an unused element.
template <class Source>
void skipElement(const PlyElement& element, Source& source)
{
	if (skipRecords(element, source)) return;
	PlyRecord unused;
	for (std::uint64_t i = 0; i < element.count; ++i)
		readRecord(element, {}, source, unused);
}

/// Calls visit(source) for the source of a file's body.
template <class Visit>
auto withSource(const PlyHeader& header, std::string_view file, const Visit& visit)
{
	const std::string_view body = file.substr(header.byteNum);
	if (header.format == PlyFormat::Ascii) return visit(TextSource(body, header.lineNum));
	return visit(BinarySource(body, header.format == PlyFormat::LittleEndian));
}

} // namespace gpr::app

#endif
