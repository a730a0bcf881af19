//! Tests of all equations: against high-precision values, in other units, and against the documentation.
//!
//! `TABLE` calls each public equation by its name with a flat list of inputs. It also has the powers of length, mass and time of
//! the inputs and the output. The values are in `data/reference.csv` (mpmath, 50 digits).

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use contact_scaling::equilibrium::RaisedSpheres;
use contact_scaling::modulus::{MixingRule, SurfaceValues};
use contact_scaling::{
    Contact, ContactValues, Hertz, HertzValues, HuntCrossley, Law, RatioValues, Ratios,
    SURFACE_OVER_COMPOSITE_MODULUS, SharedLoad, SmoothSphere, SmoothingValues, Spheres, continuation, design,
    equilibrium, mixed_radii, modulus, patch, restitution, smoothing, stiffness,
};

/// Powers of length, mass and time in the unit of a quantity.
type Dimension = [f64; 3];

const ONE: Dimension = [0.0, 0.0, 0.0];
const LENGTH: Dimension = [1.0, 0.0, 0.0];
const AREA: Dimension = [2.0, 0.0, 0.0];
const PER_LENGTH: Dimension = [-1.0, 0.0, 0.0];
const MASS: Dimension = [0.0, 1.0, 0.0];
const PER_TIME: Dimension = [0.0, 0.0, -1.0];
const SPEED: Dimension = [1.0, 0.0, -1.0];
const PER_SPEED: Dimension = [-1.0, 0.0, 1.0];
const ROOT_PER_SPEED: Dimension = [-0.5, 0.0, 1.0];
const REDUCED_SPEED: Dimension = [0.5, 0.0, -1.0];
const ACCELERATION: Dimension = [1.0, 0.0, -2.0];
const FORCE: Dimension = [1.0, 1.0, -2.0];
const STIFFNESS: Dimension = [0.0, 1.0, -2.0];
const PRESSURE: Dimension = [-1.0, 1.0, -2.0];

/// Largest relative difference from the values of `reference.csv`: the rounding of a few operations.
const REFERENCE_TOLERANCE: f64 = 2e-15;
/// Functions with a larger tolerance, because they search a root or subtract large numbers.
const LARGER_TOLERANCES: [(&str, f64); 8] = [
    ("SmoothSphere::contact_state", 2e-14), // ½ + ½ tanh: cancels before contact
    ("SmoothSphere::elastic_force", 2e-14),
    ("SmoothSphere::speed_state", 2e-14),
    ("SmoothSphere::force", 2e-14),
    ("SmoothSphere::stiffness", 2e-14),
    ("SmoothSphere::rest_force", 2e-14),
    ("SmoothSphere::rest_stiffness", 2e-14),
    ("restitution::exact_dissipation", 2e-14),
];
/// Largest relative difference of results in other units, which also change the rounding of every input.
const DIMENSION_TOLERANCE: f64 = 1e-12;

struct Equation {
    name: &'static str,
    inputs: &'static [Dimension],
    output: Dimension,
    value: fn(&[f64]) -> f64,
}

const fn eq(
    name: &'static str,
    inputs: &'static [Dimension],
    output: Dimension,
    value: fn(&[f64]) -> f64,
) -> Equation {
    Equation { name, inputs, output, value }
}

fn hertz(i: &[f64]) -> Hertz {
    Hertz::new(HertzValues { composite_modulus: i[0], radius_m: i[1], shape_factor: i[2] }).unwrap()
}

fn hunt_crossley(i: &[f64]) -> HuntCrossley {
    HuntCrossley::new(Hertz::sphere(i[0], i[1]).unwrap(), i[2]).unwrap()
}

fn smooth(i: &[f64]) -> SmoothSphere {
    let smoothing = SmoothingValues {
        constant_contact_force: i[3],
        hertz_smoothing: i[4],
        hunt_crossley_smoothing: i[5],
    };
    SmoothSphere::new(Hertz::sphere(i[0], i[1]).unwrap(), i[2], smoothing).unwrap()
}

fn spheres_under_load(i: &[f64]) -> [Spheres; 1] {
    let values = ContactValues {
        plane_strain_modulus: i[0] * SURFACE_OVER_COMPOSITE_MODULUS,
        dissipation: i[2],
        smoothing: Some(SmoothingValues {
            constant_contact_force: i[3],
            hertz_smoothing: i[4],
            hunt_crossley_smoothing: i[5],
        }),
    };
    [Spheres::new(Law::of(&Contact::new(values).unwrap(), i[1]).unwrap(), i[6]).unwrap()]
}

