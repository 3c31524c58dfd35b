# SPDX-License-Identifier: GPL-3.0-or-later
"""blocks.py PAGE...: runs the shell and Python blocks of each page, in order, in one folder a page. Each line of a block
`output` has to be among what the block before it printed.

Python blocks of a page share their names. A block in C is saved under the name that the text before it gives and is
compiled in the test of the installed library.
"""

import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```(sh|python|output)\n(.*?)^```$", re.MULTILINE | re.DOTALL)

ran = 0
for page in sys.argv[1:]:
    with open(page, encoding="utf-8") as file:
        blocks = BLOCK.findall(file.read())
    with tempfile.TemporaryDirectory() as folder:
        python = said = ""
        for language, text in blocks:
            if language == "output":
                for line in filter(None, map(str.strip, text.splitlines())):
                    if line not in said:
                        print(f"{page}: the block before did not print this line:\n{line}\nbut:\n{said}")
                        sys.exit(1)
                continue
            if language == "sh":
                command = ["bash", "-euo", "pipefail", "-c", text]
            else:
                python += text + "\n"
                command = [sys.executable, "-W", "ignore", "-c", python]
            # A page that says `ashimpact init my-ash` twice starts anew the second time.
            if language == "sh" and "ashimpact init my-ash" in text:
                subprocess.run(["rm", "-rf", folder + "/my-ash"], check=True)
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                print(f"{page}: this block ended with {done.returncode}:\n{text}{done.stdout}{done.stderr}")
                sys.exit(1)
            said = done.stdout + done.stderr
            ran += 1
    print(f"{page}: {len(blocks)} blocks")
sys.exit(0 if ran >= 10 else 1)
