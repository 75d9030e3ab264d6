# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A file whose tests were all skipped says why and ends with 77, as ctest wants it."""

import pytest

reasons = []


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_logreport(report):
    if report.skipped:
        reasons.append(report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr))


def pytest_collectreport(report):
    if report.skipped:
        reasons.append(report.longrepr[2])


def pytest_sessionfinish(session, exitstatus):
    reporter = session.config.pluginmanager.get_plugin("terminalreporter")
    passed, failed = (len(reporter.stats.get(kind, [])) for kind in ("passed", "failed"))
    errors = len(reporter.stats.get("error", []))
    if reasons and not passed and not failed and not errors:
        print("\nSKIPPED:", reasons[0].removeprefix("Skipped: "))
        session.exitstatus = 77
