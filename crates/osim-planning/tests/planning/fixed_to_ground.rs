//! Fixed objects: spheres on ground, and spheres on bodies that only WeldJoints connect with ground. They count in no number, and no change
//! moves them.
//!
//! Models get fixed objects at random; everything that is known of them and every change must be as without those. `FIXED_RUNS` says how many
//! models (60), `FIXED_SEED` where to begin (1). A failure says its seed.

use std::path::Path;

use osim_inspect::model_findings;
use osim_model::files::{CompanionPaths, Files, InMemory};
use osim_model::{FileId, FindingCode, Model};
use osim_planning::{check_with_trials, open_with, prepare};
use osim_requests::Request;
use serde_json::{Value, json};

use crate::random::{Random, number_from_environment};

const MODELS: [&str; 4] = [
    "check/within_limits.osim",
    "format/v40000.osim",
    "format/unequal_radii.osim",
    "format/both_classes.osim",
];

/// XML elements of fixed objects, which are added to the sets of a model.
#[derive(Default)]
struct FixedObjects {
    bodies: String,
    joints: String,
    forces: String,
    geometry: String,
}

impl FixedObjects {
    fn of(random: &mut Random) -> Self {
        let mut made = Self::default();
        let mut carriers = vec!["/ground".to_owned()];
        for index in 0..random.integer_below(4) {
            let name = format!("rock_{index}{}", random.one_of(&["", "_r", "_l"]));
            let under = random.integer_below(carriers.len() as u64);
            let under = carriers[usize::try_from(under).unwrap()].clone();
            // Massless, so that the weight of the model stays.
            made.bodies.push_str(&format!("<Body name=\"{name}\"><mass>0</mass></Body>\n"));
            let body = format!("/bodyset/{name}");
            // A joint may be written from either end.
            let (parent, child) =
                if random.integer_below(2) == 0 { (&under, &body) } else { (&body, &under) };
            made.joints.push_str(&format!(
                "<WeldJoint name=\"weld_{index}\"><socket_parent_frame>{parent}</socket_parent_frame>\
                 <socket_child_frame>{child}</socket_child_frame></WeldJoint>\n"
            ));
            carriers.push(body);
        }
        for index in 0..=random.integer_below(3) {
            let carrier = random.integer_below(carriers.len() as u64);
            made.add_sphere(random, index, &carriers[usize::try_from(carrier).unwrap()]);
        }
        made
    }

    fn add_sphere(&mut self, random: &mut Random, index: u64, carrier: &str) {
        let name = format!("boulder_{index}{}", random.one_of(&["", "_r", "_l"]));
        let radius = random.one_of(&["0.3", "0.0325", "nan", "0"]);
        self.geometry.push_str(&format!(
            "<ContactSphere name=\"{name}\"><socket_frame>{carrier}</socket_frame><location>0.5 -9 0</location>\
             <radius>{radius}</radius></ContactSphere>\n"
        ));
        let forces = random.integer_below(3);
        for number in 0..=forces {
            self.forces.push_str(&force(random, &format!("force_{index}_{number}"), &name));
        }
    }

    /// The text of `model` with the fixed objects at the ends of its sets.
    fn inserted_into(&self, model: &str) -> String {
        let mut text = model.to_owned();
        for (set, members) in [
            ("BodySet", &self.bodies),
            ("JointSet", &self.joints),
            ("ForceSet", &self.forces),
            ("ContactGeometrySet", &self.geometry),
        ] {
            let end = text.find(&format!("</{set}>")).unwrap();
            let at = text[..end].rfind("</objects>").unwrap();
            text.insert_str(at, members);
        }
        text
    }
}

/// The XML of a force of either class that presses the sphere on the floor.
fn force(random: &mut Random, name: &str, sphere: &str) -> String {
    if random.integer_below(2) == 0 {
        return format!(
            "<SmoothSphereHalfSpaceForce name=\"{name}\"><socket_sphere>/contactgeometryset/{sphere}</socket_sphere>\
             <socket_half_space>/contactgeometryset/floor</socket_half_space><stiffness>1e6</stiffness>\
             </SmoothSphereHalfSpaceForce>\n"
        );
    }
    format!(
        "<HuntCrossleyForce name=\"{name}\"><HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\"><objects>\
         <HuntCrossleyForce::ContactParameters><geometry>floor {sphere}</geometry><stiffness>1e6</stiffness>\
         </HuntCrossleyForce::ContactParameters></objects></HuntCrossleyForce::ContactParametersSet></HuntCrossleyForce>\n"
    )
}

/// The numbers that `inspect` and `check` give for a model, without the lists of its objects.
fn known_numbers(text: &str) -> Vec<Value> {
    let model = Model::parse(text).unwrap();
    let options = osim_inspect::InspectOptions::default();
    let inspected = options.inspect("model.osim", &model, None);
    let found = check_with_trials(&options, &model, &inspected, &[]);
    // Of the numbers of fixed objects, those that OpenSim cannot use are said, too.
    let of_numbers = [FindingCode::Terrain, FindingCode::NotFinite, FindingCode::OutOfDomain];
    let codes: Vec<&str> = found
        .findings
        .iter()
        .map(|found| found.code())
        .filter(|code| !of_numbers.contains(code))
        .map(FindingCode::as_str)
        .collect();
    let all = serde_json::to_value(&inspected).unwrap();
    let of = |field: &str| all[field].clone();
    let fields = [
        "limbs",
        "spheres_per_limb",
        "limbs_unknown",
        "figures",
        "standing",
        "known_contacts",
        "contacts_mass_kg",
    ];
    fields.into_iter().map(of).chain([json!(codes)]).collect()
}

