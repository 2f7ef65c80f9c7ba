"""Masses and inertias that parameters make together, in an FMU of FMI 2: quantities_fmu.py LIBRARY DESCRIPTION."""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "support"))
from fmi2_unit import OK, Unit  # noqa: E402

STEP = 0.01
unit = Unit(sys.argv[1], sys.argv[2])
unit.enter_initialisation()
# In any order, as long as they agree when something is asked for.
assert [unit.set_real("gross", 2.0), unit.set_real("tare", 1.0)] == [OK, OK]
unit.exit_initialisation()
assert unit.step(0.0, STEP) == OK
for name, bad, good, part in (("gross", 0.5, 2.0, "mass of block"), ("skew", 0.5, 0.1, "inertia of wheel")):
    assert unit.set_real(name, bad) == OK
    unit.said.clear()
    assert unit.step(STEP, STEP) != OK and unit.said, name
    assert unit.said[-1].endswith(f"{part} is what no model may have: set other parameters or inputs"), unit.said
    assert unit.set_real(name, good) == OK
assert unit.step(STEP, STEP) == OK
print("masses and inertias of several parameters hold in an FMU")
