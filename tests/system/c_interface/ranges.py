"""Ranges of parameters and inputs, and saved solvers: ranges.py DIRECTORY, of ranges.json; snapshot.py for others."""

import sys

sys.path.insert(0, sys.argv[1])
import ranges


def refused(action, text):
    try:
        action()
    except ranges.SolverError as error:
        assert str(error) == text, error
    else:
        raise AssertionError(f"taken: {text}")


solver = ranges.Solver()
for name, values in {"mass": [-5.0], "k": [99.0, 1001.0]}.items():
    for value in values:
        before = getattr(solver.parameters, name)
        refused(lambda: setattr(solver.parameters, name, value), f"parameter out of its range: {name}")
        assert getattr(solver.parameters, name) == before
for name, values in {"brake": [-500.0], "pull": [-51.0, 51.0]}.items():
    for value in values:
        refused(lambda: setattr(solver.inputs, name, value), f"input out of its range: {name}")
solver.parameters.offset = -0.1
solver.parameters.mass = 3.0
solver.inputs.brake = 0.0
solver.step(1e-3)

# Whoever calls C without asking is told by the call that takes the values; a good set mends it.
call, structure = solver._call, solver.parameters
wrong = ranges.Parameters(mass=-5.0, k=400.0, offset=0.1)
call("set_parameters", solver._solver, ranges.ctypes.byref(wrong))
before = bytes(solver.state)
for action in (lambda: solver.step(1e-3), lambda: solver.step(1e-3), solver.outputs, solver.assemble):
    refused(action, "parameter out of its range: mass")
assert bytes(solver.state) == before
solver.parameters = ranges.Parameters(mass=2.0, k=400.0, offset=0.1)
solver.step(1e-3)
call("set_inputs", solver._solver, ranges.ctypes.byref(ranges.Inputs(brake=-500.0)))
refused(lambda: solver.step(1e-3), "input out of its range: brake")
solver.inputs = ranges.Inputs(brake=1.0)
solver.step(1e-3)
set_one = solver._library.ranges_set_parameter
set_one.argtypes = [ranges.ctypes.c_void_p, ranges.ctypes.c_int, ranges.ctypes.c_double]
assert [set_one(solver._solver, index, value) for index, value in ((0, -1.0), (3, 1.0), (0, 2.5))] == [-2, -1, 0]
print("ranges hold, by name")
