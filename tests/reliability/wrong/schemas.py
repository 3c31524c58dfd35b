# SPDX-License-Identifier: GPL-3.0-or-later
"""What the program's own schemas say of a place in a document."""

import json
import subprocess


class Schema:
    """The schema of one kind of document, as `ashimpact schema NAME` prints it."""

    def __init__(self, program, name):
        text = subprocess.run([program, "schema", name], check=True, capture_output=True).stdout
        self.root = json.loads(text)

    def resolved(self, node):
        """The node with what it refers to put in its place; of several choices the one that is no null."""
        node = dict(node)
        while True:
            if "$ref" in node:
                target = self.root
                for part in node.pop("$ref").lstrip("#/").split("/"):
                    target = target[part]
                node = {**target, **node}
            elif "allOf" in node:
                merged = {}
                for part in node.pop("allOf"):
                    merged.update(self.resolved(part))
                node = {**merged, **node}
            elif "anyOf" in node:
                choices = [self.resolved(part) for part in node.pop("anyOf")]
                node = {**next(part for part in choices if part.get("type") != "null"), **node, "nullable": True}
            else:
                return node

    def member(self, node, key):
        """The schema of a member of an object or a list; None where the schema says nothing of it."""
        if isinstance(key, int):
            found = node.get("items")
        else:
            found = node.get("properties", {}).get(key, node.get("additionalProperties"))
        return self.resolved(found) if isinstance(found, dict) and found else None

    def keys(self):
        """Every key that the schema lists for an object, as (the object's definition or path, key); not those of a quantity."""
        found = set()

        def walk(node, path, seen):
            path, seen = self._named(node, path, seen)
            if path is None:
                return
            node = self.resolved(node)
            for key, part in node.get("properties", {}).items() if not is_quantity(node) else ():
                found.add((*path, key))
                walk(part, (*path, key), seen)
            for name in ("items", "additionalProperties"):
                if isinstance(node.get(name), dict):
                    walk(node[name], (*path, "*"), seen)

        walk(self.root, (), [])
        return found

    @staticmethod
    def _named(node, path, seen):
        """A definition is a place of its own, wherever it is referred to; None where it was seen before."""
        if "$ref" not in node:
            return path, seen
        if node["$ref"] in seen:
            return None, seen
        return (node["$ref"].rsplit("/", 1)[-1],), [*seen, node["$ref"]]

    def keys_used(self, document):
        """Those of keys() that a document has."""
        used = set()

        def walk(value, node, path):
            path = self._named(node, path, [])[0]
            node = self.resolved(node)
            if isinstance(value, dict) and not is_quantity(node):
                for key, part in value.items():
                    listed = key in node.get("properties", {})
                    if listed:
                        used.add((*path, key))
                    below = node["properties"][key] if listed else node.get("additionalProperties")
                    if isinstance(below, dict) and below:
                        walk(part, below, (*path, key if listed else "*"))
            elif isinstance(value, list) and isinstance(node.get("items"), dict):
                for part in value:
                    walk(part, node["items"], (*path, "*"))

        walk(document, self.root, ())
        return used


def is_quantity(node):
    """Whether a schema is that of a quantity: a number with a unit, and nothing else."""
    keys = set(node.get("properties", {}))
    return {"value", "unit"} <= keys <= {"value", "unit", "standard_uncertainty", "origin", "source"}
