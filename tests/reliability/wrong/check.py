#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A corpus of wrong documents, fed to the program: every key of every input missing, of a wrong type, unit, sign or range,
huge, denormal, twice, unknown, deep, long; JSON that is none; tables, XRD results, artifacts.

Each has to end with exit status 2 and one line that names the file, the place and what is allowed, with nothing on standard
output and nothing written, within 1 s of processor time and 200 MB.

    check.py PROGRAM [COUNT] [SEED]      COUNT documents (300; with ASHIMPACT_WHOLE 3000), drawn evenly over what is spoiled

Prints the documents that fail and a table of what was fed, and ends with 1 if one failed.
"""

import collections
import concurrent.futures
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import threading

import documents
import spoil
import tables
from schemas import Schema

MOST_SECONDS, MOST_KILOBYTES, LONGEST_LINE = 1.0, 200_000, 1_000

Input = collections.namedtuple("Input", "name file command ways bystanders")
CONTACT = ["--law", "dmt", "--radius", "44 um", "--density", "2300", "--contact-modulus", "90 GPa",
           "--work-of-adhesion", "0.3 J/m2"]
NEXT_STAGE = {"0-case": "modulus", "1-modulus": "contact", "2-contact": "analytic", "3-analytic": "comparison",
              "4-restitution": "damping", "5-damping": "fit", "6-fit": "critical-velocity",
              "7-critical-velocity": "histories", "8-histories": "comparison"}


# Keys whose readers tests/materials/glass, tests/pipeline and the tests of law parameters cover.
TESTED_ELSEWHERE = {"oxides", "oxides_decimal", "oxides_sample", "oxides_sheet", "glass", "glass_density", "temperature", "friction",
                    "angle", "adhesion_damping", "adhesion_damping_ratio"}


class Corpus:
    def __init__(self, program, root):
        self.program, self.root = program, root
        data = root / "data" / "cases" / "example"
        workbook = root / "tests" / "data" / "workbooks" / "openpyxl.xlsx"
        self.bystanders = {"ash.csv": (data / "ash.csv").read_bytes(), "impacts.csv": (data / "impacts.csv").read_bytes(),
                           "ash.xlsx": workbook.read_bytes(),
                           "standard.csv": b"phase,weight %\nquartz,60\nmullite,20\ncorundum,20\n"}

    def inputs(self):
        yield from self.json_inputs("case", documents.cases(), documents.CASE_RULES, ["run", "case.json", "-o", "out"])
        yield from self.json_inputs("sweep", documents.sweeps(), documents.SWEEP_RULES,
                                    ["sweep", "sweep.json", "-o", "out.json"])
        case = documents.case(documents.sample(), published="published.json", laws=["dmt"])
        yield from self.json_inputs("published", {"set": documents.PUBLISHED}, documents.CASE_RULES,
                                    ["run", "case.json", "-o", "out"], {"case.json": json.dumps(case).encode()})
        yield from self.artifacts()
        modulus = ["modulus", "table.csv", "--amorphous-fraction", "0.3"]
        impacts = ["damping", *CONTACT, "--impacts", "table.csv"]
        for name, rows, text_columns, command in [
                ("impacts", tables.IMPACTS, (), impacts), ("XRD, long", tables.XRD_LONG, ("Sample", "Phase"), modulus[:2]),
                ("XRD, wide", tables.XRD_WIDE, ("Sample",), modulus[:2]), ("XRD, peaks", tables.PEAKS, ("phase",), modulus)]:
            yield Input(name, "table.csv", command,
                        lambda rows=rows, text_columns=text_columns: tables.spoiled_table(rows, text_columns), {})
        yield Input("XRD, BGMN", "ash.lst", ["modulus", "ash.lst", "--amorphous-fraction", "0.3"], tables.spoiled_listing, {})

    def json_inputs(self, schema_name, right, rules, command, bystanders=None):
        schema = Schema(self.program, schema_name)
        used = set()
        for document in right.values():
            used |= schema.keys_used(document)
        unused = {path for path in schema.keys() - used if not TESTED_ELSEWHERE & set(path)}
        if unused:
            raise SystemExit(f"{schema_name}: no right document of documents.py has {sorted(unused)}")
        file = f"{schema_name}.json"
        for name, document in right.items():
            if schema_name == "sweep" or (schema_name == "case" and os.environ.get("ASHIMPACT_WHOLE")):
                self.check_right(f"{schema_name}, {name}", file, json.dumps(document).encode(), command)
            yield Input(f"{schema_name}, {name}", file, command,
                        lambda document=document: spoil.spoiled(schema, document, rules),
                        {**self.bystanders, **(bystanders or {})})
        text = json.dumps(next(iter(right.values())), indent=1)
        yield Input(f"{schema_name}, no JSON", file, command, lambda: spoil.broken_json(text, random.Random(3), 20),
                    {**self.bystanders, **(bystanders or {})})

    def artifacts(self):
        """The artifacts of a run, each read by the stage that comes after it."""
        with tempfile.TemporaryDirectory() as folder:
            for name, content in self.bystanders.items():
                pathlib.Path(folder, name).write_bytes(content)
            pathlib.Path(folder, "case.json").write_text(json.dumps(documents.cases()["reconstructed"]))
            subprocess.run([self.program, "run", "case.json", "-o", "out", "--no-report"], cwd=folder, check=True, capture_output=True)
            run = {f"out/{path.name}": path.read_bytes() for path in pathlib.Path(folder, "out").iterdir()}
        for stage, following in NEXT_STAGE.items():
            schema, document = Schema(self.program, stage), json.loads(run[f"out/{stage}.json"])
            command = ["run", "-o", "out", "--from", following]
            yield Input(f"artifact, {stage}", f"out/{stage}.json", command,
                        lambda schema=schema, document=document: spoil.spoiled(schema, document, documents.ARTIFACT_RULES),
                        {**self.bystanders, **run})
            text = run[f"out/{stage}.json"].decode()
            yield Input(f"artifact, {stage}, no JSON", f"out/{stage}.json", command,
                        lambda text=text: spoil.broken_json(text, random.Random(4), 5), {**self.bystanders, **run})

    def check_right(self, name, file, text, command):
        """A document that is to be spoiled is right itself."""
        if command[0] == "run":
            command = [*command, "--no-report"]
        with tempfile.TemporaryDirectory() as folder:
            for other, content in {**self.bystanders, file: text}.items():
                path = pathlib.Path(folder, other)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
            ended = subprocess.run([self.program, *command], cwd=folder, capture_output=True, text=True)
            if ended.returncode != 0:
                raise SystemExit(f"{name}: is not right itself: {ended.stderr}")


def as_bytes(text):
    text = text() if callable(text) else text
    return text if isinstance(text, bytes) else text.encode("utf-8", "surrogatepass")


def drawn(inputs, count, seed):
    """COUNT of all ways, even over inputs and kinds: (input, kind, place, index)."""
    groups = collections.defaultdict(list)
    for number, each in enumerate(inputs):
        for index, (kind, place, _) in enumerate(each.ways()):
            groups[each.name.split(",")[0], kind].append((number, kind, place, index))
    source = random.Random(seed)
    for members in groups.values():
        source.shuffle(members)
    chosen, total = [], sum(map(len, groups.values()))
    while groups and len(chosen) < count:
        for key in sorted(groups):
            if len(chosen) < count:
                chosen.append(groups[key].pop())
            if not groups[key]:
                del groups[key]
    return chosen, total


def snapshot(folder):
    found = {}
    for base, _, files in os.walk(folder):
        for name in files:
            status = os.lstat(os.path.join(base, name))
            found[os.path.relpath(os.path.join(base, name), folder)] = (status.st_size, status.st_mtime_ns)
        found[os.path.relpath(base, folder) + "/"] = None
    return found


def related(one, other):
    """Whether one pointer is the other, or leads to it."""
    shorter, longer = sorted((one.rstrip("/").split("/"), other.rstrip("/").split("/")), key=len)
    return longer[:len(shorter)] == shorter


def complaints(program, each, place, text, folder):
    """What is wrong with how the program takes a wrong document."""
    path = pathlib.Path(folder, each.file)
    path.write_bytes(text)
    before = snapshot(folder)
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        process = subprocess.Popen([program, *each.command], cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        said, message = out.read(), err.read()
    after = snapshot(folder)
    wrong = []
    if process.returncode != 2:
        wrong.append(f"exit status {process.returncode}")
    if said:
        wrong.append("something on standard output")
    if before != after:
        wrong.append(f"written: {sorted(set(after.items()) ^ set(before.items()))[:3]}")
    if usage.ru_utime + usage.ru_stime > MOST_SECONDS:
        wrong.append(f"{usage.ru_utime + usage.ru_stime:.2f} s")
    if usage.ru_maxrss > MOST_KILOBYTES:
        wrong.append(f"{usage.ru_maxrss // 1000} MB")
    try:
        line = message.decode()
    except UnicodeDecodeError:
        return [*wrong, "the message is no UTF-8"], message[:300].decode("latin-1")
    if process.returncode == 2:
        if line.count("\n") != 1 or not line.endswith("\n"):
            wrong.append(f"{line.count(chr(10))} lines")
        if re.search(r"[\x00-\x09\x0b-\x1f\x7f]", line):
            wrong.append("a control character")
        if len(line) > LONGEST_LINE:
            wrong.append(f"a line of {len(line)} characters")
        if each.file not in line:
            wrong.append("the file is not named")
        if "; allowed: " not in line:
            wrong.append("what is allowed is not said")
        found = re.search(r"\.json: (/.*?): ", line[line.find(each.file):])
        lines = re.search(r"line (\d+)", line)
        no_json = lines and "not valid JSON" in line
        # Of two numbers that have to agree one is named as the place, the other as what may be edited as well.
        as_well = isinstance(place, str) and f"or edit {place.rsplit('/', 1)[-1]} as well" in line
        if isinstance(place, str) and not no_json and not as_well and not (found and related(found[1], place)):
            wrong.append(f"the place {place} is not named")
        if isinstance(place, int) and not (lines and int(lines[1]) == place):
            wrong.append(f"line {place} is not named")
    return wrong, line[:400]


def main():
    program = os.path.abspath(sys.argv[1])
    whole = 3000 if os.environ.get("ASHIMPACT_WHOLE") else 300
    count = int(sys.argv[2]) if len(sys.argv) > 2 else whole
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    inputs = list(Corpus(program, pathlib.Path(__file__).resolve().parents[3]).inputs())
    chosen, total = drawn(inputs, count, seed)
    by_input = collections.defaultdict(dict)
    for number, _, _, index in chosen:
        by_input[number][index] = True

    failures, fed, lock = [], collections.Counter(), threading.Lock()
    top = tempfile.mkdtemp(prefix="ashimpact-wrong-")

    def feed(number):
        each = inputs[number]
        folder = tempfile.mkdtemp(dir=top)
        for name, content in each.bystanders.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        for index, (kind, place, text) in enumerate(each.ways()):
            if index not in by_input[number]:
                continue
            wrong, line = complaints(program, each, place, as_bytes(text), folder)
            with lock:
                fed[kind] += 1
                if wrong:
                    failures.append((each.name, kind, place, index, wrong, line))
                    kept = os.environ.get("ASHIMPACT_KEEP")
                    if kept:
                        pathlib.Path(kept, f"{number:03}-{index}-" + os.path.basename(each.file)).write_bytes(as_bytes(text))
            if not snapshot(folder).keys() <= {*each.bystanders, each.file, "./", "out/"}:
                shutil.rmtree(os.path.join(folder, "out"), ignore_errors=True)
                for name, content in each.bystanders.items():
                    path = pathlib.Path(folder, name)
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_bytes(content)

    try:
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(feed, by_input))
    finally:
        shutil.rmtree(top)
    for name, kind, place, index, wrong, line in sorted(failures, key=str):
        print(f"{name} #{index}, {kind} at {place}: {', '.join(wrong)}: {line.strip()}")
    print(", ".join(f"{number} {kind}" for kind, number in sorted(fed.items())))
    print(f"{sum(fed.values())} wrong documents of {total} (seed {seed}): {len(failures)} not refused as they should be")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
