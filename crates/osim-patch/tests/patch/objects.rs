//! Tests of contacts that are added to a model and removed again.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::{FileId, ForceKind, Model, Property, Scope, Selected, Selection};
use osim_patch::{ContactLayout, NewContact, Plan, add_contacts, note_of_remaining, remove};

/// The sets of models without contacts, in every form in which files have them.
const SETS_TO_FILL: [&str; 12] = [
    "",
    "\n\t\t<ForceSet>\n\t\t\t<objects/>\n\t\t</ForceSet>\n\t\t<ContactGeometrySet>\n\t\t\t<objects />\n\t\t</ContactGeometrySet>",
    "\n\t\t<ForceSet name=\"forceset\"/>\n\t\t<ContactGeometrySet name=\"c\" />",
    "\n\t\t<ForceSet>\n\t\t\t<groups/>\n\t\t</ForceSet>\n\t\t<ContactGeometrySet></ContactGeometrySet>",
    "\n\t\t<ForceSet>\n\t\t\t<objects></objects>\n\t\t\t<groups/>\n\t\t</ForceSet>\n\t\t<ContactGeometrySet>\n\t\t</ContactGeometrySet>",
    "\n\t\t<ForceSet>\n\t\t\t<objects>\n\t\t\t</objects>\n\t\t</ForceSet>\n\t\t<ContactGeometrySet>\n\t\t\t<objects>\n\n\t\t\t</objects>\n\t\t</ContactGeometrySet>",
    "\n\t\t<ForceSet>\n\t\t\t<objects>\n\t\t\t\t<CoordinateLimitForce name=\"k\">\n\t\t\t\t\t<coordinate>q</coordinate>\n\t\t\t\t</CoordinateLimitForce>\n\t\t\t</objects>\n\t\t</ForceSet>",
    "\n\t\t<ForceSet><objects><CoordinateLimitForce name=\"k\"/></objects></ForceSet>",
    "\n\t\t<ForceSet>\n\t\t\t<objects>\n\t\t\t\t<!--none-->\n\t\t\t</objects>\n\t\t</ForceSet>",
    "\n\t\t<ForceSet>\n\t\t\t<objects>\n\t\t\t\t<CoordinateLimitForce name=\"k\"/> <!--about k-->\n\t\t\t</objects>\n\t\t</ForceSet>",
    "\n\t\t<MarkerSet>\n\t\t\t<objects/>\n\t\t</MarkerSet>",
    "<ForceSet><objects/></ForceSet><ForceSet><objects/></ForceSet>",
];

fn document_with_sets(version: u32, sets: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<OpenSimDocument Version=\"{version}\">\n\t<Model name=\"leg\">\n\t\t<BodySet>\n\t\t\t<objects>\n\
         \t\t\t\t<Body name=\"foot_r\">\n\t\t\t\t\t<mass>1</mass>\n\t\t\t\t</Body>\n\t\t\t</objects>\n\t\t</BodySet>{sets}\n\t</Model>\n\
         </OpenSimDocument>\n"
    )
}

fn layout_of_kind(kind: ForceKind) -> ContactLayout {
    let mut layout = ContactLayout::default();
    for (name, x) in [("heel", 0.0), ("toe", 0.2)] {
        let mut contact = NewContact::new(kind, format!("force_{name}"), name);
        contact.body = "foot_r".into();
        contact.location_m = [x, -0.01, 0.5e-3];
        contact.radius_m = 0.03;
        contact.values =
            vec![(Property::Stiffness, 1e6), (Property::Dissipation, 2.0), (Property::StaticFriction, 0.8)];
        layout.contacts.push(contact);
    }
    layout
}

#[test]
fn added_contacts_are_read_with_the_wanted_values() {
    for version in [20302, 30000, 30505, 40000] {
        for kind in [ForceKind::SmoothSphereHalfSpace, ForceKind::HuntCrossley] {
            for sets in SETS_TO_FILL {
                let model = Model::parse(document_with_sets(version, sets)).unwrap();
                let rebuilt = add_contacts(&model, &mut layout_of_kind(kind)).unwrap();
                let built = rebuilt.model();
                assert_eq!(built.forces().len(), 2, "{version} {sets}");
                let selected = Selection::default().apply(built).unwrap();
                let read = ContactLayout::of(built, &selected).unwrap();
                let wanted = layout_of_kind(kind);
                assert_eq!(read.floor, "floor");
                for (read, wanted) in read.contacts.iter().zip(&wanted.contacts) {
                    let own = |contact: &NewContact| {
                        (
                            contact.force.clone(),
                            contact.sphere.clone(),
                            contact.body.clone(),
                            contact.location_m,
                            contact.radius_m,
                            contact.kind,
                        )
                    };
                    assert_eq!(own(read), own(wanted));
                    assert!(wanted.values.iter().all(|value| read.values.contains(value)));
                }
            }
        }
    }
}

