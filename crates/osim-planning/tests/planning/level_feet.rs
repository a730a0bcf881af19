//! Feet whose bottoms `set` and `add` bring to one height, and the remarks on a change that moves bottoms.

use std::path::Path;

use osim_inspect::{InspectOptions, Inspection};
use osim_model::files::InMemory;
use osim_model::{FileId, FindingCode, MassRequest, Model, Severity};
use osim_patch::Plan;
use osim_planning::prepare;
use osim_requests::Request;
use serde_json::{Value, json};

use crate::checks::{check_with, find, has, remedy_without_models};

/// A model in which two spheres of each foot, s5 and s6, are 21.8 mm lower than the other four; all have R = 0.032 m.
const UNEVEN_MODEL: &str = include_str!("../../../../fixtures/check/uneven_bottoms.osim");
/// A model with a heel of 0.0325 m whose bottom is 2.5 mm inside the floor.
const HEEL_MODEL: &str = include_str!("../../../../fixtures/check/within_limits.osim");
/// A model of a human's feet without contacts, and a table of contacts for it: heels of 0.03 m at y = 0.01 m, balls of 0.025 m at y = 0.005
/// m.
const FEET_MODEL: &str = include_str!("../../../../fixtures/feet/human_40000.osim");
const TABLE_OF_PLACES: &str = include_str!("../../../../fixtures/contact_tables/own.csv");
const MODEL_NAME: &str = "model.osim";

fn plan_of_fields(text: &str, fields: &Value) -> Result<(Model, Plan), String> {
    let mut fields = fields.clone();
    fields["models"] = json!([MODEL_NAME]);
    let files = InMemory::from_iter([(MODEL_NAME, text), ("table.csv", TABLE_OF_PLACES)]);
    let request = Request::from_json(fields.to_string().as_bytes()).map_err(|fault| format!("{fault:?}"))?;
    let change = prepare(request, &files).map_err(|error| format!("{error:?}"))?;
    let opened = change.open(Path::new(MODEL_NAME), &files).map_err(|failure| failure.message.to_string())?;
    let plan = change.plan(&opened, &files).map_err(|failure| failure.message.to_string())?;
    Ok((opened.model, plan))
}

fn text_after(text: &str, fields: &Value) -> String {
    let (model, plan) = plan_of_fields(text, fields).unwrap();
    String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap()
}

fn inspection_of_text(text: &str) -> Inspection {
    InspectOptions::default().inspect(MODEL_NAME, &Model::parse(text).unwrap(), None)
}

/// The heights of the bottoms of one side above the floor, m.
fn heights_of_bottoms(text: &str, side: &str) -> Vec<f64> {
    let bodies = inspection_of_text(text).standing;
    let bottoms = bodies.iter().flat_map(|body| &body.bottoms).filter(|bottom| bottom.sphere.ends_with(side));
    bottoms.map(|bottom| bottom.height_m).collect()
}

fn lowest_bottom(text: &str) -> f64 {
    heights_of_bottoms(text, "_r").into_iter().fold(f64::INFINITY, f64::min)
}

/// Whether the bottoms of each foot are at one height.
fn is_level(text: &str) -> bool {
    ["_r", "_l"].into_iter().all(|side| {
        let heights = heights_of_bottoms(text, side);
        assert!(heights.len() > 1, "{heights:?}");
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        heights.iter().all(|height| height - lowest < 1e-9)
    })
}

/// The remarks of a change about bottoms that it moves.
fn remarks_on_moved_bottoms(text: &str, fields: &Value) -> Vec<String> {
    let (_, plan) = plan_of_fields(text, fields).unwrap();
    let own = plan.findings.iter().filter(|finding| finding.code() == FindingCode::BottomsMoved);
    own.map(|finding| finding.message.to_string()).collect()
}

#[test]
fn an_uneven_foot_has_a_remedy_after_which_nothing_is_wrong() {
    let found = check_with(MODEL_NAME, UNEVEN_MODEL, &InspectOptions::default());
    let remedy = find(&found, FindingCode::UnevenBottoms).remedy.as_ref();
    assert_eq!(remedy_without_models(remedy), json!({"verb": "set", "level": true}));
    let after = text_after(UNEVEN_MODEL, &json!({"verb": "set", "level": true}));
    assert!(is_level(&after) && !is_level(UNEVEN_MODEL));
    let found = check_with(MODEL_NAME, &after, &InspectOptions::default());
    assert_eq!((found.counts.error, found.counts.warning, found.steps.len()), (0, 0, 0));
    assert!(!has(&found, FindingCode::UnlevelFoot));
    // The lowest stays where it was.
    assert!((lowest_bottom(&after) - lowest_bottom(UNEVEN_MODEL)).abs() < 1e-12);
    // Once more it changes nothing.
    assert!(plan_of_fields(&after, &json!({"verb": "set", "level": true})).unwrap().1.is_empty());
}

