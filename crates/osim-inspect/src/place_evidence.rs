//! Evidence in one model file about the places of its spheres: its note, published layouts of spheres, and how far spheres reach.

use std::collections::BTreeSet;

use osim_model::{
    CountedSpheres, MassRequest, Model, ScaledSinceNote, SphereId, are_equal_masses, has_word, without_side,
};

use crate::body_bones::{BodyBones, same_size};
use crate::known_contacts::KnownContacts;
use crate::load::LoadSharing;
use crate::published_layouts::{LayoutMatch, find_layout, find_mirrored_layout};
use crate::reach::{Reach, reaches};

/// The evidence in a model's file about the places of its spheres: right, wrong, or not known.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum PlaceEvidence {
    /// The note shows that bodies were scaled after it was written, and that the spheres stayed at their places.
    ScaledSinceNote(ScaledSinceNote),
    /// The places of the spheres are those of a published layout, but the bones have another size than in the publication.
    OtherSize(LayoutMatch),
    /// The spheres of each foot have the places that a published layout has on the other foot; the title of the layout.
    Mirrored(&'static str),
    /// No foot of the model has spheres, but other bodies have; the names of these bodies.
    NotOnFeet(Vec<String>),
    /// Some spheres reach further along the foot than spheres of published models; the reaches of these spheres.
    FarReach(Vec<Reach>),
    /// The note, or a published layout on bones of its size, shows that the spheres are at the right places.
    Right,
    /// Nothing in the file shows that bones were scaled.
    Unscaled,
    /// Bones were scaled, and nothing shows whether the spheres were moved with them.
    Unknown,
}

impl PlaceEvidence {
    /// The evidence in `model`. `noted` is what the note says about sizes of bodies, if there is such a note.
    pub(crate) fn of(model: &Model, noted: Option<ScaledSinceNote>) -> Self {
        let bones = BodyBones::of(model);
        // Also before a note, which only says that spheres are where somebody put them.
        if let Some(title) = bones.and_then(|bones| find_mirrored_layout(model, bones)) {
            return Self::Mirrored(title);
        }
        if let Some(bodies) = bones.and_then(|bones| bodies_beside_feet(model, bones)) {
            return Self::NotOnFeet(bodies);
        }
        if let Some(noted) = noted {
            return if noted.spheres_left_behind { Self::ScaledSinceNote(noted) } else { Self::Right };
        }
        let Some(bones) = bones else { return Self::Unscaled };
        if let Some(layout) = find_layout(model, bones) {
            let is_published = matches!(layout, LayoutMatch::AsPublished { .. });
            return if is_published { Self::Right } else { Self::OtherSize(layout) };
        }
        // A sphere that is odd in several measures is named once.
        let (mut far, mut named) = (reaches(model, bones), BTreeSet::new());
        far.retain(|one| one.is_odd() && named.insert(one.sphere));
        if !far.is_empty() {
            return Self::FarReach(far);
        }
        if are_feet_scaled(model) == Some(true) { Self::Unknown } else { Self::Unscaled }
    }

    /// Whether the spheres are at wrong places. Other corrections wait until the spheres are moved.
    pub(crate) fn is_wrong(&self) -> bool {
        !matches!(self, Self::Right | Self::Unscaled | Self::Unknown)
    }

    /// Whether the spheres are known to be at the right places.
    pub(crate) fn is_right(&self) -> bool {
        matches!(self, Self::Right)
    }
}

/// What one model shows about whether it was scaled, to distinguish a scaled model from its original.
#[derive(Debug, Clone, Copy, Default)]
pub struct SignsOfScaling {
    /// Whether its published contacts are for its mass, and nothing shows that they are at wrong places; `None` if this shows nothing.
    fits_contacts: Option<bool>,
    /// Whether the meshes of its feet are scaled, if they have meshes.
    has_scaled_feet: Option<bool>,
}