#[test]
fn defaults_do_not_change_added_contacts() {
    for (version, off) in [
        (40000, "<appliesForce>false</appliesForce>"),
        (30000, "<appliesForce>false</appliesForce>"),
        (30000, "<isDisabled>true</isDisabled>"),
    ] {
        for kind in [ForceKind::SmoothSphereHalfSpace, ForceKind::HuntCrossley] {
            // A layout says which values it wants; the others are those of the class.
            let numbers = "<viscous_friction>0.9</viscous_friction><transition_velocity>0.3</transition_velocity>\
                           <hertz_smoothing>7</hertz_smoothing>";
            let text = format!(
                "<defaults><{0} name=\"default\">{off}{numbers}</{0}><HuntCrossleyForce::ContactParameters>{numbers}\
                 </HuntCrossleyForce::ContactParameters><ContactSphere><location>1 2 3</location><radius>4</radius>\
                 </ContactSphere></defaults>",
                kind.as_str()
            );
            let text = document_with_sets(version, "")
                .replace("<Model name=\"leg\">", &format!("<Model name=\"leg\">{text}"));
            let model = Model::parse(text).unwrap();
            let rebuilt = add_contacts(&model, &mut layout_of_kind(kind)).unwrap();
            for force in rebuilt.model().forces() {
                let own = |property| force.checked(osim_model::SetId::FIRST, property).unwrap();
                assert!(force.applies, "{version} {off}");
                assert_eq!(
                    (own(Property::ViscousFriction), own(Property::TransitionVelocity)),
                    (Some(0.0), Some(0.01))
                );
                let smoothing = (kind == ForceKind::SmoothSphereHalfSpace).then_some(300.0);
                assert_eq!(own(Property::HertzSmoothing), smoothing);
            }
        }
    }
}

#[test]
fn removing_added_contacts_restores_the_file() {
    for sets in SETS_TO_FILL {
        let text = document_with_sets(40000, sets);
        let model = Model::parse(text.clone()).unwrap();
        let rebuilt = add_contacts(&model, &mut layout_of_kind(ForceKind::SmoothSphereHalfSpace)).unwrap();
        let plan = osim_patch::note(rebuilt.model(), 62.0, Some(9.81), None).unwrap().attach_to(rebuilt);
        let added = plan.patched(&model, FileId::MAIN).unwrap();
        let with = Model::parse(added.clone()).unwrap();
        let selected = Selection::default().apply(&with).unwrap();
        let without = remove(&with, &selected, &[]).unwrap();
        let bytes = without.model().document().bytes();
        assert_eq!(String::from_utf8_lossy(bytes), text, "{}", String::from_utf8_lossy(&added));
    }
}

#[test]
fn added_contacts_can_be_removed_in_two_parts() {
    for (sets, kind) in SETS_TO_FILL
        .into_iter()
        .flat_map(|sets| [ForceKind::SmoothSphereHalfSpace, ForceKind::HuntCrossley].map(|kind| (sets, kind)))
    {
        let text = document_with_sets(40000, sets);
        let model = Model::parse(text.clone()).unwrap();
        let rebuilt = add_contacts(&model, &mut layout_of_kind(kind)).unwrap();
        let plan = osim_patch::note(rebuilt.model(), 62.0, Some(9.81), None).unwrap().attach_to(rebuilt);
        let with = Model::parse(plan.patched(&model, FileId::MAIN).unwrap()).unwrap();
        let made = with.note.clone().unwrap().added_to_file;

        let half = Model::parse(after_removal(&with, &["force_heel"])).unwrap();
        let note = half.note.clone().unwrap();
        assert_eq!(
            (note.contacts_mass_kg, note.gravity_m_s2, note.scope),
            (Some(62.0), Some(9.81), Scope::Partial)
        );
        assert_eq!(note.added_to_file, made);
        assert_eq!(half.doubt_about_note(), Some(osim_model::NoteDoubt::Partial));

        let none = after_removal(&half, &[]);
        assert_eq!(String::from_utf8_lossy(&none), text);
    }
}

/// The bytes of a file after [`remove`] and the edits of its note, without the forces `names`; without all forces if `names` is
/// empty.
fn after_removal(model: &Model, names: &[&str]) -> Vec<u8> {
    let wanted = |force: &osim_model::Force| names.is_empty() || names.contains(&force.name.as_str());
    let rebuilt = remove(model, &Selected::matching(model, wanted), &[]).unwrap();
    let note = note_of_remaining(model, &rebuilt);
    Plan::from_objects(rebuilt, "".into()).with_note(note).patched(model, FileId::MAIN).unwrap()
}