/// No radius moves a bottom by more than itself, and a sphere that is elsewhere on the other foot is at a wrong place.
#[test]
fn bottoms_that_radii_do_not_explain_are_not_made_level() {
    let heels_low = UNEVEN_MODEL.replace("<location>0.00190115 -0.01 ", "<location>0.00190115 -0.07 ");
    let heels_lower = UNEVEN_MODEL.replace("<location>0.00190115 -0.01 ", "<location>0.00190115 -0.036 ");
    let one_side =
        UNEVEN_MODEL.replace("<location>0.06 -0.03 -0.01876031", "<location>0.06 -0.01 -0.01876031");
    let one_side = one_side.replace("<location>0.045 -0.03 0.06185696", "<location>0.045 -0.01 0.06185696");
    for (text, accused) in [
        (heels_low, FindingCode::UnevenBottoms),
        (heels_lower, FindingCode::UnevenBottoms),
        (one_side, FindingCode::LeftRightPlaces),
    ] {
        assert_ne!(text, UNEVEN_MODEL);
        let found = check_with(MODEL_NAME, &text, &InspectOptions::default());
        assert!(has(&found, FindingCode::UnevenBottoms) && has(&found, accused), "{:?}", found.findings);
        assert!(found.steps.is_empty() && find(&found, FindingCode::UnevenBottoms).remedy.is_none());
    }
}

/// The bodies weigh 62 kg. On contacts that are made for them, 21.8 mm are 0.682 R; radii for 20 kg are 1.458 times smaller, for 45 kg 1.113
/// times, and the limit of half a radius is as much larger.
#[test]
fn bottoms_are_compared_with_radii_for_the_bodies() {
    for (contacts_mass_kg, is_accused) in [(None, true), (Some(45.0), true), (Some(20.0), false)] {
        let masses = MassRequest { contacts_mass_kg, ..MassRequest::default() };
        let options = InspectOptions { masses, ..InspectOptions::default() };
        let found = check_with(MODEL_NAME, UNEVEN_MODEL, &options);
        assert_eq!(has(&found, FindingCode::UnevenBottoms), is_accused, "{contacts_mass_kg:?}");
        assert_eq!(has(&found, FindingCode::UnlevelFoot), !is_accused, "{contacts_mass_kg:?}");
    }
}

/// The model `text` with legs that are turned by `angle_rad` at the default pose.
fn with_tilted_legs(text: &str, angle_rad: f64) -> String {
    ["r", "l"].iter().fold(text.to_owned(), |text, side| {
        let joint = format!("<PinJoint name=\"leg_{side}\">");
        let angle = format!(
            "{joint}<coordinates><Coordinate name=\"angle_{side}\"><default_value>{angle_rad}</default_value></Coordinate></coordinates>"
        );
        text.replace(&joint, &angle)
    })
}

/// However far the legs are turned, feet that are level with all coordinates at 0 have their spheres at the right heights. Seen from the
/// nearest axis, a foot that is turned by 1.4 rad is tilted by 0.17.
#[test]
fn feet_that_are_level_with_coordinates_at_0_are_uneven_by_their_pose_alone() {
    let level = UNEVEN_MODEL.replace(" -0.03 ", " -0.01 ");
    let heels_high = level.replace("<location>0.00190115 -0.01 ", "<location>0.00190115 0.29 ");
    for (angle_rad, floor) in
        [(0.6, "-1.57"), (1.4, "-1.57"), (std::f64::consts::FRAC_PI_2, "-1.57"), (1.4, "-1.37")]
    {
        for (text, is_accused) in [(&level, false), (&heels_high, true)] {
            // The last floor slopes by 0.2 rad.
            let text = with_tilted_legs(text, angle_rad).replace("-1.5707963267948966", floor);
            let found = check_with(MODEL_NAME, &text, &InspectOptions::default());
            assert_eq!(has(&found, FindingCode::UnevenBottoms), is_accused, "{:?}", found.findings);
            let of_depth = found.findings.iter().filter(|one| one.code() == FindingCode::SunkIn);
            assert!(is_accused || of_depth.map(|one| one.severity).all(|it| it == Severity::Remark));
        }
    }
    let found = check_with(MODEL_NAME, &with_tilted_legs(&level, 1.4), &InspectOptions::default());
    let text = find(&found, FindingCode::UnlevelFoot).message.to_string();
    assert!(text.ends_with("; with all coordinates at 0 by 1.8 mm"), "{text}");
}

