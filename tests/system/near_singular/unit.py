"""Co-simulation past a singular position that branches do not cross at: unit.py LIBRARY DESCRIPTION STEP OFFSET WORD.

WORD is what comes of 4 s: "kept" (every step is OK and the energy stays within 1 %), or "refused" (a step is not, and the
message names the loop)."""

import ctypes
import re
import sys

library = ctypes.CDLL(sys.argv[1])
description = open(sys.argv[2]).read()
step, offset, word = float(sys.argv[3]), float(sys.argv[4]), sys.argv[5]
token = re.search(r'guid="([^"]*)"', description).group(1).encode()
reference = {
    name: int(number)
    for name, number in re.findall(r'<ScalarVariable name="([^"]*)" valueReference="(\d+)"', description)
}
LOGGER = ctypes.CFUNCTYPE(
    None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p
)
ALLOCATE = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t)
FREE = ctypes.CFUNCTYPE(None, ctypes.c_void_p)
libc = ctypes.CDLL(None)
libc.calloc.restype, libc.calloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t, ctypes.c_size_t]
libc.free.argtypes = [ctypes.c_void_p]
said = []


class Callbacks(ctypes.Structure):
    _fields_ = [
        ("logger", LOGGER), ("allocate", ALLOCATE), ("free", FREE), ("finished", ctypes.c_void_p),
        ("environment", ctypes.c_void_p),
    ]


# The logger's format is "%s": the text is the first of the arguments that follow.
logger = LOGGER(lambda environment, name, status, category, form, text: said.append(text.decode()))
callbacks = Callbacks(logger, ALLOCATE(libc.calloc), FREE(libc.free), None, None)
library.fmi2Instantiate.restype = ctypes.c_void_p
unit = ctypes.c_void_p(library.fmi2Instantiate(b"unit", 1, token, b"", ctypes.byref(callbacks), 0, 1))
assert unit.value
OK = 0


def value_of(name):
    one, value = ctypes.c_uint(reference[name]), ctypes.c_double()
    assert library.fmi2GetReal(unit, ctypes.byref(one), ctypes.c_size_t(1), ctypes.byref(value)) == OK
    return value.value


experiment = [ctypes.c_int(0), ctypes.c_double(0), ctypes.c_double(0), ctypes.c_int(0), ctypes.c_double(0)]
assert library.fmi2SetupExperiment(unit, *experiment) == OK
assert library.fmi2EnterInitializationMode(unit) == OK
one = ctypes.c_uint(reference["offset"])
assert library.fmi2SetReal(unit, ctypes.byref(one), ctypes.c_size_t(1), ctypes.byref(ctypes.c_double(offset))) == OK
assert library.fmi2ExitInitializationMode(unit) == OK
before = value_of("energy")
for k in range(int(4 / step)):
    # Warning is of turns within a step; what was wrong is above it.
    if library.fmi2DoStep(unit, ctypes.c_double(k * step), ctypes.c_double(step), 1) > 1:
        assert word == "refused", said
        assert "jd" in said[-1] and "loop" in said[-1], said
        break
    assert word == "refused" or abs(value_of("energy") / before - 1) < 0.01, (step, offset)
else:
    assert word == "kept", (step, offset, "went on")
print(f"unit, offset {offset:g}, step {step:g}: {word}")