/// Spheres at height 0, and equal spheres higher by the last input.
fn at_two_heights(i: &[f64]) -> [RaisedSpheres; 2] {
    let [spheres] = spheres_under_load(i);
    [RaisedSpheres::new(spheres, 0.0).unwrap(), RaisedSpheres::new(spheres, i[8]).unwrap()]
}

fn load(i: &[f64]) -> SharedLoad {
    SharedLoad::new(i[0], i[1]).unwrap()
}

fn ratios(i: &[f64]) -> Ratios {
    Ratios::new(RatioValues { mass: i[0], sphere_count: i[1], radius: i[2], gravity: i[3] }).unwrap()
}

const HERTZ_X: &[Dimension] = &[PRESSURE, LENGTH, ONE, LENGTH];
const HERTZ_X_HAT: &[Dimension] = &[PRESSURE, LENGTH, ONE, ONE];
const HUNT_CROSSLEY: &[Dimension] = &[PRESSURE, LENGTH, PER_SPEED, LENGTH, SPEED];
const SMOOTH: &[Dimension] = &[PRESSURE, LENGTH, PER_SPEED, AREA, PER_LENGTH, PER_SPEED, LENGTH, SPEED];
const SPHERES_UNDER_LOAD: &[Dimension] =
    &[PRESSURE, LENGTH, PER_SPEED, AREA, PER_LENGTH, PER_SPEED, ONE, FORCE];
const SPHERES_AT_TWO_HEIGHTS: &[Dimension] =
    &[PRESSURE, LENGTH, PER_SPEED, AREA, PER_LENGTH, PER_SPEED, ONE, FORCE, LENGTH];
const RATIOS: &[Dimension] = &[ONE, ONE, ONE, ONE];
const SURFACES: &[Dimension] = &[PRESSURE, PER_SPEED, PRESSURE, PER_SPEED];