/// The heights of the bottoms shrink with the bodies, as the radii did before them.
#[test]
fn a_foot_whose_body_is_still_to_be_scaled_is_as_level_as_before() {
    let text = UNEVEN_MODEL.replace(" -0.03 ", " -0.022 ");
    // 13.8 mm are 0.43 R before, and 0.63 R afterwards.
    let scaled = text_after(&text, &json!({"verb": "rescale", "target_mass": 20.0}));
    for text in [&text, &scaled] {
        let found = check_with(MODEL_NAME, text, &InspectOptions::default());
        let has = |code| has(&found, code);
        assert!(has(FindingCode::UnlevelFoot) && !has(FindingCode::UnevenBottoms), "{:?}", found.findings);
    }
}

/// As the left leg of OpenSim's Toy Landing model, which its joints fold back.
#[test]
fn a_foot_that_is_raised_above_the_other_one_may_be_uneven() {
    let level = UNEVEN_MODEL.replace(" -0.03 ", " -0.01 ");
    let (before, after) = level.split_once("<translation>0 -0.9 -0.1</translation>").unwrap();
    let turned = after.replacen("<orientation>0 0 0<", "<orientation>0 0 2<", 1);
    for (height, is_accused) in [("-0.9", true), ("-0.5", false)] {
        let text = format!("{before}<translation>0 {height} -0.1</translation>{turned}");
        let found = check_with(MODEL_NAME, &text, &InspectOptions::default());
        assert_eq!(has(&found, FindingCode::UnevenBottoms), is_accused, "{:?}", found.findings);
    }
}

/// A foot of 0.2 m that is tilted by 0.3 rad explains 60 mm, not a heel that is 300 mm higher than the others.
#[test]
fn a_tilt_explains_as_much_as_it_lifts() {
    let tilted = with_tilted_legs(UNEVEN_MODEL, 0.3);
    let heels_high = tilted.replace("<location>0.00190115 -0.01 ", "<location>0.00190115 0.29 ");
    for (text, is_accused) in [(tilted, false), (heels_high, true)] {
        let found = check_with(MODEL_NAME, &text, &InspectOptions::default());
        assert_eq!(has(&found, FindingCode::UnevenBottoms), is_accused, "{:?}", found.findings);
        assert_ne!(has(&found, FindingCode::UnlevelFoot), is_accused);
    }
}

#[test]
fn feet_are_level_with_the_radii_that_they_get() {
    let request =
        json!({"verb": "set", "set": {"radius": "x1.5"}, "select": ["*1_r", "*5_l"], "level": true});
    let after = text_after(UNEVEN_MODEL, &request);
    // Spheres of forces that are not chosen stay: s1_r alone on its foot, and s5_l on its.
    assert!(plan_of_fields(UNEVEN_MODEL, &request).unwrap().1.moves.is_empty());
    assert!(!is_level(&after));
    let after = text_after(&after, &json!({"verb": "set", "set": {"stiffness": "x2"}, "level": true}));
    assert!(is_level(&after));
    // A radius that grows makes its own bottom the lowest.
    let all = text_after(UNEVEN_MODEL, &json!({"verb": "set", "set": {"radius": "x2"}, "level": true}));
    assert!(is_level(&all));
    assert!((lowest_bottom(&all) - (lowest_bottom(UNEVEN_MODEL) - 0.032)).abs() < 1e-12);
}

#[test]
fn a_factor_is_not_applied_twice_because_feet_were_made_level_with_it() {
    let first = text_after(UNEVEN_MODEL, &json!({"verb": "set", "set": {"stiffness": "x2"}, "level": true}));
    assert!(first.contains("by set stiffness=x2 level;"), "{first}");
    for again in [
        json!({"verb": "set", "set": {"stiffness": "x2"}}),
        json!({"verb": "set", "set": {"stiffness": "x2"}, "level": true}),
    ] {
        let mut again = again;
        again["in_place"] = json!(true);
        assert!(plan_of_fields(&first, &again).is_err(), "{again}");
    }
}

#[test]
fn a_request_that_sets_nothing_is_refused() {
    assert!(plan_of_fields(UNEVEN_MODEL, &json!({"verb": "set"})).unwrap_err().contains("Missing"));
    assert!(
        plan_of_fields(UNEVEN_MODEL, &json!({"verb": "set", "level": false}))
            .unwrap_err()
            .contains("Missing")
    );
}

