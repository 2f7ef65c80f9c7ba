"""Actuators of an FMU: forces by `mbgen evaluate --inverse --engine null-space` as its inputs give the accelerations that
were asked for, and its outputs actuator.NAME.force, .speed and .power:
    tests/fmi/actuators.py MBGEN MODEL, in a folder of its own"""
import ctypes
import glob
import json
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

mbgen, ankle = sys.argv[1:]
with open("ankle.json", "w") as file:
    json.dump({"mbgen": 1, "name": "ankle", "include": [ankle],
               "initial": {"positions": {"motor_a": 0.1, "motor_b": -0.2}, "velocities": {"motor_a": 2, "motor_b": -1}}}, file)
subprocess.run([mbgen, "export", "ankle.json", "--fmi", "2", "-o", "ankle.fmu"], check=True, capture_output=True)
subprocess.run(["cmake", "-E", "tar", "xf", "ankle.fmu"], check=True)
description = ElementTree.parse("modelDescription.xml").getroot()
variables = description.findall("ModelVariables/ScalarVariable")
reference = {variable.get("name"): int(variable.get("valueReference")) for variable in variables}
derivatives = {int(unknown.get("index")): k
               for k, unknown in enumerate(description.findall("ModelStructure/Derivatives/Unknown"))}
state_of = {}  # place among the states, by the name of a variable
for index, variable in enumerate(variables, 1):
    of = variable.find("Real").get("derivative")
    if of is not None and index in derivatives:
        state_of[variables[int(of) - 1].get("name")] = derivatives[index]

library = ctypes.CDLL(glob.glob("./binaries/*/*.so")[0])
LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p)
ALLOCATE = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t)
FREE = ctypes.CFUNCTYPE(None, ctypes.c_void_p)


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), ("allocate", ALLOCATE), ("free", FREE), ("finished", ctypes.c_void_p),
                ("environment", ctypes.c_void_p)]


libc = ctypes.CDLL(None)
libc.calloc.restype = ctypes.c_void_p
libc.free.argtypes = [ctypes.c_void_p]
callbacks = Callbacks(LOGGER(lambda *words: print(words)), ALLOCATE(lambda n, size: libc.calloc(n, ctypes.c_size_t(size))),
                      FREE(lambda memory: libc.free(memory)))
library.fmi2Instantiate.restype = ctypes.c_void_p
unit = ctypes.c_void_p(library.fmi2Instantiate(b"ankle", 0, description.get("guid").encode(), b"", ctypes.byref(callbacks), 0, 0))
assert unit.value, "no instance"


def checked(status):
    assert status == 0, status


def real(values):
    return (ctypes.c_double * len(values))(*values)


def references(names):
    return (ctypes.c_uint * len(names))(*[reference[name] for name in names])


def get(names):
    values = real([0] * len(names))
    checked(library.fmi2GetReal(unit, references(names), ctypes.c_size_t(len(names)), values))
    return dict(zip(names, values))


checked(library.fmi2SetupExperiment(unit, 0, ctypes.c_double(0), ctypes.c_double(0), 0, ctypes.c_double(0)))
checked(library.fmi2EnterInitializationMode(unit))
checked(library.fmi2ExitInitializationMode(unit))
coordinates = ["motor_a", "motor_b", "ankle_ry", "ankle_rx"]
positions = get([f"z.{name}" for name in coordinates])
speeds = get([f"zd.{name}" for name in coordinates])
wanted = {"ankle_ry": 30, "ankle_rx": -20}
with open("states.json", "w") as file:
    json.dump({"joint_order": coordinates,
               "states": [{"z": list(positions.values()), "zd": list(speeds.values()), "zdd": wanted}]}, file)
answer = json.loads(subprocess.run([mbgen, "evaluate", "ankle.json", "--inverse", "--engine", "null-space", "--states", "states.json"],
                                   check=True, capture_output=True, text=True).stdout)["states"][0]
force = answer["actuators"]
checked(library.fmi2SetReal(unit, references(list(force)), ctypes.c_size_t(len(force)), real(list(force.values()))))
rates = real([0] * len(derivatives))
checked(library.fmi2GetDerivatives(unit, rates, ctypes.c_size_t(len(rates))))
found = 0
for name, zdd in zip(coordinates, answer["zdd"]):
    if f"qd.{name}" in state_of:
        found += 1
        assert abs(rates[state_of[f"qd.{name}"]] - zdd) < 1e-9 * 30, (name, rates[state_of[f"qd.{name}"]], zdd)
assert found == 2, state_of
for actuator, coordinate in (("ankle_a", "motor_a"), ("ankle_b", "motor_b")):
    names = [f"actuator.{actuator}.{what}" for what in ("force", "speed", "power")]
    shown, speed = get(names), speeds[f"zd.{coordinate}"]
    for name, value in zip(names, (force[actuator], speed, force[actuator] * speed)):
        assert abs(shown[name] - value) <= 1e-12 * abs(value), (name, shown[name], value)
    assert abs(speed) > 0.5
library.fmi2FreeInstance(unit)
print("actuators of an FMU: ok")
