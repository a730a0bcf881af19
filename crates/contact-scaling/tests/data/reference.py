#!/usr/bin/env python3
"""Reference values of every equation, in 50-digit arithmetic: python3 reference.py > reference.csv

The formulas are typed here from the paper (and, where it has none, from the source named), not from the
crate. Inputs are taken as the f64 nearest to what is written, outputs printed to 20 digits.
"""
import platform

import mpmath
from mpmath import mp, mpf, sqrt, tanh, atanh, pi, exp, log, findroot

mp.dps = 50


def force_hertz(e, r, eta, x):
    return mpf(4) / 3 * eta * sqrt(r) * e * x ** mpf("1.5") if x > 0 else mpf(0)


def smooth_cf(e, r, cf, x):
    return mpf(4) / 3 * sqrt(r) * e * sqrt(x**2 + cf) ** mpf("1.5")


def state(bd, x):
    return mpf(1) / 2 + tanh(bd * x) / 2


def speed_state(a, bv, v):
    return mpf(1) / 2 + tanh(bv * (v + 2 / (3 * a))) / 2


def smooth(e, r, a, cf, bd, bv, x, v):
    fs = smooth_cf(e, r, cf, x) * state(bd, x)
    return (fs + mpf(3) / 2 * fs * a * v) * speed_state(a, bv, v)


def share(e1, e2):
    # Simbody: k_i = E_i^(2/3), s1 = k2 / (k1 + k2).
    k1, k2 = e1 ** (mpf(2) / 3), e2 ** (mpf(2) / 3)
    return k2 / (k1 + k2)


def restitution(a, v):
    # The motion of (12) without gravity, in units where m = 1 and the elastic force is f(x):
    # v dv/dx = -f (1 + 3/2 a v), integrated by parts, gives h(d) = h(-c d). Solved with Lambert's W:
    # u = 1 - c d satisfies u exp(-u) = (1 + d) exp(-(1 + d)), on the branch u < 1.
    d = mpf(3) / 2 * a * v
    u = -mpmath.lambertw(-(1 + d) * exp(-(1 + d)), 0).real
    return (1 - u) / d


def restitution_dissipation(c, v):
    h = lambda z: z - log(1 + z)
    low, high = mpf(3) / 2 * (1 - c) * mpf("0.5"), (1 - mpf(10) ** -40) / c
    d = findroot(lambda d: h(d) - h(-c * d), (low, high), solver="anderson", tol=1e-70, maxsteps=500)
    return d / mpf("1.5") / v


def rest(e, r, a, cf, bd, bv, n, load):
    return findroot(lambda x: n * smooth(e, r, a, cf, bd, bv, x, 0) - load, (mpf("0.3") * r, mpf("0.4") * r))


def rest_of_lowest(e, r, a, cf, bd, bv, n, load, h):
    # n spheres at height 0, as many h higher.
    force = lambda x: n * (smooth(e, r, a, cf, bd, bv, x, 0) + smooth(e, r, a, cf, bd, bv, x - h, 0))
    return findroot(lambda x: force(x) - load, (mpf("0.2") * r, mpf("0.4") * r))


def hertz_rest_of_lowest(e, r, a, cf, bd, bv, n, load, h):
    force = lambda x: n * mpf(4) / 3 * sqrt(r) * e * (x**half3 + (x - h) ** half3)
    return findroot(lambda x: force(x) - load, (mpf("0.2") * r, mpf("0.4") * r))


def rest_slope(e, r, a, cf, bd, bv, x):
    return mpmath.diff(lambda y: smooth(e, r, a, cf, bd, bv, y, 0), x)


def slope(e, r, cf, bd, x):
    return mpmath.diff(lambda y: smooth_cf(e, r, cf, y) * state(bd, y), x)


half3 = mpf("1.5")
two32 = mpf(2) ** half3

