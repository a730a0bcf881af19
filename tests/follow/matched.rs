//! Which sphere of one model is which of the other, how many share the weight, and what is asked about both.

use super::{CALL, bench, close, edit, plan, planned, refuses, says};
use crate::support::{Bench, fixture};

#[test]
fn a_sphere_missing_on_one_side_is_named() {
    for (file, call) in [("generic.osim", CALL), ("scaled.osim", CALL)] {
        for name in ["toe_r", "toe_l"] {
            let bench = bench("smooth");
            let text = bench.text(file);
            // The force and the sphere go together.
            let cut = |text: &str, tag: &str, object: &str| {
                let start = text.find(&format!("<{tag} name=\"{object}\">")).unwrap();
                let end = start + text[start..].find(&format!("</{tag}>")).unwrap() + tag.len() + 3;
                format!("{}{}", &text[..start], &text[end..])
            };
            let text = cut(&text, "SmoothSphereHalfSpaceForce", &format!("contact_{name}"));
            bench.write(file, cut(&text, "ContactSphere", name));
            refuses(&bench, call, &[name, "[refused]"]);
        }
    }
}

#[test]
fn renamed_spheres_are_named() {
    let bench = bench("smooth");
    for name in ["\"ball_r\"", "contactgeometryset/ball_r<"] {
        edit(&bench, "scaled.osim", name, &name.replace("ball_r", "forefoot_r"));
    }
    refuses(&bench, CALL, &["ball_r"]);
}

#[test]
fn a_sphere_on_another_body_is_named() {
    let bench = bench("smooth");
    edit(
        &bench,
        "scaled.osim",
        "<socket_frame>/bodyset/toes_r</socket_frame>",
        "<socket_frame>/bodyset/calcn_r</socket_frame>",
    );
    refuses(&bench, CALL, &["toe_r", "calcn_r", "toes_r"]);
}

#[test]
fn a_reference_without_contacts_is_refused() {
    let bench = bench("smooth");
    bench.write("generic.osim", fixture("bad/no_contacts.osim"));
    refuses(&bench, CALL, &["generic.osim", "[no-contacts]"]);
}

#[test]
fn a_preset_has_no_bodies() {
    let bench = bench("smooth");
    says(&bench.run("transfer scaled.osim --from falisse2022 --follow-bodies").usage(), &["bodies"]);
}

#[test]
fn radii_of_spheres_that_follow_may_have_a_rule_of_their_own() {
    let bench = bench("smooth");
    // (8): 0.032 m times the cube root of 52/62, by Python's decimal; places follow the bodies.
    let isometric = plan(&bench, "--radius isometric");
    close(&planned(&isometric, "heel_r", "radius"), 0.030_177_773_622_203_01);
    super::close_place(&planned(&isometric, "heel_r", "location"), [-0.0102, -0.036, 0.00475]);
    let radius = isometric["changes"].as_array().unwrap().iter().find(|c| c["property"] == "radius").unwrap();
    assert_eq!(radius["equation"], "8");
    // (10): 52/62 of the modulus over the square of the ratio of radii, (52/62)^(1/3).
    close(&planned(&isometric, "contact_heel_r", "stiffness"), 1_886_110.851_387_688);
    // Level: the bottom of the heel, 0.9 (-0.04 - 0.032) m, stays on the scaled sole.
    let level = planned(&plan(&bench, "--radius isometric --level"), "heel_r", "location");
    super::close_place(&level, [-0.0102, -0.0648 + 0.030_177_773_622_203_01, 0.00475]);
    let metres = plan(&bench, "--radius 0.03");
    close(&planned(&metres, "toe_l", "radius"), 0.03);
    let kept = plan(&bench, "--radius keep");
    assert!(!kept["changes"].as_array().unwrap().iter().any(|change| change["property"] == "radius"));
    let factor = bench.run(&format!("{CALL} --radius x1.5")).usage();
    says(
        &factor,
        &[
            "a factor of --radius says nothing with --follow-bodies",
            "--radius-axis",
            "isometric, metres or kept",
        ],
    );
    let both = bench.run(&format!("{CALL} --radius isometric --radius-axis x")).usage();
    says(&both, &["--radius-axis says nothing with --radius"]);
}

