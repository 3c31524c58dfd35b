#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""lower.py FILE...: lets shared libraries load where glibc is older than the one they were built with.

What they take of a glibc later than 2.17 is taken in whatever version is there, and its absence is no error any more:
the entry of .gnu.version_r becomes weak, the symbols of it lose their version. Symbols that an older glibc does not have
at all are those of older_glibc.c.
"""

import re
import struct
import sys

VER_FLG_WEAK, GLOBAL = 2, 1


def sections(elf: bytes) -> dict:
    """Offset and size of each section of a 64-bit ELF, by its type."""
    table, (size, count) = struct.unpack_from("<Q", elf, 40)[0], struct.unpack_from("<HH", elf, 58)
    found = {}
    for i in range(count):
        kind, _, _, offset, length, link = struct.unpack_from("<IQQQQI", elf, table + i * size + 4)
        found[kind] = (offset, length, struct.unpack_from("<Q", elf, table + link * size + 24)[0])
    return found


def lowered(elf: bytearray) -> bytearray:
    need, versym = sections(elf).get(0x6FFFFFFE), sections(elf).get(0x6FFFFFFF)
    late = set()
    at = need[0] if need else None
    while at is not None:
        _, count, _, first, following = struct.unpack_from("<HHIII", elf, at)
        entry = at + first
        for _ in range(count):
            _, flags, index, name, step = struct.unpack_from("<IHHII", elf, entry)
            start = need[2] + name
            text = elf[start : elf.index(0, start)].decode()
            version = re.fullmatch(r"GLIBC_2\.(\d+)(\.\d+)*", text)
            if version and int(version[1]) > 17 or text == "GLIBC_ABI_DT_RELR":
                struct.pack_into("<H", elf, entry + 4, flags | VER_FLG_WEAK)
                late.add(index)
            entry += step
        at = at + following if following else None
    for i in range(versym[0], versym[0] + versym[1], 2) if late else ():
        if struct.unpack_from("<H", elf, i)[0] & 0x7FFF in late:
            struct.pack_into("<H", elf, i, GLOBAL)
    return elf


for file in sys.argv[1:]:
    with open(file, "r+b") as opened:
        elf = lowered(bytearray(opened.read()))
        opened.seek(0)
        opened.write(elf)
