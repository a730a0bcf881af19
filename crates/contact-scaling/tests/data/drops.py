#!/usr/bin/env python3
"""Drops by the classical Runge-Kutta method in very short steps: python3 drops.py > drops.csv

Independent of the crate: another method, another step control (none), another language. Everything is
dimensionless: length R, time sqrt(R/g), force M g. Steps are halved once; the rows are those of the short
steps, and the largest change on halving is printed in the head.
"""
import math
import platform

import mpmath
from mpmath import mp

R, G = 0.032, 9.81


class Body:
    def __init__(self, mass, radius, n, stiffness, alpha, smooth=None):
        weight = mass * G
        self.r, self.t = radius, math.sqrt(radius / G)
        self.e = 4 / 3 * (stiffness / 2**1.5) * radius**2 * n / weight
        self.a = 1.5 * alpha * math.sqrt(radius * G)
        self.smooth = smooth and (
            smooth[0] / radius**2,
            smooth[1] * radius,
            smooth[2] * math.sqrt(radius * G),
        )

    def rate(self, x, v):
        if self.smooth:
            cf, bd, bv = self.smooth
            f = self.e * (x * x + cf) ** 0.75 * (0.5 + 0.5 * math.tanh(bd * x)) * (1 + self.a * v)
            f *= 0.5 + 0.5 * math.tanh(bv * (v + 1 / self.a))
        else:
            f = self.e * x**1.5 * max(0.0, 1 + self.a * v) if x > 0 else 0.0
        return 1.0 - f


def step(body, x, v, h):
    f = body.rate
    a1 = f(x, v)
    v2 = v + h / 2 * a1
    a2 = f(x + h / 2 * v, v2)
    v3 = v + h / 2 * a2
    a3 = f(x + h / 2 * v2, v3)
    v4 = v + h * a3
    a4 = f(x + h * v3, v4)
    return x + h / 6 * (v + 2 * v2 + 2 * v3 + v4), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)


def series(body, height, seconds, fine):
    """x at 40 equal times after the start; the Hertz law starts anew, in graded steps, at the contact."""
    end = seconds / body.t
    times = [end * k / 40 for k in range(1, 41)]
    rows, t = [], 0.0
    if body.smooth:
        x, v = -height, 0.0
    else:
        t = math.sqrt(2 * height)
        x, v = 0.0, t
        while times and times[0] <= t:
            s = times.pop(0)
            rows.append((s * body.t, (s * s / 2 - height) * body.r))
        first, start, graded = times.pop(0), t, 40000 * fine
        for k in range(1, graded + 1):
            s = start + (first - start) * (k / graded) ** 3
            x, v = step(body, x, v, s - t)
            t = s
        rows.append((t * body.t, x * body.r))
    h = 2e-4 / fine
    for s in times:
        count = math.ceil((s - t) / h)
        part = (s - t) / count
        for _ in range(count):
            x, v = step(body, x, v, part)
        t = s
        rows.append((s * body.t, x * body.r))
    return rows


def checked(name, body, height, seconds):
    coarse, fine = (series(body, height, seconds, k) for k in (1, 2))
    change = max(abs(a[1] - b[1]) for a, b in zip(coarse, fine)) / body.r
    print(f"# {name}: halving the steps changes x by {change:.1e} R")
    return [(name, *row) for row in fine]


def bounce(mass, radius, n, stiffness, height):
    """Contact time and peak force of a bounce without dissipation, from its energy, by quadrature."""
    mp.dps = 30
    g, r = mp.mpf(G), mp.mpf(radius)
    c = mp.mpf(4) / 3 * mp.sqrt(r) * stiffness / mp.mpf(2) ** 1.5 * n
    v2 = 2 * g * height * r
    square = lambda x: v2 + 2 * g * x - mp.mpf(4) / 5 * c * x ** mp.mpf(2.5) / mass
    top = mp.findroot(square, (v2 * mass / c) ** mp.mpf(0.4))
    # x = top (1 - u^2) takes the root of the square out of the integrand.
    time = 2 * mp.quad(lambda u: 2 * top * u / mp.sqrt(square(top * (1 - u * u))), [0, 0.5, 1])
    return time, c * top ** mp.mpf(1.5), mp.sqrt(v2)


print(f"# classical Runge-Kutta in Python {platform.python_version()} floats, mpmath {mpmath.__version__}; written by drops.py")
cases = [
    checked("human", Body(62, R, 6, 1e6, 2.0), 0.25, 2.0),
    checked("mouse", Body(0.0209, 0.002, 2, 1e6 * (0.0209 / 62) * 3 * 256, 2.0), 0.25, 2.0),
    checked("smooth human", Body(62, R, 6, 1e6, 2.0, (1e-5, 300.0, 50.0)), 0.25, 2.0),
]
time, force, speed = bounce(62, R, 6, 1e8, 0.25)
print("name,time_s,indentation_m")
for case in cases:
    for name, t, x in case:
        print(f"{name},{t!r},{x!r}")
print(f"bounce: contact time,{mpmath.nstr(time.real, 17)},")
print(f"bounce: peak force,{mpmath.nstr(force, 17)},")
print(f"bounce: speed,{mpmath.nstr(speed, 17)},")
