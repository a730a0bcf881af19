//! What is written: models in, models out, both in view.
//!
//! The foot of these tests weighs 1 kg and is rescaled to 64 kg. Lengths then grow by 64^{1/3} = 4, and the paper's rules
//! give E₁* × 4, α × 4^{-1/2} = 0.5, cf × 4² = 16, bd × 4^{-1} = 0.25, bv × 4^{-1/2} = 0.5: all expected texts are exact.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

mod given;

use given::{fixture, foot, given, given_fixture, hunt_crossley, smooth};
use osim_patch::{Property, RadiusRule};

/// A foot with a smooth force, 1 kg → 64 kg, isometric.
#[track_caller]
fn smooth_foot_becomes(before: &str, after: &str) {
    given(foot(&smooth(before), "0.01")).rescaled_to(64.0).produces(foot(&smooth(after), "0.04"));
}

#[test]
fn every_number_of_a_smooth_force_follows_its_rule() {
    smooth_foot_becomes(
        "<stiffness>1000000</stiffness>
        <dissipation>2</dissipation>
        <static_friction>0.8</static_friction>
        <dynamic_friction>0.7</dynamic_friction>
        <viscous_friction>0.5</viscous_friction>
        <transition_velocity>0.2</transition_velocity>
        <constant_contact_force>0.00001</constant_contact_force>
        <hertz_smoothing>300</hertz_smoothing>
        <hunt_crossley_smoothing>50</hunt_crossley_smoothing>",
        "<stiffness>4000000</stiffness>
        <dissipation>1</dissipation>
        <static_friction>0.8</static_friction>
        <dynamic_friction>0.7</dynamic_friction>
        <viscous_friction>0.5</viscous_friction>
        <transition_velocity>0.2</transition_velocity>
        <constant_contact_force>0.00016</constant_contact_force>
        <hertz_smoothing>75</hertz_smoothing>
        <hunt_crossley_smoothing>25</hunt_crossley_smoothing>",
    );
}

#[test]
fn absent_elements_are_inserted_in_opensims_order_with_their_siblings_indentation() {
    // Class defaults: α 0 stays 0, cf 1e-5, bd 300, bv 50.
    smooth_foot_becomes(
        "<stiffness>1000000</stiffness>
        <static_friction>0.8</static_friction>
        <hertz_smoothing>400</hertz_smoothing>
        <force_visualization_radius>0.01</force_visualization_radius>",
        "<stiffness>4000000</stiffness>
        <static_friction>0.8</static_friction>
        <constant_contact_force>0.00016</constant_contact_force>
        <hertz_smoothing>100</hertz_smoothing>
        <hunt_crossley_smoothing>25</hunt_crossley_smoothing>
        <force_visualization_radius>0.01</force_visualization_radius>",
    );
}

#[test]
fn what_surrounds_a_number_stays() {
    let rest = "<constant_contact_force>0</constant_contact_force>
        <hertz_smoothing>100</hertz_smoothing>
        <hunt_crossley_smoothing>2</hunt_crossley_smoothing>";
    let rest_after = "<constant_contact_force>0</constant_contact_force>
        <hertz_smoothing>25</hertz_smoothing>
        <hunt_crossley_smoothing>1</hunt_crossley_smoothing>";
    for (before, after) in [
        ("<stiffness>  1e6\t</stiffness>", "<stiffness>  4000000\t</stiffness>"),
        ("<stiffness>1000000.0000</stiffness>", "<stiffness>4000000</stiffness>"),
        ("<stiffness>+1.0E+06</stiffness>", "<stiffness>4000000</stiffness>"),
        ("<stiffness>&#49;e6</stiffness>", "<stiffness>4000000</stiffness>"),
        ("<stiffness>1&#x65;6</stiffness>", "<stiffness>4000000</stiffness>"),
        (
            "<stiffness><!--Pa-->1e6<!-- was 2e6 --></stiffness>",
            "<stiffness><!--Pa-->4000000<!-- was 2e6 --></stiffness>",
        ),
        ("<stiffness unit='Pa' >1e6</stiffness>", "<stiffness unit='Pa' >4000000</stiffness>"),
        (
            "<stiffness>1e6</stiffness><stiffness>9</stiffness>",
            "<stiffness>4000000</stiffness><stiffness>9</stiffness>",
        ),
        (
            "<Stiffness>9</Stiffness><stiffness>1e6</stiffness>",
            "<Stiffness>9</Stiffness><stiffness>4000000</stiffness>",
        ),
        (
            "<old><stiffness>9</stiffness></old><stiffness>1e6</stiffness>",
            "<old><stiffness>9</stiffness></old><stiffness>4000000</stiffness>",
        ),
        (
            "<!--<stiffness>9</stiffness>--><stiffness>1e6</stiffness>",
            "<!--<stiffness>9</stiffness>--><stiffness>4000000</stiffness>",
        ),
    ] {
        smooth_foot_becomes(&format!("{before}\n{rest}"), &format!("{after}\n{rest_after}"));
    }
}

