"""Gradients of linkage_adjoint against central differences of linkage, and its refusals."""

import linkage
import linkage_adjoint
import numpy as np

STEP, STEPS = 1e-3, 300
TORQUES = 0.3 * np.sin(np.arange(STEPS) / 40)
RUNNING = np.linspace(1, 2, STEPS + 1) * STEP


def cost(stiffness=None, torques=TORQUES):
    """coupler_z over the motion, weighted, and twice the crank's angle at the end: instants use the torque after them."""
    solver = linkage.Solver()
    if stiffness is not None:
        solver.parameters.k = stiffness
    total = RUNNING[0] * solver.outputs().coupler_z
    for k in range(STEPS):
        solver.inputs.torque = torques[k]
        solver.step(STEP)
        total += RUNNING[k + 1] * solver.outputs().coupler_z
    return total + 2 * solver.outputs().crank_angle


motion = linkage_adjoint.Motion(STEPS)
inputs = linkage.Inputs()
for torque in TORQUES:
    inputs.torque = torque
    motion.set_inputs(inputs)
    motion.step(STEP)
assert motion.steps == STEPS
end_weight = np.zeros(STEPS + 1)
end_weight[-1] = 2
gradient = motion.gradient({"coupler_z": RUNNING, "crank_angle": end_weight})
by_number = motion.gradient({"crank_angle": 2.0})
by_array = motion.gradient({"crank_angle": end_weight})
assert by_number.parameters == by_array.parameters and np.array_equal(by_number.inputs["torque"], by_array.inputs["torque"])

stiffness = linkage.Solver().parameters.k
h = 1e-4 * stiffness
difference = (cost(stiffness + h) - cost(stiffness - h)) / (2 * h)
assert abs(gradient.parameters["k"] - difference) < 1e-6 * abs(difference), (gradient.parameters, difference)

assert gradient.inputs["torque"].shape == (STEPS + 1,) and gradient.z.shape == (3,)
largest = np.abs(gradient.inputs["torque"]).max()
for step in (0, 1, 150, 298, 299):
    moved = [TORQUES.copy() for _ in range(2)]
    moved[0][step] += 1e-2
    moved[1][step] -= 1e-2
    difference = (cost(torques=moved[0]) - cost(torques=moved[1])) / 2e-2
    assert abs(gradient.inputs["torque"][step] - difference) < 1e-6 * largest, (step, difference)
assert gradient.inputs["torque"][STEPS] == 0  # no output at the end takes the torque

# The start follows from no input here; its inputs and those of the first step are told apart.
assert gradient.start["torque"] == 0

try:
    motion.step(STEP)
except linkage.SolverError as error:
    assert "step invalid" in str(error), error
else:
    raise AssertionError("room for one step more")
for weights, text in (({"height": 1}, 'no output "height"'), ({"coupler_z": [1, 2]}, "301 for the start and 300 steps")):
    try:
        motion.gradient(weights)
    except ValueError as error:
        assert text in str(error), error
    else:
        raise AssertionError(weights)
for steps in (-1, 2**62):
    try:
        linkage_adjoint.Motion(steps)
    except ValueError as error:
        assert "steps: from 0" in str(error), error
    else:
        raise AssertionError(steps)
try:
    motion.gradient({"coupler_z": np.nan})
except ValueError as error:
    assert "weights must be finite" in str(error), error
else:
    raise AssertionError("a weight that is no number")
