//! Tests of fits: against high-precision least squares, in other units, and with noise from a fixed seed.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use contact_scaling::fit::{
    Doubt, Estimate, Fit, FitError, FitValues, FittedBranch, Measurement, Onset, Parameter, Rate, fit,
};
use contact_scaling::{Hertz, HuntCrossley};

#[derive(Clone, Default)]
struct PressData {
    x: Vec<f64>,
    v: Vec<f64>,
    f: Vec<f64>,
}

impl PressData {
    fn fit(&self, radius_m: f64, with_speed: bool, onset: Onset) -> Result<Fit, FitError> {
        let rate = if with_speed { Rate::Speed(&self.v) } else { Rate::Unknown };
        let measurement = Measurement { indentation_m: &self.x, force_n: &self.f, rate };
        fit(&measurement, &FitValues { radius_m, sphere_count: 2.0, onset, branch: FittedBranch::Both })
    }
}

fn reference(name: &str) -> (f64, f64) {
    let mut lines = include_str!("../data/fits.csv").lines();
    let line = lines.find(|line| line.split(',').next() == Some(name)).unwrap_or_else(|| panic!("{name}"));
    let cells: Vec<_> = line.split(',').collect();
    (cells[1].parse().unwrap(), cells[2].parse().unwrap_or(f64::NAN))
}

fn reference_data() -> PressData {
    let mut data = PressData::default();
    for line in include_str!("../data/fits.csv").lines().filter_map(|line| line.strip_prefix("data,")) {
        let row: Vec<f64> = line.trim_end_matches(',').split(' ').map(|x| x.parse().unwrap()).collect();
        data.x.push(row[0]);
        data.v.push(row[1]);
        data.f.push(row[2]);
    }
    data
}

#[track_caller]
fn assert_close(value: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (value / expected - 1.0).abs();
    assert!(off < tolerance, "{what}: {value:e}, expected {expected:e}, off by {off:e}");
}

#[test]
fn values_and_errors_agree_with_high_precision() {
    let data = reference_data();
    let cases = [
        ("elastic", false, Onset::At(0.0), 1e-13),
        ("dissipative", true, Onset::At(0.0), 1e-12),
        ("onset", false, Onset::Fitted, 1e-7),
        ("all", true, Onset::Fitted, 1e-7),
    ];
    for (name, with_speed, onset, tolerance) in cases {
        let result = data.fit(0.02, with_speed, onset).unwrap();
        let check = |estimate: Estimate, what: &str| {
            let (value, error) = reference(&format!("{name} {what}"));
            assert_close(estimate.value, value, tolerance, &format!("{name} {what}"));
            assert_close(estimate.standard_error, error, tolerance, &format!("error of {name} {what}"));
        };
        check(result.composite_modulus, "E");
        if let Some(estimate) = result.dissipation {
            check(estimate, "alpha");
        }
        if let Some(estimate) = result.onset_m {
            check(estimate, "x0");
        }
        let (s, _) = reference(&format!("{name} s"));
        assert_close(result.residual_deviation_n, s, tolerance, name);
        let (r2, _) = reference(&format!("{name} r2"));
        assert_close(result.r_squared, r2, 1e-13, name);
        if result.parameters.len() > 1 {
            let (covariance, _) = reference(&format!("{name} covariance"));
            assert_close(result.covariance[0][1], covariance, tolerance, name);
        }
        assert_eq!(result.degrees_of_freedom, 14 - result.parameters.len());
    }
}

#[test]
fn a_fit_does_not_depend_on_units() {
    // Metres, kilograms and seconds times arbitrary factors.
    let (l, m, t) = (3.28_f64, 0.453, 60.0);
    let data = reference_data();
    let here = data.fit(0.02, true, Onset::Fitted).unwrap();
    let elsewhere = PressData {
        x: data.x.iter().map(|x| x * l).collect(),
        v: data.v.iter().map(|v| v * l / t).collect(),
        f: data.f.iter().map(|f| f * m * l / (t * t)).collect(),
    };
    let there = elsewhere.fit(0.02 * l, true, Onset::Fitted).unwrap();
    let modulus = m / (l * t * t);
    assert_close(there.composite_modulus.value, here.composite_modulus.value * modulus, 1e-7, "E*");
    assert_close(there.plane_strain_modulus.high, here.plane_strain_modulus.high * modulus, 1e-7, "E1*");
    assert_close(there.dissipation.unwrap().low, here.dissipation.unwrap().low * t / l, 1e-6, "alpha");
    assert_close(there.onset_m.unwrap().value, here.onset_m.unwrap().value * l, 1e-6, "onset");
    assert_close(there.r_squared, here.r_squared, 1e-12, "R2");
    assert_close(there.largest_relative_indentation, here.largest_relative_indentation, 1e-9, "x hat");
}

