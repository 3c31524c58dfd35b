#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables as laboratories write them, each with what a careful reader reads in it, or that it refuses it.

    check.py PROGRAM [COUNT] [SEED]      COUNT tables (150; with ASHIMPACT_WHOLE 2000)

No table may be read otherwise than it says. Of the right ones those marked READ have to be read, of the others those
marked REFUSE to be refused; EITHER may end in both. Nothing here follows the program's code: the rule for a mark with two
readings is settle(), and what a heading holds is what it says to a person. Numbers come in twelve national forms, headings
with marks and units, tables with titles, units in a second line, footers, error values, cells that are struck out, raised,
merged or twice, as text and as .xlsx. Prints the tables that fail and ends with 1 if one did.
"""
import concurrent.futures
import io
import itertools
import json
import math
import os
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile
import types
import zipfile
from decimal import Decimal as D

READ, EITHER, REFUSE = "read", "either", "refuse"
BLANKS = " \u00a0\u202f\u2009'\u2019"
# Decimal mark, mark between groups, and sizes of groups but the last.
FORMS = [(".", "", 3), (",", "", 3), (".", ",", 3), (",", ".", 3), (".", ",", 2), *((",", blank, 3) for blank in BLANKS[:3]),
         (".", "\u2009", 3), (".", "'", 3), (".", "\u2019", 3), (".", " ", 3)]
PLAIN, COMMA = FORMS[0], FORMS[1]
PHASES = ["Quartz", "Mullite", "Hematite", "Magnetite", "Anhydrite", "Calcite", "Rutile", "Periclase", "Portlandite", "Glas"]


def written(value, form, decimals=None):
    """A number in a national form."""
    value = D(value) if decimals is None else D(value).quantize(D(1).scaleb(-decimals))
    whole, _, fraction = format(abs(value), "f").partition(".")
    if form[1]:
        groups, rest = [whole[-3:]], whole[:-3]
        while rest:
            groups.insert(0, rest[-form[2]:])
            rest = rest[:-form[2]]
        whole = form[1].join(groups)
    return ("-" if value < 0 else "") + whole + (form[0] + fraction if fraction else "")


def readings(text):
    """(value, decimal mark or None), or (as decimal, as grouped, mark) of a number with two readings."""
    plain = re.sub(rf"(?<=\d)[{BLANKS}](?=\d\d\d)", "", text)
    points, commas = plain.count("."), plain.count(",")
    if not points and not commas:
        return D(plain), None
    last = "." if plain.rfind(".") > plain.rfind(",") else ","
    other = ",." [last == ","]
    if points and commas:
        return D(plain.replace(other, "").replace(last, ".")), last
    if plain.count(last) > 1:
        return D(plain.replace(last, "")), other
    before, after = plain.split(last)
    if plain == text and len(after) == 3 and 1 <= len(before) <= 3 and before != "0":
        return D(before + "." + after), D(before + after), last
    return D((before or "0") + "." + (after or "0")), last


def settle(columns, thousands=False):
    """The numbers of columns, which may be thousands; None if one of them has two readings between which nothing decides."""
    read = [[readings(text) for text in column] for column in columns]
    marks = {number[1] for column in read for number in column if len(number) == 2} - {None}
    values = []
    for column in read:
        alike = {number[-1] for number in column if len(number) == 3}
        grouped = len(marks) == 1 and len(alike) == 1 and not marks & alike and all(len(number) == 3 for number in column)
        bare = any(number[0] and number[1] is None for number in column if len(number) == 2)
        shown = any(number[1] is not None for number in column if len(number) == 2)
        if thousands and alike and not grouped and (not marks or bare and not shown):
            return None
        if any(len(number) == 3 and not grouped and marks != {number[2]} and (marks or number[2] == ",") for number in column):
            return None
        values.append([number[int(grouped)] for number in column])
    return values


def table_of(kind, rows, truth, expect=READ, why="", options=()):
    """Rows of texts, and what they say."""
    return types.SimpleNamespace(kind=kind, rows=rows, truth=truth, expect=expect, why=why, options=options, before=[], after=[])


def stored(t, source):
    """Name and bytes of a table."""
    if any(isinstance(cell, dict) for row in t.rows for cell in row):
        return "table.xlsx", workbook(t.rows)
    separator = source.choice(";\t,")
    quoted = [[f'"{cell}"' if separator in cell else cell for cell in row] for row in t.rows]
    lines = [*t.before, *(separator.join(row) for row in quoted), *(line.replace(";", separator) for line in t.after)]
    text = source.choice(["\n", "\r\n"]).join(lines) + source.choice(["", "\n"])
    return "table.csv", text.encode(source.choice(["utf-8", "utf-8-sig"]) if max(text) > "\u00ff" else source.choice(["utf-8-sig", "latin-1"]))


def workbook(rows):
    """An .xlsx; a cell is a text or {"text", "raised", "struck", "error", "string", "format", "twice", "merged"}, the last over the cell below."""
    def xml_of(place, cell):
        cell = cell if isinstance(cell, dict) else {"text": cell}
        style = 1 if "struck" in cell else cell.get("format", 0)
        for kind in ("error", "string"):
            if kind in cell:
                return f'<c r="{place}" t="{kind[0]}"><v>{cell[kind]}</v></c>'
        if re.fullmatch(r"-?\d+(\.\d+)?", cell["text"]) and "raised" not in cell:
            return f'<c r="{place}" s="{style}"><v>{cell["text"]}</v></c>' * (2 if "twice" in cell else 1)
        raised = f'<r><rPr><vertAlign val="superscript"/></rPr><t>{cell["raised"]}</t></r>' if "raised" in cell else ""
        return f'<c r="{place}" s="{style}" t="inlineStr"><is><r><t>{cell["text"]}</t></r>{raised}</is></c>' if cell["text"] else ""
    lines = "".join(f'<row r="{i}">' + "".join(xml_of("ABCDEFGH"[k] + str(i), cell) for k, cell in enumerate(row)) + "</row>" for i, row in enumerate(rows, 1))
    merged = "".join(f'<mergeCell ref="{"ABCDEFGH"[k]}{i}:{"ABCDEFGH"[k]}{i + 1}"/>' for i, row in enumerate(rows, 1) for k, cell in enumerate(row)
                     if isinstance(cell, dict) and "merged" in cell)
    link = '<Relationship Id="{}" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/{}" Target="{}"/>'.format
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in {
                "_rels/.rels": "<Relationships>" + link("a", "officeDocument", "xl/workbook.xml") + "</Relationships>",
                "xl/workbook.xml": '<workbook xmlns:r="x"><sheets><sheet name="S" sheetId="1" r:id="a"/></sheets></workbook>',
                "xl/_rels/workbook.xml.rels": "<Relationships>" + link("a", "worksheet", "s.xml") + link("b", "styles", "styles.xml") + "</Relationships>",
                "xl/styles.xml": "<styleSheet><fonts><font/><font><strike/></font></fonts><cellXfs><xf/><xf fontId='1'/><xf numFmtId='10'/>"
                                 "<xf numFmtId='14'/></cellXfs></styleSheet>",
                "xl/s.xml": f"<worksheet><sheetData>{lines}</sheetData><mergeCells>{merged}</mergeCells></worksheet>"}.items():
            archive.writestr(name, content)
    return out.getvalue()


# ---- what headings hold: headings to be read, and headings that may be read or refused ----------------------------------

# What they hold: headings to be read (none: to be refused) || headings that may be read or refused.
SHARES = """
w 100: wt%;wt.%;wt.-%;wt-%;wt %;Wt%;Gew.-%;Gew.%;Gew-%;Gew. %;Massen-%;Masse-%;Ma.-%;weight %;Weight [%];mass %;% poids;% en masse;wt% of total;weight [wt%];Massenanteil [%];
 mass fraction [%];Weight percent;Gewichtsprozent;Gehalt [Gew.-%];content [wt%];Massenanteil in %;% w/w;m%;M.-%;m-%;Content (% w/w);Gehalt % w/w;FA1 wt %;wt% (n=3);FA1 (n = 3) [wt%] ||
 w [%];Rietveld;Rietveld [wt%];
 Quant. [%];Content (%);Anteil [%];%;% masse;% pds;viktprocent;SemiQuant [%];Konz. [%];wt%¹;wt% *;wt% (XRD);Weight%;Gew.-% (normiert);
 g/100 g;wt pct;W%;Weight (%);g;m [g]
