"""The run of check.c through the Python module, printed alike, with what Python adds: check.py DIRECTORY."""

import sys

import numpy as np

sys.path.insert(0, sys.argv[1])
import four_bar


def hexadecimal(value):
    """As printf's %a: Python writes trailing zeros."""
    sign, rest = ("-", value.hex()[1:]) if value.hex().startswith("-") else ("", value.hex())
    mantissa, exponent = rest.split("p")
    return f"{sign}{mantissa.rstrip('0').rstrip('.')}p{exponent}"


solver = four_bar.Solver()
solver.assemble()
for i in range(1000):
    if i == 500:
        parameters = solver.parameters
        parameters.k = 1500.0
        solver.parameters = parameters
        inputs = solver.inputs
        inputs.torque = 2.0
        solver.inputs = inputs
    solver.step(1e-3)
for z, zd in zip(solver.z, solver.zd):
    print(hexadecimal(float(z)), hexadecimal(float(zd)))
outputs = solver.outputs()
print(hexadecimal(solver.t), hexadecimal(outputs.spring_force), hexadecimal(outputs.kinetic_energy))

assert "spring_force=" in repr(outputs)
assert solver.accelerations().shape == (3,)
assert not np.array_equal(solver.accelerations(), solver.accelerations([1.0, 0.0, 0.0]))
try:
    solver.accelerations([1.0])
    raise AssertionError("too few forces are taken")
except ValueError as error:
    assert "shape" in str(error)
state = solver.state
state.z[0] = float("nan")
solver.state = state
try:
    solver.step(1e-3)
    raise AssertionError("what is no number is taken")
except four_bar.SolverError as error:
    assert error.name == "crank_pin", error
