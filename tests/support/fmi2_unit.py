"""A unit of FMI 2 for co-simulation, instantiated from its library by ctypes: for scripts that set, step and read it."""

import ctypes
import re

OK = 0
LOGGER = ctypes.CFUNCTYPE(
    None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p
)
ALLOCATE = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_size_t, ctypes.c_size_t)
FREE = ctypes.CFUNCTYPE(None, ctypes.c_void_p)


class Callbacks(ctypes.Structure):
    _fields_ = [
        ("logger", LOGGER), ("allocate", ALLOCATE), ("free", FREE), ("finished", ctypes.c_void_p),
        ("environment", ctypes.c_void_p),
    ]


class Unit:
    """said: texts of the unit's messages."""

    def __init__(self, library, description):
        text = open(description).read()
        self.library = ctypes.CDLL(library)
        self.said = []
        self.reference = {
            name: int(number)
            for name, number in re.findall(r'<ScalarVariable name="([^"]*)" valueReference="(\d+)"', text)
        }
        libc = ctypes.CDLL(None)
        libc.calloc.restype, libc.calloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t, ctypes.c_size_t]
        libc.free.argtypes = [ctypes.c_void_p]
        # The logger's format is "%s": the text is the first of the arguments that follow.
        logger = LOGGER(lambda environment, name, status, category, form, text: self.said.append(text.decode()))
        self.callbacks = Callbacks(logger, ALLOCATE(libc.calloc), FREE(libc.free), None, None)
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        token = re.search(r'guid="([^"]*)"', text).group(1).encode()
        self.unit = ctypes.c_void_p(
            self.library.fmi2Instantiate(b"unit", 1, token, b"", ctypes.byref(self.callbacks), 0, 1)
        )
        assert self.unit.value

    def enter_initialisation(self):
        experiment = [ctypes.c_int(0), ctypes.c_double(0), ctypes.c_double(0), ctypes.c_int(0), ctypes.c_double(0)]
        assert self.library.fmi2SetupExperiment(self.unit, *experiment) == OK
        assert self.library.fmi2EnterInitializationMode(self.unit) == OK

    def exit_initialisation(self):
        assert self.library.fmi2ExitInitializationMode(self.unit) == OK

    def set_real(self, name, value):
        one = ctypes.c_uint(self.reference[name])
        number = ctypes.byref(ctypes.c_double(value))
        return self.library.fmi2SetReal(self.unit, ctypes.byref(one), ctypes.c_size_t(1), number)

    def real(self, name):
        one, value = ctypes.c_uint(self.reference[name]), ctypes.c_double()
        status = self.library.fmi2GetReal(self.unit, ctypes.byref(one), ctypes.c_size_t(1), ctypes.byref(value))
        assert status == OK
        return value.value

    def step(self, time, step):
        return self.library.fmi2DoStep(self.unit, ctypes.c_double(time), ctypes.c_double(step), 1)
