#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# site_test.sh BUILD: the site builds without a warning, its links lead somewhere, its blocks run.
set -euo pipefail
build=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(readlink -f "$here/../..")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# shellcheck source=tests/leave_out.sh
source "$here/../leave_out.sh"

if ! command -v doxygen >/dev/null || ! /usr/bin/python3 -c 'import sphinx, myst_parser, furo, breathe' 2>/dev/null ||
    [[ ! -e /usr/share/javascript/katex/katex.min.js ]]; then
    leave_out 'doxygen, python3-sphinx, python3-myst-parser, furo, python3-breathe, libjs-katex (./dev deps docs)'
fi

echo '== the site'
"$root/docs/site/build" "$scratch/site" "$build/papers"
[[ -s $scratch/site/searchindex.js ]] || { echo 'failed: no search index'; exit 1; }
if grep -rhoE '(src|href)="(https?:)?//[^"]*\.(js|css|woff2?)"' --include='*.html' "$scratch/site"; then
    echo 'failed: a page needs something from elsewhere'
    exit 1
fi
# Read from disk a browser loads neither modules nor what a web server has.
if grep -rnE '^import |@import +(url\()?"?/' "$scratch/site/_static"; then
    echo 'failed: scripts or styles that do not work from disk'
    exit 1
fi
grep -q 'prefers-color-scheme: *dark' "$scratch/site/_static/styles/furo.css" || { echo 'failed: no dark theme'; exit 1; }
if command -v node >/dev/null; then  # what the build does not need: reading every equation as a browser does
    echo '== equations'
    grep -rhzoP --include='*.html' 'class="math[^>]*>\K[^<]+' "$scratch/site" | node -e '
        const katex = require(process.argv[1]), texts = require("fs").readFileSync(0, "utf8").split("\0").filter(Boolean);
        const plain = text => text.replaceAll("&amp;", "&").replaceAll("&lt;", "<").replaceAll("&gt;", ">");
        const wrong = texts.flatMap(text => { try { katex.renderToString(plain(text)); return [] } catch (e) { return [text, e.message] } });
        console.error(...wrong); process.exit(wrong.length || !texts.length ? 1 : 0);' "$scratch/site/_static/katex/katex.min.js"
fi
echo '== links'
/usr/bin/python3 "$here/site/links.py" "$scratch/site"
echo '== blocks'
PATH=$build:$PATH BUILD=$build PYTHONPATH=$build/python ASHIMPACT_PROGRAM=$build/ashimpact MPLCONFIGDIR=$scratch/matplotlib \
    /usr/bin/python3 "$here/site/blocks.py" "$root"/docs/tutorial/*.md "$root"/docs/how-to/*.md "$root/docs/validation.md"
