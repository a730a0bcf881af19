//! Tests of Table 1 of the paper, every row and column, to the printed digits.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use contact_scaling::table1::{self, Animal, Column, ComparedNumber};
use contact_scaling::{
    Contact, ContactValues, DimensionlessContact, Hertz, Ratios, SharedLoad, design, stiffness,
};

/// Asserts that `value`, rounded to the decimals of `printed`, is the printed number.
#[track_caller]
fn assert_prints(value: f64, printed: &str, what: &str) {
    let decimals = printed.split_once('.').map_or(0, |(_, d)| d.len());
    assert_eq!(format!("{value:.decimals$}"), printed, "{what} is {value}");
}

fn animals_of_table() -> Vec<Animal> {
    table1::animals().collect()
}

fn label_of_animal(animal: &Animal) -> String {
    format!("{} of {} kg", animal.taxon(), animal.scale().mass_kg())
}

/// The contact from which all rows are scaled: E₁* = 1 MPa exactly, α = 2 s/m.
fn base_contact() -> Contact {
    let values = ContactValues { plane_strain_modulus: 1e6, dissipation: 2.0, smoothing: None };
    Contact::new(values).unwrap()
}

#[test]
fn every_line_of_the_file_is_a_row_of_the_table() {
    // The paper has seven, and nine numbers in each.
    assert_eq!(animals_of_table().len(), 7);
    for animal in animals_of_table() {
        for column in Column::ALL {
            assert!(
                animal.printed(column).parse::<f64>().is_ok(),
                "{}: {column:?}",
                label_of_animal(&animal)
            );
        }
    }
}

#[test]
fn table_1_is_reproduced_in_every_column() {
    let rows = animals_of_table();
    let human = rows[0].scale();
    for animal in &rows {
        let (what, scale) = (label_of_animal(animal), animal.scale());
        let contact = base_contact().scaled(&Ratios::between(&human, &scale).unwrap());
        let load = SharedLoad::body_weights(&scale, 1.0).unwrap();
        let law = Hertz::of(&contact, scale.radius_m()).unwrap();
        let x_hat =
            design::relative_indentation(contact.composite_modulus(), scale.radius_m(), &load).unwrap();
        let k = law.stiffness_at_relative_indentation(x_hat);

        // The paper's mouse comes from the rounded 0.354 MPa of its human: 0.0916, where 0.0915 is exact.
        let composite = if animal.taxon() == "mouse" {
            assert_prints(contact.composite_modulus() / 1e6, "0.0915", &what);
            0.354 * contact.plane_strain_modulus() / 1e6
        } else {
            contact.composite_modulus() / 1e6
        };
        assert_prints(composite, animal.printed(Column::CompositeModulus), &what);
        let modulus = contact.plane_strain_modulus() / 1e6;
        assert_prints(modulus, animal.printed(Column::PlaneStrainModulus), &what);
        assert_prints(base_contact().dissipation(), animal.printed(Column::BaseDissipation), &what);
        assert_prints(contact.dissipation(), animal.printed(Column::ScaledDissipation), &what);
        assert_prints(x_hat, animal.printed(Column::FinalIndentation), &what);
        assert_prints(k / 1e3, animal.printed(Column::ContactStiffness), &what);

        let k_hat = stiffness::dimensionless(k, scale.radius_m(), &load).unwrap();
        assert!((k_hat - 4.2457).abs() < 1e-4, "{what}: {k_hat}"); // the paper prints 4.24, from rounded values
        assert!((stiffness::dimensionless_hertz(x_hat).unwrap() / k_hat - 1.0).abs() < 1e-14);
    }
}

#[test]
fn only_one_number_of_the_table_differs_and_it_follows_from_a_rounded_one() {
    let all: Vec<(Animal, ComparedNumber)> = animals_of_table()
        .into_iter()
        .flat_map(|animal| animal.compared().unwrap().into_iter().map(move |compared| (animal, compared)))
        .collect();
    assert_eq!(all.len(), 7 * Column::ALL.len());
    for (animal, compared) in &all {
        let decimals = compared.printed.split_once('.').map_or(0, |(_, d)| d.len());
        // An own count of the last digit: the difference in units of it, by the decimals that are printed.
        let units =
            (compared.computed - compared.printed.parse::<f64>().unwrap()) * 10_f64.powi(decimals as i32);
        let is_mouse = animal.taxon() == "mouse" && compared.column == Column::CompositeModulus;
        assert_eq!(compared.is_within_last_digit(), !is_mouse, "{}: {compared:?}", label_of_animal(animal));
        assert_eq!(compared.is_from_rounded(), is_mouse, "{}: {compared:?}", label_of_animal(animal));
        assert_eq!(units.abs() <= 0.5 + 1e-9, !is_mouse, "{}: {compared:?}", label_of_animal(animal));
    }
}

#[test]
fn all_rows_have_the_same_dimensionless_contact() {
    let rows = animals_of_table();
    let first = DimensionlessContact::of(&base_contact(), &rows[0].scale());
    for animal in &rows {
        let contact = base_contact().scaled(&Ratios::between(&rows[0].scale(), &animal.scale()).unwrap());
        let here = DimensionlessContact::of(&contact, &animal.scale());
        assert!(here.agrees_with(&first, 1e-14), "{}", label_of_animal(animal));
        assert!((here.relative_indentation() - 0.3533).abs() < 5e-5, "{}", label_of_animal(animal));
    }
}

#[test]
fn table_1_agrees_with_forces_of_opensim() {
    // OpenSim 4.6, HuntCrossleyForce, integrator accuracy 1e-9: k in kN/m at rest, row by row.
    let opensim = [13.450, 54.487, 0.218, 10.496, 26.240, 151.329, 206.515];
    for (animal, k) in animals_of_table().iter().zip(opensim) {
        let compared = animal.compared().unwrap();
        let own = compared.iter().find(|one| one.column == Column::ContactStiffness).unwrap().computed;
        assert!((own - k).abs() <= 1e-3, "{}: {own}, OpenSim {k}", label_of_animal(animal));
    }
}

#[test]
fn numbers_in_the_text_of_the_paper_are_reproduced() {
    // Section 4.2: about 0.4 m/s before the impact of the 62 kg human, c_r about 0.2.
    let speed = (2.0 * 9.81 * 0.25 * 0.032_f64).sqrt();
    assert_prints(speed, "0.4", "speed");
    assert_prints(contact_scaling::restitution::approximate(2.0, speed).unwrap(), "0.2", "restitution");
    // (B.5) of the 62 kg human is (B.4) with k of one sphere and the mass on it.
    let x_hat =
        DimensionlessContact::of(&base_contact(), &animals_of_table()[0].scale()).relative_indentation();
    let by_b5 = stiffness::equilibrium_frequency(x_hat, 0.032, 9.81).unwrap();
    let by_b4 = stiffness::natural_frequency(13_449.5, 62.0 / 6.0).unwrap();
    assert!((by_b5 / by_b4 - 1.0).abs() < 1e-5, "{by_b5} {by_b4}");
}
