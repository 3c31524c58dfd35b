"""mend_furo.py SITE: makes the theme of Debian's package furo (2022.12) whole.

The package leaves three things out. Its script is a module that imports another one, which no browser loads from disk: so there is
no switch between light and dark. Its style sheet has no dark theme for readers whose system is dark, and imports a sheet of the
web server's. A theme that has none of these faults is left as it is.
"""

import re
import sys
from pathlib import Path

# What the page needs of normalize.css, which the imported sheet would be.
NORMAL = "body{margin:0}h1{margin:.67em 0}pre,code,kbd,samp{font-size:1em}img{border-style:none}button,input{font:inherit;margin:0}\n"

static = Path(sys.argv[1]) / "_static"

script = static / "scripts" / "furo.js"
text = script.read_text(encoding="utf-8")
imported = re.search(r'^import Gumshoe from "\./(.*)";\n', text)
if imported:
    other = (static / "scripts" / imported[1]).read_text(encoding="utf-8")
    script.write_text(other + text[imported.end():], encoding="utf-8")

sheet = static / "styles" / "furo.css"
text = sheet.read_text(encoding="utf-8")
text, count = re.subn(r'@import\s+(?:url\()?["\']?/[^;]*;\n?', "", text)
if count:
    text = NORMAL + text
dark = re.search(r'@media not print \{\s*(body\[data-theme="dark"\] \{.*?\})\s*html body', text, re.DOTALL)
if dark and "prefers-color-scheme" not in text:
    own = dark[1].replace('body[data-theme="dark"]', 'body:not([data-theme="light"])')
    rule = "@media screen and (prefers-color-scheme: dark) {" + own + "}\n"
    text = text[: dark.start()] + rule + text[dark.start():]
sheet.write_text(text, encoding="utf-8")
