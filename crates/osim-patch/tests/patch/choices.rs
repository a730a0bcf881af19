//! Tests of what a choice of properties, forces, radii and gravity leaves unchanged, with the model before and after the change.
//!
//! The foot of these tests weighs 1 kg and is rescaled to 64 kg. Lengths then grow by 64^{1/3} = 4, and the paper's rules
//! give E₁* × 4, α × 4^{-1/2} = 0.5, cf × 4² = 16, bd × 4^{-1} = 0.25, bv × 4^{-1/2} = 0.5: all expected texts are exact.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::given::{foot, given, given_fixture, smooth};
use osim_model::{Property, RadiusRule};

#[test]
fn with_the_radius_kept_only_the_modulus_follows_the_mass() {
    let full = |stiffness: &str| {
        smooth(&format!(
            "<stiffness>{stiffness}</stiffness>\n<dissipation>2</dissipation>\n<hertz_smoothing>300</hertz_smoothing>"
        ))
    };
    // E₁* × μ = 64.
    given(foot(&full("1000000"), "0.01"))
        .radius(RadiusRule::Keep)
        .rescaled_to(64.0)
        .produces(foot(&full("64000000"), "0.01"));
    given(foot(&full("1000000"), "0.01"))
        .changing_only(&[Property::Stiffness])
        .rescaled_to(64.0)
        .produces(foot(&full("64000000"), "0.01"));
}

#[test]
fn a_kept_property_stays_and_the_others_follow_the_new_radius() {
    let text = |stiffness: &str, smoothing: &str| {
        smooth(&format!(
            "<stiffness>{stiffness}</stiffness>\n<dissipation>2</dissipation>\n<constant_contact_force>0</constant_contact_force>\n\
             <hertz_smoothing>300</hertz_smoothing>\n<hunt_crossley_smoothing>{smoothing}</hunt_crossley_smoothing>"
        ))
    };
    given(foot(&text("1000000", "50"), "0.01"))
        .leaving(&[Property::Dissipation, Property::HertzSmoothing])
        .rescaled_to(64.0)
        .produces(foot(&text("4000000", "25"), "0.04"));
}

#[test]
fn a_radius_given_in_metres_is_written_exactly_and_gives_the_ratios() {
    let outcome =
        given(foot(&smooth("<stiffness>1000000</stiffness>\n<dissipation>2</dissipation>"), "0.01"))
            .radius(RadiusRule::Metres(0.16))
            .rescaled_to(64.0);
    // ρ = 16: E₁* × 64/256, α × 1/4, cf × 256, bd / 16, bv / 4.
    outcome
        .sets(Property::Radius, 1, 0.16)
        .sets(Property::Stiffness, 1, 250_000.0)
        .sets(Property::Dissipation, 1, 0.5)
        .sets(Property::ConstantContactForce, 1, 2.56e-3)
        .sets(Property::HertzSmoothing, 1, 18.75)
        .sets(Property::HuntCrossleySmoothing, 1, 12.5);
    given(foot(&smooth("<stiffness>1000000</stiffness>"), "0.01"))
        .radius(RadiusRule::Factor(2.0))
        .rescaled_to(64.0)
        .sets(Property::Radius, 1, 0.02)
        .sets(Property::Stiffness, 1, 16e6);
}

#[test]
fn dissipation_can_follow_the_mass_instead() {
    // α × 64^{-1/6} = 1/2, also where radii stay, and bv, so that their ratio stays.
    let force = |stiffness: &str, dissipation: &str, smoothing: &str| {
        smooth(&format!(
            "<stiffness>{stiffness}</stiffness>\n<dissipation>{dissipation}</dissipation>\n\
             <hunt_crossley_smoothing>{smoothing}</hunt_crossley_smoothing>"
        ))
    };
    given(foot(&force("1000000", "2", "50"), "0.01"))
        .radius(RadiusRule::Keep)
        .dissipation_by_mass()
        .rescaled_to(64.0)
        .produces(foot(&force("64000000", "1", "25"), "0.01"));
}

