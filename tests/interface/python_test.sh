#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# python_test.sh BUILD: the Python module as users import it, its types as mypy sees them, its notebooks as they run.
set -euo pipefail
build=$(readlink -f "$1")
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(readlink -f "$here/../..")
export PYTHONPATH=$build/python ASHIMPACT_PROGRAM=$build/ashimpact PYTHONDONTWRITEBYTECODE=1
export ASHIMPACT_LIBRARY=$build/interface/libashimpact.so.1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# shellcheck source=tests/leave_out.sh
source "$here/../leave_out.sh"
[[ -d $build/python/ashimpact ]] || leave_out 'the module is not built: pybind11-dev, python3-dev (./dev deps library)'
/usr/bin/python3 -c 'import numpy, pandas, matplotlib, mypy, nbclient, ipykernel' 2>/dev/null ||
    leave_out 'python3-numpy, python3-pandas, python3-matplotlib, mypy, python3-nbclient, python3-ipykernel (./dev deps library)'

echo '== tests'
/usr/bin/python3 "$here/python/test_module.py"
/usr/bin/python3 -m doctest "$build/python/ashimpact/__init__.py"

echo '== types'
cd "$scratch"
mypy --strict --no-incremental --cache-dir "$scratch/mypy" --ignore-missing-imports -p ashimpact
mypy --strict --no-incremental --cache-dir "$scratch/mypy" "$here/python/consumer.py"
/usr/bin/python3 "$here/python/consumer.py"

echo '== notebooks'
export IPYTHONDIR=$scratch/ipython JUPYTER_RUNTIME_DIR=$scratch/jupyter MPLCONFIGDIR=$scratch/matplotlib
/usr/bin/python3 "$here/python/run_notebooks.py" "$root"/docs/notebooks/*.ipynb
