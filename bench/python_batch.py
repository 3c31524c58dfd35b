# SPDX-License-Identifier: GPL-3.0-or-later
"""Seconds of CPU time that ashimpact.impacts takes for a batch, a line a call: python_batch.py ARRAYS CALLS.

ARRAYS holds masses, radii and velocities of DMT impacts, one column after another, as bench/seams.cpp writes them.
"""

import sys
import time

import ashimpact
import numpy as np

mass, radius, velocity = np.fromfile(sys.argv[1]).reshape(3, -1)
for call in range(int(sys.argv[2]) + 1):
    start = time.process_time()
    ashimpact.impacts(
        law="dmt", mass=mass, radius=radius, velocity=velocity, contact_modulus=90e9, work_of_adhesion=0.3,
        damping=0.002, method="table", threads=1,
    )
    if call > 0:  # the first one makes the table
        print(time.process_time() - start)
