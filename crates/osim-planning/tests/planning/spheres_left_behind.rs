//! Spheres that stayed at their places when bodies were scaled follow their bodies by the proposed command.

use std::path::Path;

use osim_model::files::InMemory;
use osim_model::{FileId, FindingCode, Model};
use osim_planning::{Inspector, open_with, prepare};
use osim_requests::Request;
use serde_json::json;

const NAME: &str = "model.osim";

#[test]
fn spheres_that_were_left_behind_follow_by_the_command() {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/scale_tool");
    let read = |name: &str| std::fs::read_to_string(fixtures.join(name)).unwrap();
    for kind in ["smooth", "hunt_crossley"] {
        let (generic, scaled) = (read(&format!("generic_{kind}.osim")), read(&format!("scaled_{kind}.osim")));
        let scale_set = read("applied_scale_set.xml");
        let mut files = InMemory::default();
        files.add("generic.osim", generic.into_bytes());
        files.add("set.xml", scale_set.into_bytes());
        for more in
            [json!({}), json!({"body_scale_file": "set.xml"}), json!({"stance_limbs": 2, "mass": 60.0})]
        {
            let mut request = json!({"verb": "check", "models": [NAME], "from": "generic.osim"});
            request.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
            let Ok(Request::Check(request)) = Request::from_json(request.to_string().as_bytes()) else {
                panic!()
            };
            let check = |text: &[u8]| {
                let mut files = files.clone();
                files.add(NAME, text.to_vec());
                let inspector = Inspector::for_check(&request, &files);
                let opened = open_with(NAME.as_ref(), inspector.set_files.companion_paths(), &files).unwrap();
                let inspected = inspector.inspect(&opened).unwrap();
                inspector.check(&opened.model, &inspected, None, &files)
            };
            let found = check(scaled.as_bytes());
            let behind =
                found.findings.iter().find(|one| one.code() == FindingCode::SpheresLeftBehind).unwrap();
            let request = behind.remedy.as_ref().unwrap();
            let request = Request::from_json(request.to_json().as_bytes()).unwrap();
            let change = prepare(request, &files).unwrap();
            let model = Model::parse(scaled.as_str()).unwrap();
            let changed = change.plan_alone(&model).unwrap().patched(&model, FileId::MAIN).unwrap();
            let left = check(&changed);
            assert!(
                left.findings.iter().all(|one| one.code() != FindingCode::SpheresLeftBehind),
                "{more}: {left:?}"
            );
        }
    }
}
