//! Spheres that stayed at their places when bodies were scaled follow their bodies by the proposed command.

use std::path::Path;

use osim_inspect::CheckResult;
use osim_model::files::InMemory;
use osim_model::{FileId, FindingCode, Model};
use osim_planning::{Inspector, open_with, prepare};
use osim_requests::Request;
use osim_requests::options::MovedChoice;
use serde_json::{Value, json};

use crate::checks::{find, has, with_text_replaced};

const NAME: &str = "model.osim";

fn read(name: &str) -> String {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/scale_tool");
    std::fs::read_to_string(fixtures.join(name)).unwrap()
}

/// The result of `check` for the model `text`, compared with `generic.osim`. `more` has other fields of the request.
fn check_beside(files: &InMemory, text: &str, more: &Value) -> CheckResult {
    let mut request = json!({"verb": "check", "models": [NAME], "from": "generic.osim"});
    request.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
    let Ok(Request::Check(request)) = Request::from_json(request.to_string().as_bytes()) else { panic!() };
    let mut files = files.clone();
    files.add(NAME, text);
    let inspector = Inspector::for_check(&request, &files);
    let opened = open_with(NAME.as_ref(), inspector.set_files.companion_paths(), &files).unwrap();
    let inspected = inspector.inspect(&opened).unwrap();
    inspector.check(&opened.model, &inspected, None, &files)
}

/// The model `text` after the command that moves its spheres.
fn after_command(files: &InMemory, text: &str, found: &CheckResult) -> String {
    let request = find(found, FindingCode::SpheresLeftBehind).remedy.as_ref().unwrap().to_json();
    let request = Request::from_json(request.as_bytes()).unwrap();
    let model = Model::parse(text).unwrap();
    let plan = prepare(request, files).unwrap().plan_alone(&model).unwrap();
    String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap()
}

#[test]
fn spheres_that_were_left_behind_follow_by_the_command() {
    for kind in ["smooth", "hunt_crossley"] {
        let scaled = read(&format!("scaled_{kind}.osim"));
        let files = InMemory::from_iter([
            ("generic.osim", read(&format!("generic_{kind}.osim"))),
            ("set.xml", read("applied_scale_set.xml")),
        ]);
        for more in
            [json!({}), json!({"body_scale_file": "set.xml"}), json!({"stance_limbs": 2, "mass": 60.0})]
        {
            let found = check_beside(&files, &scaled, &more);
            let left = check_beside(&files, &after_command(&files, &scaled, &found), &more);
            assert!(!has(&left, FindingCode::SpheresLeftBehind), "{more}: {left:?}");
        }
    }
}

/// Lowest points that differ by 14 mm, 0.44 R, differ by 0.57 R on feet of 1.3 times the height.
#[test]
fn spheres_follow_also_where_feet_become_more_uneven() {
    let generic = read("generic_smooth.osim").replace(" -0.028000000000000001 ", " -0.014 ");
    let scaled = ["calcn_r", "toes_r", "calcn_l", "toes_l"].iter().fold(generic.clone(), |text, foot| {
        with_text_replaced(&text, &format!("<Body name=\"{foot}\">"), "1.01 1 1.02", "1.01 1.3 1.02")
    });
    let joints = [("001 -0.012 0.002<", "001 -0.0156 0.002<"), ("001 -0.012 -0.002<", "001 -0.0156 -0.002<")];
    let joints = joints.into_iter().chain([("<translation>0.12 -0.01 ", "<translation>0.12 -0.013 ")]);
    let scaled = joints.fold(scaled, |text, (old, new)| text.replace(old, new));
    let files = InMemory::from_iter([("generic.osim", generic)]);
    let found = check_beside(&files, &scaled, &json!({}));
    assert_eq!((found.counts.error, found.counts.warning, found.steps.len()), (1, 0, 1));
    let left = check_beside(&files, &after_command(&files, &scaled, &found), &json!({}));
    assert!(has(&left, FindingCode::UnevenBottoms) && left.counts.error == 0, "{left:?}");
    // It is not called right afterwards.
    assert_eq!(found.corrected, 0);
}

/// Along a wrong gravity, the lowest points would go to wrong places. Once gravity is right, the next check has the command.
#[test]
fn spheres_do_not_follow_along_a_wrong_gravity() {
    let files = InMemory::from_iter([("generic.osim", read("generic_smooth.osim"))]);
    let scaled = read("scaled_smooth.osim");
    for gravity in ["0 9.81 0", "9.81 0 0", "8.4957 -4.905 0", "0 -9810 0", "0 -98.1 0", "0 0 0"] {
        let wrong = scaled.replace("0 -9.8100000000000005 0", gravity);
        let found = check_beside(&files, &wrong, &json!({}));
        assert!(found.steps.is_empty(), "{gravity}: {:?}", found.steps);
        let left = &find(&found, FindingCode::SpheresLeftBehind).message.to_string();
        assert!(left.ends_with("; gravity has to be corrected first"), "{gravity}: {left}");
    }
    assert_eq!(check_beside(&files, &scaled, &json!({})).steps.len(), 1);
}

#[test]
fn heels_that_were_moved_far_down_are_placed_again_by_the_command() {
    let scaled = read("scaled_smooth.osim");
    let low = ["0.005", "-0.005"].into_iter().fold(scaled, |text, side| {
        let heel = format!("<location>-0.01 -0.040000000000000001 {side}");
        assert_eq!(text.matches(&heel).count(), 1);
        text.replace(&heel, &format!("<location>-0.01 -0.16 {side}"))
    });
    let files = InMemory::from_iter([("generic.osim", read("generic_smooth.osim"))]);
    let found = check_beside(&files, &low, &json!({}));
    let Some(Request::Transfer(command)) = &find(&found, FindingCode::SpheresMisplaced).remedy else {
        panic!("{found:?}")
    };
    assert_eq!(command.follow.moved_spheres, Some(MovedChoice::Replace));
    let left = check_beside(&files, &after_command(&files, &low, &found), &json!({}));
    assert!(!has(&left, FindingCode::SpheresMisplaced) && !has(&left, FindingCode::SpheresLeftBehind));
}
