"""Masses and inertias that parameters make together, in an FMU of FMI 2: quantities_fmu.py LIBRARY DESCRIPTION."""

import ctypes
import re
import sys

library = ctypes.CDLL(sys.argv[1])
description = open(sys.argv[2]).read()
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
WITH_TEXT = ctypes.CFUNCTYPE(
    None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p
)
logger = LOGGER(lambda environment, name, status, category, form, text: said.append(text.decode()))
callbacks = Callbacks(logger, ALLOCATE(libc.calloc), FREE(libc.free), None, None)
library.fmi2Instantiate.restype = ctypes.c_void_p
unit = ctypes.c_void_p(
    library.fmi2Instantiate(b"unit", 1, token, b"", ctypes.byref(callbacks), 0, 1)
)
assert unit.value


def set_real(name, value):
    one = ctypes.c_uint(reference[name])
    return library.fmi2SetReal(unit, ctypes.byref(one), ctypes.c_size_t(1), ctypes.byref(ctypes.c_double(value)))


def step(time):
    return library.fmi2DoStep(unit, ctypes.c_double(time), ctypes.c_double(0.01), 1)


OK = 0
experiment = [ctypes.c_int(0), ctypes.c_double(0), ctypes.c_double(0), ctypes.c_int(0), ctypes.c_double(0)]
assert library.fmi2SetupExperiment(unit, *experiment) == OK
assert library.fmi2EnterInitializationMode(unit) == OK
# In any order, as long as they agree when something is asked for.
assert [set_real("gross", 2.0), set_real("tare", 1.0)] == [OK, OK]
assert library.fmi2ExitInitializationMode(unit) == OK
assert step(0.0) == OK
for name, bad, good, part in (("gross", 0.5, 2.0, "mass of block"), ("skew", 0.5, 0.1, "inertia of wheel")):
    assert set_real(name, bad) == OK
    said.clear()
    assert step(0.01) != OK and said, name
    assert said[-1].endswith(f"{part} is what no model may have: set other parameters or inputs"), said
    assert set_real(name, good) == OK
assert step(0.01) == OK
print("masses and inertias of several parameters hold in an FMU")
