# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables, pages and the records that they are made from."""

import hashlib
import json
from pathlib import Path

from .commands import say

DOCS = Path("vcg_extras/docs")
README = Path("README.md")
BEGIN_IN_README = "<!-- measured: begin (made by scripts/measure/run quality) -->\n"
END_IN_README = "<!-- measured: end -->\n"
BEGIN_OF_PACKAGES = "<!-- compared: begin (made by scripts/measure/python_packages) -->\n"
END_OF_PACKAGES = "<!-- compared: end -->\n"


def add_out_option(parser):
    parser.add_argument("--out", type=Path, metavar="FOLDER",
                        help=f"where the page is written ({DOCS}); README.md is then left alone")


def table(titles, rows, left_columns=1):
    sides = ["---"] * left_columns + ["---:"] * (len(titles) - left_columns)
    lines = [titles, sides, *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def page(maker, title, *parts):
    """A page whose parts are divided by empty lines. Its first two lines name its maker and seal it."""
    body = "\n".join(part.rstrip("\n") + "\n" for part in (f"# {title}\n", *parts))
    return f"<!-- Made by {maker}; do not edit. -->\n{seal(body)}{body}"


def seal(text):
    """A line that tells whether a text is as it was made: tests/docs/check_measured_pages looks."""
    return f"<!-- content: {hashlib.sha256(text.encode()).hexdigest()[:16]} -->\n"


def is_sealed(text):
    """Whether a text begins with the seal of what follows."""
    first, _, rest = text.partition("\n")
    return first + "\n" == seal(rest)


def write_page(folder, name, text):
    """Into the folder of the documents where none is given."""
    file = (folder or DOCS) / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    say(f"written to {file}")


def between_marks(text, inner, begin=BEGIN_IN_README, end=END_IN_README):
    """The text with what stands between its marks replaced."""
    if begin not in text or end not in text:
        raise RuntimeError(f"there are no marks {begin.strip()} and {end.strip()}")
    before, rest = text.split(begin, 1)
    return before + begin + inner + end + rest.split(end, 1)[1]


def write_into_readme(folder, inner):
    """Into a copy where the pages go to a folder of their own."""
    target = folder / README.name if folder else README
    target.write_text(between_marks(README.read_text(), seal(inner) + inner))
    say(f"written to {target}")


PACKAGE_COLUMNS = ["method", "seconds", "vertices", "root mean square, %", "largest at most, %", "mean 2r/R", "smallest angle"]


def package_rows(page_text):
    """What README has of measurements_python.md: the first model, the columns of PACKAGE_COLUMNS, and the closing line."""
    title, section = page_text.split("\n## ", 2)[1].split("\n", 1)
    lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in section.splitlines() if line.startswith("|")]
    kept = [lines[0].index(name) for name in PACKAGE_COLUMNS]
    rows = [[row[at] for at in kept] for row in lines[2:]]
    faces = section.split(";")[0].strip()
    return table([f"{title}: {faces}, a tenth of its vertices", *PACKAGE_COLUMNS[1:]], rows) + "\n" + page_text.splitlines()[-1] + "\n"


def keep_record(path, figures):
    path.write_text(json.dumps(figures, indent=1))


def kept_record(path):
    if not path.exists():
        raise RuntimeError(f"there is no earlier run: {path}")
    return json.loads(path.read_text())