#[test]
fn friction_is_scaled_only_on_request() {
    let text = |stiffness: &str, dissipation: &str, viscous: &str, velocity: &str| {
        smooth(&format!(
            "<stiffness>{stiffness}</stiffness>\n<dissipation>{dissipation}</dissipation>\n\
             <static_friction>0.8</static_friction>\n<viscous_friction>{viscous}</viscous_friction>\n\
             <transition_velocity>{velocity}</transition_velocity>\n\
             <constant_contact_force>0</constant_contact_force>\n<hertz_smoothing>1</hertz_smoothing>\n\
             <hunt_crossley_smoothing>1</hunt_crossley_smoothing>"
        ))
    };
    let before = foot(&text("1000000", "2", "0.5", "0.25"), "0.01");
    let smoothing = |model: String| {
        model
            .replace("<hertz_smoothing>1<", "<hertz_smoothing>0.25<")
            .replace("<hunt_crossley_smoothing>1<", "<hunt_crossley_smoothing>0.5<")
    };
    // A speed grows by √ρ = 2, an inverse speed by 1/2.
    given(before.clone())
        .with_friction()
        .rescaled_to(64.0)
        .produces(smoothing(foot(&text("4000000", "1", "0.25", "0.5"), "0.04")))
        .has_finding("friction-not-similar");
    given(before).rescaled_to(64.0).produces(smoothing(foot(&text("4000000", "1", "0.5", "0.25"), "0.04")));
}

#[test]
fn contacts_are_scaled_to_gravity_only_with_a_target() {
    // OpenSim's default gravity, 9.80665; γ = 4: E₁* × 4 · 4, α and bv × 4^{-1/2} · 4^{-1/2}.
    given(foot(&smooth("<stiffness>1000000</stiffness>\n<dissipation>2</dissipation>"), "0.01"))
        .at_gravity(4.0 * 9.80665)
        .rescaled_to(64.0)
        .sets(Property::Stiffness, 1, 16e6)
        .sets(Property::Dissipation, 1, 0.5)
        .sets(Property::HuntCrossleySmoothing, 1, 12.5)
        .sets(Property::HertzSmoothing, 1, 75.0)
        .sets(Property::ConstantContactForce, 1, 1.6e-4)
        .sets(Property::Radius, 1, 0.04);
}

#[test]
fn a_sphere_that_two_forces_share_is_resized_once() {
    let outcome = given_fixture("format/shared_sphere.osim").rescaled_to(8.0 * 61.5);
    outcome.sets(Property::Radius, 1, 0.065);
    let stiffness: Vec<f64> =
        outcome.changes_of(Property::Stiffness).iter().map(|change| change.to).collect();
    assert_eq!(stiffness, [2_469_135.6, 4e6]);
    let outcome = given_fixture("format/shared_by_materials.osim").rescaled_to(8.0 * 61.5);
    outcome.sets(Property::Radius, 1, 0.065);
}

#[test]
fn a_sphere_that_an_unselected_force_uses_is_refused_with_advice() {
    for file in ["format/shared_sphere.osim", "format/shared_sphere_two_classes.osim"] {
        let fault = given_fixture(file).selecting("contact_1").rescaled_to(500.0);
        let fault = fault
            .is_refused("shared-sphere", &["heel_r", "contact_1", "contact_2", "`select`", "`radius` keep"]);
        assert!(fault.offset.is_some());
    }
    // Choosing it does not help where it is excluded as well.
    given_fixture("format/shared_sphere.osim")
        .excluding("contact_1")
        .rescaled_to(500.0)
        .is_refused("shared-sphere", &["contact_1, which stays as it is", "excluding none of these"]);
    // 2 × 1234567.8 for twice the mass at the same radius; the other force stays.
    given_fixture("format/shared_sphere.osim")
        .selecting("contact_1")
        .radius(RadiusRule::Keep)
        .rescaled_to(123.0)
        .changes_only(&[("<stiffness>1234567.8</stiffness>", "<stiffness>2469135.6</stiffness>")]);
}

#[test]
fn a_sphere_that_a_mesh_force_uses_too_is_refused() {
    let mesh = "<ElasticFoundationForce name=\"mesh\"><ElasticFoundationForce::ContactParametersSet name=\"contact_parameters\">\
        <objects><ElasticFoundationForce::ContactParameters><geometry>floor heel_r</geometry>\
        </ElasticFoundationForce::ContactParameters></objects></ElasticFoundationForce::ContactParametersSet>\
        </ElasticFoundationForce>";
    let model = foot(&(smooth("<stiffness>1e6</stiffness>") + mesh), "0.01");
    given(model).rescaled_to(64.0).is_refused("shared-sphere", &["mesh", "`radius` keep"]);
}