w 1: mass fraction;weight fraction;Massenanteil;weight fraction [g/g];w [kg/kg];kg/kg || w;wf;w [1];mass fraction [-];Massenbruch
w 1000: g/kg;w [g/kg];Gehalt in g/kg;mg/g;wt‰;Gew.-‰;w [‰] || g kg-1
w 1000000: content mg/kg || ppm;ppmw;mg/kg;w [ug/g]
v 100: Vol-%;Vol.-%;vol%;vol.%;Vol %;volume %;Volumenanteil [%] || Volumen-%;V%;% v/v;v/v %;Vol. pct;% vol;Volumenprozent;content, vol%
v 1:  || volume fraction;Volumenanteil;φ;v/v
none 100: wt% ± 2;Mol-%;mol%;mole fraction [%];Stoffmengenanteil [%];at.%;at%;Atom-%;Flächen-%;area %;Rel. Int. [%];rel. intensity;I/Imax [%];I [%];
 Peakfläche [%];counts;Counts [cts];FWHM;FWHM [°2Th];2θ [°];Score;Δwt%;Δ Gew.-%;(wt%)²;wt%²;√wt%;ln(wt%);log wt%;1/wt%;σ(wt%);esd(wt%);
 u²(wt%);change in wt%;wt% loss;LOI [wt%];Rwp [%];Cryst. size [nm];d [Å];scale factor;mol/mol;n [mol];ppmv;Gehalt [Mol-%];
 Gehalt [Flächen-%];Stück-% ||