impl SignsOfScaling {
    /// The signs of `model`, whose mass follows from `masses`.
    pub fn of(model: &Model, masses: &MassRequest) -> Self {
        let (forces, kg) = (model.force_ids(), masses.model_mass(model).ok().map(|mass| mass.kg));
        let count = LoadSharing::of(model, &forces).count(None, 1.0, CountedSpheres::Model).ok();
        let known = KnownContacts::find(model, &forces, count, kg);
        let fits_contacts = known.zip(kg).and_then(|(known, kg)| {
            let has_mass = known.is_published_under_other_body() || are_equal_masses(known.made_for_kg, kg);
            // Contacts that this program has scaled have the mass of any body.
            let is_sign = !has_mass || model.note.is_none();
            is_sign.then(|| has_mass && !PlaceEvidence::of(model, None).is_wrong())
        });
        Self { fits_contacts, has_scaled_feet: are_feet_scaled(model) }
    }

    /// Why the model with these signs is the original of the one with the signs `original`, which was given as its original; `None` if
    /// nothing shows this.
    pub fn why_exchanged(self, original: Self) -> Option<&'static str> {
        let contacts = (self.fits_contacts, original.fits_contacts);
        let feet = (self.has_scaled_feet, original.has_scaled_feet);
        // A scaled copy can by chance weigh what its contacts were published for.
        if contacts == (Some(true), Some(false)) && feet != (Some(true), Some(false)) {
            return Some(CONTACTS_ARE_EXCHANGED);
        }
        let why =
            "the bones of the other one are scaled, and those of this model are not: the two are swapped";
        (feet == (Some(false), Some(true))).then_some(why)
    }
}

/// Why a model is the original of the one that was given as its original.
pub const CONTACTS_ARE_EXCHANGED: &str =
    "the contacts of this model fit its body, and those of the other one do not: the two are swapped";

/// Whether the meshes of a foot with spheres are scaled; `None` if no foot with spheres has meshes of a known size.
fn are_feet_scaled(model: &Model) -> Option<bool> {
    let bones = BodyBones::of(model)?;
    let carriers = model.loaded_spheres(&model.force_ids());
    let bodies = carriers.iter().filter_map(|&id| model.sphere(id)?.body.as_deref());
    // Only feet count: meshes of balls and blocks are stretched to their size.
    let feet = bodies.filter(|body| bones.is_foot(body));
    let is_unit = |size| (-6..=3).any(|exponent| same_size(size, [10_f64.powi(exponent); 3]));
    feet.filter_map(|body| bones.size(body)).map(|size| !is_unit(size)).reduce(|a, b| a || b)
}

/// The bodies that have spheres and do not belong to a foot, if no calcaneus of the model has spheres, or, in a model without calcaneus, no
/// foot.
fn bodies_beside_feet(model: &Model, bones: &BodyBones) -> Option<Vec<String>> {
    let spheres = model.loaded_spheres(&model.force_ids());
    let bodies: BTreeSet<&str> = spheres.iter().filter_map(|&id| model.sphere(id)?.body.as_deref()).collect();
    let has_calcaneus = model.bodies().iter().any(|body| has_word(&body.name, "calc"));
    // Animals stand on a manus, too.
    let is_any_foot = |body: &str| bones.is_foot(body) || has_word(body, "manus");
    let is_foot = |body: &&str| if has_calcaneus { has_word(body, "calc") } else { is_any_foot(body) };
    if bodies.iter().any(is_foot) || !bones.has_feet() {
        return None;
    }
    // A ball has no feet. The talus is above the ground, between shank and calcaneus.
    let is_of_skeleton = |body: &str| bones.joint_above(body).is_some() || bones.has_foot_below(body);
    // A shoe has the spheres of its foot. What is named after its body, such as a palm on a hand, is meant to be there.
    let is_meant = |body: &str| bones.is_worn_by_foot(body) || are_named_after(model, &spheres, body);
    let is_of_other_bone = |body: &str| !bones.is_foot(body) || has_word(body, "talus");
    let is_beside = |body: &&str| is_of_skeleton(body) && is_of_other_bone(body) && !is_meant(body);
    let beside: Vec<String> = bodies.into_iter().filter(is_beside).map(str::to_owned).collect();
    (!beside.is_empty()).then_some(beside)
}

