"""Co-simulation past a singular position that branches do not cross at: unit.py LIBRARY DESCRIPTION STEP OFFSET WORD.

WORD is what comes of 4 s: "kept" (every step is OK and the energy stays within 1 %), or "refused" (a step is not, and the
message names the loop)."""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "support"))
from fmi2_unit import OK, Unit  # noqa: E402

unit = Unit(sys.argv[1], sys.argv[2])
step, offset, word = float(sys.argv[3]), float(sys.argv[4]), sys.argv[5]
unit.enter_initialisation()
assert unit.set_real("offset", offset) == OK
unit.exit_initialisation()
before = unit.real("energy")
for k in range(int(4 / step)):
    # Warning is of turns within a step; what was wrong is above it.
    if unit.step(k * step, step) > 1:
        assert word == "refused", unit.said
        assert "jd" in unit.said[-1] and "loop" in unit.said[-1], unit.said
        break
    assert word == "refused" or abs(unit.real("energy") / before - 1) < 0.01, (step, offset)
else:
    assert word == "kept", (step, offset, "went on")
print(f"unit, offset {offset:g}, step {step:g}: {word}")
