"""A saved solver goes on with the same bits: snapshot.py DIRECTORY MODULE STEP [INPUT=VALUE..]. Saves at many times, also
with parameters that no step has taken over, and goes on from there in the same solver and in another one."""

import importlib
import sys

sys.path.insert(0, sys.argv[1])
module = importlib.import_module(sys.argv[2])
STEP = float(sys.argv[3])
given = [text.split("=") for text in sys.argv[4:]]


def run(solver, steps):
    rows = []
    for _ in range(steps):
        solver.step(STEP)
        rows.append(bytes(solver.state) + bytes(solver.inputs) + bytes(solver.parameters))
        rows.append(bytes(solver.outputs()))
    return rows


def change(solver, at):
    """Inputs without their rates, and a parameter now and then."""
    for name, value in given if at % 2 == 0 else []:
        setattr(solver.inputs, name, float(value) * (1 + 0.01 * at))
    names = [name for name, _ in module.Parameters._fields_ if name != "unused_"]
    if names and at % 3 == 2:
        parameters = solver.parameters
        setattr(solver.parameters, names[0], getattr(parameters, names[0]) * 1.001)


solver, other = module.Solver(), module.Solver()
starts_anew = 0
for at in range(40):
    change(solver, at)
    saved, state = solver.save(), solver.state
    first = run(solver, 23)
    end = solver.save()
    solver.restore(saved)
    assert run(solver, 23) == first, f"other bits after a restore at {at}"
    other.restore(saved)
    assert run(other, 23) == first, f"other bits in another solver at {at}"
    assert solver.save() == end and other.save() == end
    other.restore(saved)
    other.state = state
    starts_anew += run(other, 23) != first
print(f"{sys.argv[2]}: the same bits from 40 saved solvers; set_state alone gives others from {starts_anew}")


def refused(data):
    before = solver.save()
    try:
        solver.restore(data)
    except ValueError:
        assert solver.save() == before
    else:
        raise AssertionError("damaged bytes are taken")


good = solver.save()
for place in (0, 20, len(good) // 2, len(good) - 1):
    refused(good[:place] + bytes([good[place] ^ 1]) + good[place + 1 :])
refused(good[:-1])
refused(b"")
