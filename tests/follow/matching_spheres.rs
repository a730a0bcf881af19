//! The matching of spheres of two models, the number of spheres that share the weight, and questions about this number.

use super::{
    CALL_OF_TRANSFER, assert_close, assert_refused, assert_stderr_has, dry_run_plan, generic_and_scaled,
    planned_value, replace_in_file,
};
use crate::support::{TestDir, fixture};

#[test]
fn a_sphere_missing_on_one_side_is_named() {
    for (file, call) in [("generic.osim", CALL_OF_TRANSFER), ("scaled.osim", CALL_OF_TRANSFER)] {
        for name in ["toe_r", "toe_l"] {
            let dir = generic_and_scaled("smooth");
            let text = dir.text(file);
            // The force and the sphere go together.
            let cut = |text: &str, tag: &str, object: &str| {
                let start = text.find(&format!("<{tag} name=\"{object}\">")).unwrap();
                let end = start + text[start..].find(&format!("</{tag}>")).unwrap() + tag.len() + 3;
                format!("{}{}", &text[..start], &text[end..])
            };
            let text = cut(&text, "SmoothSphereHalfSpaceForce", &format!("contact_{name}"));
            dir.write(file, cut(&text, "ContactSphere", name));
            assert_refused(&dir, call, &[name, "[refused]"]);
        }
    }
}

#[test]
fn spheres_with_other_names_in_the_reference_are_named() {
    let dir = generic_and_scaled("smooth");
    for name in ["\"ball_r\"", "contactgeometryset/ball_r<"] {
        replace_in_file(&dir, "scaled.osim", name, &name.replace("ball_r", "forefoot_r"));
    }
    assert_refused(&dir, CALL_OF_TRANSFER, &["ball_r"]);
}

#[test]
fn a_sphere_on_another_body_is_named() {
    let dir = generic_and_scaled("smooth");
    replace_in_file(
        &dir,
        "scaled.osim",
        "<socket_frame>/bodyset/toes_r</socket_frame>",
        "<socket_frame>/bodyset/calcn_r</socket_frame>",
    );
    assert_refused(&dir, CALL_OF_TRANSFER, &["toe_r", "calcn_r", "toes_r"]);
}

#[test]
fn a_reference_without_contacts_is_refused() {
    let dir = generic_and_scaled("smooth");
    dir.write("generic.osim", fixture("bad/no_contacts.osim"));
    assert_refused(&dir, CALL_OF_TRANSFER, &["generic.osim", "[no-contacts]"]);
}

#[test]
fn a_preset_without_bodies_is_refused() {
    let dir = generic_and_scaled("smooth");
    assert_stderr_has(
        &dir.run("transfer scaled.osim --from falisse2022 --follow-bodies").usage_error(),
        &["bodies"],
    );
}

#[test]
fn radii_of_followed_spheres_may_follow_another_rule() {
    let dir = generic_and_scaled("smooth");
    // (8): 0.032 m times the cube root of 52/62, by Python's decimal. Level: the bottom of the heel, 0.9 (-0.04 - 0.032) m, stays on the
    // scaled sole. This is the default, too.
    let isometric = dry_run_plan(&dir, "--radius isometric");
    for report in [&isometric, &dry_run_plan(&dir, ""), &dry_run_plan(&dir, "--level")] {
        assert_close(&planned_value(report, "heel_r", "radius"), 0.030_177_773_622_203_01);
        let level = [-0.0102, -0.0648 + 0.030_177_773_622_203_01, 0.00475];
        super::assert_close_place(&planned_value(report, "heel_r", "location"), level);
    }
    let radius = isometric["changes"].as_array().unwrap().iter().find(|c| c["property"] == "radius").unwrap();
    assert_eq!(radius["equation"], "8");
    // (10): 52/62 of the modulus over the square of the ratio of radii, (52/62)^(1/3).
    assert_close(&planned_value(&isometric, "contact_heel_r", "stiffness"), 1_886_110.851_387_688);
    let metres = dry_run_plan(&dir, "--radius 0.03");
    assert_close(&planned_value(&metres, "toe_l", "radius"), 0.03);
    let plan_with_kept = dry_run_plan(&dir, "--radius keep");
    assert!(
        !plan_with_kept["changes"].as_array().unwrap().iter().any(|change| change["property"] == "radius")
    );
    for call in [
        "transfer scaled.osim --from generic.osim --radius follow",
        "scaled.osim --contacts-mass 62 --target-mass 52 --radius follow",
    ] {
        let refused = dir.run(call).usage_error();
        assert_stderr_has(&refused, &["--radius follow is for transfer with --follow-bodies"]);
    }
    let designed = dir.run("design scaled.osim --indentation 0.1 --radius follow").usage_error();
    assert_stderr_has(&designed, &["--radius follow is not possible here"]);
    let factor = dir.run(&format!("{CALL_OF_TRANSFER} --radius x1.5")).usage_error();
    assert_stderr_has(
        &factor,
        &[
            "a factor of --radius has no effect with --follow-bodies",
            "--radius-axis",
            "isometric, metres or kept",
        ],
    );
    let plan_with_counts =
        dir.run(&format!("{CALL_OF_TRANSFER} --radius isometric --radius-axis x")).usage_error();
    assert_stderr_has(&plan_with_counts, &["--radius-axis has no effect with --radius"]);
}

