#!/usr/bin/env python3
"""Coefficients of runtime/include/mbgen/math/sincos.hpp, arc_tangent.hpp, exponential.hpp and logarithm.hpp.

Remez exchange on polynomials in z = x^2, at 60 digits, for the largest relative error of the whole function. The
coefficients are rounded to double (for single_precision.hpp: to float) one by one from the lowest power, and those above are fitted again after each.
Needs mpmath.
"""
from struct import pack, unpack

from mpmath import atan, atanh, cos, floor, log, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 60


def remez(target, weight, low, high, fixed, count):
    """Minimax fit of `target` on [low, high] in z: `fixed` lowest coefficients are given, `count` more are free.
    Result: coefficients, largest |weight * error|."""
    n = count + 1
    points = [(low + high) / 2 - (high - low) / 2 * mp.cos(pi * (2 * k + 1) / (2 * n)) for k in range(n)]
    first = len(fixed)
    rest = lambda z: target(z) - sum(c * z**k for k, c in enumerate(fixed))
    for _ in range(40):
        a, b = matrix(n, n), matrix(n, 1)
        for i, z in enumerate(points):
            for k in range(count):
                a[i, k] = z ** (first + k)
            a[i, count] = (-1) ** i / weight(z)
            b[i] = rest(z)
        x = lu_solve(a, b)
        found = [x[k] for k in range(count)]
        error = lambda z: weight(z) * (rest(z) - sum(c * z ** (first + k) for k, c in enumerate(found)))
        grid = [low + (high - low) * (1 - mp.cos(pi * mpf(i) / 400)) / 2 for i in range(401)]
        values = [error(z) for z in grid]
        extremes, start = [], 0
        for i in range(1, 402):
            if i == 401 or values[i] * values[start] < 0:
                best = max(range(start, i), key=lambda j: abs(values[j]))
                l, h = grid[max(best - 1, 0)], grid[min(best + 1, 400)]
                for _ in range(60):
                    p, q = l + (h - l) / 3, h - (h - l) / 3
                    if abs(error(p)) < abs(error(q)): l = p
                    else: h = q
                extremes.append((l + h) / 2)
                start = i
        while len(extremes) > n:
            extremes.pop(0 if abs(error(extremes[0])) < abs(error(extremes[-1])) else -1)
        if len(extremes) < n:
            break
        points = extremes
        sizes = [abs(error(z)) for z in extremes]
        if max(sizes) - min(sizes) < max(sizes) * mpf('1e-6'):
            break
    return list(fixed) + found, max(abs(error(z)) for z in grid)


def single(x):
    """x rounded to single precision."""
    return unpack('f', pack('f', float(x)))[0]


def rounded(target, weight, low, high, count, fixed=(), to=float):
    coefficients = [mpf(c) for c in fixed]
    for k in range(len(coefficients), count):
        fit, error = remez(target, weight, low, high, coefficients, count - k)
        if k == len(fixed): best = error
        coefficients.append(mpf(to(fit[k])))
    grid = [low + (high - low) * mpf(i) / 2000 for i in range(2001)]
    worst = max(abs(weight(z) * (target(z) - sum(c * z**k for k, c in enumerate(coefficients)))) for z in grid)
    return coefficients, best, worst


def show(name, coefficients, best, worst):
    print(f"{name}: exact fit 2^{float(log(best, 2)):.1f}, rounded 2^{float(log(worst, 2)):.1f}")
    for c in coefficients: print("   ", float(c).hex(), repr(float(c)))

TINY = mpf('1e-12')


def series(term, count):
    return lambda z: sum(term(k) * z**k for k in range(count))


def near_zero(function, powers, bound):
    """`function`, by its power series where it would cancel."""
    return lambda z: powers(z) if abs(z) < mpf(bound) else function(z)


sin_rest = near_zero(lambda z: (sin(sqrt(z)) / sqrt(z) - 1) / z,
                     series(lambda k: mpf(-1) ** (k + 1) / mp.factorial(2 * k + 3), 12), '1e-6')
cos_rest = near_zero(lambda z: (cos(sqrt(z)) - 1 + z / 2) / z**2,
                     series(lambda k: mpf(-1) ** k / mp.factorial(2 * k + 4), 12), '1e-6')
