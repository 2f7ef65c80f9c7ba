"""Functions for CasADi of one model against judges that share no formulation, differences and each other:
    check.py MBGEN MODEL DIRECTORY SPREAD
DIRECTORY has lib<name>_casadi.so and <name>_acados.py; SPREAD: of coordinates and inputs around the start."""

import ctypes
import json
import os
import subprocess
import sys
import threading
import types

import numpy as np
from external import External

mbgen, model, directory, spread = sys.argv[1:5]
STATES = 6
random = np.random.default_rng(7)


def acados():
    """The acados model's module, over stand-ins for casadi and acados_template that only record."""
    casadi, template = types.ModuleType("casadi"), types.ModuleType("acados_template")
    casadi.MX = types.SimpleNamespace(sym=lambda name, size=1: (name, size))
    casadi.external = lambda name, path: (name, path)
    template.AcadosModel = types.SimpleNamespace
    sys.modules.update(casadi=casadi, acados_template=template)
    sys.path.insert(0, directory)
    return __import__(name + "_acados")


name = next(file[: -len("_acados.py")] for file in os.listdir(directory) if file.endswith("_acados.py"))
motion = acados()
library = ctypes.CDLL(motion.library())
states, inputs, parameters = ([row[0] for row in table] for table in (motion.STATES, motion.INPUTS, motion.PARAMETERS))
free = [label[2:] for label in states if label.startswith("z.")]
auxiliary = [label[2:] for label in states if label.startswith("x.")]
assert states == ["z." + c for c in free] + ["zd." + c for c in free] + ["x." + c for c in auxiliary]
f = External(library, name + "_f")
has_time = "t" in f.inputs
arguments = ["x", "u", "p"] + (["t"] if has_time else [])
assert f.inputs == arguments and f.outputs == ["xdot"]
assert [pattern.rows for pattern in f.patterns_in] == [len(states), len(inputs), len(parameters)] + [1] * has_time
functions = [f]
if motion.OUTPUTS:
    functions.append(External(library, name + "_h"))
    assert functions[1].inputs == arguments and functions[1].outputs == ["y"]


