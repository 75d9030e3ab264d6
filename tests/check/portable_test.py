#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/check/portable accepts the engine as it is, and finds planted breaches in small engines.

    portable_test.py LIBRARY     LIBRARY: the engine as it was built
"""

import shutil
import subprocess
import sys
import unittest

from small_engine import SCRIPTS, SmallEngine

CORE = SCRIPTS.parents[1] / "vcg_extras" / "core"
LIBRARY = None


class Portable(SmallEngine):
    SCRIPT = "portable"

    def setUp(self):
        super().setUp()
        self.write("CMakeLists.txt", "target_compile_options(core PUBLIC -ffp-contract=off)")
        self.write("vector.cpp", "float length(float a) { return std::sqrt(std::floor(a)); }")

    def test_the_engine_is_portable(self):
        self.assert_accepted(CORE, LIBRARY)

    def test_exact_functions_are_free(self):
        self.assert_accepted(self.core)

    def test_a_function_of_the_library_is_found_with_its_line(self):
        for call in ("std::acos(x)", "std::atan2(y, x)", "powf(x, 2)", "::exp(x)", "-cos(x)", "std::fma(a, b, c)"):
            self.write("angle.h", f"// acos(x) is not called here\n\nfloat a = {call};")
            self.assert_breach("angle.h:3: ")

    def test_a_function_of_the_library_is_found_without_a_call(self):
        self.write("angle.h", "using std::sin;")
        self.assert_breach("angle.h:1: std::sin, which is not exact")

    def test_own_functions_and_comments_are_accepted(self):
        self.write("base/portable_math.h", "double sin(double angle);")
        self.write("angle.cpp", "/* std::sin(x) */ double a = portable::sin(x); // std::cos(x)\n"
                                'const char* text = "std::exp(x)"; run.exp(x); distance.log(x); sines(x);')
        self.assert_accepted(self.core)

    def test_what_libraries_do_in_their_own_way_is_found(self):
        for line in ("std::shuffle(a.begin(), a.end(), random);", "std::uniform_int_distribution<int> d;",
                     "std::reduce(a.begin(), a.end());", "long double sum = 0;", "#pragma STDC FP_CONTRACT ON",
                     "a = __builtin_fmaf(a, b, c);"):
            self.write("sum.cpp", line)
            self.assert_breach("sum.cpp:1: ")

    def test_a_walk_through_an_unordered_table_is_found(self):
        for walk in ("for (const auto& entry : table)", "auto first = table.begin();"):
            self.write("table.cpp", "std::unordered_map<int, std::vector<int>> table;\n" + walk)
            self.assert_breach("table.cpp:2: a walk through table")
        self.write("table.cpp", "std::unordered_map<int, int> table;\nif (table.find(3) == table.end()) return;")
        self.assert_accepted(self.core)

    def test_options_of_the_compiler_are_looked_at(self):
        self.write("CMakeLists.txt", "target_compile_options(core PUBLIC -O3) # -ffp-contract=off")
        self.assert_breach("has no -ffp-contract=off")
        self.write("CMakeLists.txt", "target_compile_options(core PUBLIC -ffp-contract=off -ffast-math)")
        self.assert_breach("has -ffast-math")

    @unittest.skipUnless(shutil.which("c++") and shutil.which("ar"), "needs c++ and ar")
    def test_a_call_in_the_library_is_found(self):
        source, archive = self.core / "call.cc", self.core / "libcall.a"
        source.write_text("#include <cmath>\ndouble f(double x) { return std::tanh(x); }\n")
        subprocess.run(["c++", "-c", source, "-o", self.core / "call.o"], check=True)
        subprocess.run(["ar", "rc", archive, self.core / "call.o"], check=True)
        self.assert_breach("libcall.a calls tanh", archive)

    def test_an_empty_folder_is_no_engine(self):
        self.assert_empty_folder_is_refused()


if __name__ == "__main__":
    LIBRARY = sys.argv.pop(1)
    unittest.main()
