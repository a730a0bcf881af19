//! Tests of drop tests against another integrator, exact results, and each other (Fig. 4).

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use contact_scaling::drop_test::{DropReport, DropTest, DropValues, compare};
use contact_scaling::{
    Contact, ContactValues, Law, Ratios, Scale, SmoothingValues, Spheres, restitution, table1,
};

/// Largest allowed error of a series, divided by its range.
const SERIES_TOLERANCE: f64 = 1e-8;

/// The scale of the animal in row `animal` of Table 1.
fn scale_of_animal(animal: usize) -> Scale {
    table1::animals().nth(animal).unwrap().scale()
}

fn contact(plane_strain_modulus: f64, dissipation: f64, smooth: bool) -> Contact {
    let smoothing = smooth.then_some(SmoothingValues::OPENSIM_DEFAULT);
    Contact::new(ContactValues { plane_strain_modulus, dissipation, smoothing }).unwrap()
}

/// The contact of the human, scaled to an animal: E₁* by (10); α and smoothing are scaled only if `all` is true.
fn contact_of_animal(animal: usize, smooth: bool, all: bool) -> Contact {
    let ratios = Ratios::between(&scale_of_animal(0), &scale_of_animal(animal)).unwrap();
    let base = contact(1e6, 2.0, smooth);
    let scaled = base.scaled(&ratios);
    if all {
        return scaled;
    }
    let plane_strain_modulus = scaled.plane_strain_modulus();
    Contact::new(ContactValues { plane_strain_modulus, ..base.values() }).unwrap()
}

fn drop_of_animal(animal: usize, contact: &Contact) -> DropTest {
    DropTest::of(contact, &scale_of_animal(animal), 0.25, 2.0).unwrap()
}

fn reference_curve(name: &str) -> Vec<(f64, f64)> {
    let lines = include_str!("../data/drops.csv").lines().filter(|line| !line.starts_with('#'));
    let rows = lines.filter_map(|line| {
        let cells: Vec<_> = line.split(',').collect();
        (cells[0] == name).then(|| (cells[1].parse().unwrap(), cells[2].parse().unwrap_or(0.0)))
    });
    rows.collect()
}

#[track_caller]
fn assert_follows(name: &str, report: &DropReport) {
    let rows = reference_curve(name);
    assert_eq!(rows.len(), 40);
    let heights = || report.series.iter().map(|s| s.height_m);
    let range = heights().fold(f64::MIN, f64::max) - heights().fold(f64::MAX, f64::min);
    let mut worst = 0.0_f64;
    for (i, (time, x)) in rows.into_iter().enumerate() {
        let sample = report.series[(i + 1) * (report.series.len() - 1) / 40];
        assert!((sample.time_s - time).abs() < 1e-14);
        worst = worst.max((sample.height_m + x).abs() / range);
    }
    assert!(worst < SERIES_TOLERANCE, "{name}: {worst:e}");
}

#[test]
fn series_agree_with_another_integrator() {
    assert_follows("human", &drop_of_animal(0, &contact_of_animal(0, false, true)).run().unwrap());
    assert_follows("mouse", &drop_of_animal(2, &contact_of_animal(2, false, false)).run().unwrap());
    assert_follows("smooth human", &drop_of_animal(0, &contact_of_animal(0, true, true)).run().unwrap());
}

#[test]
fn every_animal_of_table_1_has_the_final_indentation_of_opensim() {
    for (animal, name) in table1::animals().map(|animal| animal.taxon()).enumerate() {
        for all in [true, false] {
            let report = drop_of_animal(animal, &contact_of_animal(animal, false, all)).run().unwrap();
            let x_hat = report.final_indentation_m / scale_of_animal(animal).radius_m();
            assert_eq!(format!("{x_hat:.3}"), "0.353", "{name}"); // Table 1
            let hertz = report.hertz_indentation_m / scale_of_animal(animal).radius_m();
            assert!((hertz - 0.3533).abs() < 5e-5, "{name}");
            assert_eq!(report.hertz_stiffness_n_m, report.equilibrium_stiffness_n_m);
            // None of these drops leaves the ground again.
            assert_eq!(report.first_contact.unwrap().end, None, "{name}");
        }
        // Real OpenSim 4.6, SmoothSphereHalfSpaceForce with Falisse's cf and bd, scaled: 0.3396 in all seven.
        let report = drop_of_animal(animal, &contact_of_animal(animal, true, true)).run().unwrap();
        let x_hat = report.final_indentation_m / scale_of_animal(animal).radius_m();
        assert!((x_hat - 0.3396).abs() < 5e-5, "{name}: {x_hat}");
        let own = report.equilibrium_indentation_m / scale_of_animal(animal).radius_m();
        assert!((x_hat - own).abs() < 1e-7, "{name}: {x_hat} {own}");
    }
}

