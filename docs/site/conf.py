"""Sphinx's configuration of the site; docs/site/build runs it."""

import os
import sys

project = "ashimpact"
author = copyright = "the ashimpact authors"
version = release = os.environ["ASHIMPACT_SITE_VERSION"]

extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "sphinx.ext.napoleon"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = ["site/**", "_build/**"]
myst_enable_extensions = ["colon_fence", "deflist", "dollarmath"]
myst_dmath_double_inline = False
myst_heading_anchors = 4

html_theme = "furo"
html_title = "ashimpact"
html_copy_source = False
html_show_sphinx = False
html_static_path = ["static"]
html_css_files = ["katex/katex.min.css", "site.css"]

# Everything a page needs lies beside it: the site is read from a disk too. So KaTeX of Debian's libjs-katex, which docs/site/build
# copies, takes the place of MathJax on pages with equations.
myst_update_mathjax = False
mathjax_path = "katex/katex.min.js"
mathjax_inline = mathjax_display = ["", ""]
mathjax_options = {  # a line of equations breaks between them, a single one at its signs
    "defer": "defer",
    "onload": r"""document.querySelectorAll('.math').forEach(e => {
        const parts = e.textContent.split('\\qquad');
        const text = parts.length > 1 ? '{' + parts.join('}\\qquad\\allowbreak{') + '}' : parts[0];
        katex.render(text, e, {displayMode: e.tagName === 'DIV', throwOnError: false});
    })""",
}
html_theme_options = {"navigation_with_keys": True}

breathe_projects = {"ashimpact": os.environ["ASHIMPACT_DOXYGEN_XML"]}
breathe_default_project = "ashimpact"
primary_domain = None
highlight_language = "text"
nitpicky = False

# The Python reference comes from the sources; the compiled part is not needed to read their docstrings.
sys.path.insert(0, os.environ["ASHIMPACT_PYTHON_SOURCES"])
autodoc_mock_imports = ["ashimpact._core", "numpy", "pandas", "matplotlib"]
autodoc_typehints = "description"
autodoc_member_order = "bysource"
add_module_names = False