/// Without the left toe in both models, left and right have different numbers of spheres.
fn lopsided() -> Bench {
    let bench = bench("smooth");
    for file in ["generic.osim", "scaled.osim"] {
        let cut = |text: &str, tag: &str, object: &str| {
            let start = text.find(&format!("<{tag} name=\"{object}\">")).unwrap();
            let end = start + text[start..].find(&format!("</{tag}>")).unwrap() + tag.len() + 3;
            format!("{}{}", &text[..start], &text[end..])
        };
        let text = cut(&bench.text(file), "SmoothSphereHalfSpaceForce", "contact_toe_l");
        bench.write(file, cut(&text, "ContactSphere", "toe_l"));
    }
    bench
}

#[test]
fn matched_spheres_need_no_count() {
    let bench = lopsided();
    // That of `parameters_follow_the_paper`: the ball's own numbers do not depend on the toe that is not there.
    let expected = 1_837_655.613_115_876_4;
    let report = plan(&bench, "");
    close(&planned(&report, "contact_ball_r", "stiffness"), expected);
    says(&bench.run(&format!("{CALL} -o done.osim")).done(), &[]);
    // Twice as many limbs share the weight: half of it on each sphere (10).
    close(&planned(&plan(&bench, "--stance-limbs 2"), "contact_ball_r", "stiffness"), expected / 2.0);
    // One side that is known says the other.
    let generic = fixture("scale_tool/generic_smooth.osim");
    bench.write("whole.osim", generic);
    let whole = "transfer scaled.osim --from whole.osim --follow-bodies";
    refuses(&bench, whole, &["toe_l"]);
}

#[test]
fn a_count_is_asked_for_by_the_option_of_its_file() {
    let bench = lopsided();
    refuses(
        &bench,
        &format!("{CALL} --spheres 3"),
        &["generic.osim", "--reference-spheres N", "[sphere-count]"],
    );
    refuses(
        &bench,
        &format!("{CALL} --reference-spheres 3"),
        &["scaled.osim", "--spheres N", "[sphere-count]"],
    );
    let both = plan(&bench, "--spheres 3 --reference-spheres 3");
    close(&planned(&both, "contact_ball_r", "stiffness"), 1_837_655.613_115_876_4);
}

#[test]
fn a_shared_sphere_is_left_as_it_is_by_the_option_that_is_named() {
    let bench = bench("smooth");
    for file in ["generic.osim", "scaled.osim"] {
        let text = bench.text(file);
        let tag = "SmoothSphereHalfSpaceForce";
        let start = text.find(&format!("<{tag} name=\"contact_heel_r\">")).unwrap();
        let end = start + text[start..].find(&format!("</{tag}>")).unwrap() + tag.len() + 3;
        let second = text[start..end].replace("contact_heel_r", "second_heel_r");
        bench.write(file, format!("{}{second}{}", &text[..end], &text[end..]));
    }
    let call = format!("{CALL} --select contact_* --reference-select contact_* --dry-run");
    let ran = bench.run(&call).failed();
    says(&ran, &["sphere /contactgeometryset/heel_r is used by"]);
    // What is advised, word by word.
    let advised: Vec<String> = ran
        .err()
        .split(" with ")
        .skip(1)
        .map(|rest| rest.split(&[',', '\n'][..]).next().unwrap().replace("GLOB", "second_*"))
        .collect();
    assert_eq!(advised, ["--select second_*", "--keep radius"]);
    for option in &advised {
        let call = if option.starts_with("--select") {
            call.replace(" --reference-select contact_*", "")
        } else {
            call.clone()
        };
        bench.run(&format!("{call} {option}")).done();
    }
}

#[test]
fn spheres_of_disabled_forces_do_not_stand() {
    // Heels that are switched off in one of the two models carry nothing there: the counts are not the same and do not cancel.
    let bench = lopsided();
    for name in ["contact_heel_r", "contact_heel_l"] {
        let force = format!("<SmoothSphereHalfSpaceForce name=\"{name}\">");
        edit(&bench, "scaled.osim", &force, &format!("{force}<appliesForce>false</appliesForce>"));
    }
    refuses(&bench, CALL, &["[sphere-count]"]);
}
