# SPDX-License-Identifier: GPL-3.0-or-later
"""Right tables and listings, and ways to spoil them: (kind, line number or None, bytes)."""

IMPACTS = [
    ["v_in [m/s]", "v_r [m/s]", "u(v_in) [m/s]", "u(v_r) [m/s]", "outcome", "correlation"],
    ["1.40", "0", "0.02", "0.02", "capture", "0.1"],
    ["1.72", "0.12", "0.02", "0.02", "rebound", "0.1"],
    ["2.10", "0.44", "0.02", "0.02", "rebound", "0"],
    ["2.55", "0.73", "0.02", "0.02", "", "0"],
    ["3.35", "1.20", "0.02", "0.02", "rebound", "-0.1"],
]
XRD_LONG = [
    ["Sample", "Phase", "Weight [wt.%]", "ESD", "Density [g/cm3]"],
    ["FA-01", "Quartz", "12.31", "0.20", "2.65"],
    ["FA-01", "Mullite", "28.40", "0.55", "3.16"],
    ["FA-01", "Amorphous", "59.29", "0.70", ""],
]
XRD_WIDE = [
    ["Sample", "Quartz [wt%]", "Mullite [wt%]", "Amorphous [wt%]"],
    ["FA-01", "12.3", "29.7", "58.0"],
    ["FA-02", "8.1", "32.0", "59.9"],
]
PEAKS = [
    ["phase", "intensity", "uncertainty", "RIR", "RIR uncertainty"],
    ["Quartz", "3410", "60", "3.1", "0.1"],
    ["Mullite", "1890", "45", "2.5", "0.1"],
]

NO_NUMBERS = ["much", "nan", "inf", "1e999", "1.2.3", "0x10", "1e", "--1", "1 2", "5 m5", "9" * 400, "1\0", "7" * 100_000]

# For each column what its cells may not be. Any number that is none is wrong everywhere.
WRONG_CELLS = {
    "u(": ["-0.02", "1e300"],
    "v_in": ["-1.4", "0", "1e300", "1e-320", "1e41"],
    "v_r": ["-0.9", "9.5", "1e300"],
    "outcome": ["maybe", "7", "x" * 100_000],
    "correlation": ["2", "-1.5", "1e300"],
    "Weight": ["-1", "101", "1e300"],
    "wt%": ["-1", "101", "1e300"],
    "ESD": ["-1", "1e300"],
    "Density": ["-2.65", "0", "1e300", "1e-320", "2.65 GPa"],
    "intensity": ["-1", "1e300"],
    "uncertainty": ["-1", "1e300"],
    "RIR": ["-3.1", "0", "1e300"],
}


def text_of(rows, separator=","):
    return "\n".join(separator.join(row) for row in rows) + "\n"


def kinds_of(column):
    return next((cells for name, cells in WRONG_CELLS.items() if column.startswith(name) or name in column), [])


def spoiled_table(rows, names, first_line=2):
    """names: the columns of names, whose cells may be any text."""
    heading = rows[0]
    for row in range(1, len(rows)):
        for column, title in enumerate(heading):
            if title in names:
                continue
            numbers = [] if title == "outcome" else NO_NUMBERS
            if title in ("ESD", "uncertainty", "RIR uncertainty", "Density [g/cm3]"):
                numbers = [text for text in numbers if text != "nan"]  # "nan" states that there is none
            for cell in [*numbers, *kinds_of(title)]:
                changed = [list(other) for other in rows]
                changed[row][column] = cell
                unnamed = cell == "nan" and rows is XRD_WIDE  # the phase is not there, and the rest adds up to too little
                yield "cell", None if unnamed else row + 1, text_of(changed).encode("utf-8", "surrogateescape")
        for more in ("extra", "1"):
            changed = [list(other) for other in rows]
            changed[row] += [more] * 3
            yield "long", row + 1, text_of(changed).encode()
    for column, title in enumerate(heading):
        changed = [list(other) for other in rows]
        changed[0][column] = "v_in [kg]" if title.startswith("v_") else title
        if title.startswith("v_in"):
            yield "unit", 1, text_of(changed).encode()
            changed[0][column] = "v_in [furlnogs/s]"
            yield "unit", 1, text_of(changed).encode()
            yield "missing", 1, text_of([[cell for i, cell in enumerate(row) if i != column] for row in rows]).encode()
        # Uncertainties may follow each of several columns under one name.
        if title != "outcome" and title not in names and title != "ESD" and "uncertainty" not in title:
            twice = [[*row, row[column]] for row in rows]
            yield "duplicate", 1 if rows is not XRD_WIDE else None, text_of(twice).encode()
    text = text_of(rows)
    yield "missing", None, text_of(rows[:1]).encode()
    yield "missing", None, b""
    yield "missing", None, b"\n\n\n"
    yield "missing", None, b"# a comment only\n"
    yield "missing", 1, text_of(rows[1:]).encode()
    yield "text", None, b"nonsense\n"
    yield "text", None, b"{}"
    yield "text", None, b"[]"
    yield "text", None, b"<html><body>404</body></html>\n"
    yield "text", None, bytes(range(256)) * 4
    yield "text", None, b"PK\x03\x04" + bytes(200)
    yield "encoding", None, text.encode("utf-32")
    yield "control", None, text.replace(".", "\0.", 1).encode()
    yield "long", None, (",".join(f"c{i}" for i in range(20_000)) + "\n").encode()
    yield "long", None, (text_of(rows) + "x" * 2_000_000 + "\n").encode()
    yield "text", None, text_of(rows).replace(rows[1][0], '"' + rows[1][0], 1).encode()


BGMN = """Rietveld refinement to file(s) FA-07.xy
BGMN version 4.2.23, 3001 measured points, 187 peaks, 64 parameters
58 iteration steps

Rp=4.71%  Rpb=51.23%  R=7.92%  Rwp=6.83% Rexp=2.06%

Global parameters and GOALs
****************************
QQuartz=0.3021+-0.0012
QMullite=0.6979+-0.0088

Local parameters and GOALs for phase Quartz
********************************************
XrayDensity=2.651
GEWICHT=0.3021

Local parameters and GOALs for phase Mullite
*********************************************
XrayDensity=3.16
GEWICHT=0.6979
"""


def spoiled_listing():
    for number in ("-0.3", "1.3", "nan", "inf", "1e999", "much", "", "0.3.1", "1e300", "9" * 400, "0,3"):
        yield "cell", 9, BGMN.replace("=0.3021+-", f"={number}+-", 1).encode()
    for number in ("-0.1", "nan", "much", "1e300", "1e999"):
        yield "cell", 9, BGMN.replace("+-0.0012", f"+-{number}", 1).encode()
    for number in ("-2.6", "0", "nan", "1e300", "much"):
        yield "cell", 14, BGMN.replace("XrayDensity=2.651", f"XrayDensity={number}", 1).encode()
    yield "missing", None, BGMN.split("Global")[0].encode()
    yield "duplicate", 10, BGMN.replace("QMullite", "QQuartz").encode()
    yield "long", None, (BGMN.split("Global")[0] + "x" * 3_000_000).encode()
    for position in (20, 60, 100):
        yield "cut", None, BGMN[:position].encode()
