"""Masses and inertias that parameters make together: quantities.py DIRECTORY, of quantities.json."""

import sys

sys.path.insert(0, sys.argv[1])
import numpy
import quantities

NAMES = {"mass": "mass of block", "inertia": "inertia of wheel"}
call = quantities.Solver()._call


def answer(**values):
    """What a step says of these parameters, set one by one, and then whether the default ones mend it."""
    solver = quantities.Solver()
    before = bytes(solver.state)
    for name, value in values.items():
        setattr(solver.parameters, name, value)
    try:
        solver.step(1e-3)
    except quantities.SolverError as error:
        assert bytes(solver.state) == before
        solver.parameters = quantities.Parameters(gross=5.0, tare=3.0, skew=0.1, about=0.5)
        solver.step(1e-3)
        return str(error)
    return "ok"


def inertia_is_of_a_body(skew, about):
    moments = numpy.linalg.eigvalsh([[0.4, skew, 0], [skew, about, 0.5 * skew], [0, 0.5 * skew, 0.3]])
    return moments[0] >= 0 and moments[2] <= moments[0] + moments[1]


refused = "parameters make what no model may have: "
assert answer() == "ok"
assert answer(gross=2.0) == refused + NAMES["mass"]
assert answer(gross=2.0, tare=1.0) == "ok", "the order in which parameters are set does not matter"
assert answer(gross=3.0) == "ok", "a mass of 0 is read, too"
random = numpy.random.default_rng(5)
seen = {True: 0, False: 0}
for _ in range(200):
    skew, about = random.uniform(-0.6, 0.6), random.uniform(0.0, 1.0)
    expected = inertia_is_of_a_body(skew, about)
    seen[bool(expected)] += 1
    assert answer(skew=skew, about=about) == ("ok" if expected else refused + NAMES["inertia"]), (skew, about)
assert min(seen.values()) > 20, seen
print("masses and inertias of several parameters hold, by name")
