#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/check/words accepts plain sentences, and finds pronouns, riddles and banned words in small projects."""

import unittest

from small_engine import SmallEngine

GLOSSARY = """# Glossary

| term | meaning | not used |
|---|---|---|
| border | The edges that have one face. | boundary, open edge |
| degenerate face | A face whose area is zero. | zero-area face, face without area |
"""
PLAIN = "/// Splits each border edge whose length exceeds the limit. Needs a connected mesh. Cost: linear.\n" * 12


class Words(SmallEngine):
    SCRIPT = "words"

    def setUp(self):
        super().setUp()
        self.write("vcg_extras/docs/glossary.md", GLOSSARY)
        self.write("vcg_extras/core/mesh/split.h", PLAIN)
        self.write("README.md", "# A remesher\n\nThe program makes regular triangles.")

    def lines_of(self, path):
        return self.check(self.core, "--lines", path).stdout.splitlines()

    def test_plain_sentences_are_accepted(self):
        self.assert_accepted(self.core)

    def test_each_kind_of_word_is_found_in_comments(self):
        for words, kind in (("That of those which it and them, others, one and ones had.", "pronouns"), ("What it is is what it was.", "what"),
                            ("Where edges end, where faces begin, where all meet.", "where"), ("The boundary is split.", "synonyms")):
            with self.subTest(kind):
                self.write("vcg_extras/core/mesh/split.h", PLAIN + f"// {words}\n")
                self.assert_breach(f" {kind}, at most ")

    def test_each_room_is_checked(self):
        for file, room in (("vcg_extras/core/input/load.cpp", "core/input"), ("vcg_extras/core/remesh.h", "core/(public)"),
                           ("vcg_extras/io/mesh.h", "vcg_extras/io"), ("filter_geodesic_poisson/filter.h", "filter_geodesic_poisson"),
                           ("vcg_extras/web/page.js", "vcg_extras/web")):
            with self.subTest(file):
                self.write(file, "// The boundary.")
                self.assert_breach(f"{room}: 1.0 synonyms, at most 0")
                (self.core / file).unlink()

    def test_documents_are_checked(self):
        for document in ("README.md", "vcg_extras/docs/algorithm.md", "vcg_extras/docs/CHANGELOG.md", "packaging/deb/README.md"):
            with self.subTest(document):
                self.write(document, "# Title\n\nThe samples of a boundary.")
                self.assert_breach("documents: 1.0 synonyms, at most 0")
                self.write(document, "# Title\n\nThose of one are them of others.")
                self.assert_breach("documents: ")
                self.write(document, "# Title")

    def test_docstrings_and_comments_of_python_are_read(self):
        self.write("vcg_extras/python/call.py", '"""Finds the boundary.\n\nNeeds a mesh."""\nkey = "boundary"  # an open edge\n')
        self.assertEqual([line.split(": ")[1] for line in self.lines_of("vcg_extras/python/call.py")], ["boundary", "open edge"])

    def test_lines_are_told_with_their_numbers(self):
        self.write("vcg_extras/core/mesh/split.h", "int a;\n/* A zero\n   area face. */ int b; // two zero-area faces, one face\n")
        told = self.lines_of("vcg_extras/core")
        self.assertEqual([line.split(": ")[:2] for line in told],
                         [["vcg_extras/core/mesh/split.h:2", "zero area face"],
                          ["vcg_extras/core/mesh/split.h:3", "zero-area faces, one"]])

    def test_code_is_no_prose(self):
        self.write("vcg_extras/core/mesh/split.h", PLAIN + 'const char* boundary = "the boundary";\n'
                   "// `boundary`, --boundary, Stage::boundary, boundary(x), mesh.boundary, boundary_curves, boundaryLoops, one-sided\n")
        self.write("vcg_extras/docs/use.md", "# Use\n\n```sh\nremesh --boundary smooth # the boundary\n```\n\n| a | boundary |\n\n"
                   "[Borders](boundary.md) <!-- table: begin -->the boundary<!-- table: end -->")
        self.assert_accepted(self.core)
        self.assertEqual(self.lines_of("vcg_extras"), [])

    def test_pages_of_scripts_are_checked(self):
        self.write("vcg_extras/docs/speed.md", "<!-- Made by scripts/bench; do not edit. -->\nThe boundary.")
        self.assert_breach("documents: 1.0 synonyms, at most 0")

    def test_documents_are_checked_alone(self):
        self.write("vcg_extras/core/mesh/split.h", "// The boundary.")
        self.assert_accepted(self.core, "--documents")
        self.write("README.md", "# A remesher of a boundary")
        self.assert_breach("documents: 1.0 synonyms, at most 0", "--documents")
        self.write("README.md", "line\n" * 120)
        self.assert_breach("README.md has 121 lines, at most 120", "--documents")

    def test_the_worst_file_comes_first(self):
        self.write("vcg_extras/core/mesh/bad.h", "// That of it.")
        rows = self.check(self.core, "--list", "vcg_extras/core").stdout.splitlines()
        self.assertEqual([row.split()[0] for row in rows[1:]], ["vcg_extras/core/mesh/bad.h", "vcg_extras/core/mesh/split.h"])
        self.assertEqual(rows[1].split()[1:3], ["3", "666.7"])

    def test_a_path_without_words_is_refused(self):
        self.assertEqual(self.check(self.core, "--list", "vcg_extras/nowhere").returncode, 1)

    def test_long_documents_are_found(self):
        self.assert_accepted(self.core, "--words")
        self.write("vcg_extras/docs/algorithm.md", "word " * 12000 + "\n" + "| cell " * 12000 + "\n" + "more " * 12000)
        self.assert_breach("words, at most 24000", "--words")
        self.write("vcg_extras/docs/algorithm.md", "short")
        self.write("README.md", "line\n" * 120)
        self.assert_breach("README.md has 121 lines, at most 120", "--words")

    def test_a_glossary_without_a_table_is_refused(self):
        self.write("vcg_extras/docs/glossary.md", "# Glossary")
        self.assert_breach("has no table")

    def test_an_empty_folder_is_no_project(self):
        self.assert_empty_folder_is_refused()


if __name__ == "__main__":
    unittest.main()