/// A folder with two models that have more spheres on the right side, because the left toe has none.
fn models_without_left_toe() -> TestDir {
    let dir = generic_and_scaled("smooth");
    for file in ["generic.osim", "scaled.osim"] {
        let cut = |text: &str, tag: &str, object: &str| {
            let start = text.find(&format!("<{tag} name=\"{object}\">")).unwrap();
            let end = start + text[start..].find(&format!("</{tag}>")).unwrap() + tag.len() + 3;
            format!("{}{}", &text[..start], &text[end..])
        };
        let text = cut(&dir.text(file), "SmoothSphereHalfSpaceForce", "contact_toe_l");
        dir.write(file, cut(&text, "ContactSphere", "toe_l"));
    }
    dir
}

#[test]
fn spheres_with_the_same_names_need_no_count() {
    let dir = models_without_left_toe();
    // That of `parameters_agree_with_the_paper`: the ball's own numbers do not depend on the toe that is not there.
    let expected = 1_886_110.851_387_688;
    let report = dry_run_plan(&dir, "");
    assert_close(&planned_value(&report, "contact_ball_r", "stiffness"), expected);
    assert_stderr_has(&dir.run(&format!("{CALL_OF_TRANSFER} -o done.osim")).succeeded(), &[]);
    // Twice as many limbs share the weight: half of it on each sphere (10).
    assert_close(
        &planned_value(&dry_run_plan(&dir, "--stance-limbs 2"), "contact_ball_r", "stiffness"),
        expected / 2.0,
    );
    // With all spheres in the reference, the missing one is named.
    let generic = fixture("scale_tool/generic_smooth.osim");
    dir.write("whole.osim", generic);
    let whole = "transfer scaled.osim --from whole.osim --follow-bodies";
    assert_refused(&dir, whole, &["toe_l"]);
}

#[test]
fn a_missing_count_is_requested_by_the_option_of_its_model() {
    let dir = models_without_left_toe();
    assert_refused(
        &dir,
        &format!("{CALL_OF_TRANSFER} --spheres 3"),
        &["generic.osim", "--reference-spheres N", "[sphere-count]"],
    );
    assert_refused(
        &dir,
        &format!("{CALL_OF_TRANSFER} --reference-spheres 3"),
        &["scaled.osim", "--spheres N", "[sphere-count]"],
    );
    let plan_with_counts = dry_run_plan(&dir, "--spheres 3 --reference-spheres 3");
    assert_close(&planned_value(&plan_with_counts, "contact_ball_r", "stiffness"), 1_886_110.851_387_688);
}

#[test]
fn the_advised_options_leave_a_shared_sphere_unchanged() {
    let dir = generic_and_scaled("smooth");
    for file in ["generic.osim", "scaled.osim"] {
        let text = dir.text(file);
        let tag = "SmoothSphereHalfSpaceForce";
        let start = text.find(&format!("<{tag} name=\"contact_heel_r\">")).unwrap();
        let end = start + text[start..].find(&format!("</{tag}>")).unwrap() + tag.len() + 3;
        let second = text[start..end].replace("contact_heel_r", "second_heel_r");
        dir.write(file, format!("{}{second}{}", &text[..end], &text[end..]));
    }
    let call = format!("{CALL_OF_TRANSFER} --select contact_* --reference-select contact_* --dry-run");
    let run = dir.run(&call).failed();
    assert_stderr_has(&run, &["sphere /contactgeometryset/heel_r is used by"]);
    // The advised options.
    let advised_options: Vec<String> = run
        .err()
        .split(" with ")
        .skip(1)
        .map(|rest| rest.split(&[',', '\n'][..]).next().unwrap().replace("GLOB", "second_*"))
        .collect();
    assert_eq!(advised_options, ["--select second_*", "--radius keep"]);
    for option in &advised_options {
        let call = if option.starts_with("--select") {
            call.replace(" --reference-select contact_*", "")
        } else {
            call.clone()
        };
        dir.run(&format!("{call} {option}")).succeeded();
    }
}

#[test]
fn spheres_of_disabled_forces_do_not_count() {
    // Heels that are switched off in one of the two models carry nothing there: the counts are not the same and do not cancel.
    let dir = models_without_left_toe();
    for name in ["contact_heel_r", "contact_heel_l"] {
        let force = format!("<SmoothSphereHalfSpaceForce name=\"{name}\">");
        replace_in_file(&dir, "scaled.osim", &force, &format!("{force}<appliesForce>false</appliesForce>"));
    }
    assert_refused(&dir, CALL_OF_TRANSFER, &["[sphere-count]"]);
}