/// Indentations, speeds and forces of a press in and out, by `law` and with Gaussian noise.
fn simulated_press(law: &HuntCrossley, onset: f64, noise: f64, random: &mut RandomNumbers) -> PressData {
    let mut data = PressData::default();
    for i in 0..80 {
        let phase = std::f64::consts::PI * f64::from(i) / 79.0;
        let x = 0.004 * phase.sin() - 0.0004;
        let v = 0.004 * phase.cos() * 40.0;
        data.x.push(x + onset);
        data.v.push(v);
        data.f.push(2.0 * law.force(x, v) + noise * random.normal());
    }
    data
}

/// Random numbers by SplitMix64 with the Box–Muller transform: the same on every machine.
struct RandomNumbers(u64);

impl RandomNumbers {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (a, b) = (1.0 - self.uniform(), self.uniform());
        (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    }
}

fn law_of_the_press() -> HuntCrossley {
    HuntCrossley::new(Hertz::sphere(3e5, 0.02).unwrap(), 0.8).unwrap()
}

#[test]
fn data_without_noise_give_the_true_parameters() {
    let data = simulated_press(&law_of_the_press(), 0.0013, 0.0, &mut RandomNumbers(1));
    for onset in [Onset::At(0.0013), Onset::Fitted] {
        let result = data.fit(0.02, true, onset).unwrap();
        assert_close(result.composite_modulus.value, 3e5, 1e-9, "E*");
        assert_close(result.dissipation.unwrap().value, 0.8, 1e-9, "alpha");
        if let Some(onset) = result.onset_m {
            assert_close(onset.value, 0.0013, 1e-9, "onset");
        }
        assert!(result.r_squared > 1.0 - 1e-12);
    }
}

#[test]
fn intervals_cover_the_true_parameters_in_95_of_100_runs() {
    const RUNS: u32 = 1000;
    let mut random = RandomNumbers(2026);
    for onset in [Onset::At(0.0013), Onset::Fitted] {
        let mut covered = [0_u32; 4];
        for _ in 0..RUNS {
            let result = simulated_press(&law_of_the_press(), 0.0013, 0.3, &mut random)
                .fit(0.02, true, onset)
                .unwrap();
            let holds = |estimate: Option<Estimate>, truth: f64| {
                u32::from(estimate.is_some_and(|e| e.low <= truth && truth <= e.high))
            };
            covered[0] += holds(Some(result.composite_modulus), 3e5);
            covered[1] += holds(Some(result.plane_strain_modulus), 3e5 * 2.0_f64.powf(1.5));
            covered[2] += holds(result.dissipation, 0.8);
            covered[3] += holds(result.onset_m, 0.0013);
        }
        for (i, covered) in covered.into_iter().enumerate().filter(|(i, _)| *i < 3 || onset == Onset::Fitted)
        {
            let share = f64::from(covered) / f64::from(RUNS);
            assert!((0.936..=0.964).contains(&share), "parameter {i}, {onset:?}: {share}");
        }
    }
}

#[test]
fn the_result_has_the_limits_of_the_laws() {
    let result = simulated_press(&law_of_the_press(), 0.0, 0.1, &mut RandomNumbers(7))
        .fit(0.02, true, Onset::At(0.0))
        .unwrap();
    assert_eq!(result.parameters, [Parameter::CompositeModulus, Parameter::Dissipation]);
    assert_close(result.largest_relative_indentation, 0.0036 / 0.02, 1e-3, "x hat");
    assert!(!result.within_hertz_limit);
    assert_close(result.largest_speed_m_s.unwrap(), 0.16, 0.02, "speed");
    assert_close(result.restitution.unwrap(), 1.0 - 0.8 * 0.16, 0.02, "restitution");
    assert_eq!(result.within_hunt_crossley_limit, Some(true));
    assert!(result.r_squared > 0.99);
    assert_eq!(result.residuals_n.len(), 80);
}

