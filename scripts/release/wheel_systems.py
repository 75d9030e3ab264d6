# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The systems that wheels are made for: how scikit-build-core and CMake are told to compile for each."""

import os
import re
import subprocess
import sys
from pathlib import Path

HEADERS = ("CLI", "nlohmann")  # libraries that are headers only
GLIBC = "2.28"  # of Debian 10, RHEL 8 and Ubuntu 18.10
MUSL_TAG = "musllinux_1_2"  # what zig brings is compatible with musl 1.2
MACOS = {"x86_64": "10.15", "arm64": "11.0"}  # the first with std::filesystem, the first on this processor
STABLE_ABI = "0x030c0000"  # what is declared in Python's headers for the stable ABI of 3.12


def build_requirements(project):
    """What pyproject.toml asks for, with CMake and ninja, since nothing is isolated."""
    found = re.search(r"^requires = \[(.*)\]", project.read_text(encoding="utf-8"), re.MULTILINE)
    return re.findall(r'"([^"]+)"', found.group(1)) + ["cmake>=3.26", "ninja"]


# zig's linker does not read nanobind's list of Python's symbols, and all that is undefined is looked up without it. It crashes
# at bundles; Python loads a library as well.
FOR_MACOS = """for word; do
	shift
	case $word in
	-Wl,@*) ;;
	-bundle) set -- "$@" -dynamiclib ;;
	*) set -- "$@" "$word" ;;
	esac
done
"""


class Here:
    """This machine's own compiler."""

    name = "here"
    machine = os.uname().machine
    is_musl = False
    kind = "Linux"
    is_this_machine = True

    def has(self, version):
        return True

    def settings(self, tools, folder, version):
        return []

    def environment(self):
        return {}


class ZigSystem:
    """A system that zig's clang compiles for. Its kind is CMake's name for it."""

    def __init__(self, name, target, kind="Linux"):
        self.name = name
        self.target = target
        self.kind = kind
        self.machine = name.split("-")[1]
        self.is_musl = "musl" in target
        self.is_this_machine = name == "linux-" + os.uname().machine

    def has(self, version):
        """Whether there is a wheel for this Python. Windows's libraries of 3.10 and 3.11 are not to be had here."""
        return version >= (3, 12) or self.kind != "Windows"

    def settings(self, tools, folder, version):
        """Settings of scikit-build-core; what they name lies in the folder."""
        folder.mkdir(exist_ok=True)
        install_zig(tools, folder)
        for name in ("c++", "ar", "ranlib", "rc"):
            # nanobind uses the header of C's input and output, which only other C++ libraries bring along.
            target = f' -target {self.target} -include stdio.h' if name == "c++" else ""
            write_script(folder / name, f'{FOR_MACOS if self.kind == "Darwin" else ""}exec "{zig_of(folder)}" -m ziglang {name}{target} "$@"')
        headers = collect_headers(folder / "include")
        defines = {f"GPR_{name}_INCLUDE_DIR": headers for name in ("CLI11", "JSON")}
        defines["CMAKE_TOOLCHAIN_FILE"] = self.write_toolchain(folder)
        defines["GPR_PYTHON_SUFFIX"] = self.suffix(version)
        if self.kind == "Windows":
            defines.update(windows_python(tools, folder))
        return ["install.strip=false"] + [f"cmake.define.{name}={value}" for name, value in defines.items()]

    def environment(self):
        """Without vcglib, whether or not it is here: compare has the engine's own methods only."""
        return {"GPR_CACHE_DIR": "/nonexistent"}

    def suffix(self, version):
        """How the name of a module ends that Python finds."""
        if self.kind == "Windows":
            return ".pyd"
        if version >= (3, 12):
            return ".abi3.so"
        if self.kind == "Darwin":
            return ".cpython-%d%d-darwin.so" % version
        return ".cpython-%d%d-%s-linux-%s.so" % (*version, self.machine, "musl" if self.is_musl else "gnu")

    def link_flags(self, is_module):
        """Without debugging symbols; where zig strips for macOS all of them, the table of indirect ones is wrong after it."""
        if self.kind != "Darwin":
            return "-s"
        return "-Wl,-undefined,dynamic_lookup" if is_module else ""

    def write_toolchain(self, folder):
        path = folder / "toolchain.cmake"
        path.write_text(f"""set(CMAKE_SYSTEM_NAME {self.kind})
set(CMAKE_SYSTEM_PROCESSOR {self.machine})
set(CMAKE_CXX_COMPILER {folder}/c++)
set(CMAKE_AR {folder}/ar CACHE FILEPATH "")
set(CMAKE_RANLIB {folder}/ranlib CACHE FILEPATH "")
set(CMAKE_RC_COMPILER {folder}/rc CACHE FILEPATH "")
# zig checks for undefined behaviour unless told otherwise.
set(CMAKE_CXX_FLAGS_INIT "-fno-sanitize=undefined")
set(CMAKE_EXE_LINKER_FLAGS_INIT "{self.link_flags(is_module=False)}")
set(CMAKE_MODULE_LINKER_FLAGS_INIT "{self.link_flags(is_module=True)}")
""", encoding="utf-8")
        return path


