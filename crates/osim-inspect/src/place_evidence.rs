//! Evidence in one model file about the places of its spheres: its note, published layouts of spheres, and how far spheres reach.

use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use osim_model::{Model, ScaledSinceNote, SphereId, rounding_of_places_m, without_side};
use serde::Deserialize;
use sha2::{Digest, Sha256};

use crate::reach::{BodyBones, Reach, reaches, same_size};

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
            return if noted.is_scaled() { Self::ScaledSinceNote(noted) } else { Self::Right };
        }
        let Some(bones) = bones else { return Self::Unscaled };
        match find_layout(model, bones) {
            Some(LayoutMatch::AsPublished { .. }) => return Self::Right,
            Some(other) => return Self::OtherSize(other),
            None => {}
        }
        // A sphere that is odd in several measures is named once.
        let mut named = BTreeSet::new();
        let far = reaches(model, bones).into_iter().filter(|one| one.is_odd() && named.insert(one.sphere));
        let far: Vec<Reach> = far.collect();
        if !far.is_empty() {
            return Self::FarReach(far);
        }
        let carriers = model.loaded_spheres(&model.force_ids());
        let mut bodies = carriers.iter().filter_map(|&id| model.sphere(id)?.body.as_deref());
        // Only feet count: meshes of balls and blocks are stretched to their size.
        let is_scaled = |body: &str| {
            bones.is_foot(body) && bones.size(body).is_some_and(|size| !is_conversion_of_unit(size))
        };
        if bodies.any(is_scaled) { Self::Unknown } else { Self::Unscaled }
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

/// The bodies that have spheres and do not belong to a foot, if no calcaneus of the model has spheres, or, in a model without calcaneus, no
/// foot.
fn bodies_beside_feet(model: &Model, bones: &BodyBones) -> Option<Vec<String>> {
    let spheres = model.loaded_spheres(&model.force_ids());
    let bodies: BTreeSet<&str> = spheres.iter().filter_map(|&id| model.sphere(id)?.body.as_deref()).collect();
    let names = |part: &'static str| move |body: &&str| body.to_lowercase().contains(part);
    let has_calcaneus = model.bodies().iter().any(|body| names("calc")(&body.name.as_str()));
    let is_foot = |body: &&str| if has_calcaneus { names("calc")(body) } else { bones.is_foot(body) };
    if bodies.iter().any(is_foot) || !bones.has_feet() {
        return None;
    }
    // A ball has no feet. The talus is above the ground, between shank and calcaneus.
    let is_of_skeleton = |body: &str| bones.joint_above(body).is_some() || bones.has_foot_below(body);
    // A shoe has the spheres of its foot. What is named after its body, such as a palm on a hand, is meant to be there.
    let is_meant = |body: &str| bones.is_worn_by_foot(body) || are_named_after(model, &spheres, body);
    let is_of_other_bone = |body: &str| !bones.is_foot(body) || names("talus")(&body);
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

/// Whether the factors of meshes are 1, or convert a unit of length, such as 0.001.
fn is_conversion_of_unit(factors: [f64; 3]) -> bool {
    (-6..=3).any(|exponent| same_size(factors, [10_f64.powi(exponent); 3]))
}

// Published layouts of contact spheres, `layouts.json`, and the sizes of bones on which they were published.
//
// A layout is recognised by its places. If its licence does not allow copying, the table has a digest of the places, in
// whole micrometres, from which they cannot be read.

/// Places that differ by no more than this in each axis are the same, m, unless they are rounded to fewer digits.
const SAME_PLACE_M: f64 = 1e-6;

/// Places of the contact spheres of a published model.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PublishedLayout {
    #[cfg_attr(not(test), expect(dead_code, reason = "for readers of the table"))]
    name: String,
    title: String,
    /// The publication of the layout, with its licence.
    #[cfg_attr(not(test), expect(dead_code, reason = "for readers of the table"))]
    source: String,
    /// For each published size of the bones, the factors of each body's meshes; names of bodies are without their side.
    sizes: Vec<BTreeMap<String, [f64; 3]>>,
    places: Option<Vec<PublishedPlace>>,
    /// Digest of the places, if the licence does not allow copying them.
    digest: Option<String>,
}

