"""Derivatives of linkage_tangents against central differences of linkage, and its refusals."""

import linkage
import linkage_tangents
import numpy as np

STEP, STEPS = 1e-3, 300


def end_of(**changes):
    """Coordinates and outputs at the end, from the start of the model."""
    solver = linkage.Solver()
    for name, value in changes.items():
        setattr(solver.parameters, name, value)
    for _ in range(STEPS):
        solver.step(STEP)
    outputs = solver.outputs()
    return solver.z, np.array([getattr(outputs, name) for name, _ in linkage.Outputs._fields_])


motion = linkage_tangents.Motion(["c", "k"])
for _ in range(STEPS):
    motion.step(STEP)
assert abs(motion.t - STEP * STEPS) < 1e-12
z, by = motion.z
outputs, derivatives = motion.outputs()
assert z.shape == (3,) and by.shape == (3, 2) and motion.zd[1].shape == (3, 2)
default = linkage.Solver().parameters
for column, name in enumerate(["c", "k"]):
    value = getattr(default, name)
    h = 1e-4 * value
    (z_up, y_up), (z_down, y_down) = end_of(**{name: value + h}), end_of(**{name: value - h})
    difference = (z_up - z_down) / (2 * h)
    assert np.abs(by[:, column] - difference).max() < 1e-6 * np.abs(difference).max(), (by[:, column], difference)
    difference = (y_up - y_down) / (2 * h)
    exact = np.array([derivatives[field][column] for field, _ in linkage.Outputs._fields_])
    assert np.abs(exact - difference).max() < 1e-6 * np.abs(difference).max(), (exact, difference)
assert np.array_equal(z, end_of()[0]) or np.abs(z - end_of()[0]).max() < 1e-12

# The start moves with a length, while the crank that the model locks is held.
_, by = linkage_tangents.Motion(["l2"]).z
crank = linkage.COORDINATES.index("crank_pin")
assert by[crank, 0] == 0 and np.abs(by).max() > 0.1

for names, text in ((["none"], 'no tunable parameter or input "none"'), (["k"] * 9, "at most 8 directions")):
    try:
        linkage_tangents.Motion(names)
    except ValueError as error:
        assert text in str(error), error
    else:
        raise AssertionError(names)