"""  # w, weights, or v, volumes, in units of the whole; none: anything else
SPREADS = """
1:  || esd;e.s.d.;±;+/-;SD;σ;u;error;Fehler;Unsicherheit;uncertainty;std. dev.;Standardabweichung;Std. error;Standardabw.;Est. error;
 Messunsicherheit;± 1σ;1σ;Standardfehler;incertitude;s;Err.;abs. error [wt%]
0.5:  || Fehler (2s);± 2σ;U (k=2);2σ;2 sigma;error (2σ);Unsicherheit (k = 2)
1/3:  || 3σ;3 sigma;Fehler (3σ)
none:  || rel. error [%];RSD [%];CV [%];u_rel [%];variance;Varianz;σ²;esd²;u²(w);u^2;95 % CI;CI;expanded uncertainty;LOD;min;max;N;√σ;ln σ
"""  # uncertainties: factor to the standard one
VELOCITIES = """
1: v_in [m/s];v_in (m/s);V_in [m/s];v_in in m/s;v_i [m/s];incident velocity [m/s];Einfallsgeschwindigkeit [m/s];vitesse d'impact [m/s];
 v_ein [m/s];vᵢ [m/s];v_0 [m/s];U_in [m/s];vel in [m/s];pre-impact velocity [m/s];v_in [ms-1];v_in [m s-1];v_in [m·s⁻¹];v_in [m s^-1];v_in m/s;v_in, m/s || v vor [m/s];v1 [m/s];v0 [m/s];v before [m/s];v_in,n [m/s];
 v_in [m/sec];v_in;v_in / m/s;v_in/(m/s);Vin[m/s]
0.001: v_in [mm/s];impact velocity (mm/s);v_in mm/s || v_before [mm/s];v_in [mm s⁻¹];v_in in mm/s;v_in / mm/s;velocity in [mm/s]
none: v_in ± 0.03 [m/s];v_in +/- 0.03 [m/s];v_in (±0.03) [m/s];v_in² [m²/s²];v_in^2 [m/s];v_in**2;√v_in [m/s];sqrt(v_in);ln(v_in);1/v_in [s/m];Δv [m/s];Δv_in [m/s];v_t [m/s];u(v_in) [m/s];
 σ(v_in) [m/s];E_in [J];v_in [m];v_in [%];a_in [m/s²];v_in - v_r [m/s];v_in·v_r [m²/s²];v_crit [m/s];v_in,t [m/s];v_in³;(v_in)² [m/s];
 -ln v_in;v_in^0.5;delta v_in [m/s] ||
