"""Inputs that come without their rates, and names that are not there: rates.py DIRECTORY, of driven_cart.json."""

import math
import sys

import numpy as np

sys.path.insert(0, sys.argv[1])
import driven_cart

STEP = 1e-3
SIZE, FREQUENCY = 0.2, 5.0


def way(t):
    """Value, rate and acceleration of a cart that starts gently."""
    if t < 0:
        return 0.0, 0.0, 0.0
    phase = FREQUENCY * t
    return (
        SIZE * (phase - math.sin(phase)),
        SIZE * FREQUENCY * (1 - math.cos(phase)),
        SIZE * FREQUENCY**2 * math.sin(phase),
    )


def ride(given, delay=0.0, forced=False):
    """Positions of cart and pendulum at each step; rates are given or zero."""
    solver = driven_cart.Solver()
    solver.set_rates_given(forced)
    rows = []
    for k in range(3000):
        inputs = driven_cart.Inputs(torque=0.0)
        inputs.way, speed, _ = way(k * STEP - delay)
        # A value that is constant during a step is best given as of its middle.
        acceleration = way((k + 0.5) * STEP - delay)[2]
        inputs.speed, inputs.acceleration = (speed, acceleration) if given else (0.0, 0.0)
        solver.inputs = inputs
        if k == 0:
            solver.assemble()
        solver.step(STEP)
        rows.append(solver.z)
    return np.array(rows)


exact, made, late = ride(True), ride(False), ride(True, delay=1.5 * STEP)
unmade = ride(False, forced=True)
swing = np.ptp(exact[:, 1])
print(f"swing of {swing:.3f} rad, off it at most:")
print(f"  rates that are zero        {np.abs(unmade - exact)[:, 1].max() / swing:8.1%}")
print(f"  rates made of the values   {np.abs(made - exact)[:, 1].max() / swing:8.1%}")
print(f"  the same, less their delay {np.abs(made - late)[:, 1].max() / swing:8.1%}")
assert np.abs(unmade - exact)[:, 1].max() > 0.3 * swing
assert np.abs(made - exact)[:, 1].max() < 2e-2 * swing
assert np.abs(made - late)[:, 1].max() < 1e-3 * swing

# An input that is set once goes on by the rates that it has, and stays without any.
solver = driven_cart.Solver()
solver.inputs = driven_cart.Inputs(way=0.1, speed=0.5)
solver.assemble()
for _ in range(100):
    solver.step(STEP)
assert abs(solver.z[0] - 0.15) < 1e-12, solver.z
assert abs(solver.inputs.way - 0.15) < 1e-12

# Plain assignment works, wherever the number is; the rest keeps what the solver has.
solver = driven_cart.Solver()
solver.inputs = driven_cart.Inputs(way=0.1)
copy = solver.inputs
solver.inputs.torque = 3.0
copy.way = 0.2
assert (solver.inputs.torque, solver.inputs.way) == (3.0, 0.2)
assert copy.torque == 0.0 and driven_cart.Inputs().torque == 0.0
solver.state.z[1] = 0.3
solver.state.zd[:] = [0.0, 0.7]
solver.state.t = 4.0
assert (solver.z[1], solver.zd[1], solver.t) == (0.3, 0.7, 4.0)
apart = driven_cart.State()
apart.z[0] = 9.0
assert apart.z[0] == 9.0 and solver.z[0] != 9.0


def refused(action, error, text):
    try:
        action()
    except error as found:
        assert text in str(found), found
    else:
        raise AssertionError(f"taken: {text}")


refused(lambda: setattr(solver.inputs, "sped", 1.0), AttributeError, 'Inputs has no "sped"; did you mean "speed"?')
refused(lambda: setattr(solver.inputs, "xyz", 1.0), AttributeError, "it has way, speed, acceleration, torque")
refused(lambda: setattr(solver.state, "T", 1.0), AttributeError, 'State has no "T"')
refused(lambda: driven_cart.Inputs(sped=1.0), AttributeError, 'did you mean "speed"?')
refused(lambda: setattr(solver, "torque", 1.0), AttributeError, "torque")
refused(lambda: solver.z.__setitem__(0, 1.0), ValueError, "read-only")