#[test]
fn rates_from_times_give_the_same_fit() {
    let data = simulated_press(&law_of_the_press(), 0.0, 0.0, &mut RandomNumbers(1));
    let times: Vec<f64> = (0..80).map(|i| std::f64::consts::PI * f64::from(i) / 79.0 / 40.0).collect();
    let measurement = Measurement { indentation_m: &data.x, force_n: &data.f, rate: Rate::Time(&times) };
    let values =
        FitValues { radius_m: 0.02, sphere_count: 2.0, onset: Onset::At(0.0), branch: FittedBranch::Both };
    let result = fit(&measurement, &values).unwrap();
    assert_close(result.composite_modulus.value, 3e5, 1e-4, "E*");
    assert_close(result.dissipation.unwrap().value, 0.8, 1e-3, "alpha");
}

#[test]
fn loading_and_unloading_are_fitted_apart() {
    let data = simulated_press(&law_of_the_press(), 0.0, 0.0, &mut RandomNumbers(1));
    let measurement = Measurement { indentation_m: &data.x, force_n: &data.f, rate: Rate::Unknown };
    let modulus = |branch| {
        let values = FitValues { radius_m: 0.02, sphere_count: 2.0, onset: Onset::At(0.0), branch };
        fit(&measurement, &values).unwrap().composite_modulus.value
    };
    assert!(modulus(FittedBranch::Loading) > modulus(FittedBranch::Both));
    assert!(modulus(FittedBranch::Both) > modulus(FittedBranch::Unloading));
}

#[test]
fn data_without_stiffness_are_refused() {
    let data = PressData { x: vec![0.001, 0.002, 0.003], v: vec![], f: vec![-1.0, -2.0, -3.0] };
    assert!(matches!(data.fit(0.02, false, Onset::At(0.0)), Err(FitError::NoStiffness { .. })));
    assert!(data.fit(0.02, false, Onset::Fitted).is_err());
    assert!(matches!(data.fit(0.02, false, Onset::At(0.1)), Err(FitError::TooFewPoints { .. })));
    assert!(matches!(data.fit(0.0, false, Onset::At(0.0)), Err(FitError::Domain(_))));
    let empty = PressData::default();
    assert!(matches!(empty.fit(0.02, false, Onset::Fitted), Err(FitError::TooFewPoints { .. })));
    assert!(matches!(empty.fit(0.02, true, Onset::At(0.0)), Err(FitError::TooFewPoints { .. })));
}

/// Data with F = 2 × 4/3 √R E* x^(3/2) (1 + 3/2 α v) plus `noise`, with E* = 4e5 N/m² and R = 0.02 m.
fn data_with_noise(
    indentations: &[f64],
    alpha: f64,
    speed: impl Fn(usize) -> f64,
    noise: impl Fn(usize) -> f64,
) -> PressData {
    let mut data = PressData::default();
    for (row, &x) in indentations.iter().enumerate() {
        let v = speed(row);
        data.x.push(x);
        data.v.push(v);
        let elastic = 2.0 * 4.0 / 3.0 * 0.02_f64.sqrt() * 4e5 * x.max(0.0).powf(1.5);
        data.f.push(elastic * (1.0 + 1.5 * alpha * v) + noise(row));
    }
    data
}

#[test]
fn measurements_of_one_indentation_are_refused() {
    // Every law passes through one point, also where it was measured ten times with an error.
    for noise in [0.0, 1.0] {
        let data = data_with_noise(&[0.003; 10], 0.0, |_| 0.0, |row| noise * (row % 3) as f64);
        for onset in [Onset::At(0.0), Onset::At(0.001), Onset::Fitted] {
            assert!(data.fit(0.02, false, onset).is_err(), "{onset:?}");
        }
        for onset in [Onset::At(0.0), Onset::Fitted] {
            let error = data.fit(0.02, false, onset).unwrap_err();
            assert_eq!(error, FitError::OneIndentation { indentation_m: 0.003 }, "{onset:?}");
        }
    }
    // As many rows as a fit of modulus, dissipation and onset needs, at different speeds.
    let data = data_with_noise(&[0.003; 4], 1.0, |row| row as f64 * 0.01, |_| 0.0);
    let error = data.fit(0.02, true, Onset::Fitted).unwrap_err();
    assert_eq!(error, FitError::OneIndentation { indentation_m: 0.003 });
    // Rows before contact do not help: they have no force by any law.
    let data = data_with_noise(&[-0.002, -0.001, 0.0, 0.003, 0.003, 0.003], 0.0, |_| 0.0, |_| 0.0);
    assert!(matches!(data.fit(0.02, false, Onset::At(0.0)), Err(FitError::OneIndentation { .. })));
}