/// The name of a body, and x, y, z of a sphere centre in it, m.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct PublishedPlace(String, f64, f64, f64);

/// The centre of a contact sphere in the frame of its body, m.
#[derive(Debug, Clone, Copy, PartialEq)]
struct SphereCentre<'m> {
    body: &'m str,
    at_m: [f64; 3],
}

/// The sphere centres of a model, with their digest, which is computed when a layout is compared by digest.
#[derive(Default)]
struct DigestedCentres<'m> {
    list: Vec<SphereCentre<'m>>,
    digest: OnceCell<String>,
}

/// How the bones of a model fit the published layout whose places its spheres have.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum LayoutMatch {
    /// The bones have the published size, or the spheres moved as the bones grew, to `volume` times the published volume.
    AsPublished { volume: f64 },
    /// The bones have another size than published. `growth` is that of one of the bones, along x, y and z.
    OtherSize { title: &'static str, body: String, growth: [f64; 3] },
}

/// The published layout whose places the spheres of `model` have; `None` if no layout is known, or nothing shows how large the bones are.
fn find_layout(model: &Model, bones: &BodyBones) -> Option<LayoutMatch> {
    let list = sphere_centres(model)?;
    LayoutCache::of(model, &list).layout.get_or_init(|| match_layout(list, bones)).clone()
}

/// The volume of the bones over that of the published ones, if the spheres have the places of a published layout on them.
pub(crate) fn volume_of_published_bones(model: &Model) -> Option<f64> {
    match find_layout(model, BodyBones::of(model)?)? {
        LayoutMatch::AsPublished { volume } => Some(volume),
        LayoutMatch::OtherSize { .. } => None,
    }
}

/// The layouts that were found for one list of sphere centres. They are kept with the bodies of a model, because most changes do not move
/// spheres.
#[derive(Debug, Default)]
struct LayoutCache {
    places: Vec<(String, [f64; 3])>,
    layout: OnceLock<Option<LayoutMatch>>,
    mirrored: OnceLock<Option<&'static str>>,
}

impl LayoutCache {
    /// The cache for the spheres in `list`; a new one if the spheres of the last call were at other places.
    fn of(model: &Model, list: &[SphereCentre<'_>]) -> Arc<Self> {
        let last = model.derived_from_bodies(|_| Mutex::new(Arc::<Self>::default()));
        let mut last = last.lock().unwrap_or_else(PoisonError::into_inner);
        let places = list.iter().map(|place| (place.body, place.at_m));
        if !places.clone().eq(last.places.iter().map(|(body, at_m)| (body.as_str(), *at_m))) {
            let places = places.map(|(body, at_m)| (body.to_owned(), at_m)).collect();
            *last = Arc::new(Self { places, ..Self::default() });
        }
        Arc::clone(&last)
    }
}

/// The published layout that the centres in `list` have, and how the bones fit it.
fn match_layout(list: Vec<SphereCentre<'_>>, bones: &BodyBones) -> Option<LayoutMatch> {
    let centres = DigestedCentres { list, ..DigestedCentres::default() };
    let Some(layout) = published_layouts().iter().find(|layout| layout.has_places(&centres)) else {
        let mut layouts = published_layouts().iter();
        let volume = layouts.find_map(|layout| layout.volume_of_grown_bones(&centres, bones));
        return volume.map(|volume| LayoutMatch::AsPublished { volume });
    };
    let bodies: BTreeSet<&str> = centres.list.iter().map(|place| place.body).collect();
    if bodies.iter().all(|body| bones.size(body).is_none() && bones.length_by_toe_joint(body).is_none()) {
        return None;
    }
    let differs = |published: &BTreeMap<String, [f64; 3]>| {
        bodies.iter().find_map(|&body| {
            let growth = growth_of_bone(bones, body, *published.get(published_name(body))?)?;
            Some((body.to_owned(), growth))
        })
    };
    // If the bones have none of the published sizes, the difference from the first is reported.
    let differences: Option<Vec<_>> = layout.sizes.iter().map(differs).collect();
    let first = differences.and_then(|differences| differences.into_iter().next());
    let Some((body, growth)) = first else { return Some(LayoutMatch::AsPublished { volume: 1.0 }) };
    Some(LayoutMatch::OtherSize { title: &layout.title, body, growth })
}

/// A foot has the published length if the length that its toe joint shows differs by at most this, relatively.
const SAME_LENGTH_TOLERANCE: f64 = 0.02;

/// Meshes that are so much larger or smaller than published are in another unit, such as millimetres, and show no other size of the bone.
const PLAUSIBLE_GROWTH: std::ops::Range<f64> = 0.05..20.0;

/// The size of `body` over `published`, by its meshes or else by its joint to the toes; `None` if it has the published size.
fn growth_of_bone(bones: &BodyBones, body: &str, published: [f64; 3]) -> Option<[f64; 3]> {
    let of_meshes = bones.size(body).filter(|here| !same_size(*here, published));
    let of_meshes = of_meshes.map(|here| std::array::from_fn(|axis| here[axis] / published[axis]));
    let of_meshes = of_meshes.filter(|growth| growth.iter().all(|one| PLAUSIBLE_GROWTH.contains(one)));
    let of_length = bones.length_by_toe_joint(body).map(|length| length / published[0]);
    let of_length = of_length.filter(|ratio| (ratio - 1.0).abs() > SAME_LENGTH_TOLERANCE);
    of_meshes.or(of_length.map(|ratio| [ratio; 3]))
}

/// The title of a published layout whose mirror image the spheres of `model` are: each foot has the places of the other foot. `None` if the
/// spheres are also at the published places, because a layout can be symmetric.
fn find_mirrored_layout(model: &Model, bones: &BodyBones) -> Option<&'static str> {
    let list = sphere_centres(model)?;
    *LayoutCache::of(model, &list).mirrored.get_or_init(|| match_mirrored_layout(list, bones))
}

