"""Functions of a shared library as CasADi's external finds and calls them: casadi/core/external.cpp, 3.6."""

import ctypes

import numpy as np

Integer = ctypes.c_longlong
Numbers = ctypes.POINTER(ctypes.c_double)
GUARD = 12345.678  # beyond the work vector


class Pattern:
    """A sparsity pattern in compressed columns, checked as CasADi checks it."""

    def __init__(self, data):
        self.rows, self.columns = data[0], data[1]
        assert self.rows >= 0 and self.columns >= 0
        self.first = [data[2 + j] for j in range(self.columns + 1)]
        assert self.first[0] == 0 and all(a <= b for a, b in zip(self.first, self.first[1:])), self.first
        self.entries = self.first[-1]
        self.row = [data[3 + self.columns + k] for k in range(self.entries)]
        for begin, end in zip(self.first, self.first[1:]):
            column = self.row[begin:end]
            assert column == sorted(set(column)) and all(0 <= i < self.rows for i in column), column

    def dense(self, entries):
        matrix = np.zeros((self.rows, self.columns))
        for j in range(self.columns):
            for k in range(self.first[j], self.first[j + 1]):
                matrix[self.row[k], j] = entries[k]
        return matrix

    def entries_of(self, matrix):
        matrix = np.asarray(matrix, dtype=float).reshape((self.rows, self.columns), order="F")
        return np.array([matrix[self.row[k], j] for j in range(self.columns) for k in range(self.first[j], self.first[j + 1])])


class External:
    """One function by its name. Calls it with arrays, or None for a null pointer."""

    def __init__(self, library, name):
        self.name = name

        def symbol(suffix, result, *arguments):
            function = getattr(library, name + suffix)
            function.restype, function.argtypes = result, arguments
            return function

        n_in, n_out = symbol("_n_in", Integer)(), symbol("_n_out", Integer)()
        labels = [(symbol("_name_" + way, ctypes.c_char_p, Integer), count) for way, count in (("in", n_in), ("out", n_out))]
        patterns = [symbol("_sparsity_" + way, ctypes.POINTER(Integer), Integer) for way in ("in", "out")]
        self.inputs, self.outputs = ([label(i).decode() for i in range(count)] for label, count in labels)
        assert labels[0][0](n_in) is None and not patterns[1](n_out) and not patterns[0](-1)
        self.patterns_in, self.patterns_out = ([Pattern(of(i)) for i in range(count)] for of, count in zip(patterns, (n_in, n_out)))
        sizes = [Integer() for _ in range(4)]
        assert symbol("_work", ctypes.c_int, *[ctypes.POINTER(Integer)] * 4)(*sizes) == 0
        self.sizes = [size.value for size in sizes]
        assert self.sizes[0] >= n_in and self.sizes[1] >= n_out
        assert hasattr(library, name + "_incref") == hasattr(library, name + "_decref")
        self.eval = symbol("", ctypes.c_int, ctypes.POINTER(Numbers), ctypes.POINTER(Numbers), ctypes.POINTER(Integer), Numbers, ctypes.c_int)

    def status(self, arguments, results):
        """Calls the function on lists of arrays of entries, or None."""
        keep = [None if a is None else np.ascontiguousarray(a, dtype=float) for a in arguments]
        for a, pattern in zip(keep, self.patterns_in):
            assert a is None or a.size == pattern.entries, (self.name, a.size, pattern.entries)
        pointer = lambda a: None if a is None else a.ctypes.data_as(Numbers)
        arg = (Numbers * self.sizes[0])(*[pointer(a) for a in keep])
        res = (Numbers * self.sizes[1])(*[pointer(a) for a in results])
        w = np.full(self.sizes[3] + 4, GUARD)
        iw = (Integer * (self.sizes[2] + 1))()
        status = self.eval(arg, res, iw, pointer(w), 0)
        assert np.all(w[self.sizes[3]:] == GUARD), self.name + " writes beyond its work vector"
        return status

    def __call__(self, *arguments):
        """Results as dense matrices, None where the function has none."""
        results = [np.full(pattern.entries, np.nan) for pattern in self.patterns_out]
        if self.status(arguments, results) != 0:
            return None
        dense = [pattern.dense(entries) for pattern, entries in zip(self.patterns_out, results)]
        return dense[0] if len(dense) == 1 else dense
