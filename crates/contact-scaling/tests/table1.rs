//! Table 1 of the paper, every row and column, at the digits it prints.

#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use contact_scaling::{
    Contact, ContactValues, DimensionlessContact, Hertz, Ratios, Scale, ScaleValues, SharedLoad, design,
    stiffness,
};

/// A printed number, with the decimals it is printed to.
#[track_caller]
fn assert_prints(value: f64, printed: &str, what: &str) {
    let decimals = printed.split_once('.').map_or(0, |(_, d)| d.len());
    assert_eq!(format!("{value:.decimals$}"), printed, "{what} is {value}");
}

struct Row {
    what: String,
    scale: Scale,
    printed: Vec<&'static str>,
}

fn rows() -> Vec<Row> {
    let lines = include_str!("data/table1.csv").lines().skip(2);
    let row = |line: &'static str| {
        let printed: Vec<_> = line.split(',').collect();
        let number = |i: usize| printed[i].parse::<f64>().unwrap();
        let values = ScaleValues {
            mass_kg: number(1),
            sphere_count: number(2),
            radius_m: number(3),
            gravity_m_s2: 9.81,
        };
        let what = format!("{} of {} kg on {} spheres", printed[0], printed[1], printed[2]);
        Row { what, scale: Scale::new(values).unwrap(), printed }
    };
    lines.map(row).collect()
}

fn base() -> Contact {
    let values = ContactValues { plane_strain_modulus: 1e6, dissipation: 2.0, smoothing: None };
    Contact::new(values).unwrap()
}

#[test]
fn table_1_is_reproduced_in_every_column() {
    let rows = rows();
    assert_eq!(rows.len(), 7);
    let human = rows[0].scale;
    for Row { what, scale, printed } in &rows {
        let contact = base().scaled(&Ratios::between(&human, scale).unwrap());
        let load = SharedLoad::body_weights(scale, 1.0).unwrap();
        let law = Hertz::of(&contact, scale.radius_m()).unwrap();
        let x_hat =
            design::relative_indentation(contact.composite_modulus(), scale.radius_m(), &load).unwrap();
        let k = law.stiffness_at_relative_indentation(x_hat);

        // The paper's mouse comes from the rounded 0.354 MPa of its human: 0.0916, where 0.0915 is exact.
        let composite = if what.starts_with("mouse") {
            assert_prints(contact.composite_modulus() / 1e6, "0.0915", what);
            0.354 * contact.plane_strain_modulus() / 1e6
        } else {
            contact.composite_modulus() / 1e6
        };
        assert_prints(composite, printed[4], what);
        assert_prints(contact.plane_strain_modulus() / 1e6, printed[5], what);
        assert_prints(base().dissipation(), printed[6], what);
        assert_prints(contact.dissipation(), printed[7], what);
        assert_prints(x_hat, printed[8], what);
        assert_prints(k / 1e3, printed[9], what);

        let k_hat = stiffness::dimensionless(k, scale.radius_m(), &load).unwrap();
        assert!((k_hat - 4.2457).abs() < 1e-4, "{what}: {k_hat}"); // the paper prints 4.24, from rounded values
        assert!((stiffness::dimensionless_hertz(x_hat).unwrap() / k_hat - 1.0).abs() < 1e-14);
    }
}

#[test]
fn all_rows_are_one_dimensionless_contact() {
    let rows = rows();
    let first = DimensionlessContact::of(&base(), &rows[0].scale);
    for Row { what, scale, .. } in &rows {
        let contact = base().scaled(&Ratios::between(&rows[0].scale, scale).unwrap());
        let here = DimensionlessContact::of(&contact, scale);
        assert!(here.agrees_with(&first, 1e-14), "{what}");
        assert!((here.relative_indentation() - 0.3533).abs() < 5e-5, "{what}");
    }
}

#[test]
fn real_opensim_agrees() {
    // OpenSim 4.6, HuntCrossleyForce, integrator accuracy 1e-9: k in kN/m at rest, row by row.
    let opensim = ["13.450", "54.487", "0.218", "10.496", "26.240", "151.329", "206.515"];
    let rows = rows();
    for (Row { what, scale, .. }, printed) in rows.iter().zip(opensim) {
        let contact = base().scaled(&Ratios::between(&rows[0].scale, scale).unwrap());
        let x_hat = DimensionlessContact::of(&contact, scale).relative_indentation();
        let law = Hertz::of(&contact, scale.radius_m()).unwrap();
        let k = law.stiffness_at_relative_indentation(x_hat) / 1e3;
        let off = (k - printed.parse::<f64>().unwrap()).abs();
        assert!(off <= 1e-3, "{what}: {k}, OpenSim {printed}");
    }
}

#[test]
fn numbers_of_the_text() {
    // Section 4.2: about 0.4 m/s before the impact of the 62 kg human, c_r about 0.2.
    let speed = (2.0 * 9.81 * 0.25 * 0.032_f64).sqrt();
    assert_prints(speed, "0.4", "speed");
    assert_prints(contact_scaling::restitution::approximate(2.0, speed).unwrap(), "0.2", "restitution");
    // (B.5) of the 62 kg human is (B.4) with k of one sphere and the mass on it.
    let x_hat = DimensionlessContact::of(&base(), &rows()[0].scale).relative_indentation();
    let by_b5 = stiffness::equilibrium_frequency(x_hat, 0.032, 9.81).unwrap();
    let by_b4 = stiffness::natural_frequency(13_449.5, 62.0 / 6.0).unwrap();
    assert!((by_b5 / by_b4 - 1.0).abs() < 1e-5, "{by_b5} {by_b4}");
}
