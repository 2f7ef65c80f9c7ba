"""Inverse dynamics by the Python module beside `mbgen evaluate --inverse --engine null-space`."""
import json
import subprocess
import sys

import numpy as np

sys.path.insert(0, "made")
import parallel_ankle  # noqa: E402

mbgen, model = sys.argv[1:]
solver = parallel_ankle.Solver()
solver.state.z[:] = [0.1, 0.1, 0.1, 0.05]
solver.state.zd[:] = [3, 3, 3, -1]
solver.assemble()
at = solver.state
zdd = {"ankle_ry": 100, "ankle_rx": -40}
force, found = solver.inverse_dynamics([zdd.get(name, 0) for name in parallel_ankle.COORDINATES])
state = {"z": list(at.z[:]), "zd": list(at.zd[:]), "zdd": zdd}
with open("states.json", "w") as file:
    json.dump({"joint_order": parallel_ankle.COORDINATES, "states": [state]}, file)
answer = json.loads(subprocess.run([mbgen, "evaluate", model, "--inverse", "--engine", "null-space", "--states", "states.json"],
                                   check=True, capture_output=True, text=True).stdout)["states"][0]
expected = [answer["actuators"][name] for name in parallel_ankle.ACTUATORS]
assert np.allclose(force, expected, rtol=1e-9, atol=0), (force, expected)
assert np.allclose(found, answer["zdd"], rtol=1e-9, atol=1e-9), (found, answer["zdd"])
# The motors alone lead to the same pose, and their torques to the same work.
motors = [parallel_ankle.COORDINATES.index(name) for name in ("motor_a", "motor_b")]
other = parallel_ankle.Solver()
other.complete_joints(np.array(at.z)[motors], np.array(at.zd)[motors])
assert np.allclose(other.state.z, at.z, rtol=0, atol=1e-9), (other.state.z[:], at.z[:])
assert np.allclose(other.state.zd, at.zd, rtol=0, atol=1e-8), (other.state.zd[:], at.zd[:])
positions, speeds = other.actuator_positions()
assert np.allclose(positions, np.array(at.z)[motors], rtol=0, atol=1e-9) and np.allclose(speeds, np.array(at.zd)[motors])
assert np.allclose(solver.complete_accelerations(found[motors]), found, rtol=1e-9, atol=1e-9)
assert np.allclose(solver.actuator_jacobian() @ np.array(at.zd)[motors], at.zd, rtol=1e-9, atol=1e-9)
tau = solver.forces_at_independent(force)
assert abs(np.dot(tau, at.zd) - np.dot(force, np.array(at.zd)[motors])) < 1e-9
assert np.allclose(solver.forces_at_actuators(tau), force, rtol=1e-9, atol=0)
try:
    solver.inverse_dynamics([0, 0])
    raise SystemExit("two accelerations were taken for four")
except ValueError as error:
    assert "zdd has shape (2,)" in str(error), error
print("inverse dynamics: ok")