#[test]
fn a_number_in_cdata_reads_as_the_new_number_afterwards() {
    let given = given_fixture("format/number_cdata.osim");
    let outcome = given.rescaled_to(8.0 * 61.5);
    // 3e6 × 2; OpenSim reads plain text and CDATA alike.
    outcome.sets(Property::Stiffness, 1, 6e6);
    let text = String::from_utf8(outcome.bytes().to_vec()).unwrap();
    assert!(
        text.contains("<stiffness>6000000</stiffness>")
            || text.contains("<stiffness><![CDATA[6000000]]></stiffness>"),
        "{text}"
    );
}

#[test]
fn an_unchanged_number_keeps_its_spelling() {
    given(foot(
        &smooth(
            "<stiffness>1e6</stiffness>
            <dissipation>0.0</dissipation>
            <static_friction>0.80000000000000004</static_friction>
            <transition_velocity> 2.e-1 </transition_velocity>
            <constant_contact_force>0e0</constant_contact_force>
            <hertz_smoothing>4e2</hertz_smoothing>
            <hunt_crossley_smoothing>4E1</hunt_crossley_smoothing>",
        ),
        "1e-2",
    ))
    .rescaled_to(64.0)
    .changes_only(&[
        ("<stiffness>1e6</stiffness>", "<stiffness>4000000</stiffness>"),
        ("<hertz_smoothing>4e2</hertz_smoothing>", "<hertz_smoothing>100</hertz_smoothing>"),
        (
            "<hunt_crossley_smoothing>4E1</hunt_crossley_smoothing>",
            "<hunt_crossley_smoothing>20</hunt_crossley_smoothing>",
        ),
        ("<radius>1e-2</radius>", "<radius>0.04</radius>"),
    ]);
}

#[test]
fn a_hunt_crossley_force_has_modulus_and_dissipation_only() {
    let before = hunt_crossley(&[
        "<geometry>floor heel_r</geometry><stiffness>1e6</stiffness><dissipation>2</dissipation>\
         <static_friction>0.8</static_friction>",
    ]);
    let after = hunt_crossley(&[
        "<geometry>floor heel_r</geometry><stiffness>4000000</stiffness><dissipation>1</dissipation>\
         <static_friction>0.8</static_friction>",
    ]);
    given(foot(&before, "0.01")).rescaled_to(64.0).produces(foot(&after, "0.04"));
}

#[test]
fn all_materials_of_a_force_get_the_same_factor() {
    let set = |geometry, stiffness, dissipation| {
        format!(
            "<geometry>{geometry}</geometry><stiffness>{stiffness}</stiffness><dissipation>{dissipation}</dissipation>"
        )
    };
    let before = hunt_crossley(&[&set("floor", "5e6", "0"), &set("heel_r", "1e6", "3")]);
    let after = hunt_crossley(&[&set("floor", "20000000", "0"), &set("heel_r", "4000000", "1.5")]);
    given(foot(&before, "0.01"))
        .rescaled_to(64.0)
        .produces(foot(&after, "0.04"))
        .warns("several-parameter-sets");
}

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
        .only(&[Property::Stiffness])
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
        .keeping(&[Property::Dissipation, Property::HertzSmoothing])
        .rescaled_to(64.0)
        .produces(foot(&text("4000000", "25"), "0.04"));
}