atan_rest = near_zero(lambda z: (atan(sqrt(z)) / sqrt(z) - 1) / z,
                      series(lambda k: mpf(-1) ** (k + 1) / (2 * k + 3), 20), '1e-4')
# e^r - 1 - r, its even and its odd powers by themselves.
cosh_rest = near_zero(lambda z: (mp.cosh(sqrt(z)) - 1) / z, series(lambda k: 1 / mp.factorial(2 * k + 2), 12), '1e-4')
sinh_rest = near_zero(lambda z: (mp.sinh(sqrt(z)) / sqrt(z) - 1) / z,
                      series(lambda k: 1 / mp.factorial(2 * k + 3), 12), '1e-4')
log_rest = near_zero(lambda z: 2 * (atanh(sqrt(z)) / sqrt(z) - 1) / z,
                     series(lambda k: mpf(2) / (2 * k + 3), 20), '1e-4')


def parts(value, sizes, to=float):
    """`value` as a sum of doubles, or floats, of so many bits; the last one is rounded."""
    for place, bits in enumerate(sizes):
        unit = mpf(2) ** (int(floor(log(value, 2))) - bits + 1)
        part = floor(value / unit) * unit if place + 1 < len(sizes) else mpf(to(value))
        value -= part
        print("   ", float(part).hex())


if __name__ == '__main__':
    edge = (pi / 4 * (1 + mpf(2) ** -20)) ** 2
    show('sin', *rounded(sin_rest, lambda z: z * sqrt(z) / sin(sqrt(z)), TINY, edge, 6))
    show('cos', *rounded(cos_rest, lambda z: z * z / cos(sqrt(z)), TINY, edge, 6))
    half_turn = (pi / 2 * (1 + mpf(2) ** -20)) ** 2
    show('sin alone', *rounded(sin_rest, lambda z: z * sqrt(z) / sin(sqrt(z)), TINY, half_turn, 8))
    half = (1 + mpf(2) ** -20) / 4
    show('atan', *rounded(atan_rest, lambda z: z * sqrt(z) / atan(sqrt(z)), TINY, half, 12))
    edge = (log(2) / 2 * (1 + mpf(2) ** -20)) ** 2
    show('exp, even powers', *rounded(cosh_rest, lambda z: sqrt(z), TINY, edge, 6))
    show('exp, odd powers', *rounded(sinh_rest, lambda z: z, TINY, edge, 5))
    edge = ((sqrt(2) - 1) / (sqrt(2) + 1)) ** 2 * (1 + mpf(2) ** -20)
    show('log', *rounded(log_rest, lambda z: z * sqrt(z) / atanh(sqrt(z)) / 2, TINY, edge, 9))
    print('pi/2, pi/2 for fused products, and what a double lacks of it:')
    parts(pi / 2, (33, 33, 33, 53))
    parts(pi / 2, (53, 33, 53))
    print("   ", float((pi - mpf(float(pi))) / pi).hex())
    print('log(2):')
    parts(log(2), (32, 53))

    print('single precision')
    edge = (pi / 4 * (1 + mpf(2) ** -10)) ** 2
    show('sin', *rounded(sin_rest, lambda z: z * sqrt(z) / sin(sqrt(z)), TINY, edge, 4, to=single))
    show('cos', *rounded(cos_rest, lambda z: z * z / cos(sqrt(z)), TINY, edge, 3, to=single))
    show('atan', *rounded(atan_rest, lambda z: z * sqrt(z) / atan(sqrt(z)), TINY, mpf(1), 9, to=single))
    edge = (log(2) / 2 * (1 + mpf(2) ** -10)) ** 2
    show('exp, even powers', *rounded(cosh_rest, lambda z: sqrt(z), TINY, edge, 3, to=single))
    show('exp, odd powers', *rounded(sinh_rest, lambda z: z, TINY, edge, 3, to=single))
    edge = ((sqrt(2) - 1) / (sqrt(2) + 1)) ** 2 * (1 + mpf(2) ** -10)
    show('log', *rounded(log_rest, lambda z: z * sqrt(z) / atanh(sqrt(z)) / 2, TINY, edge, 5, to=single))
    print('pi/2:')
    parts(pi / 2, (9, 9, 9, 24), single)
    print('log(2):')
    parts(log(2), (14, 24), single)
