// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Our conversions of numbers for libraries without std::to_chars of reals, compared with a library
// that has std::to_chars.
#include <vcg_extras/io/text/number_text.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>

using namespace gpr::app;

namespace {

template <class Real>
void expectSameText(Real value)
{
	char        own[400], library[400];
	char* const ownEnd = writeReal(own, value);
	char* const end    = std::to_chars(library, library + sizeof library, value).ptr;
	EXPECT_EQ(std::string(own, ownEnd), std::string(library, end));
}

/// Bits of all magnitudes, and numbers of the size of coordinates.
template <class Real, class Bits>
void compareTexts()
{
	std::mt19937_64 random(1);
	for (int i = 0; i < 20000; ++i) {
		const Bits bits = Bits(random());
		Real       value;
		std::memcpy(&value, &bits, sizeof value);
		if (std::isfinite(value)) expectSameText(value);
		const double thousandths = double(random() % 2000000) / 1000 - 1000;
		expectSameText(Real(thousandths));
		expectSameText(Real(random() >> (random() % 64)));
	}
	for (const double value : {0., -0., 1., 10., 1e5, 1e6, 1.5e5, 123456., 1e-4, 1e-5, 1e22, 0.1})
		expectSameText(Real(value));
}

template <class Real>
void expectSameNumber(const std::string& text)
{
	Real        own = 7, library = 7;
	const char *at = text.data(), *end = at + text.size();
	const auto  ofOwn = readReal(at, end, own), ofLibrary = std::from_chars(at, end, library);
	EXPECT_EQ(ofOwn.ptr - at, ofLibrary.ptr - at) << text;
	EXPECT_EQ(ofOwn.ec, ofLibrary.ec) << text;
	EXPECT_TRUE(own == library || (std::isnan(own) && std::isnan(library))) << text;
}

} // namespace

TEST(CharConversion, WritesTheFewestDigitsAsTheLibraryDoes)
{
	compareTexts<float, std::uint32_t>();
	compareTexts<double, std::uint64_t>();
}

TEST(CharConversion, ReadsAsTheLibraryDoes)
{
	for (const char* text : {"1",
							 "-1.5",
							 "+1",
							 "",
							 "-",
							 ".",
							 ".5",
							 "5.",
							 "1e5",
							 "1e",
							 "1e+",
							 "1e+5x",
							 "1e-400",
							 "1e400",
							 "-1e400",
							 "0x10",
							 "1,5",
							 " 1",
							 "nan",
							 "-NaN",
							 "inf",
							 "-INFINITY",
							 "infin",
							 "0e-400",
							 "0.000000000000000000000000000000000000000000000000000000000000001",
							 "1e-310",
							 "3 4",
							 "123456789012345678901234567890",
							 "1.7976931348623157e308",
							 "1.0000000596046448"}) {
		expectSameNumber<double>(text);
		expectSameNumber<float>(text);
	}
}
