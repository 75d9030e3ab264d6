#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/check/rooms accepts the engine as it is, and finds planted breaches in small engines."""

import unittest

from small_engine import SmallEngine


class Rooms(SmallEngine):
    SCRIPT = "rooms"

    def setUp(self):
        super().setUp()
        self.write("base/vector.h", "")
        self.write("mesh/half_edges.h", "#include <vcg_extras/core/base/vector.h>")
        self.write("mesh/half_edges.cpp", '#include "half_edges.h"')

    def test_the_engine_is_in_order(self):
        self.assert_accepted()

    def test_a_small_engine_in_order_is_accepted(self):
        self.assert_accepted(self.core)

    def test_an_upward_include_is_found(self):
        self.write("base/vector.h", "#include <vcg_extras/core/mesh/triangle.h>")
        self.write("mesh/triangle.h", "")
        self.assert_breach("upward include: base/vector includes mesh/triangle")

    def test_a_room_that_includes_the_facade_is_found(self):
        self.write("remesh.h", "")
        self.write("mesh/half_edges.cpp", '#include "half_edges.h"\n#include <vcg_extras/core/remesh.h>')
        self.assert_breach("upward include: mesh/half_edges includes remesh")

    def test_a_circle_through_a_source_is_found(self):
        self.write("mesh/edit.h", '#include "half_edges.h"')
        self.write("mesh/half_edges.cpp", '#include "half_edges.h"\n#include "edit.h"')
        self.assert_breach("circle: mesh/edit -> mesh/half_edges -> mesh/edit")

    def test_a_declared_type_of_a_higher_room_is_found(self):
        self.write("run/guide.h", "struct Guide {\n};")
        for line in ("struct Guide;", "namespace gpr { class Guide; }", "friend class Guide;", "struct Guide* guide;"):
            self.write("base/vector.h", line)
            self.assert_breach("upward declaration: base/vector declares Guide of run/guide")

    def test_a_declared_type_of_a_higher_room_is_found_in_a_source(self):
        self.write("mesh/kind.h", "enum class Kind : char { Sharp, Smooth };")
        self.write("base/vector.cpp", "enum class Kind : char;")
        self.assert_breach("upward declaration: base/vector declares Kind of mesh/kind")

    def test_a_declared_type_of_the_facade_is_found(self):
        self.write("prepared.h", "template <class Mesh>\nclass Prepared final : Base {\n};")
        self.write("mesh/half_edges.h", "template <class Mesh> class Prepared;")
        self.assert_breach("upward declaration: mesh/half_edges declares Prepared of prepared")

    def test_a_circle_through_a_declaration_is_found(self):
        self.write("mesh/half_edges.h", "struct Edit;")
        self.write("mesh/edit.h", '#include "half_edges.h"\nstruct Edit {\n};')
        self.assert_breach("circle: mesh/edit -> mesh/half_edges -> mesh/edit")

    def test_a_declared_type_of_a_lower_room_or_of_its_own_is_accepted(self):
        self.write("base/vector.h", "struct Vector {\n};\nstruct Vector;\n")
        self.write("mesh/half_edges.h", "struct Vector;\nstruct Own;\nstruct Own {\n\tstruct Inner;\n};")
        self.write("run/other.h", "struct Other {\n\tstruct Inner {\n\t};\n};")
        self.assert_accepted(self.core)

    def test_words_of_comments_and_templates_are_no_declarations(self):
        self.write("run/visit.h", "struct Visit {\n};")
        self.write("base/vector.h", '// struct Visit;\n/* class Visit; */\nconst char* x = "struct Visit;";\n'
                   "template <class Visit> void all(Visit* visit);\ntemplate <int n, class Visit> struct Each {\n};")
        self.assert_accepted(self.core)

    def test_a_crowded_room_is_found(self):
        for i in range(20):
            self.write(f"mesh/m{i}.h", "")
        self.assert_breach("mesh has 21 modules")

    def test_an_unknown_room_is_found(self):
        self.write("attic/old.h", "")
        self.assert_breach("attic/old lies in an unknown room")

    def test_an_empty_folder_is_no_engine(self):
        self.assert_empty_folder_is_refused()


if __name__ == "__main__":
    unittest.main()
