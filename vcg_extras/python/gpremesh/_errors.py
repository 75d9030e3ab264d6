# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later


class Error(RuntimeError):
    """The engine gave no result. The message gives the reason in a sentence.

    Attributes
    ----------
    status : str
        "unusable input", "count too small", "promise broken", "out of memory", "cancelled",
        "out of time", "bad options" or "internal error".
    smallest_count : int or None
        With "count too small": the smallest possible number of vertices.
    """

    status: str
    smallest_count: "int | None"

    def __init__(self, message, status, smallest_count=None):
        super().__init__(message)
        self.status = status
        self.smallest_count = smallest_count

    def __reduce__(self):
        return (Error, (str(self), self.status, self.smallest_count))


def check(outcome):
    """Raises the failure of an outcome of the engine. Does nothing for a result."""
    if outcome["status"] != "ok":
        raise Error(outcome["message"], outcome["status"], outcome.get("smallest_count") or None)