#[test]
fn added_spheres_are_level_where_that_is_asked() {
    let add = |level: bool| {
        let request = json!({"verb": "add", "contacts": "table.csv", "class": "smooth", "indentation": 0.16, "level": level});
        text_after(FEET_MODEL, &request)
    };
    let (plain, level) = (add(false), add(true));
    // 0.01 - 0.03 and 0.005 - 0.025 are level as they are: then nothing moves.
    assert!(is_level(&plain));
    assert_eq!(plain.matches("<location>").count(), level.matches("<location>").count());
    let high = TABLE_OF_PLACES.replace("ball_r,calcn_r,0.16,0.005", "ball_r,calcn_r,0.16,0.015");
    let files = |level: bool| {
        let files = InMemory::from_iter([(MODEL_NAME, FEET_MODEL), ("table.csv", &high)]);
        let request = json!({
            "verb": "add", "models": [MODEL_NAME], "contacts": "table.csv", "class": "smooth", "indentation": 0.16, "level": level,
        });
        let change = prepare(Request::from_json(request.to_string().as_bytes()).unwrap(), &files).unwrap();
        let opened = change.open(Path::new(MODEL_NAME), &files).unwrap();
        let plan = change.plan(&opened, &files).unwrap();
        (String::from_utf8(plan.patched(&opened.model, FileId::MAIN).unwrap()).unwrap(), plan)
    };
    let (uneven, _) = files(false);
    assert!(!is_level(&uneven));
    let (level, plan) = files(true);
    assert!(is_level(&level));
    // What is written is what the plan says, and what its note says.
    let ball = plan.new_spheres().into_iter().find(|sphere| sphere.name == "ball_r").unwrap();
    assert!((ball.centre_m[1] - 0.005).abs() < 1e-12, "{ball:?}");
    let model = Model::parse(level).unwrap();
    assert!(model.doubt_about_note().is_none());
    assert_eq!(model.note.as_ref().unwrap().places, Some(model.places_digest(|_| None)));
}

#[test]
fn a_change_after_which_the_default_pose_no_longer_stands_says_so() {
    // 2.5 mm and 32.5 mm more.
    let said = remarks_on_moved_bottoms(HEEL_MODEL, &json!({"verb": "set", "set": {"radius": "x2"}}));
    let [said] = said.as_slice() else { panic!("{said:?}") };
    assert!(said.starts_with("the default pose was 2.5 mm too low and is 35 mm too low now; "), "{said}");
    assert!(said.ends_with("; the spheres then carry the body)"), "{said}");
    // Bottoms that stay, and little that moves.
    assert!(
        remarks_on_moved_bottoms(HEEL_MODEL, &json!({"verb": "set", "set": {"radius": "x1.05"}})).is_empty()
    );
    let body =
        json!({"verb": "rescale", "target_mass": 61.5, "contacts_mass": 7.6875, "radius": "isometric"});
    assert_eq!(remarks_on_moved_bottoms(HEEL_MODEL, &body).len(), 1);
    let mut level = body.clone();
    level["level"] = json!(true);
    assert!(remarks_on_moved_bottoms(HEEL_MODEL, &level).is_empty());
}

#[test]
fn a_body_that_is_still_to_be_scaled_is_not_judged_by_its_pose() {
    assert!(
        remarks_on_moved_bottoms(HEEL_MODEL, &json!({"verb": "rescale", "target_mass": 492.0})).is_empty()
    );
}

#[test]
fn a_model_that_did_not_stand_does_not_lose_its_stand() {
    for height in ["0.9", "-0.5"] {
        let text = HEEL_MODEL
            .replace("<location>0 -0.05 0</location>", &format!("<location>0 {height} 0</location>"));
        assert_ne!(text, HEEL_MODEL);
        assert!(remarks_on_moved_bottoms(&text, &json!({"verb": "set", "set": {"radius": "x2"}})).is_empty());
    }
}

#[test]
fn a_change_that_makes_a_foot_uneven_says_so() {
    let level = text_after(UNEVEN_MODEL, &json!({"verb": "set", "level": true, "no_note": true}));
    // R = 0.032 becomes 0.0416: 9.6 mm, 0.231 of the largest radius.
    let said = remarks_on_moved_bottoms(
        &level,
        &json!({"verb": "set", "set": {"radius": "x1.3"}, "select": ["*1_r"]}),
    );
    let [said] = said.as_slice() else { panic!("{said:?}") };
    let expected = "the lowest points of calcn_r differed by 0 mm at the default pose and differ by 9.6 mm now, 0.231 R, from s1_r to s";
    assert!(said.starts_with(expected), "{said}");
    // Level again, with that radius.
    let again = json!({"verb": "set", "set": {"radius": "x1.3"}, "select": ["*_r"], "level": true});
    assert!(remarks_on_moved_bottoms(&level, &again).iter().all(|said| !said.contains("differed")));
}
