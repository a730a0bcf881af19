"""Examples of `osim_contact_scale.scaling`, which dev/generate_scaling.py puts into the help of the functions.

The values are calculated with 50 digits from the equations in that help, apart from this project: where an example
fails, the function is wrong. There is an empty line between the examples of two functions.
"""

EXAMPLES = """
>>> round(scaling.hertz_force(composite_modulus=3e5, radius=0.032, indentation=0.008), 3)
51.2

>>> round(scaling.hertz_indentation(composite_modulus=3e5, radius=0.032, force=51.2), 6)
0.008

>>> scaling.relative_indentation(indentation=0.008, radius=0.032)
0.25

>>> scaling.indentation(relative_indentation=0.25, radius=0.032)
0.008

>>> round(scaling.hertz_force_at_relative_indentation(composite_modulus=3e5, radius=0.032,
...     relative_indentation=0.25), 3)
51.2

>>> round(scaling.hunt_crossley_dissipative_force(composite_modulus=3e5, radius=0.032, dissipation=2,
...     indentation=0.008, speed=0.1), 3)
15.36

>>> round(scaling.hunt_crossley_force(composite_modulus=3e5, radius=0.032, dissipation=2, indentation=0.008,
...     speed=0.1), 3)
66.56

>>> round(scaling.mean_stress(force=51.2, radius=0.032, relative_indentation=0.25), 1)
63662.0

>>> round(scaling.patch_radius(indentation=0.008, radius=0.032), 6)
0.016

>>> round(scaling.patch_diameter(indentation=0.008, radius=0.032), 6)
0.032

>>> round(scaling.relative_patch_radius(relative_indentation=0.16), 6)
0.4

>>> round(scaling.hertz_stiffness(composite_modulus=3e5, radius=0.032, indentation=0.008), 3)
9600.0

>>> round(scaling.hertz_stiffness_at_relative_indentation(composite_modulus=3e5, radius=0.032,
...     relative_indentation=0.25), 3)
9600.0

>>> scaling.approximate_restitution(dissipation=2, impact_speed=0.1)
0.8

>>> round(scaling.dissipation_for_restitution(restitution=0.8, impact_speed=0.1), 6)
2.0

>>> round(scaling.exact_restitution(dissipation=2, impact_speed=0.396), 3)
0.549

>>> round(scaling.dissipation_for_exact_restitution(restitution=0.55, impact_speed=0.396), 3)
1.996

>>> round(scaling.drop_speed(gravity=9.81, radius=0.032), 3)
0.396

>>> scaling.plane_strain_modulus_of_material(youngs_modulus=7.5e5, poissons_ratio=0.5)
1000000.0

>>> scaling.composite_modulus_by_johnson(first_modulus=1e6, second_modulus=3e6)
750000.0

>>> round(scaling.composite_modulus_by_sherman(first_modulus=1e6, second_modulus=8e6), 1)
715541.8

>>> round(scaling.plane_strain_modulus_of_equal_surfaces(composite_modulus=353553.4), 1)
1000000.0
>>> scaling.plane_strain_modulus_of_equal_surfaces(composite_modulus=5e5, rule="johnson")
1000000.0

>>> round(scaling.composite_modulus_of_equal_surfaces(plane_strain_modulus=1e6), 1)
353553.4
>>> scaling.composite_modulus_of_equal_surfaces(plane_strain_modulus=1e6, rule="johnson")
500000.0

>>> round(scaling.stiffness_on_rigid_ground(youngs_modulus=7.5e5, poissons_ratio=0.5), 1)
2828427.1

>>> round(scaling.mixed_dissipation(first_modulus=1e6, first_dissipation=2, second_modulus=8e6,
...     second_dissipation=1), 6)
1.8

>>> round(scaling.composite_radius(first_radius=0.03, second_radius=0.06), 6)
0.02

>>> round(scaling.composite_modulus_for_indentation(relative_indentation=0.25, radius=0.032, load=600,
...     sphere_count=6), 3)
585937.5

>>> round(scaling.relative_indentation_under_load(composite_modulus=353553.4, radius=0.032, load=62 * 9.81,
...     sphere_count=6), 4)
0.3533

>>> round(scaling.composite_modulus_for_stiffness(stiffness=9600, radius=0.032, relative_indentation=0.25), 3)
300000.0

>>> round(scaling.radius_for_stiffness(stiffness=9600, relative_indentation=0.25, load=600, sphere_count=6), 6)
0.0625

>>> round(scaling.dimensionless_stiffness(stiffness=9600, radius=0.032, load=307.2, sphere_count=6), 6)
6.0

>>> scaling.dimensionless_hertz_stiffness(relative_indentation=0.25)
6.0

>>> round(scaling.natural_frequency(stiffness=13450, mass_on_sphere=62 / 6), 3)
5.742

>>> round(scaling.equilibrium_frequency(relative_indentation=0.3533, radius=0.032, gravity=9.81), 3)
5.742

>>> scaling.modulus_ratio(first_dimensionless_stiffness=4, second_dimensionless_stiffness=1)
8.0

>>> round(scaling.constant_indentation_force(composite_modulus=3e5, radius=0.04, constant_contact_force=3.6e-5,
...     indentation=0.008), 3)
80.0

>>> round(scaling.smooth_elastic_force(composite_modulus=3e5, radius=0.04, constant_contact_force=3.6e-5,
...     hertz_smoothing=300, indentation=0.008), 3)
79.347

>>> round(scaling.smooth_elastic_stiffness(composite_modulus=3e5, radius=0.04, constant_contact_force=3.6e-5,
...     hertz_smoothing=300, indentation=0.008), 2)
9910.24

>>> scaling.contact_state(hertz_smoothing=300, indentation=0)
0.5
>>> round(scaling.contact_state(hertz_smoothing=300, indentation=0.008), 3)
0.992

>>> round(scaling.smooth_force(composite_modulus=3e5, radius=0.04, dissipation=2, constant_contact_force=3.6e-5,
...     hertz_smoothing=300, hunt_crossley_smoothing=50, indentation=0.008, speed=0.1), 3)
103.151

>>> round(scaling.speed_state(dissipation=2, hunt_crossley_smoothing=50, speed=-0.3), 3)
0.966

>>> round(scaling.speed_state_at_rest(dissipation=20, hunt_crossley_smoothing=50), 3)
0.966

>>> round(scaling.smooth_rest_force(composite_modulus=3e5, radius=0.04, dissipation=20,
...     constant_contact_force=3.6e-5, hertz_smoothing=300, hunt_crossley_smoothing=50, indentation=0.008), 3)
76.614

>>> round(scaling.smooth_rest_stiffness(composite_modulus=3e5, radius=0.04, dissipation=20,
...     constant_contact_force=3.6e-5, hertz_smoothing=300, hunt_crossley_smoothing=50, indentation=0.008), 2)
9568.88

>>> round(scaling.constant_contact_force_for_indentation(constant_relative_indentation=0.1, radius=0.032), 9)
1.024e-05

>>> round(scaling.constant_relative_indentation(constant_contact_force=1e-5, radius=0.032), 4)
0.0988

>>> round(scaling.hertz_smoothing_for_radius(dimensionless_hertz_smoothing=9.6, radius=0.032), 6)
300.0

>>> round(scaling.threshold_indentation(threshold=0.05, hertz_smoothing=300, radius=0.032), 4)
0.1534

>>> round(scaling.transition_width(threshold=0.05, hertz_smoothing=300, radius=0.032), 4)
0.3067

>>> round(scaling.hertz_smoothing_for_width(threshold=0.05, transition_width=0.3, radius=0.032), 2)
306.71

>>> round(scaling.hunt_crossley_smoothing_for_radius(reduced_hunt_crossley_smoothing=9, radius=0.04), 6)
45.0

>>> round(scaling.hunt_crossley_smoothing_for_speed_width(threshold=0.05, speed_width=0.1), 3)
29.444

>>> round(scaling.hunt_crossley_smoothing_for_reduced_width(threshold=0.05, reduced_speed_width=0.5,
...     radius=0.04), 3)
29.444

>>> round(scaling.plane_strain_modulus(mass_ratio=545 / 62, sphere_count_ratio=10 / 6,
...     radius_ratio=0.015 / 0.032), 2)
24.0

>>> scaling.dissipation(radius_ratio=4)
0.5
>>> scaling.dissipation(radius_ratio=[0.0625, 1])
array([4., 1.])

>>> round(scaling.dissipation_by_mass(mass_ratio=64), 6)
0.5

>>> scaling.constant_contact_force(radius_ratio=0.5)
0.25

>>> scaling.hertz_smoothing(radius_ratio=0.0625)
16.0

>>> scaling.hunt_crossley_smoothing(radius_ratio=0.25)
2.0

>>> scaling.transition_velocity(radius_ratio=4)
2.0

>>> scaling.viscous_friction(radius_ratio=4)
0.5

>>> round(scaling.mean_square_radius(radius=[0.03, 0.04]), 6)
0.00125

>>> round(scaling.hertz_rest_indentation(load=120, composite_modulus=3e5, radius=[0.04, 0.01]), 6)
0.01

>>> round(scaling.smooth_rest_indentation(load=120, composite_modulus=3e5, radius=[0.04, 0.01], dissipation=2,
...     constant_contact_force=1e-5, hertz_smoothing=300, hunt_crossley_smoothing=50), 6)
0.00951

>>> steps = scaling.continuation_steps(first=1, last=16, dissipation_ratio=4, count=3)
>>> steps.modulus_factor.round(6).tolist(), steps.dissipation_factor.round(6).tolist()
([0.015625, 0.125, 1.0], [4.0, 2.0, 1.0])
"""
