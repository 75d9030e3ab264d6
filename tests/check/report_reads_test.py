#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/check/report_reads accepts the engine as it is, and finds planted reads of the report in small engines."""

import unittest

from small_engine import SmallEngine


class ReportReads(SmallEngine):
    SCRIPT = "report_reads"

    def write_body(self, statement):
        self.write("run/stages.cpp", f"void stages(Run& run)\n{{\n\t{statement}\n}}")

    def test_the_engine_does_not_read_its_report(self):
        self.assert_accepted()

    def test_writes_are_accepted(self):
        for statement in ("run.report.seed = seed;", "if (isMany) run.report.counts.faces += more;", "++run.report.num;",
                          "run.report.stages.push_back(stage);", "run.report.add(figures);",
                          "result.report = std::move(trial.report);", "for (int f : faces) run.report.num++;",
                          "run.report.sizes[i] = size;"):
            with self.subTest(statement):
                self.write_body(statement)
                self.assert_accepted(self.core)

    def test_reads_are_found(self):
        for statement in ("if (run.report.seed > 0) stop();", "const int n = run.report.num;", "target = report->num;",
                          "run.report.a = run.report.b;", "auto& report = run.report;", "tell(run.report);",
                          "return report_.num;", "const int n = run.report.stages.size();", "if (report.num == 3) stop();",
                          "int& num = run.report.num;", "best.report = trial.report;", "while (report.isOpen()) stop();"):
            with self.subTest(statement):
                self.write_body(statement)
                self.assert_breach("run/stages.cpp:3: reads ")

    def test_only_the_files_that_write_reports_name_its_type(self):
        self.write("run/report.cpp", "void tell(const Figures& f, RemeshReport& report)\n{\n\tif (!report.num) report.num = f.num;\n}")
        self.write("output/report_checks.h", "void tell(const Checks& checks, RemeshReport& report);")
        self.assert_accepted(self.core)
        self.write("run/stages.h", "void stages(RemeshReport& report);")
        self.assert_breach("run/stages.h:1: names RemeshReport")

    def test_the_facade_may_read(self):
        self.write("remesh.cpp", "return result.report.num;")
        self.assert_accepted(self.core)

    def test_comments_includes_and_other_words_are_no_reads(self):
        self.write("run/stages.cpp", "#include <vcg_extras/core/report.h>\n// report.num is read by none\n"
                   'const char* name = "report.num";\nvoid reporting(Report report);\nint x = run.reporter.num();')
        self.assert_accepted(self.core)

    def test_an_empty_folder_is_no_engine(self):
        self.assert_empty_folder_is_refused()


if __name__ == "__main__":
    unittest.main()
