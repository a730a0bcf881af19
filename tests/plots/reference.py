"""Numbers that figures must show, from the equations of theory alone: mpmath 1.3.0 with 40 digits, and the motion of
Fig. 4 by the classical Runge-Kutta method with steps of 1 us (for the mouse a quarter of that).

Run: python tests/plots/reference.py (10 s). The output stands in tests/plots.rs.
"""

import math

from mpmath import atanh, findroot, log, mp, mpf, nstr, sqrt, tanh

mp.dps = 40


def hertz(x, r, e):
    return mpf(4) / 3 * sqrt(r) * e * x ** mpf("1.5") if x > 0 else mpf(0)


def with_constant(x, r, e, cf):
    return mpf(4) / 3 * sqrt(r) * e * (x * x + cf) ** mpf("0.75")


def smoothed(x, r, e, cf, bd):
    return with_constant(x, r, e, cf) * (mpf(1) / 2 + tanh(bd * x) / 2)


def show(name, value):
    print(name, nstr(value, 10))


R, E, CF, BD = mpf("0.032"), mpf("1e6") / mpf(2) ** mpf("1.5"), mpf("1e-5"), mpf(300)
show("falisse2022: Hertz at 0.5", hertz(R / 2, R, E))
show("falisse2022: with cf at 0", with_constant(0, R, E, CF))
show("falisse2022: smoothed at 0", smoothed(0, R, E, CF, BD))
show("falisse2022: smoothed at 0.5", smoothed(R / 2, R, E, CF, BD))
share = 62 * mpf("9.80665") / 6
show("falisse2022: rests at", findroot(lambda x: smoothed(x, R, E, CF, BD) - share, R / 3) / R)
r = mpf("0.015")
rho = r / R
e = E * mpf("37.80") / 62 * mpf(6) / 10 / rho**2
show("emu: Hertz at 0.5", hertz(r / 2, r, e))
show("emu, default: smoothed at 0", smoothed(0, r, e, CF, BD))
show("emu, default: smoothed at 0.5", smoothed(r / 2, r, e, CF, BD))
show("emu, scaled: smoothed at 0", smoothed(0, r, e, CF * rho**2, BD / rho))
show("emu, default: threshold", atanh(mpf("0.9")) / (BD * r))
show("emu, scaled: threshold", atanh(mpf("0.9")) / (BD * R))

# Restitution of an impact without gravity, with the speed of a fall from a quarter of the radius and alpha 2.
d = mpf(3) / 2 * 2 * sqrt(mpf("9.80665") * mpf("0.032") / 2)
exact = findroot(lambda c: d - log(1 + d) + c * d + log(1 - c * d), (mpf("0.3"), mpf("0.7")), solver="anderson")
show("human: restitution", exact)


def extremes(mass, count, radius, surface_modulus, dissipation, gravity=9.81, until=0.2):
    """(time, force/weight) of the first maxima and minima of a drop from a quarter of the radius."""
    k = count * 4 / 3 * math.sqrt(radius) * surface_modulus / 2**1.5
    height = 0.25 * radius
    x, v, t = 0.0, math.sqrt(2 * gravity * height), math.sqrt(2 * height / gravity)
    dt = 1e-6 * math.sqrt(radius / 0.032)

    def force(x, v):
        return max(0.0, k * x**1.5 * (1 + 1.5 * dissipation * v)) if x > 0 else 0.0

    def pull(x, v):
        return gravity - force(x, v) / mass

    seen, last, rising = [], 0.0, True
    while t < until:
        a1 = pull(x, v)
        v2 = v + dt / 2 * a1
        a2 = pull(x + dt / 2 * v, v2)
        v3 = v + dt / 2 * a2
        a3 = pull(x + dt / 2 * v2, v3)
        v4 = v + dt * a3
        a4 = pull(x + dt * v3, v4)
        x, v, t = x + dt / 6 * (v + 2 * v2 + 2 * v3 + v4), v + dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4), t + dt
        now = force(x, v) / (mass * gravity)
        if (now < last) == rising:
            seen.append((round(t - dt, 6), round(last, 6)))
            rising = not rising
        last = now
    return seen[:3]


def scaled_modulus(mass, count, radius):
    return 1e6 * mass / 62 * 6 / count * (0.032 / radius) ** 2


mouse, giraffe = (0.0209, 2, 0.002), (1190, 8, 0.030)
print("mouse, alpha 2:", extremes(*mouse, scaled_modulus(*mouse), 2.0))
print("mouse, scaled:", extremes(*mouse, scaled_modulus(*mouse), 8.0))
print("giraffe, alpha 2:", extremes(*giraffe, scaled_modulus(*giraffe), 2.0))
print("giraffe, scaled:", extremes(*giraffe, scaled_modulus(*giraffe), 2 * math.sqrt(0.032 / 0.030)))
