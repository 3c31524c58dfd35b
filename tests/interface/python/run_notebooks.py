# SPDX-License-Identifier: GPL-3.0-or-later
"""run_notebooks.py FILE...: runs notebooks from top to bottom; any cell that fails ends it."""

import sys
import tempfile
import time

import nbclient
import nbformat

for name in sys.argv[1:]:
    with open(name, encoding="utf-8") as file:
        notebook = nbformat.read(file, as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells), f"{name}: kept outputs"
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        client = nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": folder}})
        client.execute()
    figures = sum("image/png" in output.get("data", {}) for cell in notebook.cells for output in cell.get("outputs", []))
    assert figures > 0, f"{name}: no figure was drawn"
    print(f"{name}: {len(notebook.cells)} cells, {figures} figures, {time.monotonic() - start:.1f} s")
