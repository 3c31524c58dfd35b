# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to spoil a document, each of which makes it wrong whatever the rest says.

A way is (kind, pointer, text): the kind of mistake, the place that the message has to name (or a part of it, or what it is
a part of), and the document's new text or a function that makes it. Values that JSON cannot hold are put in by their text:
Raw.
"""

import copy
import json

from schemas import Schema, is_quantity

WRONG_UNIT = {"1": "m"}  # of a fraction; of all else the candela, which is of no quantity here


class Raw:
    """A value by its text."""

    def __init__(self, text):
        self.text = text


def text_of(document):
    raw = []

    def mark(value):
        if isinstance(value, Raw):
            raw.append(value.text)
            return f"@@raw{len(raw) - 1}@@"
        if isinstance(value, dict):
            return {key: mark(part) for key, part in value.items()}
        return [mark(part) for part in value] if isinstance(value, list) else value

    text = json.dumps(mark(document), indent=1, ensure_ascii=False)
    for index, piece in enumerate(raw):
        text = text.replace(f'"@@raw{index}@@"', piece, 1)
    return text


def pointer_of(path):
    return "/" + "/".join(str(key).replace("~", "~0").replace("/", "~1") for key in path)


def at(document, path):
    for key in path:
        document = document[key]
    return document


def replaced(document, path, value):
    if not path:
        return value
    changed = copy.deepcopy(document)
    at(changed, path[:-1])[path[-1]] = value
    return changed


def without(document, path, key):
    changed = copy.deepcopy(document)
    del at(changed, path)[key]
    return changed


def nested(depth):
    return Raw("[" * depth + "]" * depth)


def number_of(value):
    """The number of a quantity and its unit, as they stand."""
    if isinstance(value, dict):
        return value.get("value"), value.get("unit", "1")
    if isinstance(value, str):
        number, _, unit = value.partition(" ")
        try:
            return float(number), unit
        except ValueError:
            return None, None
    return value, None


def wrong_quantities(value, node, may_be):
    """(kind, value) for a quantity. may_be: what else it may be, of "negative", "zero", "tiny"."""
    number, unit = number_of(value)
    if number is None:
        return
    wrong = WRONG_UNIT.get(unit or "1", "cd") if "fraction" in node.get("description", "") else "cd"
    suffix = f" {unit}" if unit and unit != "1" else ""
    yield "unit", f"{number} {wrong}"
    yield "unit", f"{number} furlnogs"
    yield "unit", {"value": number, "unit": wrong}
    yield "unit", {"value": number, "unit": 3}
    yield "unit", {"value": number, "unit": "m\u0000"}
    yield "type", {"value": str(number), "unit": unit or ""}
    yield "type", {"value": None, "unit": unit or "1"}
    yield "missing", {"unit": unit or "1"}
    yield "unknown", {"value": number, "unit": unit or "1", "valeu": 1}
    yield "duplicate", Raw('{"value": %r, "value": %r, "unit": "1"}' % (number, number))
    yield "number", "nan" + suffix
    yield "number", "inf" + suffix
    yield "number", "much" + suffix
    yield "number", ""
    yield "number", "1e999" + suffix
    yield "number", f"{number} {number}{suffix} x"
    yield "number", Raw("1e999")
    yield "number", Raw("NaN")
    yield "huge", 1e300
    yield "huge", f"1e300{suffix}"
    yield "huge", {"value": -1e300, "unit": unit or "1"}
    yield "long", "1" * 100_000 + suffix
    yield "long", f"{number} " + "m" * 100_000
    if "tiny" not in may_be:
        yield "denormal", 5e-324
        yield "denormal", f"1e-310{suffix}"
    if "negative" not in may_be:
        yield "sign", f"-{abs(number) or 1}{suffix}"
        yield "sign", -abs(number) or -1.0
    if "zero" not in may_be:
        yield "range", 0
    plain = {"value": number, "unit": unit or "1"}
    yield "sign", {**plain, "standard_uncertainty": -abs(number) or -1.0}
    yield "type", {**plain, "standard_uncertainty": "1"}
    yield "huge", {**plain, "standard_uncertainty": 1e308}
    if "origin" in node["properties"]:
        yield "unknown", {**plain, "origin": "guesed"}
        yield "type", {**plain, "origin": 3}
        yield "type", {**plain, "source": ["a"]}


def wrong_values(value, node, may_be):
    """(kind, value) for any place, from what its schema says."""
    kinds = node.get("type", [])
    kinds = {kinds} if isinstance(kinds, str) else set(kinds)
    if "enum" in node:
        kinds = {"string"}
    if not kinds:
        return
    nullable = "null" in kinds or node.get("nullable")
    others = {"boolean": True, "object": {}, "array": [], "string": "x", "number": 7}
    if not nullable:
        yield "type", None
    for kind, other in others.items():
        fits = kind in kinds or (kind == "number" and "integer" in kinds)
        if not fits and not (kind == "string" and "number" in kinds and "string" in kinds):
            yield "type", other
    if "array" not in kinds:
        yield "deep", nested(200)
        yield "type", [value]
    yield "deep", nested(100_000)

    if is_quantity(node) and "number" in kinds:
        yield from wrong_quantities(value, node, may_be)
    elif "enum" in node:
        yield "unknown", "no such name"
        yield "unknown", str(value) + "x"
        yield "unknown", ""
        yield "unknown", str(value) + "\u0000"
        yield "long", "x" * 1_000_000
    elif "string" in kinds and "text" not in may_be:
        yield "control", str(value) + "\u0000y"
        yield "encoding", Raw('"\\ud800"')
        if node.get("minLength"):
            yield "range", ""
        if "pattern" in node:
            yield "range", "g" * 64
            yield "long", "0" * 100_000
    elif kinds & {"number", "integer"} and not isinstance(value, str):
        yield "number", Raw("1e999")
        yield "number", Raw("-Infinity")
        yield "number", Raw("0x10")
        yield "number", Raw("01")
        if "maximum" in node:
            yield "range", node["maximum"] + max(1, abs(node["maximum"]) * 1e-3)
            yield "huge", 1e300
        if "minimum" in node or "exclusiveMinimum" in node:
            least = node.get("minimum", node.get("exclusiveMinimum"))
            yield "range", least - 1
            yield "sign", -1e300
        if "exclusiveMinimum" in node:
            yield "range", node["exclusiveMinimum"]
        if "integer" in kinds:
            yield "type", 5.5
            yield "denormal", 5e-324
    if "array" in kinds and isinstance(value, list):
        if node.get("minItems"):
            yield "range", []
        if value and node.get("uniqueItems"):
            yield "duplicate", [*value, value[0]]
            yield "long", [value[0]] * 10_000
        if value and isinstance(node.get("items"), dict) and node["items"]:
            yield "type", [*value, None]
            yield "type", [*value, [value[0]]]
    if "object" in kinds and isinstance(value, dict):
        if node.get("additionalProperties") is False:
            yield "unknown", {**value, "no such key": 1}
            yield "unknown", {**value, "": 1}
            yield "long", {**value, "k" * 100_000: 1}
            yield "long", {**value, **{f"key {i}": i for i in range(5_000)}}
        if node.get("minProperties"):
            yield "range", {}
        if value:
            key = next(iter(value))
            body = json.dumps(value, ensure_ascii=False)
            twice = json.dumps({key: value[key]}, ensure_ascii=False)
            yield "duplicate", Raw(body[:-1] + ", " + twice[1:])


def spoiled(schema: Schema, document, rules):
    """Every (kind, pointer, text) of a document. rules: what the schema does not say; see documents.py."""
    root = schema.resolved(schema.root)

    def walk(value, node, path):
        if node is None or rules.leave_alone(path):
            return
        may_be = rules.may_be(path)
        for kind, other in wrong_values(value, node, may_be):
            if not rules.is_right(path, kind, other):
                yield kind, pointer_of(path), lambda path=path, other=other: text_of(replaced(document, path, other))
        if isinstance(value, dict):
            needed = set(node.get("required", [])) if not is_quantity(node) else set()
            for key in value:
                if key in needed or rules.is_needed((*path, key)):
                    yield "missing", pointer_of(path), lambda path=path, key=key: text_of(without(document, path, key))
            for key, part in value.items():
                if not (is_quantity(node) and key in ("value", "unit", "standard_uncertainty", "origin", "source")):
                    yield from walk(part, schema.member(node, key), (*path, key))
        elif isinstance(value, list):
            for index in rules.entries(value):
                yield from walk(value[index], schema.member(node, index), (*path, index))

    yield from walk(document, root, ())


def broken_json(text, random, count):
    """(kind, None, bytes) of what is no JSON."""
    data = text.strip().encode()
    for position in sorted(random.sample(range(len(data)), count)):
        yield "cut", None, data[:position]
    for _ in range(count):
        position = random.randrange(len(data))
        yield "control", None, data[:position] + b"\0" + data[position:]
        yield "encoding", None, data[:position] + bytes([random.choice([0x80, 0xC0, 0xF8, 0xFF])]) + data[position:]
    yield "text", None, data + data
    yield "text", None, data + b"}"
    yield "text", None, data[:-1] + b",}"
    yield "text", None, b"# a comment\n" + data
    yield "text", None, data.replace(b'"', b"'")
    yield "text", None, b""
    yield "text", None, b" \n\n"
    yield "text", None, b"{"
    yield "text", None, b"nonsense"
    yield "text", None, b"[]"
    yield "text", None, b"null"
    yield "text", None, b'"text"'
    yield "text", None, b"7"
    yield "text", None, bytes([0x1F, 0x8B, 8, 0, 0, 0, 0, 0])
    yield "encoding", None, text.encode("utf-16")
    yield "deep", None, b'{"a":' * 100_000
    yield "deep", None, b"[" * 1_000_000
    yield "deep", None, b'{"a":' * 20_000 + b"1" + b"}" * 20_000
    yield "long", None, b'{"' + b"k" * 5_000_000 + b'": 1}'
