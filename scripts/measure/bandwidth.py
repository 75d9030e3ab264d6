# SPDX-FileCopyrightText: 2026 the gpremesh authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The bandwidth of the memory, by a plain copy of a large array."""

import ctypes
import os
import time
from concurrent.futures import ThreadPoolExecutor

COPIED_BYTES = 1 << 30  # no cache is so large
COPY_NUM = 5


def memory_bandwidth(byte_num=COPIED_BYTES):
    """Bytes a second, read and written ones together; all cores copy, each its part. The best of some copies."""
    source, target = (ctypes.create_string_buffer(byte_num) for _ in range(2))
    ctypes.memset(source, 1, byte_num)  # pages that were never written to would all be the same one
    seconds = min(_seconds_of_copy(source, target, byte_num) for _ in range(COPY_NUM))
    return 2 * byte_num / seconds


def _seconds_of_copy(source, target, byte_num):
    cores = len(os.sched_getaffinity(0))
    part = byte_num // cores

    def copy(i):
        ctypes.memmove(ctypes.addressof(target) + i * part, ctypes.addressof(source) + i * part, part)

    with ThreadPoolExecutor(cores) as pool:
        start = time.perf_counter()
        list(pool.map(copy, range(cores)))
        return time.perf_counter() - start
