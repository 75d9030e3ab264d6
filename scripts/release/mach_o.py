# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program or module for macOS says in its load commands: for which processor and system it is, and which
libraries it loads."""

import struct
from dataclasses import dataclass, field

MAGIC_64 = 0xFEEDFACF
PROCESSORS = {0x01000007: "x86_64", 0x0100000C: "arm64"}
LOAD_DYLIB, WEAK_DYLIB, REEXPORT_DYLIB = 0xC, 0x80000018, 0x8000001F
VERSION_MIN_MACOSX, BUILD_VERSION, CODE_SIGNATURE = 0x24, 0x32, 0x1D
MACOS_PLATFORM = 1


@dataclass
class LoadCommands:
    machine: str
    least_system: str = ""
    is_signed: bool = False
    libraries: list = field(default_factory=list)


def version_text(number):
    """10.15 of 0x000a0f00."""
    return f"{number >> 16}.{number >> 8 & 255}"


def load_commands(data):
    """Raises ValueError for what is no file of macOS, or one that ends too early."""
    if len(data) < 32:
        raise ValueError("no Mach-O file")
    magic, processor, _, _, count, size, _, _ = struct.unpack_from("<8I", data)
    if magic != MAGIC_64 or processor not in PROCESSORS or 32 + size > len(data):
        raise ValueError("no Mach-O file of 64 bits for a Mac")
    found = LoadCommands(PROCESSORS[processor])
    at = 32
    for _ in range(count):
        kind, length = struct.unpack_from("<2I", data, at)
        if length < 8 or at + length > 32 + size:
            raise ValueError("a load command ends behind the others")
        if kind in (LOAD_DYLIB, WEAK_DYLIB, REEXPORT_DYLIB):
            (offset,) = struct.unpack_from("<I", data, at + 8)
            found.libraries.append(data[at + offset:at + length].split(b"\0")[0].decode())
        elif kind == VERSION_MIN_MACOSX:
            found.least_system = version_text(struct.unpack_from("<I", data, at + 8)[0])
        elif kind == BUILD_VERSION:
            platform, least = struct.unpack_from("<2I", data, at + 8)
            if platform != MACOS_PLATFORM:
                raise ValueError(f"for platform {platform}, not for macOS")
            found.least_system = version_text(least)
        elif kind == CODE_SIGNATURE:
            found.is_signed = True
        at += length
    return found
