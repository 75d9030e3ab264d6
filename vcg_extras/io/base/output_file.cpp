// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_file.h"

#include "exit_code.h"
#include "platform.h"

#include <vcg_extras/io/text/number_text.h>

#include <cerrno>
#include <cstring>

namespace gpr::app {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void failToWrite(const std::string& path, const std::string& why)
{
	throw AppError(ExitCode::Failure, "cannot write '" + path + "': " + why);
}

/// The target of a path after all links, so that no file replaces a link.
std::string withoutLinks(const std::string& path)
{
	std::error_code error;
	const fs::path  real = fs::weakly_canonical(path, error);
	return error ? path : real.string();
}

bool isSpecial(const std::string& path)
{
	std::error_code       error;
	const fs::file_status status = fs::status(path, error);
	return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

} // namespace

OutputFile::OutputFile(const std::string& path, const RunLimit& limit) :
		wanted_(path), target_(withoutLinks(path)), limit_(limit)
{
	if (isSpecial(target_)) {
		file_ = std::fopen(target_.c_str(), "wb");
	}
	else {
		int attempt = 0;
		do {
			temporary_ = target_ + ".part" + processName(attempt++);
			file_      = openNewFile(temporary_);
		} while (file_ == nullptr && errno == EEXIST);
		if (file_ == nullptr) temporary_.clear();
	}
	if (file_ == nullptr) fail();
	buffer_.resize(capacity);
}

OutputFile::~OutputFile()
{
	if (file_ != nullptr) std::fclose(file_);
	if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void OutputFile::fail() const
{
	failToWrite(wanted_, std::strerror(errno));
}

void OutputFile::writeThrough(const char* data, std::size_t num)
{
	if (std::fwrite(data, 1, num, file_) != num) fail();
}

void OutputFile::flush()
{
	limit_.check();
	writeThrough(buffer_.data(), used_);
	used_ = 0;
}

void OutputFile::integer(std::int64_t value)
{
	char       digits[24];
	const auto end = toChars(digits, digits + sizeof digits, value);
	bytes(digits, std::size_t(end - digits));
}

void OutputFile::position(const Vec3d& p, bool doublePrecision)
{
	char  line[100];
	char* at = line;
	for (const double c : {p.x, p.y, p.z}) {
		*at++          = ' ';
		char* const to = line + sizeof line;
		at             = doublePrecision ? toChars(at, to, c) : toChars(at, to, float(c));
	}
	bytes(line, std::size_t(at - line));
}

void OutputFile::finish()
{
	if (file_ == nullptr) return;
	flush();
	buffer_           = {};
	const bool closed = std::fclose(file_) == 0;
	file_             = nullptr;
	if (!closed) fail();
}

void OutputFile::commit()
{
	finish();
	if (temporary_.empty()) return;

	std::error_code       error;
	const fs::file_status old = fs::status(target_, error);
	if (fs::is_regular_file(old)) fs::permissions(temporary_, old.permissions(), error);
	error.clear();
	fs::rename(temporary_, target_, error);
	if (error) failToWrite(wanted_, error.message());
	temporary_.clear();
}

void writeText(const std::string& path, const std::string& text, const RunLimit& limit)
{
	OutputFile out(path, limit);
	out.text(text);
	out.commit();
}

NewFolder::NewFolder(const std::string& path)
{
	std::error_code error;
	for (fs::path at = path; !at.empty() && !fs::exists(at, error); at = at.parent_path())
		made_.push_back(at);
	if (!made_.empty()) fs::create_directories(path, error);
}

NewFolder::~NewFolder()
{
	std::error_code error;
	for (const fs::path& made : made_)
		fs::remove(made, error);
}

void checkWritable(const std::string& path)
{
	const std::string target = withoutLinks(path);
	std::error_code   error;
	if (fs::is_directory(target, error)) failToWrite(path, "a folder has this name");
	if (!mayOverwrite(target)) failToWrite(path, "the file is write-protected");
	if (isSpecial(target)) return;
	OutputFile attempt(path); // made and removed again
}

} // namespace gpr::app