#[test]
fn a_force_that_does_not_follow_the_indentation_has_no_fit() {
    let depths: Vec<f64> = (1..=12).map(|row| f64::from(row) * 1e-3).collect();
    // The force is equal everywhere: its variance is 0, so R squared is not a number.
    let constant = PressData { x: depths.clone(), v: vec![0.0; 12], f: vec![50.0; 12] };
    let error = constant.fit(0.02, false, Onset::At(0.0)).unwrap_err();
    assert!(
        matches!(error, FitError::NoLaw { .. }) && error.to_string().contains("(the force never changes)"),
        "{error}"
    );
    // High where the indentation is small: the mean is nearer to the data than the law.
    let falling: Vec<f64> = depths.iter().map(|x| 100.0 - 5e3 * x).collect();
    let falling = PressData { x: depths, v: vec![0.0; 12], f: falling };
    match falling.fit(0.02, false, Onset::At(0.0)) {
        Err(FitError::NoLaw { r_squared }) => assert!(r_squared < 0.0),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_law_that_explains_little_is_doubted() {
    let depths: Vec<f64> = (1..=12).map(|row| f64::from(row) * 1e-3).collect();
    // An error as large as the largest force, with changing sign.
    let data = data_with_noise(&depths, 0.0, |_| 0.0, |row| if row % 2 == 0 { 200.0 } else { -200.0 });
    let fit = data.fit(0.02, false, Onset::At(0.0)).unwrap();
    assert!(fit.r_squared < 0.5 && fit.r_squared > 0.0, "{}", fit.r_squared);
    assert!(fit.doubts.contains(&Doubt::LowRSquared { r_squared: fit.r_squared }));
    let clear = data_with_noise(&depths, 0.0, |_| 0.0, |row| if row % 2 == 0 { 1.0 } else { -1.0 });
    assert_eq!(clear.fit(0.02, false, Onset::At(0.0)).unwrap().doubts, []);
}

#[test]
fn a_dissipation_that_the_error_hides_is_doubted() {
    let depths: Vec<f64> = (1..=20).map(|row| f64::from(row) * 5e-4).collect();
    let noise = |row: usize| [0.9, -1.1, 0.3, -0.4, 1.2, -0.9, 0.2][row % 7];
    // Speeds of 1 micrometre per second: the force changes by a millionth, the error is a newton.
    let slow = data_with_noise(&depths, 0.5, |row| 1e-6 * (row % 4) as f64, noise)
        .fit(0.02, true, Onset::At(0.0))
        .unwrap();
    let undetermined = Doubt::Undetermined { parameter: Parameter::Dissipation };
    assert_eq!(slow.doubts, [undetermined]);
    // At 0.1 to 0.3 m/s the same dissipation is plain.
    let fast = data_with_noise(&depths, 0.5, |row| 0.1 * (row % 4) as f64, noise)
        .fit(0.02, true, Onset::At(0.0))
        .unwrap();
    assert_eq!(fast.doubts, []);
}

#[test]
fn data_from_the_law_have_no_confidence_interval() {
    let depths: Vec<f64> = (1..=9).map(|row| f64::from(row) * 1e-3).collect();
    let fit = data_with_noise(&depths, 0.4, |row| 0.1 * (row % 3) as f64, |_| 0.0)
        .fit(0.02, true, Onset::At(0.0))
        .unwrap();
    assert_close(fit.composite_modulus.value, 4e5, 1e-12, "E*");
    assert_eq!(fit.doubts, [Doubt::NoResiduals]);
    for estimate in [fit.composite_modulus, fit.plane_strain_modulus, fit.dissipation.unwrap()] {
        assert!(estimate.low.is_nan() && estimate.high.is_nan() && estimate.standard_error.is_nan());
    }
}
