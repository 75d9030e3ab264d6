// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_SPILL_FILES_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_SPILL_FILES_H

#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace gpr::app {

/// A file of bytes for each tile, appended to by pieces. Only one file is open at a time, so any
/// number of tiles is possible. Throws AppError (Failure) if writing or reading fails.
class SpillFiles {
public:
	/// flushBytes: bytes of each file in memory before writing.
	SpillFiles(const std::string& folder, const std::string& name, int tileNum,
			   std::size_t flushBytes = std::size_t(1) << 18);

	void add(int tile, const char* data, std::size_t num)
	{
		std::vector<char>& buffer = buffer_[std::size_t(tile)];
		buffer.insert(buffer.end(), data, data + num);
		if (buffer.size() >= flushBytes_) flush(tile);
	}
	template <class T>
	void addValue(int tile, T value)
	{
		char bytes[sizeof(T)];
		std::memcpy(bytes, &value, sizeof(T));
		add(tile, bytes, sizeof(T));
	}

	/// All bytes of a tile's file. Nothing may be added to the file afterwards.
	std::vector<char> take(int tile);
	template <class T>
	std::vector<T> takeValues(int tile)
	{
		const std::vector<char> bytes = take(tile);
		std::vector<T>          values(bytes.size() / sizeof(T));
		if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
		return values;
	}

private:
	std::string                    stem_;
	std::size_t                    flushBytes_;
	std::vector<std::vector<char>> buffer_;

	std::string pathOf(int tile) const { return stem_ + std::to_string(tile); }
	void        flush(int tile);
};

} // namespace gpr::app

#endif
