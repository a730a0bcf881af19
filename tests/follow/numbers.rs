//! The numbers of contacts and the places of spheres after a transfer to scaled bodies.

use super::{
    assert_close, assert_close_place, assert_stderr_has, dry_run_plan, generic_and_scaled, planned_value,
};

#[test]
fn parameters_agree_with_the_paper() {
    // Radii by (52/62)^(1/3), with bottoms on the scaled sole, and radii by the foot.
    for (options, [stiffness, dissipation, force, hertz, hunt_crossley], place) in [
        (
            "",
            [
                1_886_110.851_387_688,
                2.059_498_057_363_586_5,
                8.893_535_359_305_973e-6,
                318.114_918_621_329,
                51.487_451_434_089_67,
            ],
            [0.012_659_574_174_317_836, -0.027_430_012_677_953_958, 0.017_727_474_783_552_12],
        ),
        (
            "--radius follow",
            [
                1_837_655.613_115_876_4,
                2.046_141_267_854_657_6,
                9.128_039_785_400_951e-6,
                314.002_056_601_339_86,
                51.153_531_696_366_436,
            ],
            [0.011_190_745_890_090_035, -0.027_914_656_364_983_893, 0.018_338_133_644_451_395],
        ),
    ] {
        let report = dry_run_plan(&generic_and_scaled("smooth"), options);
        for (property, expected) in [
            ("stiffness", stiffness),
            ("dissipation", dissipation),
            ("constant_contact_force", force),
            ("hertz_smoothing", hertz),
            ("hunt_crossley_smoothing", hunt_crossley),
        ] {
            assert_close(&planned_value(&report, "contact_ball_r", property), expected);
        }
        assert_close_place(&planned_value(&report, "ball_r", "location"), place);
    }
}

#[test]
fn level_keeps_the_lowest_points_on_the_scaled_sole() {
    let dir = generic_and_scaled("smooth");
    for (options, heel, ball, toe) in [
        (
            "--level --radius follow",
            [-0.0102, -0.034_226_951_836_215_99, 0.00475],
            [0.012_659_574_174_317_836, -0.027_034_738_136_372_95, 0.017_727_474_783_552_12],
            [0.0306, -0.023_426_951_836_215_98, -0.0038],
        ),
        (
            "--level --level-axis z --radius follow",
            [-0.0102, -0.036_000_000_000_000_004, 0.004_923_048_163_784_02],
            [0.011_385_132_268_790_465, -0.028_525_315_225_883_172, 0.018_556_986_496_414_053],
            [0.0306, -0.0252, -0.003_626_951_836_215_981_7],
        ),
    ] {
        let report = dry_run_plan(&dir, options);
        for (name, place) in [("heel_r", heel), ("ball_r", ball), ("toe_r", toe)] {
            assert_close_place(&planned_value(&report, name, "location"), place);
        }
    }
    let run_without_follow = dir.run("transfer scaled.osim --from generic.osim --level").usage_error();
    assert_stderr_has(
        &run_without_follow,
        &["--level has no effect here: radii stay", "--radius isometric", "--follow-bodies"],
    );
}

#[test]
fn level_uses_the_vertical_axis_of_a_rotated_frame() {
    // A quarter turn about z: the frame's x points up, and the offset across the sole is along its -y.
    let dir = generic_and_scaled("smooth");
    for name in ["generic.osim", "scaled.osim"] {
        let text = dir.text(name);
        let turned = text.match_indices("<orientation>0.").map(|(at, _)| at).collect::<Vec<_>>();
        let mut text = text.clone();
        for at in turned.into_iter().rev() {
            let end = at + text[at..].find("</orientation>").unwrap();
            text.replace_range(at..end, "<orientation>0 0 1.5707963267948966");
        }
        dir.write(name, text);
    }
    // x: 0.9 (0.01 - 0.032) + R'; y: 1.02 (-0.03); z: 0.95 (0.02).
    let place = planned_value(&dry_run_plan(&dir, "--level --radius follow"), "ball_r", "location");
    assert_close_place(&place, [0.010_773_048_163_784_02, -0.0306, 0.019]);
}

#[test]
fn radii_follow_the_given_axis() {
    let dir = generic_and_scaled("smooth");
    for (axis, radius) in [
        ("x", 0.03264),
        ("y", 0.0288),
        ("z", 0.0304),
        ("min", 0.0288),
        ("max", 0.03264),
        ("geomean", 0.030_573_048_163_784_02),
    ] {
        let report = dry_run_plan(&dir, &format!("--radius-axis {axis}"));
        assert_close(&planned_value(&report, "toe_l", "radius"), radius);
        let ratio: f64 = radius / 0.032;
        assert_close(
            &planned_value(&report, "contact_toe_l", "stiffness"),
            2e6 * (52.0 / 62.0) / (ratio * ratio),
        );
    }
    let plan_with_kept = dry_run_plan(&dir, "--keep radius --level");
    assert!(
        !plan_with_kept["changes"].as_array().unwrap().iter().any(|change| change["property"] == "radius")
    );
    assert_close(&planned_value(&plan_with_kept, "contact_toe_l", "stiffness"), 2e6 * (52.0 / 62.0));
    // The lowest point of the unchanged sphere: 0.9 (-0.028 - 0.032) + 0.032.
    assert_close_place(&planned_value(&plan_with_kept, "toe_r", "location"), [0.0306, -0.022, -0.0038]);
}