#[test]
fn a_note_in_doubt_stays_in_doubt_after_a_removal() {
    let model = Model::parse(document_with_sets(40000, "")).unwrap();
    let rebuilt = add_contacts(&model, &mut layout_of_kind(ForceKind::SmoothSphereHalfSpace)).unwrap();
    let plan = osim_patch::note(rebuilt.model(), 62.0, Some(9.81), None).unwrap().attach_to(rebuilt);
    let with = String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap();
    let edited = Model::parse(with.replacen("<stiffness>1000000<", "<stiffness>1100000<", 1)).unwrap();
    let half = Model::parse(after_removal(&edited, &["force_toe"])).unwrap();
    assert_eq!(half.doubt_about_note(), Some(osim_model::NoteDoubt::ValuesChanged));
    assert_eq!(String::from_utf8_lossy(&after_removal(&half, &[])), document_with_sets(40000, ""));
}

/// A floor that the program added is removed once; a user's floor that is later at the same place in the file stays.
#[test]
fn a_users_floor_is_not_taken_for_an_added_floor() {
    let model = Model::parse(document_with_sets(40000, "")).unwrap();
    let rebuilt = add_contacts(&model, &mut layout_of_kind(ForceKind::SmoothSphereHalfSpace)).unwrap();
    let plan = osim_patch::note(rebuilt.model(), 62.0, Some(9.81), None).unwrap().attach_to(rebuilt);
    let with = String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap();
    let floor = with.split_once("<ContactHalfSpace").unwrap().1.split_once("</ContactHalfSpace>").unwrap().0;
    let own = format!(
        "<ContactHalfSpace{floor}</ContactHalfSpace><ContactHalfSpace{}</ContactHalfSpace>",
        floor.replace("\"floor\"", "\"plate\"")
    );
    let with = with.replace(&format!("<ContactHalfSpace{floor}</ContactHalfSpace>"), &own);
    // The second force stands on the user's plate.
    let at = with.rfind("/contactgeometryset/floor<").unwrap();
    let with = format!("{}{}", &with[..at], with[at..].replacen("/floor<", "/plate<", 1));
    let half = Model::parse(after_removal(&Model::parse(with).unwrap(), &["force_heel"])).unwrap();
    assert_eq!(half.half_spaces().iter().map(|plane| plane.name.clone()).collect::<Vec<_>>(), ["plate"]);
    let none = Model::parse(after_removal(&half, &[])).unwrap();
    assert_eq!(none.half_spaces().len(), 1);
}

const OLD_NOTE: &str = "[contacts made for 12 kg at 9.8 m/s2 (osim-contact-scale 0.0.9; all; by add; sizes none; \
                   record 0000000000000000 00000000 00000000 1:00000000 1:00000000 0000.-.-.-.-.-.-.-.-; made fgOhc)]";

/// If another program removes contacts, their note stays in the file and is about no contact any more.
#[test]
fn a_removal_restores_the_old_note() {
    for credits in [
        format!("<credits>A; {OLD_NOTE}</credits>"),
        format!("<credits>{OLD_NOTE}</credits>"),
        format!("<credits>A {OLD_NOTE} tail</credits>"),
        format!("<credits><![CDATA[A & B; {OLD_NOTE}]]></credits>"),
        format!("<credits>A;\n {}\n</credits>", OLD_NOTE.replace(' ', "\n\t")),
    ] {
        for sets in SETS_TO_FILL {
            let text = document_with_sets(40000, sets)
                .replace("<Model name=\"leg\">", &format!("<Model name=\"leg\">{credits}"));
            let model = Model::parse(text.clone()).unwrap();
            let rebuilt =
                add_contacts(&model, &mut layout_of_kind(ForceKind::SmoothSphereHalfSpace)).unwrap();
            let plan = osim_patch::note(rebuilt.model(), 62.0, Some(9.81), None).unwrap().attach_to(rebuilt);
            let with = Model::parse(plan.patched(&model, FileId::MAIN).unwrap()).unwrap();
            assert_eq!(
                with.note.as_ref().and_then(|note| note.contacts_mass_kg),
                Some(62.0),
                "the new one counts"
            );
            assert_eq!(with.doubt_about_note(), None);
            // A change in between replaces the new one alone.
            let plan = osim_patch::note(&with, 70.0, Some(9.81), None).unwrap();
            let noted = Model::parse(plan.patched(&with, FileId::MAIN).unwrap()).unwrap();
            assert_eq!(noted.note.as_ref().and_then(|note| note.contacts_mass_kg), Some(70.0));
            for with in [with, noted] {
                assert_eq!(String::from_utf8_lossy(&after_removal(&with, &[])), text);
            }
        }
    }
}

