# SPDX-License-Identifier: GPL-3.0-or-later
"""links.py SITE: every link of every page to another page or a place in it must lead somewhere."""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.places = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" and value:
                self.places.add(value)
            if name in ("href", "src") and value and tag != "link":
                self.links.append(value)


site = Path(sys.argv[1])
pages = {path.resolve(): Page(path) for path in site.rglob("*.html")}
broken, checked = [], 0
for path, page in pages.items():
    for link in page.links:
        parts = urlsplit(link)
        if parts.scheme or parts.netloc:
            continue
        checked += 1
        target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
        if not target.is_file():
            broken.append(f"{path.relative_to(site.resolve())}: {link}: no such file")
        elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].places:
            broken.append(f"{path.relative_to(site.resolve())}: {link}: no such place")
print("\n".join(broken))
print(f"{checked} links on {len(pages)} pages, {len(broken)} broken")
sys.exit(1 if broken or checked < 100 else 0)