#[test]
fn a_radius_in_metres_is_written_as_said_and_the_ratios_use_it() {
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
    // α × 64^{-1/6} = 1/2, also where radii stay.
    let force = |stiffness: &str, dissipation: &str| {
        smooth(&format!("<stiffness>{stiffness}</stiffness>\n<dissipation>{dissipation}</dissipation>"))
    };
    given(foot(&force("1000000", "2"), "0.01"))
        .radius(RadiusRule::Keep)
        .dissipation_by_mass()
        .rescaled_to(64.0)
        .produces(foot(&force("64000000", "1"), "0.01"));
}

#[test]
fn friction_follows_only_where_it_is_asked_for() {
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
        .warns("friction-not-similar");
    given(before).rescaled_to(64.0).produces(smoothing(foot(&text("4000000", "1", "0.5", "0.25"), "0.04")));
}

#[test]
fn gravity_scales_only_where_a_target_is_given() {
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
fn a_sphere_that_another_force_needs_as_it_is_is_refused_with_ways_out() {
    for file in ["format/shared_sphere.osim", "format/shared_sphere_two_classes.osim"] {
        let fault = given_fixture(file).selecting("contact_1").rescaled_to(500.0);
        let fault = fault
            .is_refused("shared-sphere", &["heel_r", "contact_1", "contact_2", "--select", "--radius keep"]);
        assert!(fault.offset.is_some());
    }
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
    given(model).rescaled_to(64.0).is_refused("shared-sphere", &["mesh", "--radius keep"]);
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
        .is_refused("refused", &["contact_r", "contact_l", "--select"]);
}

#[test]
fn mixed_radii_use_the_mean_square_before_and_after() {
    let mixed = || given_fixture("format/mixed_radii.osim");
    // Isometric: all radii × 2, so E₁* × 2 as ever.
    let outcome = mixed().rescaled_to(8.0 * 53.0);
    outcome.sets(Property::Stiffness, 2, 2_469_135.6).warns("mixed-radii");
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
fn terrain_is_never_resized() {
    for file in ["format/terrain_on_ground.osim", "format/terrain_welded.osim"] {
        let outcome = given_fixture(file).standing_for(53.0).rescaled_to(8.0 * 53.0);
        outcome.sets(Property::Radius, 4, 0.065).sets(Property::Stiffness, 2, 2_469_135.6).warns("terrain");
        assert!(outcome.changes_of(Property::Radius).iter().all(|change| !change.path.contains("rock")));
    }
}

#[test]
fn spheres_that_no_ground_contact_uses_stay() {
    given_fixture("format/sphere_unused.osim")
        .only(&[Property::Radius])
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
    outcome.warns("disabled-force");
    let outcome = given_fixture("format/all_disabled.osim").rescaled_to(8.0 * 61.5);
    outcome.sets(Property::Stiffness, 1, 2_469_135.6).sets(Property::Radius, 1, 0.065);
}

#[test]
fn the_moco_dialect_is_rescaled_in_its_own_form() {
    // 61.5 kg → 492 kg: lengths × 2; last digits from Python 3 decimal, 60 digits.
    given_fixture("format/moco_sphere_in_force.osim").rescaled_to(492.0).changes_only(&[
        (
            "<contact_sphere_radius>0.0325</contact_sphere_radius>",
            "<contact_sphere_radius>0.065</contact_sphere_radius>",
        ),
        ("<stiffness>1234567.8</stiffness>", "<stiffness>2469135.6</stiffness>"),
        ("<dissipation>2.25</dissipation>", "<dissipation>1.590990257669732</dissipation>"),
        (
            "<constant_contact_force>1.5e-05</constant_contact_force>",
            "<constant_contact_force>0.00006</constant_contact_force>",
        ),
        ("<hertz_smoothing>310</hertz_smoothing>", "<hertz_smoothing>155</hertz_smoothing>"),
        (
            "<hunt_crossley_smoothing>52</hunt_crossley_smoothing>",
            "<hunt_crossley_smoothing>36.76955262170047</hunt_crossley_smoothing>",
        ),
    ]);
    given_fixture("format/moco_sphere_in_force.osim")
        .read(|model| {
            assert!(model.warnings.iter().any(|warning| warning.code.as_str() == "moco-dialect"));
            Ok(())
        })
        .unwrap();
}

#[test]
fn defaults_are_read_but_never_edited() {
    let outcome = given_fixture("format/defaults_smooth.osim").rescaled_to(492.0);
    // bd 111 from <defaults>, halved, becomes the force's own element; its dissipation is its own 2.25.
    outcome.sets(Property::HertzSmoothing, 1, 55.5);
    let (before, after) = (outcome.before.clone(), outcome.bytes().to_vec());
    let defaults = |bytes: &[u8]| {
        let text = String::from_utf8(bytes.to_vec()).unwrap();
        text.split("</defaults>").next().unwrap().to_owned()
    };
    assert_eq!(defaults(&before), defaults(&after));
    assert!(
        String::from_utf8(after).unwrap().contains("\n\t\t\t\t\t<hertz_smoothing>55.5</hertz_smoothing>\n")
    );
}

#[test]
fn a_number_that_something_interrupts_is_refused() {
    for file in ["comment_inside", "half_cdata", "element_inside"] {
        given_fixture(&format!("bad/number_{file}.osim"))
            .rescaled_to(492.0)
            .is_refused("not-a-number", &["stiffness"]);
    }
}

#[test]
fn materials_that_only_defaults_hold_are_read_but_not_changed() {
    given_fixture("format/defaults_hunt_crossley.osim")
        .rescaled_to(492.0)
        .is_refused("parameters-in-defaults", &["<defaults>"]);
}

#[test]
fn self_closing_and_comment_only_objects_are_filled() {
    let after =
        |file: &str| String::from_utf8(given_fixture(file).rescaled_to(492.0).bytes().to_vec()).unwrap();
    let text = after("format/defaults_comment_only.osim");
    assert!(
        text.contains(
            "\t\t\t\t\t\t\t<HuntCrossleyForce::ContactParameters>\n\
             \t\t\t\t\t\t\t\t<!--All properties of this object have their default values.-->\n\
             \t\t\t\t\t\t\t\t<stiffness>2469135.6</stiffness>\n\
             \t\t\t\t\t\t\t\t<dissipation>1.590990257669732</dissipation>\n\
             \t\t\t\t\t\t\t</HuntCrossleyForce::ContactParameters>\n"
        ),
        "{text}"
    );
    let text = after("format/defaults_self_closing_material.osim");
    assert!(
        text.contains(
            "\t\t\t\t\t\t\t<HuntCrossleyForce::ContactParameters>\n\
             \t\t\t\t\t\t\t\t<stiffness>2469135.6</stiffness>\n\
             \t\t\t\t\t\t\t\t<dissipation>1.590990257669732</dissipation>\n\
             \t\t\t\t\t\t\t</HuntCrossleyForce::ContactParameters>\n"
        ),
        "{text}"
    );
}

#[test]
fn the_files_line_ends_and_indentation_are_used_for_what_is_inserted() {
    let inserted = |file: &str, line: &str| {
        let outcome = given_fixture(file).rescaled_to(492.0);
        let text = String::from_utf8(outcome.bytes().to_vec()).unwrap();
        assert!(text.contains(line), "{file}: {text}");
        let lone = text.match_indices('\n').filter(|(at, _)| !text[..*at].ends_with('\r')).count();
        let crlf = text.matches("\r\n").count();
        (lone, crlf)
    };
    let (lone, crlf) =
        inserted("format/bytes_crlf.osim", "\r\n\t\t\t\t\t<hertz_smoothing>150</hertz_smoothing>\r\n");
    assert!(lone == 0 && crlf > 0, "{lone} bare line ends beside {crlf}");
    inserted("format/bytes_spaces.osim", "\n                    <hertz_smoothing>150</hertz_smoothing>\n");
    inserted(
        "format/left_out_in_the_middle.osim",
        "</constant_contact_force>\n\t\t\t\t\t<hertz_smoothing>150</hertz_smoothing>\n\t\t\t\t\t<hunt",
    );
    // On one line there is nothing to indent by.
    let one_line = String::from_utf8(fixture("format/bytes_one_line.osim")).unwrap();
    let without = one_line.replace("<hertz_smoothing>310</hertz_smoothing>", "");
    let outcome = given(without).with_note().rescaled_to(492.0);
    let text = String::from_utf8(outcome.bytes().to_vec()).unwrap();
    assert!(text.contains("</constant_contact_force><hertz_smoothing>150</hertz_smoothing><hunt"), "{text}");
    assert!(!text.contains('\n') || one_line.contains('\n'), "{text}");
}