#[test]
fn animals_with_scaled_contacts_have_the_same_dimensionless_fall() {
    for smooth in [false, true] {
        let human = drop_of_animal(0, &contact_of_animal(0, smooth, true));
        for (animal, name) in table1::animals().map(|animal| animal.taxon()).enumerate() {
            let difference =
                compare(&human, &drop_of_animal(animal, &contact_of_animal(animal, smooth, true))).unwrap();
            assert!(difference.height < 1e-6, "{name}: {difference:?}");
            assert!(difference.force < 1e-6, "{name}: {difference:?}");
        }
    }
}

#[test]
fn without_scaled_dissipation_the_mouse_is_underdamped() {
    // Fig. 4 A: at α = 2 the mouse oscillates about its rest long after the giraffe has settled.
    let (mouse, giraffe) = (
        drop_of_animal(2, &contact_of_animal(2, false, false)),
        drop_of_animal(6, &contact_of_animal(6, false, false)),
    );
    assert!(compare(&mouse, &giraffe).unwrap().force > 0.5);
    let (mouse, giraffe) = (mouse.run().unwrap(), giraffe.run().unwrap());
    assert!(mouse.peak_force_bw() > giraffe.peak_force_bw());
    let above = |report: &DropReport| {
        let signs: Vec<_> = report.series.iter().map(|s| s.force_n > report.body_weight_n).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    assert!(above(&mouse) > 4 * above(&giraffe), "{} {}", above(&mouse), above(&giraffe));
}

#[test]
fn a_bounce_without_dissipation_returns_its_energy() {
    let test = DropTest::of(&contact(1e8, 0.0, false), &scale_of_animal(0), 0.25, 2.0).unwrap();
    let report = test.run().unwrap();
    let first = report.first_contact.unwrap();
    let end = first.end.unwrap();
    let exact = |what: &str| reference_curve(&format!("bounce: {what}"))[0].0;
    let close = |value: f64, what: &str| {
        let off = (value / exact(what) - 1.0).abs();
        assert!(off < 1e-9, "{what}: {value}, expected {}, off by {off:e}", exact(what));
    };
    close(first.impact_speed_m_s, "speed");
    close(end.rebound_speed_m_s, "speed");
    close(end.contact_time_s, "contact time");
    close(report.peak_force_n, "peak force");
    assert_eq!((first.restitution_exact, first.restitution_approximate), (1.0, Some(1.0)));
    // And it bounces back to where it was let go.
    let top = report.series.iter().skip(300).map(|s| s.height_m).fold(f64::MIN, f64::max);
    assert!((top / 0.008 - 1.0).abs() < 1e-3, "{top}");
}

#[test]
fn integrated_impacts_have_the_exact_restitution() {
    // A very stiff contact makes gravity during the impact as small as one likes.
    for alpha_speed in [0.01, 0.1, 0.5, 0.792, 2.0] {
        let speed = (2.0 * 9.81_f64 * 0.25 * 0.032).sqrt();
        let impact = |stiffness: f64| {
            let contact = contact(stiffness, alpha_speed / speed, false);
            let values = DropValues {
                mass_kg: 62.0,
                gravity_m_s2: 9.81,
                height_m: 0.25 * 0.032,
                duration_s: 0.06,
                samples: 2,
            };
            let spheres = Spheres::new(Law::of(&contact, 0.032).unwrap(), 6.0).unwrap();
            let first = DropTest::new([spheres], values).unwrap().run().unwrap().first_contact.unwrap();
            (first.end.unwrap().rebound_speed_m_s / first.impact_speed_m_s, first.restitution_exact)
        };
        let exact = restitution::exact(alpha_speed / speed, speed).unwrap();
        let (c, reported) = impact(1e30);
        assert!((reported / exact - 1.0).abs() < 1e-12);
        assert!((c - exact).abs() < 1e-8, "α ẋ = {alpha_speed}: integrated {c}, exact {exact}");
    }
}

#[test]
fn spheres_of_one_law_are_one_entry() {
    let law = Law::of(&contact(1e6, 2.0, false), 0.032).unwrap();
    let values = DropTest::of(&contact(1e6, 2.0, false), &scale_of_animal(0), 0.25, 2.0).unwrap().values();
    let one = Spheres::new(law, 1.0).unwrap();
    let six = DropTest::new([one; 6], values).unwrap();
    assert_eq!(six.spheres().len(), 1);
    assert_eq!(six, drop_of_animal(0, &contact(1e6, 2.0, false)));
}

#[test]
fn spheres_of_different_radii_and_laws_share_the_load() {
    let hard = Law::of(&contact(2e6, 0.5, false), 0.02).unwrap();
    let soft = Law::of(&contact(1e6, 2.0, false), 0.032).unwrap();
    let smooth = Law::of(&contact(1e6, 2.0, true), 0.032).unwrap();
    let values =
        DropValues { mass_kg: 62.0, gravity_m_s2: 9.81, height_m: 0.008, duration_s: 3.0, samples: 101 };
    for laws in [[hard, soft], [hard, smooth]] {
        let spheres = laws.map(|law| Spheres::new(law, 3.0).unwrap());
        let report = DropTest::new(spheres, values).unwrap().run().unwrap();
        let last = report.series.last().unwrap();
        assert!((last.force_n / report.body_weight_n - 1.0).abs() < 1e-6);
        assert!((report.final_indentation_m / report.equilibrium_indentation_m - 1.0).abs() < 1e-6);
        assert!(
            (report.reference_radius_m.powi(2) - (0.02_f64.powi(2) + 0.032_f64.powi(2)) / 2.0).abs() < 1e-18
        );
    }
}

#[test]
fn force_and_acceleration_satisfy_the_equation_of_motion() {
    // M v = ∫ (M g − F) dt at every sample, by the trapezoidal rule; both laws, and both in one body.
    let hard = Law::of(&contact(2e6, 0.5, false), 0.02).unwrap();
    let soft = Law::of(&contact(2e5, 1.0, true), 0.05).unwrap();
    let values =
        DropValues { mass_kg: 62.0, gravity_m_s2: 9.81, height_m: 0.008, duration_s: 0.5, samples: 50_001 };
    for laws in [[hard, hard], [soft, soft], [hard, soft]] {
        let spheres = laws.map(|law| Spheres::new(law, 3.0).unwrap());
        let report = DropTest::new(spheres, values).unwrap().run().unwrap();
        let mut speed = 0.0;
        for pair in report.series.windows(2) {
            let force = 0.5 * (pair[0].force_n + pair[1].force_n);
            speed += (force / 62.0 - 9.81) * (pair[1].time_s - pair[0].time_s);
            assert!((speed - pair[1].speed_m_s).abs() < 1e-7, "{pair:?} {speed}");
        }
    }
}

#[test]
fn an_unscaled_smooth_mouse_never_touches_the_ground() {
    let report = drop_of_animal(2, &contact_of_animal(2, true, false)).run().unwrap();
    assert_eq!(report.first_contact, None);
    assert!(report.final_indentation_m < 0.0);
}

#[test]
fn drops_with_impossible_values_are_refused() {
    let good = drop_of_animal(0, &contact(1e6, 2.0, false)).values();
    let sphere = Spheres::new(Law::of(&contact(1e6, 2.0, false), 0.032).unwrap(), 6.0).unwrap();
    let refused = |values| DropTest::new([sphere], values).unwrap_err().to_string();
    assert_eq!(refused(DropValues { mass_kg: 0.0, ..good }), "mass is 0.0, expected a finite number above 0");
    assert!(refused(DropValues { gravity_m_s2: -9.81, ..good }).starts_with("gravity"));
    assert!(refused(DropValues { height_m: -0.1, ..good }).starts_with("height"));
    assert!(refused(DropValues { duration_s: f64::NAN, ..good }).starts_with("duration"));
    assert!(refused(DropValues { samples: 1, ..good }).starts_with("number of samples"));
    assert!(DropTest::new([], good).unwrap_err().to_string().starts_with("number of spheres"));
}

#[test]
fn a_start_on_the_ground_is_a_contact_from_the_start() {
    let test = DropTest::of(&contact(1e6, 2.0, false), &scale_of_animal(0), 0.0, 2.0).unwrap();
    let first = test.run().unwrap().first_contact.unwrap();
    assert_eq!((first.start_s, first.impact_speed_m_s), (0.0, 0.0));
}

/// The peak force may be anywhere within a step of the integrator, also before its first point; no sample of a fine series is
/// larger than the peak.
#[test]
fn no_sample_is_above_the_peak() {
    for (smooth, tenths) in [false, true].into_iter().flat_map(|smooth| (1..40).map(move |n| (smooth, n))) {
        let contact = contact(1e6, 0.1 * f64::from(tenths), smooth);
        let coarse = DropTest::of(&contact, &scale_of_animal(0), 1.0, 0.4).unwrap();
        let values = DropValues { samples: 20_001, ..coarse.values() };
        let report = DropTest::new(coarse.spheres().iter().copied(), values).unwrap().run().unwrap();
        let highest = report.series.iter().map(|sample| sample.force_n).fold(0.0, f64::max);
        let above = highest / report.peak_force_n - 1.0;
        assert!(above < 1e-9, "smooth {smooth}, alpha 0.1 x {tenths}: {above:e} above the peak");
        assert!(
            above > -1e-6,
            "smooth {smooth}, alpha 0.1 x {tenths}: the peak is {above:e} from any sample"
        );
    }
}