#[test]
fn a_selection_leaves_the_other_forces_and_their_spheres_alone() {
    // 53 kg → 8 × 53 kg: R × 2, E₁* × 2, α × 2^{-1/2}; the left side keeps every byte.
    given_fixture("format/v30000_two_feet.osim").selecting("*_r").rescaled_to(8.0 * 53.0).changes_only(&[
        ("<stiffness>1234567.8</stiffness>", "<stiffness>2469135.6</stiffness>"),
        ("<dissipation>2.25</dissipation>", "<dissipation>1.590990257669732</dissipation>"),
        ("<radius>0.0325</radius>", "<radius>0.065</radius>"),
        ("<radius>0.0325</radius>", "<radius>0.065</radius>"),
    ]);
    given_fixture("format/v30000_two_feet.osim")
        .selecting("nothing_*")
        .rescaled_to(100.0)
        .is_refused("refused", &["contact_r", "contact_l", "`select`"]);
}

#[test]
fn mixed_radii_use_the_mean_square_before_and_after() {
    let mixed = || given_fixture("format/mixed_radii.osim");
    // Isometric: all radii × 2, so E₁* × 2 as ever.
    let outcome = mixed().rescaled_to(8.0 * 53.0);
    outcome.sets(Property::Stiffness, 2, 2_469_135.6).has_finding("mixed-radii");
    let radii: Vec<f64> = outcome.changes_of(Property::Radius).iter().map(|change| change.to).collect();
    assert_eq!(radii, [0.1, 0.05, 0.1, 0.05]);
    // All become 0.05 m: mean R² was (0.05² + 0.025²)/2 = 0.0015625 and is 0.0025, so ρ² = 1.6.
    // E₁* × 8/1.6 = 5; α × 1.6^{-1/4} = 0.889139705..., Python 3 decimal, 40 digits: 2.25 × 0.88913970501946140...
    let outcome = mixed().radius(RadiusRule::Metres(0.05)).rescaled_to(8.0 * 53.0);
    outcome.sets(Property::Stiffness, 2, 6_172_839.0);
    outcome.sets(Property::Dissipation, 2, 2.000_564_336_293_788);
    outcome.sets(Property::Radius, 2, 0.05);
    // Twice the radius of each.
    mixed().radius(RadiusRule::Factor(2.0)).rescaled_to(8.0 * 53.0).sets(Property::Stiffness, 2, 2_469_135.6);
}

#[test]
fn spheres_of_terrain_are_never_resized() {
    for file in ["format/terrain_on_ground.osim", "format/terrain_welded.osim"] {
        let outcome = given_fixture(file).standing_for(53.0).rescaled_to(8.0 * 53.0);
        outcome.sets(Property::Radius, 4, 0.065).sets(Property::Stiffness, 2, 2_469_135.6);
        assert!(outcome.changes_of(Property::Radius).iter().all(|change| !change.path.contains("rock")));
    }
}

#[test]
fn spheres_that_no_ground_contact_uses_stay() {
    given_fixture("format/sphere_unused.osim")
        .changing_only(&[Property::Radius])
        .rescaled_to(8.0 * 61.5)
        .changes_only(&[("<radius>0.0325</radius>", "<radius>0.065</radius>")]);
    // Two spheres that knock against each other are not a ground contact, but they are the feet's spheres.
    given_fixture("format/sphere_on_sphere.osim").rescaled_to(500.0).is_refused("shared-sphere", &["knock"]);
    given_fixture("format/sphere_on_sphere_only.osim").rescaled_to(500.0).is_refused("no-contacts", &[]);
}

#[test]
fn forces_that_are_switched_off_are_scaled_too() {
    let outcome = given_fixture("format/v30000_disabled.osim").rescaled_to(8.0 * 53.0);
    assert_eq!(outcome.changes_of(Property::Stiffness).len(), 2);
    outcome.has_finding("disabled-force");
    let outcome = given_fixture("format/all_disabled.osim").rescaled_to(8.0 * 61.5);
    outcome.sets(Property::Stiffness, 1, 2_469_135.6).sets(Property::Radius, 1, 0.065);
}
