"""Numbers with bounds that parameters and inputs make together: bounded.py DIRECTORY, of bounded.json.

What the reader says of the same values is right: it reads them as the values of the file."""

import json
import math
import random
import re
import subprocess
import sys

directory, mbgen, model = sys.argv[1:4]
sys.path.insert(0, directory)
import bounded

REFUSED = "parameters make what no model may have: "


def answer(a, b, c, u, v):
    solver = bounded.Solver()
    before = bytes(solver.state)
    solver.parameters.a, solver.parameters.b, solver.parameters.c = a, b, c
    solver.inputs.u, solver.inputs.v = u, v
    try:
        solver.step(1e-6)
    except bounded.SolverError as error:
        if not str(error).startswith(REFUSED):
            return "ok"
        assert error.status.code == bounded.QUANTITY_OUT_OF_RANGE == -3
        assert bytes(solver.state) == before
        return error.name
    return "ok"


with open(model) as file:
    text = file.read()


def refused_by_reader(a, b, c, u, v):
    """Pointers of the fields that the reader refuses at these values."""
    changed = text
    for name, value in (("a", a), ("b", b), ("c", c)):
        changed = re.sub(rf'"{name}": {{ "value": [^,]*', f'"{name}": {{ "value": {value!r}', changed)
    for name, value in (("u", u), ("v", v)):
        changed = re.sub(rf'"{name}": {{ "default": [^}}]*', f'"{name}": {{ "default": {value!r} ', changed)
    with open("changed.json", "w") as file:
        file.write(changed)
    said = subprocess.run([mbgen, "check", "changed.json"], capture_output=True, text=True)
    return [pointer.split("/")[-2:] for pointer in re.findall(r": (/\S+):", said.stderr)]


random.seed(3)
seen = {}
for k in range(60):
    values = {"a": 5.0, "b": 3.0, "c": 1.0, "u": 1.0, "v": 2.0}
    for name in random.sample(sorted(values), 2):
        values[name] = round(random.uniform(-6, 9), 2)
    names = [f"{field} of {element}" for element, field in refused_by_reader(**values)]
    got = answer(**values)
    seen[got] = seen.get(got, 0) + 1
    assert got in names or (got == "ok" and not names), (values, got, names)
assert len(seen) > 6 and seen["ok"] > 5, seen
for name, values in {
    "mass of block": (2.0, 3.0, 1.0, 1.0, 2.0),
    "damping of bar": (5.0, 3.0, 1.0, -3.0, 2.0),
    "coulomb of brake": (5.0, 3.0, 1.0, 2.5, 2.0),
    "elastic of brake": (5.0, 4.5, 1.0, 1.0, 2.0),
    "free_length of strut": (5.0, 3.0, 0.45, 1.0, 2.0),
    "viscous of rail": (5.0, 1.2, 1.3, 1.0, 2.0),
}.items():
    assert answer(*values) == name, (name, answer(*values))
print("numbers with bounds hold, by name:", ", ".join(sorted(seen)))