/// The title of the published layout whose mirror image the centres in `list` are.
fn match_mirrored_layout(list: Vec<SphereCentre<'_>>, bones: &BodyBones) -> Option<&'static str> {
    // Each place in the frame of the other foot.
    let on_other_foot = |&SphereCentre { body, at_m: [x, y, z] }| SphereCentre { body, at_m: [x, y, -z] };
    let mirrored = list.iter().map(on_other_foot).collect();
    if layout_with_centres(list, bones).is_some() {
        return None;
    }
    Some(layout_with_centres(mirrored, bones)?.title.as_str())
}

/// The layout with these centres, in a published size or in the size of the bones.
fn layout_with_centres(list: Vec<SphereCentre<'_>>, bones: &BodyBones) -> Option<&'static PublishedLayout> {
    let centres = DigestedCentres { list, ..DigestedCentres::default() };
    published_layouts()
        .iter()
        .find(|layout| layout.has_places(&centres) || layout.volume_of_grown_bones(&centres, bones).is_some())
}

/// Centres of the spheres that carry weight; `None` if the place of a sphere is not known, or no sphere carries weight.
fn sphere_centres(model: &Model) -> Option<Vec<SphereCentre<'_>>> {
    let spheres = model.loaded_spheres(&model.force_ids());
    let place = |&id| {
        let body = model.sphere(id)?.body.as_deref()?;
        Some(SphereCentre { body, at_m: model.centre_m(id)?.to_array() })
    };
    spheres.iter().map(place).collect::<Option<Vec<SphereCentre<'_>>>>().filter(|places| !places.is_empty())
}

impl PublishedLayout {
    /// Whether the centres are the published places, compared directly or by digest.
    fn has_places(&self, centres: &DigestedCentres<'_>) -> bool {
        self.matches(&centres.list, |own| {
            own == centres.digest.get_or_init(|| digest_of_places(&centres.list))
        })
    }

    /// Whether the centres `list` are the places of the layout. A layout without places has a digest, with which `list` is compared.
    fn matches(&self, list: &[SphereCentre<'_>], has_digest: impl FnOnce(&str) -> bool) -> bool {
        match (&self.places, &self.digest) {
            (Some(places), _) if places.len() == list.len() => {
                let rounding_m =
                    rounding_of_places_m(list.iter().map(|centre| centre.at_m)).max(SAME_PLACE_M);
                places.iter().all(|place| list.iter().any(|centre| place.is_at(centre, rounding_m)))
            }
            (None, Some(digest)) => has_digest(digest),
            _ => false,
        }
    }

    /// The volume of a bone over the published volume, if each centre is the published place times the factor by which the bone of the
    /// sphere is larger than published.
    fn volume_of_grown_bones(&self, centres: &DigestedCentres<'_>, bones: &BodyBones) -> Option<f64> {
        self.sizes.iter().find_map(|published| {
            let mut volume = 1.0;
            let back = centres.list.iter().map(|&SphereCentre { body, at_m }| {
                let (here, published) = (bones.size(body)?, published.get(published_name(body))?);
                volume = here.iter().product::<f64>() / published.iter().product::<f64>();
                let at_m = std::array::from_fn(|axis| at_m[axis] * (published[axis] / here[axis]));
                Some(SphereCentre { body, at_m })
            });
            let back = back.collect::<Option<Vec<SphereCentre<'_>>>>()?;
            self.matches(&back, |own| own == digest_of_places(&back)).then_some(volume)
        })
    }
}

impl PublishedPlace {
    /// Whether a centre is at this place on the body of the same name, within a tolerance.
    fn is_at(&self, other: &SphereCentre<'_>, tolerance_m: f64) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= tolerance_m;
        let [x, y, z] = other.at_m;
        self.0 == other.body && near(self.1, x) && near(self.2, y) && near(self.3, z)
    }
}

/// A digest of the places in whole micrometres. It does not depend on the order of the places.
fn digest_of_places(places: &[SphereCentre<'_>]) -> String {
    let micrometres = |metres: f64| (metres * 1e6).round() as i64;
    let mut lines: Vec<String> = places
        .iter()
        .map(|SphereCentre { body, at_m: [x, y, z] }| {
            format!("{body} {} {} {}\n", micrometres(*x), micrometres(*y), micrometres(*z))
        })
        .collect();
    lines.sort();
    let hash = Sha256::digest(lines.concat());
    hash.iter().take(16).fold(String::with_capacity(32), |mut text, byte| {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// The name of a body in the table of layouts: `calcn` for `calcn_r`.
fn published_name(body: &str) -> &str {
    ["_r", "_l"].iter().find_map(|side| body.strip_suffix(side)).unwrap_or(body)
}

/// The table of published layouts.
fn published_layouts() -> &'static [PublishedLayout] {
    static PUBLISHED_LAYOUTS: OnceLock<Vec<PublishedLayout>> = OnceLock::new();
    // A test checks that the table can be read.
    PUBLISHED_LAYOUTS.get_or_init(|| serde_json::from_str(include_str!("layouts.json")).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
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

    #[test]
    fn the_table_of_layouts_is_complete() {
        let layouts: Vec<PublishedLayout> = serde_json::from_str(include_str!("layouts.json")).unwrap();
        assert!(layouts.len() >= 10);
        let names: BTreeSet<&str> = layouts.iter().map(|layout| layout.name.as_str()).collect();
        assert_eq!(names.len(), layouts.len());
        for layout in &layouts {
            assert!(layout.places.is_some() != layout.digest.is_some(), "{}", layout.name);
            assert!(!layout.sizes.is_empty() && !layout.source.is_empty(), "{}", layout.name);
            assert!(layout.digest.as_ref().is_none_or(|digest| digest.len() == 32), "{}", layout.name);
        }
    }

    #[test]
    fn a_digest_depends_on_micrometres_and_not_on_the_order() {
        let heel = SphereCentre { body: "calcn_r", at_m: [0.01, -0.02, 0.0] };
        let toe = SphereCentre { body: "toes_r", at_m: [0.03, 0.0, 0.001] };
        let one = digest_of_places(&[heel, toe]);
        assert_eq!(one, digest_of_places(&[toe, heel]));
        assert_ne!(one, digest_of_places(&[SphereCentre { at_m: [0.010001, -0.02, 0.0], ..heel }, toe]));
    }
}
