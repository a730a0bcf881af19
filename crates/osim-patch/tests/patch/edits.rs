//! Tests of the written bytes, with the model before and after the change.
//!
//! The foot of these tests weighs 1 kg and is rescaled to 64 kg. Lengths then grow by 64^{1/3} = 4, and the paper's rules
//! give E₁* × 4, α × 4^{-1/2} = 0.5, cf × 4² = 16, bd × 4^{-1} = 0.25, bv × 4^{-1/2} = 0.5: all expected texts are exact.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::given::{fixture, foot, given, given_fixture, hunt_crossley, smooth};
use osim_model::Property;

/// Asserts that a foot with a smooth force has the text `after` when it is rescaled isometrically from 1 kg to 64 kg.
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
fn white_space_and_comments_around_a_number_stay() {
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
        .has_finding("several-parameter-sets");
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
