#!/usr/bin/env python3
"""Least squares in 40-digit arithmetic: python3 fits.py > fits.csv

A made-up measurement of 14 rows on 2 spheres of R = 0.02 m, and the parameters that make the gradient of the
sum of squares zero, with their standard errors s sqrt(diag((J'J)^-1)). Typed from (1) and (12), not from the crate.
"""
import platform

import mpmath
from mpmath import findroot, matrix, mp, mpf, sqrt

mp.dps = 40
R, N = mpf(0.02), 2
X = [-0.0005, 0.0, 0.0004, 0.001, 0.0016, 0.0021, 0.0027, 0.003, 0.0028, 0.0022, 0.0015, 0.0009, 0.0003, -0.0002]
V = [0.05, 0.05, 0.05, 0.05, 0.045, 0.04, 0.03, 0.0, -0.03, -0.045, -0.05, -0.05, -0.05, -0.05]
F = [0.02, -0.03, 0.55, 3.05, 6.9, 10.6, 15.2, 16.85, 14.35, 9.6, 5.05, 2.1, 0.2, 0.04]


def force(p, x, v):
    e, alpha, onset = p
    u = x - onset
    return N * mpf(4) / 3 * sqrt(R) * e * u ** mpf("1.5") * (1 + mpf("1.5") * alpha * v) if u > 0 else mpf(0)


def solve(free, start):
    full = lambda q: [q[free.index(i)] if i in free else mpf(0) for i in range(3)]
    rows = [(mpf(x), mpf(v), mpf(f)) for x, v, f in zip(X, V, F)]
    scale = [mpf(10) ** (5 if i == 0 else 0 if i == 1 else -4) for i in free]
    unscale = lambda q: [a * b for a, b in zip(q, scale)]

    def gradient(*q):
        q = unscale(q)
        total = [mpf(0)] * len(free)
        for x, v, f in rows:
            r = f - force(full(q), x, v)
            total = [t + r * s * c for t, s, c in zip(total, analytic(q, x, v), scale)]
        return total

    def analytic(q, x, v):
        e, alpha, onset = full(q)
        u = x - onset
        if u <= 0:
            return [mpf(0)] * len(free)
        k = N * mpf(4) / 3 * sqrt(R)
        d = 1 + mpf("1.5") * alpha * v
        every = [k * u ** mpf("1.5") * d, k * u ** mpf("1.5") * e * mpf("1.5") * v, -mpf("1.5") * k * e * sqrt(u) * d]
        return [every[i] for i in free]

    unknown = [mpf(s) / c for s, c in zip(start, scale)]
    q = unscale(list(findroot(gradient, unknown, tol=1e-50, maxsteps=200) if len(unknown) > 1 else [findroot(lambda a: gradient(a)[0], unknown[0])]))
    jacobian = matrix([analytic(q, x, v) for x, v, _ in rows])
    square = sum((f - force(full(q), x, v)) ** 2 for x, v, f in rows)
    s2 = square / (len(rows) - len(free))
    covariance = s2 * (jacobian.T * jacobian) ** -1
    mean = sum(f for _, _, f in rows) / len(rows)
    r2 = 1 - square / sum((f - mean) ** 2 for _, _, f in rows)
    return q, [sqrt(covariance[i, i]) for i in range(len(free))], sqrt(s2), covariance, r2


print(f"# mpmath {mpmath.__version__}, Python {platform.python_version()}, {mp.dps} digits; written by fits.py")
print("name,value,standard_error")
cases = [("elastic", [0], [2.7e5]), ("dissipative", [0, 1], [2.7e5, 1.0]), ("onset", [0, 2], [2.7e5, 5e-6]), ("all", [0, 1, 2], [2.7e5, 1.0, 5e-6])]
for name, free, start in cases:
    q, errors, s, covariance, r2 = solve(free, start)
    for i, value, error in zip(free, q, errors):
        print(f"{name} {('E', 'alpha', 'x0')[i]},{mpmath.nstr(value, 20)},{mpmath.nstr(error, 20)}")
    print(f"{name} s,{mpmath.nstr(s, 20)},")
    print(f"{name} r2,{mpmath.nstr(r2, 20)},")
    if len(free) > 1:
        print(f"{name} covariance,{mpmath.nstr(covariance[0, 1], 20)},")
for x, v, f in zip(X, V, F):
    print(f"data,{x!r} {v!r} {f!r},")
