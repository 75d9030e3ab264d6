# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`gpremesh remesh` for a package built without the program: a parser of arguments from the table of the engine. The
code of the program does the rest, with the same messages and exit codes."""

import argparse
import sys

from . import _core

_USAGE = 2  # exit code
_EPILOG = "'gpremesh IN -o OUT' is 'gpremesh remesh IN OUT'."


class _UsageError(Exception):
    pass


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise _UsageError(message)


class _Keep(argparse.Action):
    """Stores arguments by the names of the options; no option may be given twice."""

    def __call__(self, parser, namespace, word, option_string=None):
        given = namespace.given
        if word == "":
            raise _UsageError(f"{_last(self.dest)}: 1 required {self.metavar} missing")
        if self.dest in given and self.nargs != 0:
            raise _UsageError(f"{_last(self.dest)}: At Most 1 required but received 2")
        given[self.dest] = "on" if self.nargs == 0 else word


def _last(option):
    return option.split(",")[-1]


def _parser(texts, shows_all):
    """A parser whose help has the everyday options, or all options in groups."""
    more = "" if shows_all else "'gpremesh remesh --help-all' lists all options, in groups.\n"
    parser = _Parser("gpremesh remesh", usage="gpremesh remesh [OPTIONS] IN [OUT]", description=texts["description"],
                     epilog=more + _EPILOG, allow_abbrev=False, add_help=False,
                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("files", nargs="*", metavar="IN [OUT]", help=f"IN: {texts['in']}\nOUT: {texts['out']}")
    groups = {texts["everyday"]: parser.add_argument_group(texts["everyday"])}
    groups[texts["everyday"]].add_argument("-h", "--help", action="help", help="Show the everyday options and exit")
    groups[texts["everyday"]].add_argument("--help-all", action="help", help="Show all options and exit")
    for row in texts["options"]:
        takes = {"metavar": row["argument"]} if row["argument"] else {"nargs": 0}
        group = groups.get(row["group"]) or groups.setdefault(row["group"], parser.add_argument_group(row["group"]))
        is_shown = shows_all or row["group"] == texts["everyday"]
        group.add_argument(*row["option"].split(","), dest=row["option"], action=_Keep, default=argparse.SUPPRESS,
                           help=row["help"].replace("%", "%%") if is_shown else argparse.SUPPRESS, **takes)
    return parser


def _joined(words, texts):
    """Joins each option with the next word, even if the word begins with a hyphen."""
    takers = {name for row in texts["options"] if row["argument"] for name in row["option"].split(",")}
    words, joined = iter(words), []
    for word in words:
        if word == "--":
            return joined + [word, *words]
        behind = next(words, "") if word in takers else None
        joined.append(word if behind is None else f"{word}={behind}" if word.startswith("--") else word + behind)
    return joined


def _remesh(words):
    texts = _core.remesh_command_texts()
    namespace = argparse.Namespace(given={})
    found, others = _parser(texts, "--help-all" in words).parse_known_intermixed_args(_joined(words, texts), namespace)
    if others:
        raise _UsageError(f"The following argument was not expected: {others[0]}")
    return _core.run_remesh_command(found.files, found.given)


def _overview():
    return (f"Remeshes triangle meshes by geodesic Poisson-disk sampling.\nUsage: gpremesh remesh [OPTIONS] IN [OUT]\n\n"
            f"{_EPILOG}\n'gpremesh remesh --help' lists the everyday options, 'gpremesh remesh --help-all' all options.\n"
            f"{_without_program()}")


def _without_program():
    others = ", ".join(name for name in _core.command_names() if name != "remesh")
    return (f"The commands {others} are missing: this package was built without the program, because CLI11 (libcli11-dev "
            "on Debian) was missing.")


def run(words):
    """Runs a command line and returns the exit code."""
    words = _core.with_command(words)
    if words and words[0] in ("-h", "--help", "--help-all"):
        print(_overview())
        return 0
    if words and words[0] == "--version":
        print("gpremesh", _core.version)
        return 0
    if not words or words[0] not in _core.command_names():
        print("gpremesh: A subcommand is required. See gpremesh --help.", file=sys.stderr)
        return _USAGE
    if words[0] != "remesh":
        print("gpremesh:", _without_program(), file=sys.stderr)
        return 1
    try:
        return _remesh(words[1:])
    except _UsageError as error:
        print(f"gpremesh: {error}. See gpremesh --help.", file=sys.stderr)
        return _USAGE