def judged():
    """States that another engine has made consistent, with its accelerations: x, u, p, t, xdot."""
    with open("%s/%s.json" % (directory, name)) as file:
        order = json.load(file)["coordinates"]
    start = {row[0]: row[2] for row in motion.STATES}
    asked = []
    for _ in range(STATES):
        state = {"z": [0.0] * len(order), "zd": [0.0] * len(order), "t": float(random.uniform(0, 2)) if has_time else 0.0}
        for c in free:
            state["z"][order.index(c)] = start["z." + c] + float(random.uniform(-1, 1)) * float(spread)
            state["zd"][order.index(c)] = start["zd." + c] + float(random.uniform(-1, 1))
        state["x"] = [start["x." + c] + 1e-3 * float(random.uniform(-1, 1)) for c in auxiliary]
        state["inputs"] = {row[0]: row[2] + float(random.uniform(-1, 1)) * float(spread) for row in motion.INPUTS}
        asked.append(state)
    with open(directory + "/states.json", "w") as file:
        json.dump({"joint_order": order, "states": asked}, file)
    made = subprocess.run([mbgen, "evaluate", model, "--states", directory + "/states.json", "--project", "--engine", "null-space"], capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    points = []
    for given, state in zip(asked, json.loads(made.stdout)["states"]):
        if state["status"] != "ok":
            continue
        pick = lambda values: [values[order.index(c)] for c in free]
        x = np.array(pick(state["z"]) + pick(state["zd"]) + given["x"])
        point = [x, np.array([given["inputs"][label] for label in inputs]), np.array(motion.values(motion.PARAMETERS), dtype=float)]
        points.append((point + [np.array([given["t"]])] * has_time, np.array(pick(state["zd"]) + pick(state["zdd"]))))
    assert len(points) >= STATES // 2, made.stdout
    return points


def difference(function, point, argument, i):
    """Central differences of sixth order by one number of an argument."""
    h = 5e-4 * max(1.0, abs(point[argument][i]))

    def moved(step):
        there = [a.copy() for a in point]
        there[argument][i] += step
        return function(*there)[:, 0]

    return sum(c * (moved(k * h) - moved(-k * h)) for k, c in ((1, 45), (2, -9), (3, 1))) / (60 * h)


def check_derivatives(function, points, compared):
    """compared: points at which differences are taken."""
    base, result = function.name, function.outputs[0]
    jacobian = External(library, "jac_" + base)
    assert jacobian.inputs == arguments + ["out_" + result]
    assert jacobian.outputs == ["jac_%s_%s" % (result, a) for a in arguments]
    rows = function.patterns_out[0].rows
    assert jacobian.patterns_in[-1].rows == rows and jacobian.patterns_in[-1].entries == 0
    assert [(p.rows, p.columns) for p in jacobian.patterns_out] == [(rows, p.rows) for p in function.patterns_in]
    worst = 0
    for number, point in enumerate(points):
        blocks = jacobian(*point, None)
        assert blocks is not None
        whole = np.hstack(blocks)
        scale = np.abs(whole).max(axis=1) + 1e-300
        for a in range(len(arguments)):
            for i in range(len(point[a]) if number < compared else 0):
                error = np.abs(blocks[a][:, i] - difference(function, point, a, i)) * max(1.0, abs(point[a][i])) / np.maximum(scale, 1)
                worst = max(worst, error.max(initial=0))
        for width in (1, 2, 4, 8):
            forward, adjoint = (External(library, "%s%d_%s" % (way, width, base)) for way in ("fwd", "adj"))
            assert forward.inputs == jacobian.inputs + ["fwd_" + a for a in arguments] and forward.outputs == ["fwd_" + result]
            assert adjoint.inputs == jacobian.inputs + ["adj_" + result] and adjoint.outputs == ["adj_" + a for a in arguments]
            seeds = [random.standard_normal((p.rows, width)) for p in function.patterns_in]
            along = forward(*point, None, *[s.flatten(order="F") for s in seeds])
            expected = whole @ np.vstack(seeds)
            assert np.abs(along - expected).max() <= 1e-12 * (np.abs(whole) @ np.abs(np.vstack(seeds))).max() + 1e-300
            bars = random.standard_normal((rows, width))
            backward = np.vstack(adjoint(*point, None, bars.flatten(order="F")))
            for k in range(width):  # <bar, J s> = <J' bar, s>
                one, other = bars[:, k] @ along[:, k], backward[:, k] @ np.vstack(seeds)[:, k]
                assert abs(one - other) <= 1e-11 * (np.abs(bars[:, k]) @ np.abs(whole) @ np.abs(np.vstack(seeds)[:, k]) + 1e-300)
            # Null pointers: seeds of zero, and results that nobody wants.
            nothing = forward(*point, None, *[None] * len(arguments))
            assert np.all(nothing == 0)
            assert adjoint.status([*point, None, None], [None] * len(arguments)) == 0
    return worst


points = judged()
worst = 0
for point, xdot in points:
    found = f(*point)
    assert found is not None, "no value at " + str(point)
    error = np.abs(found[: len(xdot), 0] - xdot).max() / max(1.0, np.abs(xdot).max())
    worst = max(worst, error)
assert worst < 1e-11, worst  # the judge closes loops to 1e-12
print("%s: %d states, accelerations within %.1e of the judge's" % (name, len(points), worst))
for function in functions:
    error = check_derivatives(function, [point for point, _ in points[:3]], 2)
    assert error < 1e-8, error
    print("%s: Jacobian within %.1e of differences" % (function.name, error))

# A function: the same bits in any order, in two threads at once.
alone = [f(*point).tobytes() for point, _ in points]
wrong = []


def run(order):
    for _ in range(100):
        for k in order:
            if f(*points[k][0]).tobytes() != alone[k]:
                wrong.append(k)


threads = [threading.Thread(target=run, args=(order,)) for order in (range(len(points)), range(len(points) - 1, -1, -1))]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert not wrong

# No value: arguments that are no numbers.
assert f(np.full(len(states), np.nan), *points[0][0][1:]) is None