/// The changes that the request `call` makes in a model, without line numbers, and the new bytes; or why it is refused.
fn changes_and_bytes(call: &Value, text: &str, presets: &InMemory) -> Result<(Value, String), String> {
    let mut files = presets.clone();
    files.add("model.osim", text.as_bytes().to_vec());
    let mut call = call.clone();
    call["models"] = json!(["model.osim"]);
    let request = Request::from_json(call.to_string().as_bytes()).unwrap();
    let change = prepare(request, &files).unwrap();
    let opened = open_with(Path::new("model.osim"), CompanionPaths::default(), &files).unwrap();
    let plan = change.plan_alone(&opened.model).map_err(|fault| fault.to_string())?;
    let changes: Vec<_> = plan
        .changes
        .iter()
        .map(|change| json!([change.path, change.property.as_str(), change.from, change.to]))
        .collect();
    let objects: Vec<_> =
        plan.objects().iter().map(|object| (object.action.as_str(), &object.path)).collect();
    let bytes = plan.patched(&opened.model, FileId::MAIN).unwrap();
    Ok((json!([changes, objects]), String::from_utf8(bytes).unwrap()))
}

fn calls_of_all_verbs() -> Vec<Value> {
    vec![
        json!({"verb": "rescale", "target_mass": 100, "contacts_mass": 61}),
        json!({"verb": "set", "set": {"radius": "x1.5", "stiffness": "x2"}}),
        json!({"verb": "design", "indentation": 0.2, "spheres": 2}),
        json!({"verb": "transfer", "from": "falisse2022", "spheres": 4}),
        json!({"verb": "convert", "to": "smooth"}),
        json!({"verb": "convert", "to": "hunt-crossley"}),
        json!({"verb": "remove"}),
    ]
}

fn text_of(path: &str, files: &InMemory) -> String {
    String::from_utf8(files.read(Path::new(path)).unwrap()).unwrap()
}

#[test]
fn fixed_objects_count_nowhere_and_stay_as_they_are() {
    let files = crate::rules::fixtures();
    let (first, runs) = (number_from_environment("FIXED_SEED", 1), number_from_environment("FIXED_RUNS", 60));
    let mut compared = 0;
    for seed in first..first + runs {
        let mut random = Random::of(seed);
        let bare = text_of(random.one_of(&MODELS), &files);
        let fixed = FixedObjects::of(&mut random);
        let whole = fixed.inserted_into(&bare);
        let said = Model::parse(whole.as_str()).unwrap();
        let terrain =
            model_findings(&said).iter().filter(|finding| finding.code() == FindingCode::Terrain).count();
        assert_eq!(terrain, 1, "seed {seed}: fixed objects are reported once");
        for (plain, with) in known_numbers(&bare).into_iter().zip(known_numbers(&whole)) {
            assert_eq!(plain, with, "seed {seed}\n{whole}");
        }
        for call in calls_of_all_verbs() {
            match (changes_and_bytes(&call, &bare, &files), changes_and_bytes(&call, &whole, &files)) {
                (Ok((plain, _)), Ok((with, bytes))) => {
                    assert_eq!(plain, with, "seed {seed}, {call}");
                    for object in [&fixed.bodies, &fixed.joints, &fixed.forces, &fixed.geometry] {
                        let kept = object.lines().all(|line| bytes.contains(line));
                        assert!(kept, "seed {seed}, {call}: a fixed object was changed\n{bytes}");
                    }
                    compared += 1;
                }
                (plain, with) => assert_eq!(plain.err(), with.err(), "seed {seed}, {call}"),
            }
        }
    }
    assert!(compared > 4 * runs, "{compared}");
}

#[test]
fn contacts_are_not_put_on_what_does_not_move() {
    let mut files = crate::rules::fixtures();
    // A foot that is welded to ground.
    let text = text_of("feet/human_40000.osim", &files);
    let welded = ["FreeJoint", "PinJoint", "CustomJoint"]
        .iter()
        .fold(text, |text, joint| text.replace(joint, "WeldJoint"));
    files.add("model.osim", welded.into_bytes());
    files.add("table.csv", b"name,body,x,y,z,radius\nheel_r,calcn_r,0,0,0,0.03\n".to_vec());
    for numbers in [
        json!({"indentation": 0.3, "spheres": 6}),
        json!({"young": 1e6, "poisson": 0.5, "restitution": 0.5}),
        json!({"from": "falisse2022", "spheres": 6}),
    ] {
        let mut call =
            json!({"verb": "add", "models": ["model.osim"], "contacts": "table.csv", "class": "smooth"});
        call.as_object_mut().unwrap().extend(numbers.as_object().unwrap().clone());
        if numbers["from"].is_string() {
            call.as_object_mut().unwrap().remove("class");
        }
        let request = Request::from_json(call.to_string().as_bytes()).unwrap();
        let change = prepare(request, &files).unwrap_or_else(|error| panic!("{call}: {error:?}"));
        let opened = open_with(Path::new("model.osim"), CompanionPaths::default(), &files).unwrap();
        let failure = change.plan_with_companions(&opened, &files).unwrap_err();
        let said = format!("{failure:?}");
        assert!(said.contains("only WeldJoints are between body calcn_r and ground"), "{call}: {said}");
    }
}
