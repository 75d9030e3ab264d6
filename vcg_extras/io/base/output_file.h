// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_BASE_OUTPUT_FILE_H
#define VCG_EXTRAS_IO_BASE_OUTPUT_FILE_H

#include "run_limit.h"

#include <vcg_extras/core/vec.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gpr::app {

/// A result on the disk that appears whole at commit(), or not at all.
class Output {
public:
	Output()                         = default;
	Output(const Output&)            = delete;
	Output& operator=(const Output&) = delete;
	virtual ~Output()                = default;
	/// Puts the result in its place, over an older one.
	virtual void commit() = 0;
};

/// The results of a run: all are written before the first one replaces an older one.
using Outputs = std::vector<std::unique_ptr<Output>>;

/// A file that appears whole or not at all. The file is written under a temporary name beside the
/// wanted name and renamed by commit(); without commit() the temporary file is removed and an older
/// file stays. Links are followed, and the permissions of an older file are kept; a device or pipe
/// is written directly. Throws AppError (Failure) with a sentence if writing fails, and AppError
/// (Stopped) if the run has to end, which is tested at every megabyte.
class OutputFile : public Output {
public:
	explicit OutputFile(const std::string& path, const RunLimit& limit = RunLimit());
	~OutputFile() override;

	const std::string& path() const { return wanted_; }
	void               bytes(const char* data, std::size_t num)
	{
		if (num > capacity - used_) flush();
		if (num > capacity) {
			writeThrough(data, num);
			return;
		}
		for (std::size_t i = 0; i < num; ++i)
			buffer_[used_ + i] = data[i];
		used_ += num;
	}
	void text(std::string_view words) { bytes(words.data(), words.size()); }
	void integer(std::int64_t value);
	/// " x y z" with the fewest digits from which the same double or float can be read, in the C
	/// locale.
	void position(const Vec3d& p, bool doublePrecision);

	/// For who works long before there is a megabyte: throws when the run has to end.
	void poll() const { limit_.check(); }
	/// Ends the writing: all bytes are on the disk, and the memory is freed.
	void finish();
	void commit() override;

private:
	static constexpr std::size_t capacity = 1 << 20;

	std::string       wanted_;    ///< for sentences: as the user gave the path
	std::string       target_;    ///< the place of the file, links followed
	std::string       temporary_; ///< empty when writing directly
	RunLimit          limit_;
	std::FILE*        file_ = nullptr;
	std::vector<char> buffer_;
	std::size_t       used_ = 0;

	void              flush();
	void              writeThrough(const char* data, std::size_t num);
	[[noreturn]] void fail() const;
};

/// Writes a whole file of text.
void writeText(const std::string& path, const std::string& text, const RunLimit& limit = {});

/// Makes a folder and its missing parents, and removes them again while they are empty: a run that
/// fails leaves no folder.
class NewFolder {
public:
	/// path: "" for none. A failure is silent; checkWritable() tells it.
	explicit NewFolder(const std::string& path);
	~NewFolder();
	NewFolder(const NewFolder&)            = delete;
	NewFolder& operator=(const NewFolder&) = delete;

private:
	std::vector<std::filesystem::path> made_; ///< innermost first
};

/// Throws AppError (Failure) when no file could be written there: the folder is missing or not
/// writable, or the path is a folder. Leaves no trace. To be asked before long work.
void checkWritable(const std::string& path);

} // namespace gpr::app

#endif
