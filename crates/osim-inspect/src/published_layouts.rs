//! Published layouts of contact spheres, `layouts.json`, and the sizes of bones on which they were published.
//!
//! A layout is recognised by its places. If its licence does not allow copying, the table has a digest of the places, in
//! whole micrometres, from which they cannot be read.

use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use osim_model::{Model, rounding_of_places_m};
use serde::Deserialize;
use sha2::{Digest, Sha256};

use crate::body_bones::{BodyBones, same_size};

/// Places that differ by no more than this in each axis are the same, m, unless they are rounded to fewer digits.
const SAME_PLACE_M: f64 = 1e-6;

/// Places of the contact spheres of a published model.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PublishedLayout {
    #[cfg_attr(not(test), expect(dead_code, reason = "for readers of the table"))]
    name: &'static str,
    title: &'static str,
    /// The publication of the layout, with its licence.
    #[cfg_attr(not(test), expect(dead_code, reason = "for readers of the table"))]
    source: &'static str,
    /// The bones of each published skeleton that carries the layout; names of bodies are without their side.
    sizes: Vec<BTreeMap<&'static str, PublishedBone>>,
    places: Option<Vec<PublishedPlace>>,
    /// The number of places and their digest, if the licence does not allow copying them.
    digest: Option<(usize, &'static str)>,
}

/// The size of a bone of a published model.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PublishedBone {
    /// The scale factors of its meshes.
    factors: [f64; 3],
    /// Its [length by joints](BodyBones::length_by_joints) in the published model, m, or OpenSim's times a factor: where meshes are absent
    /// or were not scaled, it shows the size.
    length_m: Option<f64>,
}

/// The name of a body, and x, y, z of a sphere centre in it, m.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct PublishedPlace(&'static str, f64, f64, f64);

/// The centre of a contact sphere in the frame of its body, m.
#[derive(Debug, Clone, Copy, PartialEq)]
struct SphereCentre<'m> {
    body: &'m str,
    at_m: [f64; 3],
}

/// The sphere centres of a model, with how far they are rounded and their digest, which are found when a layout is compared by them.
#[derive(Default)]
struct DigestedCentres<'m> {
    list: Vec<SphereCentre<'m>>,
    rounding_m: OnceCell<f64>,
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
pub(crate) fn find_layout(model: &Model, bones: &BodyBones) -> Option<LayoutMatch> {
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
    /// Finds the cache of `model` for the spheres in `list`, or makes a new one if the spheres of the last call were at other places.
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
    if bodies.iter().all(|body| bones.size(body).is_none() && bones.length_by_joints(body).is_none()) {
        return None;
    }
    let differs = |published: &BTreeMap<&str, PublishedBone>| {
        bodies.iter().find_map(|&body| {
            let growth = growth_of_bone(bones, body, published.get(published_name(body))?)?;
            Some((body.to_owned(), growth))
        })
    };
    // If the bones have none of the published sizes, the difference from the first is reported.
    let differences: Option<Vec<_>> = layout.sizes.iter().map(differs).collect();
    let first = differences.and_then(|differences| differences.into_iter().next());
    let Some((body, growth)) = first else { return Some(LayoutMatch::AsPublished { volume: 1.0 }) };
    Some(LayoutMatch::OtherSize { title: layout.title, body, growth })
}

/// A bone has the published length if its length by joints differs by at most this, relatively.
const SAME_LENGTH_TOLERANCE: f64 = 0.02;

/// Bones that are so much larger or smaller than published are in another unit, such as millimetres, and show no other size.
const PLAUSIBLE_GROWTH: std::ops::Range<f64> = 0.05..20.0;

/// The size of `body` over the `published` one, by its meshes or else by its joints; `None` if it has the published size.
fn growth_of_bone(bones: &BodyBones, body: &str, published: &PublishedBone) -> Option<[f64; 3]> {
    let PublishedBone { factors, length_m } = published;
    let of_meshes = bones.size(body).filter(|here| !same_size(*here, *factors));
    let of_meshes = of_meshes.map(|here| std::array::from_fn(|axis| here[axis] / factors[axis]));
    let of_joints =
        bones.length_by_joints(body).zip(*length_m).map(|(here, published)| [here / published; 3]);
    let of_joints = of_joints.filter(|[ratio, ..]| (ratio - 1.0).abs() > SAME_LENGTH_TOLERANCE);
    let is_plausible = |growth: &[f64; 3]| growth.iter().all(|one| PLAUSIBLE_GROWTH.contains(one));
    of_meshes.filter(is_plausible).or(of_joints.filter(is_plausible))
}

/// The title of a published layout whose mirror image the spheres of `model` are: each foot has the places of the other foot. `None` if the
/// spheres are also at the published places, because a layout can be symmetric.
pub(crate) fn find_mirrored_layout(model: &Model, bones: &BodyBones) -> Option<&'static str> {
    // What most models have is known without the mirror image.
    if find_layout(model, bones).is_some() {
        return None;
    }
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
    Some(layout_with_centres(mirrored, bones)?.title)
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
    /// Whether the centres are the published places, compared directly or, for a layout without places, by digest.
    fn has_places(&self, centres: &DigestedCentres<'_>) -> bool {
        let list = &centres.list;
        match (&self.places, &self.digest) {
            (Some(places), _) if places.len() == list.len() => {
                let rounding_m =
                    || rounding_of_places_m(list.iter().map(|centre| centre.at_m)).max(SAME_PLACE_M);
                let rounding_m = *centres.rounding_m.get_or_init(rounding_m);
                places.iter().all(|place| list.iter().any(|centre| place.is_at(centre, rounding_m)))
            }
            (None, Some((count, digest))) if *count == list.len() => {
                *digest == centres.digest.get_or_init(|| digest_of_places(list)).as_str()
            }
            _ => false,
        }
    }

    /// The volume of a bone over the published volume, if each centre is the published place times the factor by which the bone of the
    /// sphere is larger than published.
    fn volume_of_grown_bones(&self, centres: &DigestedCentres<'_>, bones: &BodyBones) -> Option<f64> {
        self.sizes.iter().find_map(|published| {
            let mut volume = 1.0;
            let back = centres.list.iter().map(|&SphereCentre { body, at_m }| {
                let (here, published) = (bones.size(body)?, published.get(published_name(body))?.factors);
                volume = here.iter().product::<f64>() / published.iter().product::<f64>();
                let at_m = std::array::from_fn(|axis| at_m[axis] * (published[axis] / here[axis]));
                Some(SphereCentre { body, at_m })
            });
            let list = back.collect::<Option<Vec<SphereCentre<'_>>>>()?;
            self.has_places(&DigestedCentres { list, ..DigestedCentres::default() }).then_some(volume)
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
    use super::*;

    #[test]
    fn the_table_of_layouts_is_complete() {
        let layouts: Vec<PublishedLayout> = serde_json::from_str(include_str!("layouts.json")).unwrap();
        assert!(layouts.len() >= 10);
        let names: BTreeSet<&str> = layouts.iter().map(|layout| layout.name).collect();
        assert_eq!(names.len(), layouts.len());
        for layout in &layouts {
            assert!(layout.places.is_some() != layout.digest.is_some(), "{}", layout.name);
            assert!(!layout.sizes.is_empty() && !layout.source.is_empty(), "{}", layout.name);
            assert!(layout.digest.as_ref().is_none_or(|(_, digest)| digest.len() == 32), "{}", layout.name);
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
