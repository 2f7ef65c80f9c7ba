"""The crank of models/four_bar.json turns round and round: f and h along a motion of another engine, on its branch.
    revolution.py MBGEN MODEL DIRECTORY"""

import csv
import ctypes
import subprocess
import sys

import numpy as np
from external import External

mbgen, model, directory = sys.argv[1:4]
library = ctypes.CDLL(directory + "/libfour_bar_casadi.so")
f, h, jacobian = (External(library, name) for name in ("four_bar_f", "four_bar_h", "jac_four_bar_f"))
subprocess.run([mbgen, "simulate", model, "--duration", "0.6", "--step", "5e-4", "--input", "torque=5", "--engine", "generic", "--every", "7", "--out", directory + "/run.csv"],
               check=True, stdout=subprocess.DEVNULL)
with open(directory + "/run.csv") as file:
    rows = [{label.split(" ")[0]: float(value) for label, value in row.items()} for row in csv.DictReader(file)]
turned = max(abs(row["z.coupler_pin"]) for row in rows)
assert turned > 4 * np.pi, turned
stiffness, torque = np.array([1200.0]), np.array([5.0])
for row in rows:
    x = np.array([row["z.coupler_pin"], row["zd.coupler_pin"]])
    y = h(x, torque, stiffness)[:, 0]
    expected = [row[name] for name in ("crank_angle", "coupler_x", "coupler_z", "spring_force")]
    assert np.allclose(y, expected, rtol=1e-9, atol=1e-9), (row, y)

# xdot integrated by the midpoint rule from row to row meets the table: accelerations are those of the motion.
x = np.array([rows[0]["z.coupler_pin"], rows[0]["zd.coupler_pin"]])
step, per_row = 1e-4, 35
for row in rows[1:20]:
    for _ in range(per_row):
        half = x + 0.5 * step * f(x, torque, stiffness)[:, 0]
        x = x + step * f(half, torque, stiffness)[:, 0]
    assert abs(x[0] - row["z.coupler_pin"]) < 1e-4, (x, row)

# Arguments where the mechanism has no place are refused, and those beside them are not affected.
spring_of_no_length = External(library, "four_bar_f")
assert f(np.array([4000.0, 0]), torque, stiffness) is None
assert f(np.array([0.1, np.inf]), torque, stiffness) is None
assert np.array_equal(f(x, torque, stiffness), spring_of_no_length(x, torque, stiffness))
# Nothing moves by its own velocity alone but the coordinate: entries that are always zero are not in the pattern.
assert jacobian.patterns_out[0].dense([1] * jacobian.patterns_out[0].entries).tolist() == [[0, 1], [1, 1]]
assert jacobian.patterns_out[1].dense([1]).tolist() == [[0], [1]]
print("four_bar: %d rows over %.1f turns" % (len(rows), turned / (2 * np.pi)))