E = [353553.39, 91540.5, 8.486e6]
R = [0.032, 0.002, 0.0637]
X = [0.0113, 0.0007, 0.0225]
XH = [0.3533, 0.16, 0.05]
F = [101.37, 0.1025, 1459.2375]
V = [0.396, -0.21, 1.3]
A = [2.0, 8.0, 0.5]
N = [6.0, 2.0, 8.0]
K = [13449.5, 218.0, 206515.0]
M = [62.0, 0.0209, 1190.0]
G = [9.81, 9.80665, 1.62]
CF, BD, BV = [1e-5, 3.90625e-8, 2.5e-4], [300.0, 4800.0, 150.7], [50.0, 200.0, 35.4]
# With these the second factor of (C.9) is far from 1 at speed 0.
AT_REST, BV_AT_REST = [20.0, 50.0, 2.0], [50.0, 5.0, 1.7]
T = [0.05, 0.01, 0.25]
ETA = [1.0, 1.3, 0.8]
STANDING = ([353553.39, 91540.5, 353553.39, 353553.39], [0.032, 0.002, 0.032, 0.032], [2.0, 8.0, 20.0, 50.0], [1e-5, 3.90625e-8, 1e-5, 1e-5], [300.0, 4800.0, 300.0, 300.0], [50.0, 200.0, 50.0, 5.0], [6.0, 2.0, 6.0, 6.0], [608.22, 0.205, 608.22, 608.22])
# Heights at which the higher spheres still touch.
UNEVEN = (*STANDING, [0.002, 0.0001, 0.001, 0.0005])