const TABLE: &[Equation] = &[
    eq("Hertz::relative_indentation", HERTZ_X, ONE, |i| hertz(i).relative_indentation(i[3])),
    eq("Hertz::indentation", HERTZ_X_HAT, LENGTH, |i| hertz(i).indentation(i[3])),
    eq("Hertz::force", HERTZ_X, FORCE, |i| hertz(i).force(i[3])),
    eq("Hertz::force_at_relative_indentation", HERTZ_X_HAT, FORCE, |i| {
        hertz(i).force_at_relative_indentation(i[3])
    }),
    eq("Hertz::indentation_from_force", &[PRESSURE, LENGTH, ONE, FORCE], LENGTH, |i| {
        hertz(i).indentation_from_force(i[3]).unwrap()
    }),
    eq("Hertz::stiffness", HERTZ_X, STIFFNESS, |i| hertz(i).stiffness(i[3])),
    eq("Hertz::stiffness_at_relative_indentation", HERTZ_X_HAT, STIFFNESS, |i| {
        hertz(i).stiffness_at_relative_indentation(i[3])
    }),
    eq("HuntCrossley::dissipative_force", HUNT_CROSSLEY, FORCE, |i| {
        hunt_crossley(i).dissipative_force(i[3], i[4])
    }),
    eq("HuntCrossley::force", HUNT_CROSSLEY, FORCE, |i| hunt_crossley(i).force(i[3], i[4])),
    eq("SmoothSphere::constant_indentation_force", SMOOTH, FORCE, |i| {
        smooth(i).constant_indentation_force(i[6])
    }),
    eq("SmoothSphere::contact_state", SMOOTH, ONE, |i| smooth(i).contact_state(i[6])),
    eq("SmoothSphere::elastic_force", SMOOTH, FORCE, |i| smooth(i).elastic_force(i[6])),
    eq("SmoothSphere::speed_state", SMOOTH, ONE, |i| smooth(i).speed_state(i[7])),
    eq("SmoothSphere::force", SMOOTH, FORCE, |i| smooth(i).force(i[6], i[7])),
    eq("SmoothSphere::stiffness", SMOOTH, STIFFNESS, |i| smooth(i).stiffness(i[6])),
    eq("SmoothSphere::rest_force", SMOOTH, FORCE, |i| smooth(i).rest_force(i[6])),
    eq("SmoothSphere::rest_stiffness", SMOOTH, STIFFNESS, |i| smooth(i).rest_stiffness(i[6])),
    eq("patch::radius", &[LENGTH, LENGTH], LENGTH, |i| patch::radius(i[0], i[1]).unwrap()),
    eq("patch::diameter", &[LENGTH, LENGTH], LENGTH, |i| patch::diameter(i[0], i[1]).unwrap()),
    eq("patch::relative_radius", &[ONE], ONE, |i| patch::relative_radius(i[0]).unwrap()),
    eq("patch::mean_stress", &[FORCE, LENGTH, ONE], PRESSURE, |i| {
        patch::mean_stress(i[0], i[1], i[2]).unwrap()
    }),
    eq("modulus::plane_strain", &[PRESSURE, ONE], PRESSURE, |i| modulus::plane_strain(i[0], i[1]).unwrap()),
    eq("modulus::composite_johnson", &[PRESSURE, PRESSURE], PRESSURE, |i| {
        modulus::composite_johnson(i[0], i[1]).unwrap()
    }),
    eq("modulus::composite_sherman", &[PRESSURE, PRESSURE], PRESSURE, |i| {
        modulus::composite_sherman(i[0], i[1]).unwrap()
    }),
    eq("modulus::of_equal_surfaces", &[PRESSURE], PRESSURE, |i| {
        modulus::of_equal_surfaces(i[0], MixingRule::Sherman).unwrap()
    }),
    eq("modulus::composite_of_equal", &[PRESSURE], PRESSURE, |i| {
        modulus::composite_of_equal(i[0], MixingRule::Sherman).unwrap()
    }),
    eq("modulus::stiffness_on_rigid_ground", &[PRESSURE, ONE], PRESSURE, |i| {
        modulus::stiffness_on_rigid_ground(i[0], i[1]).unwrap()
    }),
    eq("modulus::mixed_dissipation", SURFACES, PER_SPEED, |i| {
        let first = SurfaceValues { plane_strain_modulus: i[0], dissipation: i[1] };
        let second = SurfaceValues { plane_strain_modulus: i[2], dissipation: i[3] };
        modulus::mixed_dissipation(first, second).unwrap()
    }),
    eq("modulus::composite_radius", &[LENGTH, LENGTH], LENGTH, |i| {
        modulus::composite_radius(i[0], i[1]).unwrap()
    }),
    eq("design::composite_modulus", &[LENGTH, ONE, FORCE, ONE], PRESSURE, |i| {
        design::composite_modulus(i[0], i[1], &load(&i[2..])).unwrap()
    }),
    eq("design::relative_indentation", &[PRESSURE, LENGTH, FORCE, ONE], ONE, |i| {
        design::relative_indentation(i[0], i[1], &load(&i[2..])).unwrap()
    }),
    eq("design::radius_for_stiffness", &[STIFFNESS, ONE, FORCE, ONE], LENGTH, |i| {
        design::radius_for_stiffness(i[0], i[1], &load(&i[2..])).unwrap()
    }),
    eq("design::composite_modulus_for_stiffness", &[STIFFNESS, LENGTH, ONE], PRESSURE, |i| {
        design::composite_modulus_for_stiffness(i[0], i[1], i[2]).unwrap()
    }),
    eq("stiffness::dimensionless", &[STIFFNESS, LENGTH, FORCE, ONE], ONE, |i| {
        stiffness::dimensionless(i[0], i[1], &load(&i[2..])).unwrap()
    }),
    eq("stiffness::dimensionless_hertz", &[ONE], ONE, |i| stiffness::dimensionless_hertz(i[0]).unwrap()),
    eq("stiffness::natural_frequency", &[STIFFNESS, MASS], PER_TIME, |i| {
        stiffness::natural_frequency(i[0], i[1]).unwrap()
    }),
    eq("stiffness::equilibrium_frequency", &[ONE, LENGTH, ACCELERATION], PER_TIME, |i| {
        stiffness::equilibrium_frequency(i[0], i[1], i[2]).unwrap()
    }),
    eq("restitution::approximate", &[PER_SPEED, SPEED], ONE, |i| {
        restitution::approximate(i[0], i[1]).unwrap()
    }),
    eq("restitution::dissipation", &[ONE, SPEED], PER_SPEED, |i| {
        restitution::dissipation(i[0], i[1]).unwrap()
    }),
    eq("continuation::modulus_ratio", &[ONE, ONE], ONE, |i| continuation::modulus_ratio(i[0], i[1]).unwrap()),
    eq("restitution::drop_speed", &[ACCELERATION, LENGTH], SPEED, |i| {
        restitution::drop_speed(i[0], i[1]).unwrap()
    }),
    eq("restitution::exact", &[PER_SPEED, SPEED], ONE, |i| restitution::exact(i[0], i[1]).unwrap()),
    eq("restitution::exact_dissipation", &[ONE, SPEED], PER_SPEED, |i| {
        restitution::exact_dissipation(i[0], i[1]).unwrap()
    }),
    eq("smoothing::constant_contact_force", &[ONE, LENGTH], AREA, |i| {
        smoothing::constant_contact_force(i[0], i[1]).unwrap()
    }),
    eq("smoothing::constant_indentation", &[AREA, LENGTH], ONE, |i| {
        smoothing::constant_indentation(i[0], i[1]).unwrap()
    }),
    eq("smoothing::hertz_smoothing", &[ONE, LENGTH], PER_LENGTH, |i| {
        smoothing::hertz_smoothing(i[0], i[1]).unwrap()
    }),
    eq("smoothing::threshold_indentation", &[ONE, PER_LENGTH, LENGTH], ONE, |i| {
        smoothing::threshold_indentation(i[0], i[1], i[2]).unwrap()
    }),
    eq("smoothing::transition_width", &[ONE, PER_LENGTH, LENGTH], ONE, |i| {
        smoothing::transition_width(i[0], i[1], i[2]).unwrap()
    }),
    eq("smoothing::hertz_smoothing_for_width", &[ONE, ONE, LENGTH], PER_LENGTH, |i| {
        smoothing::hertz_smoothing_for_width(i[0], i[1], i[2]).unwrap()
    }),
    eq("smoothing::hunt_crossley_smoothing", &[ROOT_PER_SPEED, LENGTH], PER_SPEED, |i| {
        smoothing::hunt_crossley_smoothing(i[0], i[1]).unwrap()
    }),
    eq("smoothing::hunt_crossley_smoothing_for_speed_width", &[ONE, SPEED], PER_SPEED, |i| {
        smoothing::hunt_crossley_smoothing_for_speed_width(i[0], i[1]).unwrap()
    }),
    eq(
        "smoothing::hunt_crossley_smoothing_for_reduced_width",
        &[ONE, REDUCED_SPEED, LENGTH],
        PER_SPEED,
        |i| smoothing::hunt_crossley_smoothing_for_reduced_width(i[0], i[1], i[2]).unwrap(),
    ),
    eq("smoothing::speed_state_at_rest", &[PER_SPEED, PER_SPEED], ONE, |i| {
        smoothing::speed_state_at_rest(i[0], i[1]).unwrap()
    }),
    eq("equilibrium::hertz_indentation", SPHERES_UNDER_LOAD, LENGTH, |i| {
        equilibrium::hertz_indentation(&spheres_under_load(i), i[7]).unwrap()
    }),
    eq("equilibrium::indentation", SPHERES_UNDER_LOAD, LENGTH, |i| {
        equilibrium::indentation(&spheres_under_load(i), i[7]).unwrap()
    }),
    eq("equilibrium::hertz_indentation_of_lowest", SPHERES_AT_TWO_HEIGHTS, LENGTH, |i| {
        equilibrium::hertz_indentation_of_lowest(&at_two_heights(i), i[7]).unwrap()
    }),
    eq("equilibrium::indentation_of_lowest", SPHERES_AT_TWO_HEIGHTS, LENGTH, |i| {
        equilibrium::indentation_of_lowest(&at_two_heights(i), i[7]).unwrap()
    }),
    eq("mixed_radii::mean_square", &[LENGTH, LENGTH, LENGTH], AREA, |i| mixed_radii::mean_square(i).unwrap()),
    eq("Ratios::plane_strain_modulus", RATIOS, ONE, |i| ratios(i).plane_strain_modulus()),
    eq("Ratios::dissipation", RATIOS, ONE, |i| ratios(i).dissipation()),
    eq("Ratios::dissipation_by_mass", RATIOS, ONE, |i| ratios(i).dissipation_by_mass()),
    eq("Ratios::constant_contact_force", RATIOS, ONE, |i| ratios(i).constant_contact_force()),
    eq("Ratios::hertz_smoothing", RATIOS, ONE, |i| ratios(i).hertz_smoothing()),
    eq("Ratios::hunt_crossley_smoothing", RATIOS, ONE, |i| ratios(i).hunt_crossley_smoothing()),
    eq("Ratios::transition_velocity", RATIOS, ONE, |i| ratios(i).transition_velocity()),
    eq("Ratios::viscous_friction", RATIOS, ONE, |i| ratios(i).viscous_friction()),
];

