"""The run of four_bar.c in Python: python3 four_bar_run.py DIRECTORY_OF_THE_SOLVER. See docs/use/embedding.md."""

import sys

sys.path.insert(0, sys.argv[1])
import four_bar

linkage = four_bar.Solver()
linkage.assemble()
for i in range(1, 1001):
    linkage.inputs.torque = 0.0 if i < 500 else 2.0
    if i == 750:
        linkage.parameters.k = 1500.0
    linkage.step(1e-3)
    if i % 250 == 0:
        outputs = linkage.outputs()
        print(f"{linkage.t:5.3f} s  crank {outputs.crank_angle:8.4f} rad  spring {outputs.spring_force:8.3f} N")