ROWS = [
    ("Hertz::relative_indentation", lambda e, r, eta, x: x / r, (E, R, ETA, X)),
    ("Hertz::indentation", lambda e, r, eta, xh: xh * r, (E, R, ETA, XH)),
    ("Hertz::force", force_hertz, (E, R, ETA, X)),
    ("Hertz::force_at_relative_indentation", lambda e, r, eta, xh: mpf(4) / 3 * eta * r**2 * e * xh**half3, (E, R, ETA, XH)),
    ("Hertz::indentation_from_force", lambda e, r, eta, f: (f / (mpf(4) / 3 * eta * sqrt(r) * e)) ** (mpf(2) / 3), (E, R, ETA, F)),
    ("Hertz::stiffness", lambda e, r, eta, x: mpmath.diff(lambda y: force_hertz(e, r, eta, y), x), (E, R, ETA, X)),
    ("Hertz::stiffness_at_relative_indentation", lambda e, r, eta, xh: 2 * eta * r * e * sqrt(xh), (E, R, ETA, XH)),
    ("HuntCrossley::dissipative_force", lambda e, r, a, x, v: half3 * force_hertz(e, r, 1, x) * a * v, (E, R, A, X, V)),
    ("HuntCrossley::force", lambda e, r, a, x, v: max(mpf(0), force_hertz(e, r, 1, x) * (1 + half3 * a * v)), (E, R, [2.0, 1.0, 0.5], X, V)),
    ("SmoothSphere::constant_indentation_force", lambda e, r, a, cf, bd, bv, x, v: smooth_cf(e, r, cf, x), (E, R, A, CF, BD, BV, X, V)),
    ("SmoothSphere::contact_state", lambda e, r, a, cf, bd, bv, x, v: state(bd, x), (E, R, A, CF, BD, BV, [0.0005, -0.0001, 0.002], V)),
    ("SmoothSphere::elastic_force", lambda e, r, a, cf, bd, bv, x, v: smooth_cf(e, r, cf, x) * state(bd, x), (E, R, A, CF, BD, BV, [0.0113, -0.0001, 0.002], V)),
    ("SmoothSphere::speed_state", lambda e, r, a, cf, bd, bv, x, v: speed_state(a, bv, v), (E, R, A, CF, BD, BV, X, [-0.32, -0.08, -1.35])),
    ("SmoothSphere::force", smooth, (E, R, A, CF, BD, BV, [0.0113, -0.0001, 0.002], [-0.32, 0.3, -1.3])),
    ("SmoothSphere::stiffness", lambda e, r, a, cf, bd, bv, x, v: slope(e, r, cf, bd, x), (E, R, A, CF, BD, BV, [0.0113, -0.0001, 0.002], V)),
    ("SmoothSphere::rest_force", lambda e, r, a, cf, bd, bv, x, v: smooth(e, r, a, cf, bd, bv, x, 0), (E * 2, R * 2, A + AT_REST, CF * 2, BD * 2, BV + BV_AT_REST, [0.0113, -0.0001, 0.002] * 2, V * 2)),
    ("SmoothSphere::rest_stiffness", lambda e, r, a, cf, bd, bv, x, v: rest_slope(e, r, a, cf, bd, bv, x), (E * 2, R * 2, A + AT_REST, CF * 2, BD * 2, BV + BV_AT_REST, [0.0113, -0.0001, 0.002] * 2, V * 2)),
    ("patch::radius", lambda x, r: sqrt(x * r), (X, R)),
    ("patch::diameter", lambda x, r: 2 * sqrt(x * r), (X, R)),
    ("patch::relative_radius", lambda xh: sqrt(xh), (XH,)),
    ("patch::mean_stress", lambda f, r, xh: f / (pi * r**2 * xh), (F, R, XH)),
    ("modulus::plane_strain", lambda e, nu: e / (1 - nu**2), (E, [0.5, 0.3, -0.25])),
    ("modulus::composite_johnson", lambda a, b: a * b / (a + b), (E, [1e6, 2.5e5, 7e10])),
    ("modulus::composite_sherman", lambda a, b: (a ** (mpf(2) / 3) * b ** (mpf(2) / 3) / (a ** (mpf(2) / 3) + b ** (mpf(2) / 3))) ** half3, (E, [1e6, 2.5e5, 7e10])),
    ("modulus::of_equal_surfaces", lambda e: two32 * e, (E,)),
    ("modulus::composite_of_equal", lambda e: e / two32, (E,)),
    ("modulus::stiffness_on_rigid_ground", lambda e, nu: two32 * e / (1 - nu**2), (E, [0.5, 0.3, -0.25])),
    ("modulus::mixed_dissipation", lambda e1, a1, e2, a2: a1 * share(e1, e2) + a2 * (1 - share(e1, e2)), (E, A, [1e6, 2.5e5, 7e10], [0.1, 3.0, 1.0])),
    ("modulus::composite_radius", lambda a, b: a * b / (a + b), (R, [0.5, 0.03, 0.0637])),
    ("design::composite_modulus", lambda r, xh, f, n: 3 * f / (4 * r**2 * xh**half3 * n), (R, XH, F, N)),
    ("design::relative_indentation", lambda e, r, f, n: (3 * f / (4 * e * r**2 * n)) ** (mpf(2) / 3), (E, R, F, N)),
    ("design::radius_for_stiffness", lambda k, xh, f, n: 3 * f / (2 * k * xh * n), (K, XH, F, N)),
    ("design::composite_modulus_for_stiffness", lambda k, r, xh: k / (2 * r * sqrt(xh)), (K, R, XH)),
    ("stiffness::dimensionless", lambda k, r, f, n: k * r * n / f, (K, R, F, N)),
    ("stiffness::dimensionless_hertz", lambda xh: 3 / (2 * xh), (XH,)),
    ("stiffness::natural_frequency", lambda k, m: sqrt(k / m) / (2 * pi), (K, M)),
    ("stiffness::equilibrium_frequency", lambda xh, r, g: sqrt(half3 / xh * g / r) / (2 * pi), (XH, R, G)),
    ("restitution::approximate", lambda a, v: 1 - a * v, ([2.0, 0.5, 0.01], [0.396, 0.4, 0.02])),
    ("restitution::dissipation", lambda c, v: (1 - c) / v, ([0.8, 0.55, 0.99], [0.4, 0.1, 3.0])),
    # From the height R/4, by the energy.
    ("restitution::drop_speed", lambda g, r: sqrt(2 * g * (r / 4)), (G, R)),
    ("restitution::exact", restitution, ([2.0, 2.0, 0.5, 0.01, 1e-6, 40.0], [0.396, 0.1, 0.4, 0.02, 0.5, 7.0])),
    ("restitution::exact_dissipation", restitution_dissipation, ([0.8, 0.55, 0.1, 0.99], [0.4, 0.1, 1.0, 3.0])),
    ("smoothing::constant_contact_force", lambda xc, r: (r * xc) ** 2, ([0.0988, 0.05, 0.1], R)),
    ("smoothing::constant_indentation", lambda cf, r: sqrt(cf) / r, (CF, R)),
    ("smoothing::hertz_smoothing", lambda b, r: b / r, ([9.6, 10.0, 25.0], R)),
    ("smoothing::threshold_indentation", lambda t, bd, r: atanh(1 - 2 * t) / (bd * r), ([0.05, 0.8, 0.25], BD, R)),
    ("smoothing::transition_width", lambda t, bd, r: 2 * atanh(1 - 2 * t) / (bd * r), (T, BD, R)),
    ("smoothing::hertz_smoothing_for_width", lambda t, w, r: 2 * atanh(1 - 2 * t) / (w * r), (T, [0.3, 0.1, 0.5], R)),
    ("smoothing::hunt_crossley_smoothing", lambda b, r: b / sqrt(r), ([8.94, 9.0, 20.0], R)),
    ("smoothing::hunt_crossley_smoothing_for_speed_width", lambda t, w: 2 * atanh(1 - 2 * t) / w, (T, [0.06, 0.3, 0.01])),
    ("smoothing::hunt_crossley_smoothing_for_reduced_width", lambda t, w, r: 2 * atanh(1 - 2 * t) / (w * sqrt(r)), (T, [0.3, 0.2, 1.0], R)),
    ("smoothing::speed_state_at_rest", lambda a, bv: speed_state(a, bv, 0), (A + AT_REST, BV + BV_AT_REST)),
    ("equilibrium::hertz_indentation", lambda e, r, a, cf, bd, bv, n, f: (f / (n * mpf(4) / 3 * sqrt(r) * e)) ** (mpf(2) / 3), STANDING),
    ("equilibrium::indentation", rest, STANDING),
    ("equilibrium::hertz_indentation_of_lowest", hertz_rest_of_lowest, UNEVEN),
    ("equilibrium::indentation_of_lowest", rest_of_lowest, UNEVEN),
    ("continuation::modulus_ratio", lambda a, b: (a / b) ** half3, ([1.2, 2.5, 4.246], [9.375, 4.246, 1.5])),
    ("mixed_radii::mean_square", lambda a, b, c: (a**2 + b**2 + c**2) / 3, ([0.032, 0.015], [0.03, 0.002], [0.0637, 0.1])),
]