/// Rows of `reference.csv` by function: inputs and value.
fn reference() -> BTreeMap<&'static str, Vec<(Vec<f64>, f64)>> {
    let mut rows: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for line in include_str!("../data/reference.csv").lines().filter(|l| !l.starts_with('#')).skip(1) {
        let [name, inputs, value] = line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let inputs = inputs.split(' ').map(|x| x.parse().unwrap()).collect();
        rows.entry(name).or_default().push((inputs, value.parse().unwrap()));
    }
    rows
}

#[test]
fn every_equation_agrees_with_high_precision() {
    let reference = reference();
    let mut wrong = Vec::new();
    for equation in TABLE {
        let name = equation.name;
        let loose = LARGER_TOLERANCES.iter().find(|(loose, _)| *loose == name);
        let tolerance = loose.map_or(REFERENCE_TOLERANCE, |(_, t)| *t);
        let rows = reference.get(name).unwrap_or_else(|| panic!("{name} has no reference value"));
        for (inputs, expected) in rows {
            let value = (equation.value)(inputs);
            let off = (value - expected).abs() / expected.abs().max(f64::MIN_POSITIVE);
            if off > tolerance {
                wrong.push(format!("{name} {inputs:?}: {value:e}, expected {expected:e}, off by {off:e}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert_eq!(reference.len(), TABLE.len(), "reference.csv has functions that TABLE has not");
}

#[test]
fn every_equation_has_its_dimension() {
    // Other units of length, mass and time; nothing round, so that no two powers coincide.
    const UNITS: [[f64; 3]; 4] =
        [[3.28084, 2.20462, 1.0], [1000.0, 1e-3, 60.0], [0.37, 71.0, 0.013], [1.0, 1.0, 17.3]];
    let reference = reference();
    for equation in TABLE {
        for (inputs, _) in &reference[equation.name] {
            assert_eq!(inputs.len(), equation.inputs.len(), "{}", equation.name);
            for units in UNITS {
                let factor = |d: Dimension| (0..3).map(|i| units[i].powf(d[i])).product::<f64>();
                let elsewhere: Vec<f64> =
                    inputs.iter().zip(equation.inputs).map(|(x, &d)| x * factor(d)).collect();
                let expected = (equation.value)(inputs) * factor(equation.output);
                let value = (equation.value)(&elsewhere);
                let off = (value - expected).abs();
                assert!(
                    off <= DIMENSION_TOLERANCE * expected.abs(),
                    "{} {inputs:?} in {units:?}: {value:e}, expected {expected:e}",
                    equation.name
                );
            }
        }
    }
}

fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// Public functions whose doc comments contain `Source:`, as `Type::name` or `module::name`.
fn equations_in_source() -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&root, &mut files);
    let mut found = BTreeSet::new();
    for file in files {
        let module = file.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = std::fs::read_to_string(&file).unwrap();
        let (mut owner, mut sourced) = (module.clone(), false);
        for line in text.lines() {
            let code = line.trim_start();
            if let Some(name) = line.strip_prefix("impl ") {
                owner = name.trim_end_matches([' ', '{']).to_owned();
            } else if line == "}" {
                owner = module.clone();
            } else if code.starts_with("///") && code.contains(" Source: ") {
                sourced = true;
            } else if let Some(signature) = code.strip_prefix("pub fn ") {
                if sourced {
                    found.insert(format!("{owner}::{}", signature.split(['(', '<']).next().unwrap()));
                }
                sourced = false;
            } else if !code.starts_with("///") && !code.starts_with("#[") {
                sourced = false;
            }
        }
    }
    found
}

fn equations_page() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/equations.md");
    std::fs::read_to_string(path).unwrap()
}

/// The functions of the third column of the tables in `docs/reference/equations.md`.
fn equations_in_docs() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for line in equations_page().lines().filter(|l| l.starts_with('|')) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let names = cells[3].split('`').skip(1).step_by(2);
        found.extend(names.filter(|n| n.contains("::")).map(str::to_owned));
    }
    found
}

#[test]
fn every_equation_of_the_source_is_in_the_docs_and_the_reverse() {
    assert_eq!(equations_in_source(), equations_in_docs());
}

#[test]
fn every_equation_of_the_source_is_tested_here() {
    let here: BTreeSet<String> = TABLE.iter().map(|e| e.name.to_owned()).collect();
    assert_eq!(equations_in_source(), here);
}

#[test]
fn every_number_of_the_paper_is_in_the_docs() {
    let page = equations_page();
    let numbered = |prefix: &str, range: std::ops::RangeInclusive<u32>| {
        range.map(|i| format!("({prefix}{i})")).collect::<Vec<_>>()
    };
    let sets = [numbered("", 1..=15), numbered("A.", 1..=5), numbered("B.", 1..=5), numbered("C.", 1..=10)];
    let missing: Vec<_> = sets.concat().into_iter().filter(|n| !page.contains(&format!("|{n}"))).collect();
    assert!(missing.is_empty(), "not in docs/reference/equations.md: {missing:?}");
}