/// Objects refer to the spheres named in `<defaults>` if they name none themselves; the remaining objects keep their spheres.
#[test]
fn defaults_that_name_a_sphere_do_not_prevent_a_removal() {
    let parameters = "<HuntCrossleyForce::ContactParametersSet name=\"contact_parameters\"><objects><HuntCrossleyForce::ContactParameters>\
                      <geometry>heel floor</geometry><stiffness>1</stiffness></HuntCrossleyForce::ContactParameters></objects>\
                      </HuntCrossleyForce::ContactParametersSet>";
    let defaults = format!(
        "<defaults><HuntCrossleyForce name=\"default\">{parameters}</HuntCrossleyForce><SmoothSphereHalfSpaceForce>\
         <socket_sphere>/contactgeometryset/heel</socket_sphere></SmoothSphereHalfSpaceForce></defaults>"
    );
    let text = document_with_sets(40000, "")
        .replace("<Model name=\"leg\">", &format!("<Model name=\"leg\">{defaults}"));
    let model = Model::parse(text.clone()).unwrap();
    let rebuilt = add_contacts(&model, &mut layout_of_kind(ForceKind::HuntCrossley)).unwrap();
    let plan = osim_patch::note(rebuilt.model(), 62.0, Some(9.81), None).unwrap().attach_to(rebuilt);
    let with = String::from_utf8(plan.patched(&model, FileId::MAIN).unwrap()).unwrap();
    assert_eq!(String::from_utf8_lossy(&after_removal(&Model::parse(with.clone()).unwrap(), &[])), text);

    // A force that has its parameters from there needs the sphere.
    let relies = with.replacen(
        "<HuntCrossleyForce name=\"force_heel\">",
        "<HuntCrossleyForce name=\"relies\"/><HuntCrossleyForce name=\"force_heel\">",
        1,
    );
    let left =
        Model::parse(after_removal(&Model::parse(relies).unwrap(), &["force_heel", "force_toe"])).unwrap();
    assert_eq!(left.spheres().iter().map(|sphere| sphere.name.as_str()).collect::<Vec<_>>(), ["heel"]);
    assert_eq!(left.half_spaces().len(), 1);
}

#[test]
fn defaults_of_an_unread_class_are_refused_with_advice() {
    let other =
        "<defaults><ElasticFoundationForce><geometry>heel</geometry></ElasticFoundationForce></defaults>";
    let model = Model::parse(document_with_sets(40000, "")).unwrap();
    let added = add_contacts(&model, &mut layout_of_kind(ForceKind::HuntCrossley)).unwrap();
    let text = String::from_utf8(added.model().document().bytes().to_vec()).unwrap();
    let model =
        Model::parse(text.replace("<Model name=\"leg\">", &format!("<Model name=\"leg\">{other}"))).unwrap();
    let fault = remove(&model, &Selected::matching(&model, |_| true), &[]).unwrap_err().to_string();
    assert!(fault.contains("in <defaults> uses heel") && fault.contains("text editor"), "{fault}");
}

/// A new object does not get a name that some text of the file uses, even if no object has this name.
#[test]
fn new_objects_have_names_that_nothing_uses() {
    let other = "<ForceSet><objects><ElasticFoundationForce name=\"e\"><ElasticFoundationForce::ContactParametersSet \
                 name=\"contact_parameters\"><objects><ElasticFoundationForce::ContactParameters><geometry>heel</geometry>\
                 </ElasticFoundationForce::ContactParameters></objects></ElasticFoundationForce::ContactParametersSet>\
                 </ElasticFoundationForce></objects></ForceSet>";
    let text = document_with_sets(40000, other);
    let model = Model::parse(text.clone()).unwrap();
    let added = add_contacts(&model, &mut layout_of_kind(ForceKind::HuntCrossley)).unwrap();
    let names: Vec<&str> = added.model().spheres().iter().map(|sphere| sphere.name.as_str()).collect();
    assert_eq!(names, ["heel_2", "toe"]);
    let plan = osim_patch::note(added.model(), 62.0, Some(9.81), None).unwrap().attach_to(added);
    let with = Model::parse(plan.patched(&model, FileId::MAIN).unwrap()).unwrap();
    assert_eq!(String::from_utf8_lossy(&after_removal(&with, &[])), text);
}