MU, NN, RHO, GAMMA = [8.0645, 3.37e-4, 19.19], [1.0, 0.3333, 1.25], [1.99, 0.0625, 0.9375], [1.0, 0.165, 2.5]
RATIOS = [
    ("plane_strain_modulus", lambda m, n, r, g: m / n / r**2 * g),
    ("dissipation", lambda m, n, r, g: 1 / sqrt(r * g)),
    ("dissipation_by_mass", lambda m, n, r, g: m ** (-mpf(1) / 6) / sqrt(g)),
    ("constant_contact_force", lambda m, n, r, g: r**2),
    ("hertz_smoothing", lambda m, n, r, g: 1 / r),
    ("hunt_crossley_smoothing", lambda m, n, r, g: 1 / sqrt(r * g)),
    ("transition_velocity", lambda m, n, r, g: sqrt(r * g)),
    ("viscous_friction", lambda m, n, r, g: 1 / sqrt(r * g)),
]
ROWS += [("Ratios::" + name, f, (MU, NN, RHO, GAMMA)) for name, f in RATIOS]

print(f"# mpmath {mpmath.__version__}, Python {platform.python_version()}, {mp.dps} digits; written by reference.py")
print("function,inputs,value")
for name, f, columns in ROWS:
    for row in zip(*columns):
        value = f(*[mpf(x) for x in row])
        print(f"{name},{' '.join(repr(float(x)) for x in row)},{mpmath.nstr(value, 20)}")
