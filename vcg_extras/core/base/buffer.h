// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_BASE_BUFFER_H
#define VCG_EXTRAS_CORE_BASE_BUFFER_H

#include "pages.h"

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

namespace gpr {

/// An array of plain values without initialisation, unlike std::vector: the first write is the only
/// pass over fresh memory. Large arrays lie in huge pages if the system has such pages.
template <class T>
class Buffer {
	static_assert(std::is_trivially_copyable<T>::value, "Buffer holds plain values only");

public:
	Buffer() = default;
	explicit Buffer(std::size_t n) { reset(n); }
	Buffer(std::size_t n, const T& value)
	{
		reset(n);
		fill(value);
	}
	~Buffer() { release(); }
	Buffer(Buffer&& o) noexcept { swap(o); }
	Buffer& operator=(Buffer&& o) noexcept
	{
		swap(o);
		return *this;
	}
	Buffer(const Buffer&)            = delete;
	Buffer& operator=(const Buffer&) = delete;

	/// n values of unknown content; throws std::bad_alloc.
	void reset(std::size_t n)
	{
		release();
		data_ = static_cast<T*>(allocatePages(n * sizeof(T)));
		size_ = n;
	}
	/// Keeps the first min(n, size()) values.
	void resize(std::size_t n)
	{
		Buffer            other(n);
		const std::size_t kept = n < size_ ? n : size_;
		if (kept > 0) std::memcpy(static_cast<void*>(other.data_), data_, kept * sizeof(T));
		swap(other);
	}
	void release()
	{
		if (data_ != nullptr) releasePages(data_, size_ * sizeof(T));
		data_ = nullptr;
		size_ = 0;
	}
	void fill(const T& value)
	{
		for (std::size_t i = 0; i < size_; ++i)
			data_[i] = value;
	}
	void swap(Buffer& o) noexcept
	{
		std::swap(data_, o.data_);
		std::swap(size_, o.size_);
	}

	std::size_t size() const { return size_; }
	bool        empty() const { return size_ == 0; }
	T*          data() { return data_; }
	const T*    data() const { return data_; }
	T&          operator[](std::size_t i) { return data_[i]; }
	const T&    operator[](std::size_t i) const { return data_[i]; }
	T*          begin() { return data_; }
	T*          end() { return data_ + size_; }
	const T*    begin() const { return data_; }
	const T*    end() const { return data_ + size_; }

private:
	T*          data_ = nullptr;
	std::size_t size_ = 0;
};

} // namespace gpr

#endif
