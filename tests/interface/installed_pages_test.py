#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""installed_pages_test.py BUILD: installs the program with its pages into a scratch folder, and follows every link of every page.
installed_pages_test.py --below FOLDER: the same for pages that are installed.

A link to a file must lead to an installed file, one to a heading to a heading of that page. Links into the net are not followed.
"""

import pathlib
import re
import subprocess
import sys
import tempfile


def headings(page):
    """The anchors of a page, as renderers of Markdown make them."""
    titles = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), flags=re.M)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def links(page):
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.S)
    for found in re.finditer(r"\]\(([^)\s]+)\)", text):
        if not re.match(r"[a-z]+:", found[1]):
            yield found[1]


def broken(page):
    for link in links(page):
        path, _, heading = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.exists():
            yield f"{link}: is not installed"
        elif heading and target.suffix == ".md" and heading not in headings(target):
            yield f"{link}: no such heading"


def faults_of(documents):
    pages = sorted(documents.rglob("*.md"))
    count = sum(len(list(links(page))) for page in pages)
    faults = [f"{page.relative_to(documents)}: {fault}" for page in pages for fault in broken(page)]
    empty = [folder for folder in documents.rglob("*") if folder.is_dir() and not any(folder.iterdir())]
    faults += [f"{folder.relative_to(documents)}: an empty folder is installed" for folder in empty]
    print("\n".join(faults))
    print(f"{len(pages)} pages, {count} links, {len(faults)} faults")
    return 1 if faults or len(pages) < 20 or count < 50 else 0


def main(arguments):
    if arguments[0] == "--below":
        return faults_of(pathlib.Path(arguments[1]))
    with tempfile.TemporaryDirectory() as scratch:
        for component in ("program", "documentation"):
            subprocess.run(["cmake", "--install", arguments[0], "--prefix", scratch, "--component", component], check=True,
                           stdout=subprocess.DEVNULL)
        return faults_of(pathlib.Path(scratch) / "share" / "doc")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