/// Whether all of `spheres` that are on `body` have its name, without the side, in their own names.
fn are_named_after(model: &Model, spheres: &[SphereId], body: &str) -> bool {
    let part = without_side(body).replace('#', "");
    let part = part.trim_matches('_');
    let on_body = spheres.iter().filter_map(|&id| model.sphere(id));
    let mut on_body = on_body.filter(|sphere| sphere.body.as_deref() == Some(body));
    !part.is_empty() && on_body.all(|sphere| sphere.name.to_lowercase().contains(part))
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;

    /// Models of the corpus that have contacts, with their names.
    fn corpus_models_with_contacts() -> Vec<(String, Model)> {
        let Some(folder) =
            std::env::var_os("OSIM_CORPUS").map(PathBuf::from).filter(|folder| folder.is_dir())
        else {
            eprintln!(
                "skipped: evidence of published models: OSIM_CORPUS is not set to the folder of real models"
            );
            return Vec::new();
        };
        let mut paths: Vec<PathBuf> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        paths.retain(|path| path.extension().is_some_and(|end| end == "osim"));
        paths.sort();
        let read = |path: &PathBuf| {
            let model = Model::parse(std::fs::read(path).unwrap()).ok()?;
            let name = path.file_stem().unwrap().to_string_lossy().into_owned();
            (!model.loaded_spheres(&model.force_ids()).is_empty()).then_some((name, model))
        };
        let models: Vec<_> = paths.iter().filter_map(read).collect();
        assert!(models.len() >= 15, "{} models with contacts", models.len());
        models
    }

    #[test]
    fn spheres_of_published_models_are_not_reported() {
        for (name, model) in corpus_models_with_contacts() {
            let evidence = PlaceEvidence::of(&model, None);
            assert!(!evidence.is_wrong(), "{name}: {evidence:?}");
            assert_ne!(
                evidence,
                PlaceEvidence::Unknown,
                "{name}: its layout is in the table, or its bones are not scaled"
            );
        }
    }

    /// The model with four foot segments has the spheres of the one with three, and another mesh of the calcaneus: 1.0241 1.2 1.147.
    #[test]
    fn the_published_model_with_four_foot_segments_is_not_reported() {
        let Some(folder) = std::env::var_os("OSIM_CORPUS").map(PathBuf::from) else {
            eprintln!("skipped: four foot segments: OSIM_CORPUS is not set to the folder of real models");
            return;
        };
        let text = std::fs::read_to_string(folder.join("v40000_dhondt_2024_3seg_human.osim")).unwrap();
        let size = "1.0458972284474237 1.4293941749999999 0.99789000000000005";
        assert!(text.contains(size));
        let model = Model::parse(text.replace(size, "1.0241 1.2 1.147")).unwrap();
        assert_eq!(PlaceEvidence::of(&model, None), PlaceEvidence::Right);
    }

    const FALISSE: &str = include_str!("../../../fixtures/check/known_contacts.osim");

    /// The model `text` with the sign of z reversed in the place of each sphere.
    fn mirrored(text: &str) -> String {
        let with_opposite_z = |part: &str| {
            let start = part.find("<location>").unwrap() + "<location>".len();
            let end = start + part[start..].find('<').unwrap();
            let [x, y, z] = *part[start..end].split(' ').collect::<Vec<_>>() else { panic!("{part}") };
            let z: f64 = z.parse().unwrap();
            format!("{}{x} {y} {}{}", &part[..start], -z, &part[end..])
        };
        let mut parts = text.split("<ContactSphere ");
        let first = parts.next().unwrap().to_owned();
        parts.fold(first, |text, part| format!("{text}<ContactSphere {}", with_opposite_z(part)))
    }

    #[test]
    fn feet_with_the_places_of_the_other_foot_are_reported() {
        let evidence = |text: &str| PlaceEvidence::of(&Model::parse(text).unwrap(), None);
        assert_eq!(evidence(FALISSE), PlaceEvidence::Right);
        let swapped = mirrored(FALISSE);
        assert_eq!(evidence(&swapped), PlaceEvidence::Mirrored("Falisse et al. (2022)"));
        assert_eq!(evidence(&mirrored(&swapped)), PlaceEvidence::Right);
        // Also on bones of another size.
        let grown = swapped.replace("0.913924 0.913924 0.913924", "0.8 0.8 0.8");
        assert_eq!(evidence(&grown), PlaceEvidence::Mirrored("Falisse et al. (2022)"));
    }

    #[test]
    fn spheres_on_the_body_that_carries_the_feet_are_reported() {
        let (skeleton, spheres) = FALISSE.split_once("<ContactGeometrySet").unwrap();
        let feet = ["calcn_r", "toes_r", "calcn_l", "toes_l"];
        let all_on = |place: &str| {
            let moved = feet.iter().fold(spheres.to_owned(), |text, foot| {
                text.replace(&format!("/bodyset/{foot}"), &format!("/bodyset/{place}"))
            });
            PlaceEvidence::of(&Model::parse(format!("{skeleton}<ContactGeometrySet{moved}")).unwrap(), None)
        };
        assert_eq!(all_on("pelvis"), PlaceEvidence::NotOnFeet(vec!["pelvis".to_owned()]));
        // A ball without feet, in a scene with a skeleton, is none of its bodies.
        let ball = r#"<Body name="ball"><mass>0.4</mass></Body><Body name="pelvis">"#;
        let joint = r#"<FreeJoint name="free"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/ball</socket_child_frame></FreeJoint><FreeJoint name="ground_pelvis">"#;
        let with_ball = skeleton
            .replace(r#"<Body name="pelvis">"#, ball)
            .replace(r#"<FreeJoint name="ground_pelvis">"#, joint);
        let on_ball = feet.iter().fold(spheres.to_owned(), |text, foot| {
            text.replace(&format!("/bodyset/{foot}"), "/bodyset/ball")
        });
        let model = Model::parse(format!("{with_ball}<ContactGeometrySet{on_ball}")).unwrap();
        assert!(!matches!(PlaceEvidence::of(&model, None), PlaceEvidence::NotOnFeet(_)));
    }

    #[test]
    fn an_animal_may_have_contacts_under_its_fore_feet_alone() {
        let horse = include_str!("../../../fixtures/table1/horse_hunt_crossley.osim");
        let text = ["r", "l"].iter().fold(horse.to_owned(), |text, side| {
            let start = format!("<HuntCrossleyForce name=\"contact_foot_hind_{side}\">");
            let (before, force) = text.split_once(&start).unwrap();
            format!("{before}{}", force.split_once("</HuntCrossleyForce>").unwrap().1)
        });
        let evidence = PlaceEvidence::of(&Model::parse(text).unwrap(), None);
        assert!(!evidence.is_wrong(), "{evidence:?}");
    }

    #[test]
    fn spheres_on_shoes_and_spheres_named_after_their_body_are_meant_to_be_there() {
        let all_on = |part: &str, parent: &str, spheres: &str| {
            let body = |side| format!(r#"<Body name="{part}_{side}"><mass>0.3</mass></Body>"#);
            let joint = |side| {
                let frame = format!("<socket_parent_frame>/bodyset/{parent}</socket_parent_frame>");
                let frame = frame.replace("SIDE", side);
                format!(
                    r#"<WeldJoint name="{part}_{side}">{frame}<socket_child_frame>/bodyset/{part}_{side}</socket_child_frame></WeldJoint>"#
                )
            };
            let (skeleton, places) = FALISSE.split_once("<ContactGeometrySet").unwrap();
            let feet = ["calcn", "toes"].into_iter().map(|foot| format!("/bodyset/{foot}_"));
            let places =
                feet.fold(places.to_owned(), |text, foot| text.replace(&foot, &format!("/bodyset/{part}_")));
            let text = format!("{skeleton}<ContactGeometrySet{places}")
                .replace(
                    r#"<Body name="pelvis">"#,
                    &format!("{}{}<Body name=\"pelvis\">", body("r"), body("l")),
                )
                .replace(
                    "<PinJoint name=\"leg_r\">",
                    &format!("{}{}<PinJoint name=\"leg_r\">", joint("r"), joint("l")),
                )
                .replace("ContactSphere name=\"s", &format!("ContactSphere name=\"{spheres}"))
                .replace("/contactgeometryset/s", &format!("/contactgeometryset/{spheres}"));
            matches!(PlaceEvidence::of(&Model::parse(text).unwrap(), None), PlaceEvidence::NotOnFeet(_))
        };
        assert!(!all_on("shoe", "calcn_SIDE", "s"));
        assert!(!all_on("hand", "pelvis", "hand_"));
        assert!(all_on("hand", "pelvis", "s"));
    }
}