def write_script(path, text):
    path.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
    path.chmod(0o755)


def zig_of(folder):
    """The Python with ziglang, one for all systems."""
    return folder.parent / "zig/bin/python"


def install_zig(tools, folder):
    zig = zig_of(folder)
    if not zig.exists():
        subprocess.run([tools, "-m", "venv", zig.parents[1]], check=True)
        subprocess.run([zig, "-m", "pip", "--quiet", "--disable-pip-version-check", "install", "ziglang"], check=True)


def collect_headers(folder):
    """Links to libraries that are headers only, apart from the other headers of this system."""
    folder.mkdir(exist_ok=True)
    for name in HEADERS:
        if not (folder / name).exists():
            (folder / name).symlink_to(f"/usr/include/{name}")
    return folder


def windows_python(tools, folder):
    """Python's headers for Windows, and the library through which a module finds python3.dll. The headers are
    those of this system, which are the same on all but for pyconfig.h."""
    include = folder / "python"
    if not include.exists():
        code = "import sysconfig; print(sysconfig.get_path('include'))"
        ours = Path(subprocess.run([tools, "-c", code], check=True, capture_output=True, text=True).stdout.strip())
        include.mkdir()
        for path in ours.iterdir():
            if path.name != "pyconfig.h":
                (include / path.name).symlink_to(path)
        (include / "pyconfig.h").symlink_to(Path(__file__).with_name("windows_pyconfig.h"))
    library = folder / "python3.lib"
    write_import_library(folder, include, library)
    return {"GPR_WINDOWS_PYTHON_INCLUDE_DIR": include, "GPR_WINDOWS_PYTHON_LIBRARY": library}


def write_import_library(folder, include, library):
    """Of all that the headers declare for the stable ABI, as they say themselves."""
    source = folder / "declared.cpp"
    source.write_text("#include <Python.h>\n", encoding="utf-8")
    declared = subprocess.run([folder / "c++", f"-DPy_LIMITED_API={STABLE_ABI}", "-I", include, "-E", source],
                              check=True, capture_output=True, text=True).stdout
    # The name stands before the arguments, the semicolon or the bracket of what is declared.
    declaration = re.compile(r"dllimport\)\)?\)[^;{}]*?\b(_?Py\w+)\s*(?:\(|;|\[)")
    names = sorted(set(declaration.findall(declared)))
    if len(names) < 500:
        sys.exit(f"make_wheels: only {len(names)} names were found in Python's headers")
    definition = folder / "python3.def"
    definition.write_text("LIBRARY python3.dll\nEXPORTS\n" + "\n".join(names) + "\n", encoding="utf-8")
    subprocess.run([zig_of(folder), "-m", "ziglang", "dlltool", "-m", "i386:x86-64", "-d", definition,
                    "-l", library], check=True)


SYSTEMS = [
    ZigSystem("linux-x86_64", f"x86_64-linux-gnu.{GLIBC}"),
    ZigSystem("linux-aarch64", f"aarch64-linux-gnu.{GLIBC}"),
    ZigSystem("musl-x86_64", "x86_64-linux-musl"),
    ZigSystem("musl-aarch64", "aarch64-linux-musl"),
    ZigSystem("macos-x86_64", f"x86_64-macos.{MACOS['x86_64']}", "Darwin"),
    ZigSystem("macos-arm64", f"aarch64-macos.{MACOS['arm64']}", "Darwin"),
    ZigSystem("windows-x86_64", "x86_64-windows-gnu", "Windows"),
    Here(),
]


def by_names(text):
    known = {system.name: system for system in SYSTEMS}
    for name in text.split(","):
        if name not in known:
            sys.exit(f"make_wheels: there is no system {name}; it is one of {', '.join(known)}")
    return [known[name] for name in text.split(",")]
