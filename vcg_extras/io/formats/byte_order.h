// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_BYTE_ORDER_H
#define VCG_EXTRAS_IO_FORMATS_BYTE_ORDER_H

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace gpr::app {

inline bool hostIsLittleEndian()
{
	const std::uint16_t one = 1;
	char                first;
	std::memcpy(&first, &one, 1);
	return first == 1;
}

/// The number at a place in memory; swap: its byte order is not the machine's.
template <class T>
T loadAs(const char* at, bool swap)
{
	char bytes[sizeof(T)];
	std::memcpy(bytes, at, sizeof(T));
	if (swap) std::reverse(bytes, bytes + sizeof(T));
	T value;
	std::memcpy(&value, bytes, sizeof(T));
	return value;
}

template <class T>
T loadLittleEndian(const char* at)
{
	return loadAs<T>(at, !hostIsLittleEndian());
}

/// Puts the bytes of a number in little endian order on every machine, and moves on to the next
/// place.
template <class T>
void putLittleEndian(T value, char*& at)
{
	std::memcpy(at, &value, sizeof value);
	if (!hostIsLittleEndian()) std::reverse(at, at + sizeof value);
	at += sizeof value;
}

template <class T>
void appendLittleEndian(T value, std::string& out)
{
	char  bytes[sizeof(T)];
	char* at = bytes;
	putLittleEndian(value, at);
	out.append(bytes, sizeof bytes);
}

} // namespace gpr::app

#endif