"""  # v_in: factor to m/s
RATIOS = """
e: e;e_n;COR;e [-];e_n [1];Stoßzahl;coefficient of restitution;Restitutionszahl || e_N;Stosszahl;ε;v_r/v_in;e (normal);CoR [-];Rest.
100 * e:  || e [%];COR (%);e_n in %;e_n/%
e * e:  || e²;e^2;e_n²;COR²;COR^2;COR2;e2;e**2;(e_n)²;e_n·e_n;e ²;e² [-];COR squared;E_r/E_in;energy restitution;Stoßzahl²
math.sqrt(e):  || √e;√e_n;sqrt(e);e^0.5;e_n^(1/2);√COR;root of e;e_n^½
1 - e:  || 1-e;1−e_n
1 - e * e:  || 1-e²;1−e_n²
-math.log(e):  || -ln e;-ln(e);ln(1/e)
none: Δe;Δe_n;Δ e;delta e;e_t;e_tot;u(e);σ(e_n);SD(e);e³;log e;u²(e);N(e);tangential e;1/e ||
"""  # e: what is written of it


def headings(lists):
    """(what a heading holds, heading, expectation), in an order that looks random."""
    all_of = []
    for entry in re.split(r"\n(?=\S)", lists.strip()):
        holds, both = entry.replace("\n ", "").split(": ", 1)
        for expect, words in zip((REFUSE if holds.startswith("none") else READ, EITHER), both.split("||")):
            all_of += [(holds, heading.strip(), expect) for heading in words.split(";") if heading.strip()]
    random.Random(5).shuffle(all_of)
    return itertools.cycle(all_of)


class Corpus:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.shares_of, self.spreads_of, self.velocities_of, self.ratios_of = map(headings, (SHARES, SPREADS, VELOCITIES, RATIOS))
        self.edits = {kind: itertools.cycle(edits) for kind, edits in (("xrd", XRD_EDITS), ("impacts", IMPACT_EDITS))}

    def shares(self, decimals=1):
        """Phases and their per cent, which add up to 100."""
        names = [*self.random.sample(PHASES[1:-1], self.random.randint(1, 3)), PHASES[-1]]
        unit = 10**decimals
        parts = [D(self.random.randint(2 * unit, 19 * unit)).scaleb(-decimals) for _ in names]
        return {"Quartz": 100 - sum(parts), **dict(zip(names, parts))}

    def velocities(self, low=0.5, high=6.0, decimals=2):
        speeds = [D(self.random.uniform(low, high)).quantize(D(1).scaleb(-decimals)) for _ in range(self.random.randint(3, 5))]
        return [(v, (v * D(self.random.uniform(0.2, 0.8))).quantize(D(1).scaleb(-decimals))) for v in speeds]

    def table(self, turn):
        return [self.numbers, self.xrd_heading, self.impact_heading, self.edited, self.peaks][turn % 5](turn // 5)

    def numbers(self, turn):
        """Velocities in a national form, with groups, or with three decimals between which other numbers decide or do not."""
        form, way = FORMS[turn % len(FORMS)], self.random.choice(["groups", "groups", "three", "three and others", "all grouped", "conflict"])
        other = PLAIN if form[0] == "," else COMMA
        unit, factor = ("mm/s", D("0.001")) if way in ("groups", "all grouped") else ("m/s", D(1))
        pairs = self.velocities(1.1, 9.9, 3)
        columns = [[written(x, form, 3) for x in column] for column in zip(*pairs)]
        if way == "groups":
            columns = [[written(1000 * x, form, 1) for x in column] for column in zip(*pairs)]
        elif way == "all grouped":
            columns[1] = [written(1000 * r, other, 1) for _, r in pairs]
        elif way != "three":
            columns[1] = [written(r, other if way == "conflict" and i % 2 else form, 2) for i, (_, r) in enumerate(pairs)]
        values = settle(columns, unit == "mm/s")
        truth = values and [(v * factor, r * factor) for v, r in zip(*values)]
        expect = REFUSE if values is None else EITHER if form[1] == " " and way != "groups" else READ
        return table_of("impacts", [[f"v_in [{unit}]", f"v_r [{unit}]"], *map(list, zip(*columns))], truth, expect, f"numbers, {way}, in the form {form}")

    def peaks(self, turn):
        """Intensities with groups beside reference intensity ratios."""
        form, names, decimals = FORMS[turn % len(FORMS)], self.random.sample(PHASES[:-1], 3), self.random.choice([0, 0, 1])
        columns = [[written(D(self.random.randint(low, high)).scaleb(-places), form, shown) for _ in names]
                   for low, high, places, shown in ((1001, 999999, 0, decimals), (51, 499, 2, 2))]
        values = settle(columns)
        total = values and sum(i / r for i, r in zip(*values))
        truth = values and {"": {"w": {name: i / r / total for name, i, r in zip(names, *values)}}}
        return table_of("xrd", [["Phase", "Intensity", "RIR"], *map(list, zip(names, *columns))], truth, REFUSE if values is None else READ,
                        f"intensities in the form {form}", ["--amorphous-fraction", "none"])

    def xrd_heading(self, turn):
        form = self.random.choice([PLAIN, COMMA])
        if turn % 3 == 2:
            factor, heading, expect = next(self.spreads_of)
            shares, spreads = self.shares(), [D(self.random.randint(2, 19)).scaleb(-1) for _ in PHASES]
            rows = [["Phase", "wt%", heading], *([name, written(x, form), written(u, form)] for (name, x), u in zip(shares.items(), spreads))]
            truth = {"": {"w": {name: x / 100 for name, x in shares.items()}}}
            truth["u"] = factor != "none" and {name: float(u) * eval(factor) / 100 for name, u in zip(shares, spreads)}
            return table_of("xrd", rows, truth, EITHER, f"{heading!r} beside wt%: times {factor}")
        holds, heading, expect = next(self.shares_of)
        what, scale = holds.split()
        shares = self.shares()
        rows = [["Phase", heading], *([name, written(x * int(scale) / 100, form)] for name, x in shares.items())]
        truth = {"": {what: {name: x / 100 for name, x in shares.items()}}}
        return table_of("xrd", rows, truth, expect, f"{heading!r} holds {holds}")

    def impact_heading(self, turn):
        form, pairs = self.random.choice([PLAIN, COMMA]), self.velocities()
        if turn % 2:
            factor, heading, expect = next(self.velocities_of)
            rows = [[heading, "v_r [m/s]"], *([written(v / D(factor.replace("none", "1")), form), written(r, form)] for v, r in pairs)]
            return table_of("impacts", rows, pairs, expect, f"{heading!r} for v_in, times {factor}")
        holds, heading, expect = next(self.ratios_of)
        ratios = [D(self.random.randint(20, 80)).scaleb(-2) for _ in pairs]
        cells = [D(repr(round(eval(holds.replace("none", "e"), {"e": float(e), "math": math}), 9))) for e in ratios]
        rows = [["v_in [m/s]", heading], *([written(v, form), written(x, form)] for (v, _), x in zip(pairs, cells))]
        return table_of("impacts", rows, [(v, v * e) for (v, _), e in zip(pairs, ratios)], expect, f"{heading!r} holds {holds}")

    def edited(self, turn):
        """A right table with one thing more or less; see XRD_EDITS and IMPACT_EDITS."""
        form = self.random.choice([PLAIN, COMMA])
        if turn % 2:
            pairs = self.velocities()
            table = table_of("impacts", [["v_in [m/s]", "v_r [m/s]"], *([written(v, form), written(r, form)] for v, r in pairs)], pairs)
        else:
            shares = self.shares()
            rows = [["Phase", "Gew.-%"], *([name, written(x, form)] for name, x in shares.items())]
            table = table_of("xrd", rows, {"": {"w": {name: x / 100 for name, x in shares.items()}}})
        table.why, table.expect, edit = next(self.edits[table.kind])
        edit(table, self.random.randrange(1, len(table.rows)), self.random, form)
        return table


# ---- edits: what is done, expectation, and how, of a table t, a row i, a source of random numbers r and a form f ----------

def add(t, *row, gap=0):
    t.rows += [[""]] * gap + [list(row)]


def reads(t, i, mark, rebound):
    """The reading of an impact is a word."""
    t.rows[i][1], t.truth[i - 1] = mark, (t.truth[i - 1][0], rebound)


def cell(t, i, **what):
    """The table is an .xlsx, whose numbers are numbers; the last cell of a row has a format or a fault."""
    t.rows = [[each[0] if t.kind == "xrd" else each[0].replace(",", "."), each[1].replace(",", ".")] for each in t.rows]
    t.rows[i][1] = {"text": t.rows[i][1], **what}


def merge(t, column):
    """Two neighbouring cells are one; the second is empty in the file."""
    cell(t, 1)
    t.rows[1][column], t.rows[2][column] = {"text": t.rows[1][column], "merged": 1}, ""


def units(t, unit):
    """The units stand in a second line."""
    t.rows[0] = ["Phase", "Gehalt"] if t.kind == "xrd" else ["v_in", "v_r"]
    t.rows.insert(1, ["" if t.kind == "xrd" else unit, unit])
    by_volume(t, "ol" in unit)


def by_volume(t, really=True):
    if really:
        t.truth = {"": {"v": t.truth[""]["w"]}}


def numbered(t, f, label, gap):
    """A first column of numbers, and a row that sums up."""
    means = [written(sum(column) / len(column), f, 2) for column in zip(*t.truth)]
    t.rows = [["Nr.", *t.rows[0]], *([str(k), *each] for k, each in enumerate(t.rows[1:], 1))]
    add(t, label, *means, gap=gap)


def wide(t, *labels, spreads=(), beside=(), unit=""):
    """One row a sample, and rows that sum up; rows of uncertainties behind each; columns beside; a unit of the first phase."""
    names, *cells = zip(*t.rows[1:])
    t.rows = [["Probe", names[0] + unit, *names[1:]], *([label, *cells[0]] for label in ("FA1", *spreads, "FA2", *spreads, *labels))]
    for heading in beside:
        t.rows = [[*row, heading if i == 0 else "7"] for i, row in enumerate(t.rows)]
    t.truth = {"FA1": t.truth[""], "FA2": t.truth[""]}


def remark(t, i, text):
    """A column of remarks with one."""
    t.rows = [[*row, "Bemerkung" if k == 0 else text if k == i else ""] for k, row in enumerate(t.rows)]


def oxides(t):
    for row, name in zip(t.rows[1:], ["SiO2", "Al2O3", "Fe2O3", "CaO", "MgO"]):
        row[0] = name
    t.options = ["--amorphous-fraction", "none"]


def in_cells(t, unit, *headings):
    """The unit stands in the cells."""
    t.rows = [list(headings), *([*row[:t.kind.count("xrd")], *(f"{cell} {unit}" for cell in row[t.kind.count("xrd"):])] for row in t.rows[1:])]


ERRORS = ["#N/A", "#DIV/0!", "#WERT!", "#VALUE!", "#REF!", "#NV", "#NAME?", "Err:502", "####"]
JUNK = ["1.23.4", "1..95", "12,34.5", "1.2345,6", "1 23,4", "O.95", "1.95e", "0x1F", "1.95 0.31", "inf", "1/2", "01.05.2026", "1.9-2.1", ">1.95", "--1.95"]
BOTH_EDITS = [
    ("titles", READ, lambda t, i, r, f: t.before.extend(["Serie 3, Glas", ""])), ("comments", READ, lambda t, i, r, f: t.before.append("# wt%, v_in [m/s]")),
    ("trailing cells", READ, lambda t, i, r, f: t.after.append(";;;")), ("a note below", EITHER, lambda t, i, r, f: add(t, r.choice(["* lost", "Labor: N.N."]), "", gap=1)),
    ("a number of a sheet", READ, lambda t, i, r, f: cell(t, i)), ("a struck-out number", REFUSE, lambda t, i, r, f: cell(t, i, struck=True)),
    ("a raised digit", EITHER, lambda t, i, r, f: cell(t, i, raised="1")), ("a cell twice", REFUSE, lambda t, i, r, f: cell(t, i, twice=True)),
    ("a name or v_in over two rows", REFUSE, lambda t, i, r, f: merge(t, 0)),
    ("a date", REFUSE, lambda t, i, r, f: cell(t, i, format=3)), ("a text that is not there", REFUSE, lambda t, i, r, f: cell(t, i, string="7")),
    ("junk", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(t.kind == "xrd", r.choice(JUNK))),
    ("an error value for a number", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(t.kind == "xrd", r.choice(ERRORS))),
]
XRD_EDITS = [
    *BOTH_EDITS, ("a total", READ, lambda t, i, r, f: add(t, r.choice(["Summe", "Total", "Gesamt", "Sum"]), "100", gap=r.choice([0, 1]))),
    ("a wrong total", REFUSE, lambda t, i, r, f: add(t, "Summe", "71")), ("a phase twice", REFUSE, lambda t, i, r, f: add(t, *t.rows[i])),
    ("a phase that is lost", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(1, r.choice(["tr.", "n.d.", "-", ""]))),
    ("a phase in traces", READ, lambda t, i, r, f: add(t, "Lime", r.choice(["tr.", "n.d.", "< 0.5"]))),
    ("a limit", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(1, r.choice([">12", "≥ 12"]))), ("an error cell", REFUSE, lambda t, i, r, f: cell(t, i, error="#N/A")),
    ("another unit in a cell", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(1, r.choice(["12 vol%", "12 mol%"]))),
    ("units in a second line", READ, lambda t, i, r, f: units(t, r.choice(["wt%", "[Gew.-%]", "(wt%)", "Vol.-%"]))),
    ("moles in a second line", REFUSE, lambda t, i, r, f: units(t, "mol%")), ("two samples", READ, lambda t, i, r, f: wide(t)),
    ("rows that sum up", READ, lambda t, i, r, f: wide(t, r.choice(["Mittel", "Mean", "Mittelwert"]), "SD")),
    ("a standard that is only named", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(0, t.rows[i][0] + r.choice([" (internal standard)", " (spike)", ", int. std.", " [IS]"]))),
    ("not detected, by name", READ, lambda t, i, r, f: add(t, "Lime" + r.choice([" (not detected)", " (n.d.)", ", n.n."]), r.choice(["", "-", "0"]))),
    ("traces, by name", READ, lambda t, i, r, f: t.rows[i].__setitem__(0, t.rows[i][0] + " (traces)")),
    ("an uncertainty in per cent", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(1, t.rows[i][1] + r.choice([" ± 3%", "±3 %", " +- 3%"]))),
    ("a figure of merit", READ, lambda t, i, r, f: add(t, r.choice(["Rwp", "GOF", "Rexp [%]", "chi2"]), written(D("7.8"), f, 1))),
    ("units in cells", READ, lambda t, i, r, f: in_cells(t, r.choice(["wt%", "Gew.-%", "% w/w"]), "Phase", "Gehalt")),
    ("volumes in cells", REFUSE, lambda t, i, r, f: in_cells(t, "vol%", "Phase", "Gehalt")),
    ("glass in the crystalline part", REFUSE, lambda t, i, r, f: t.rows[0].__setitem__(1, "wt% (crystalline)")), ("oxides", REFUSE, lambda t, i, r, f: oxides(t)),
    ("rows of uncertainties", READ, lambda t, i, r, f: wide(t, spreads=[r.choice(["esd", "±", "SD"])])),
    ("columns beside", READ, lambda t, i, r, f: wide(t, beside=["Blaine [cm2/g]", "Rwp", r.choice(["LOI [%]", "density [g/cm3]"])])),
    ("ppm in one column", REFUSE, lambda t, i, r, f: wide(t, unit=" [ppm]")), ("repeats", READ, lambda t, i, r, f: t.rows[0].__setitem__(1, "Gew.-% (n=3)")),
    ("another basis beside the table", REFUSE, lambda t, i, r, f: (t.before if r.random() < 0.5 else t.after).extend(["", r.choice(["Angaben in Vol.-%", "mole fractions", "amounts by volume"])])),
    ("a group of volumes", READ, lambda t, i, r, f: (t.rows.__setitem__(slice(0, 1), [["Phase", r.choice(["Vol.-%", "Volume [%]"])], ["", "FA1"]]),
                                                     t.truth.__setitem__("FA1", {"v": t.truth.pop("")["w"]}))),
    ("a title of volumes", EITHER, lambda t, i, r, f: (t.before.append("Phasengehalte in Vol.-%"), by_volume(t))),
]
IMPACT_EDITS = [
    *BOTH_EDITS, ("rows that sum up", READ, lambda t, i, r, f: numbered(t, f, r.choice(["Mittel", "Mean", "Standardabw.", "SD", "s", "n", "max", "Schnitt", "SD (n=3)", "n=3", "RSD %", "Ø 1-3"]), r.choice([0, 1]))),
    ("a row of sums", REFUSE, lambda t, i, r, f: add(t, *(written(sum(column), f) for column in zip(*t.truth)))),
    ("a row of deviations", REFUSE, lambda t, i, r, f: add(t, *(written(statistics.stdev(column), f, 4) for column in zip(*t.truth)))),
    ("v_r beside e_n", READ, lambda t, i, r, f: t.rows.__setitem__(slice(None), [[*row, written(t.truth[k - 1][1] / t.truth[k - 1][0], f, 2) if k else "e_n"] for k, row in enumerate(t.rows)])),
    ("a row of another kind", REFUSE, lambda t, i, r, f: numbered(t, f, r.choice(["Serie", "foo", "", "?"]), r.choice([0, 1]))),
    ("a remark of an invalid impact", REFUSE, lambda t, i, r, f: remark(t, i, r.choice(["ungültig", "Ausreißer!", "exclude", "outlier (camera)", "haftet an der Wand"]))),
    ("a remark", READ, lambda t, i, r, f: remark(t, i, r.choice(["Bild unscharf", "kein Ausreißer", "ok", "haftet nicht"]))),
    ("a column of classes", READ, lambda t, i, r, f: t.rows.__setitem__(slice(None), [[*row, r.choice(["total", "max", "Mean"]) if k else "Art"] for k, row in enumerate(t.rows)])),
    ("units in cells", READ, lambda t, i, r, f: in_cells(t, "m/s", "v_in", "v_r")), ("whole mm/s", REFUSE, lambda t, i, r, f: t.rows.__setitem__(slice(None), [["v_in [mm/s]", "v_r [mm/s]"], ["1.753", "540"], ["950", "45"]])),
    ("a restitution above one", REFUSE, lambda t, i, r, f: t.rows.__setitem__(slice(None), [["v_in [m/s]", "e"], ["1.75", "0.54"], ["2.5", "69.8"]])),
    ("an error value", EITHER, lambda t, i, r, f: reads(t, i, r.choice(ERRORS), None)), ("an unknown reading", READ, lambda t, i, r, f: reads(t, i, "", None)),
    ("unknown, in words", EITHER, lambda t, i, r, f: reads(t, i, r.choice(["n.d.", "?", "tr."]), None)),
    ("a capture", READ, lambda t, i, r, f: reads(t, i, r.choice(["haftet", "stuck", "0"]), D(0))), ("v_in of zero", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(0, "0")),
    ("per cent", REFUSE, lambda t, i, r, f: t.rows[i].__setitem__(1, r.choice(["57 %", "57%"]))), ("a cell in per cent", REFUSE, lambda t, i, r, f: cell(t, i, format=2)),
    ("units in a second line", READ, lambda t, i, r, f: units(t, r.choice(["m/s", "[m/s]", "(m/s)"]))),
    ("an error cell", EITHER, lambda t, i, r, f: (cell(t, i, error="#N/A"), reads(t, i, t.rows[i][1], None))),
    ("a row twice", READ, lambda t, i, r, f: (add(t, *t.rows[i]), t.truth.append(t.truth[i - 1]))),
    ("a footnote", EITHER, lambda t, i, r, f: t.rows[i].__setitem__(0, t.rows[i][0] + "¹")),
    ("a second table", EITHER, lambda t, i, r, f: t.after.extend(["", "d [um];T [K]", "88;293"])),
    ("another unit beside the table", REFUSE, lambda t, i, r, f: (t.before if r.random() < 0.5 else t.after).extend(["", r.choice(["Velocities in mm/s", "all [cm/s]"])])),
    ("a title with a unit", EITHER, lambda t, i, r, f: (t.before.append("All in mm/s"), t.rows.__setitem__(0, ["v_in", "v_r"]),
                                                        t.truth.__setitem__(slice(None), [(v / 1000, x / 1000) for v, x in t.truth]))),
]


# ---- what the program reads --------------------------------------------------------------------------------------------

def near(one, other, tolerance=1e-7):
    return abs(float(one) - float(other)) <= tolerance * max(abs(float(one)), abs(float(other)), 1e-9)


class Checker:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, kind, name, content, options=()):
        path = os.path.join(self.folder, name)
        pathlib.Path(path).write_bytes(content)
        command = ["modulus", path] if kind == "xrd" else ["damping", "--law", "hertz", "--radius", "44 um", "--density", "2160", "--contact-modulus", "60 GPa", "--impacts", path]
        ended = subprocess.run([*self.program, *command, *options, "--json"], capture_output=True)
        return ended.returncode, ended.stdout.decode(), ended.stderr.decode().replace(path, "table")

    def of_xrd(self, table, read, number):
        samples = read.get("samples", [read])
        truth = {name: shares for name, shares in table.truth.items() if name != "u"}
        if len(samples) != len(truth):
            return f"{len(samples)} samples"
        for (name, shares), sample in zip(truth.items(), samples):
            (what, wanted), = shares.items()
            key = "weight_fraction" if what == "w" else "volume_fraction"
            found = {phase["name"]: phase[key] for phase in sample["phases"] if phase[key] > 1e-12}
            if (name and sample["name"] != name) or found.keys() != wanted.keys() or not all(near(found[each], wanted[each]) for each in wanted):
                return f"{sample.get('name')}: {what} {found}"
        if "u" not in table.truth:
            return None
        # Uncertainties are not printed: they show in that of the modulus, as from a plain table with them.
        modulus = {}
        for spread in {None: None, "u": table.truth["u"]}.items():
            lines = ["phase;weight %;esd", *(f"{each};{float(x) * 100};{spread[1][each] * 100 if spread[1] else ''}" for each, x in truth[""]["w"].items())]
            modulus[spread[0]] = json.loads(self.run("xrd", f"{number}-plain.csv", "\n".join(lines).encode())[1])["young_modulus"]["standard_uncertainty"]
        have = samples[0]["young_modulus"]["standard_uncertainty"]
        unused = near(have, modulus[None], 1e-6)
        return None if near(have, modulus["u"], 1e-6) or unused else "the uncertainties are not those of the table"

    @staticmethod
    def of_impacts(table, read):
        found = read["inversion"]
        rebounds = sorted((v, v * e) for v, e in zip(found["velocity"]["values"], found["restitution"]["values"]))
        wanted = sorted((v, r) for v, r in table.truth if r)
        captures, expected = sorted(found["captured_at"]["values"]), sorted(v for v, r in table.truth if r == 0)
        same = len(rebounds) == len(wanted) and all(near(*both) for pair in zip(rebounds, wanted) for both in zip(*pair))
        return None if same and len(captures) == len(expected) and all(map(near, captures, expected)) else f"{rebounds}, captures {captures}"

    def complaint(self, number, table, source):
        """What is wrong with how the program takes a table; None if nothing is."""
        name, content = stored(table, source)
        status, out, err = self.run(table.kind, f"{number}-{name}", content, table.options)
        if status == 2:
            return f"refused: {err.strip()}" if table.expect == READ else None
        if status != 0:
            return f"exit status {status}: {err.strip()}"
        if table.expect == REFUSE:
            return "read, to be refused"
        wrong = self.of_xrd(table, json.loads(out), number) if table.kind == "xrd" else self.of_impacts(table, json.loads(out))
        return wrong and f"read wrongly: {wrong}"


def main():
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 2000 if os.environ.get("ASHIMPACT_WHOLE") else 150
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    corpus = Corpus(seed)
    tables = [corpus.table(turn) for turn in range(count)]
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        checker = Checker(sys.argv[1].split(), folder)
        complaints = list(pool.map(lambda turn: checker.complaint(turn, tables[turn], random.Random(turn)), range(count)))
    for number, (table, complaint) in enumerate(zip(tables, complaints)):
        if complaint:
            print(f"table {number}, {table.kind}, {table.why} ({table.expect}): {complaint}\n    {table.rows[:3]}")
    print(f"{count} tables (seed {seed}): {sum(map(bool, complaints))} not taken as they should be")
    return 1 if any(complaints) else 0


if __name__ == "__main__":
    sys.exit(main())
