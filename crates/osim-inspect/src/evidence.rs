//! What one file alone says about its spheres, in the order in which it counts, and the published layouts it is compared with.

use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use osim_model::{Model, ScaledSinceNote};
use serde::Deserialize;
use sha2::{Digest, Sha256};

use crate::reach::{Bones, Reach, reaches, same_size};

/// What is known of the places of spheres.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Evidence {
    /// By the note: bodies were scaled and the spheres stayed.
    Note(ScaledSinceNote),
    /// A published layout is on bones of another size.
    OtherSize(LayoutAnswer),
    /// Each foot has the places that the published layout of this title has on the other foot.
    Mirrored(&'static str),
    /// Spheres reach further than published ones.
    Reach(Vec<Reach>),
    /// They are right: by the note, or a published layout on bones of its size.
    Right,
    /// Nothing in the file shows that bones were scaled.
    Unscaled,
    /// Bones were scaled, and nothing shows whether spheres followed.
    Unknown,
}

impl Evidence {
    /// What is known of `model`. `noted` is what its note says about sizes, where it has such a note.
    pub(crate) fn of(model: &Model, noted: Option<ScaledSinceNote>) -> Self {
        let bones = Bones::of(model);
        // A note says that spheres are where somebody put them.
        if let Some(title) = bones.and_then(|bones| mirrored(model, bones)) {
            return Self::Mirrored(title);
        }
        if let Some(noted) = noted {
            return if noted.is_scaled() { Self::Note(noted) } else { Self::Right };
        }
        let Some(bones) = bones else { return Self::Unscaled };
        match answer(model, bones) {
            Some(LayoutAnswer::AsPublished) => return Self::Right,
            Some(other) => return Self::OtherSize(other),
            None => {}
        }
        let odd: Vec<Reach> = reaches(model, bones).into_iter().filter(Reach::is_odd).collect();
        if !odd.is_empty() {
            return Self::Reach(odd);
        }
        let carriers = model.loaded_spheres(&model.force_ids());
        let mut bodies = carriers.iter().filter_map(|&id| model.sphere(id)?.body.as_deref());
        // Meshes of balls and blocks are stretched to their size.
        let is_scaled =
            |body: &str| bones.is_foot(body) && bones.size(body).is_some_and(|size| !is_unit(size));
        if bodies.any(is_scaled) { Self::Unknown } else { Self::Unscaled }
    }

    /// Whether spheres are where they should not be: everything else waits until they are moved.
    pub(crate) fn is_wrong(&self) -> bool {
        matches!(self, Self::Note(_) | Self::OtherSize(_) | Self::Mirrored(_) | Self::Reach(_))
    }

    /// Whether spheres are known to be where they belong.
    pub(crate) fn is_right(&self) -> bool {
        matches!(self, Self::Right)
    }
}

/// Whether meshes have the size of their files: factor 1, or another unit of length, such as 0.001.
fn is_unit(factors: [f64; 3]) -> bool {
    (-6..=3).any(|exponent| same_size(factors, [10_f64.powi(exponent); 3]))
}

// Published layouts of contact spheres, `layouts.json`, and the sizes of bones on which they were published.
//
// A layout is recognised by its places. If its licence does not allow copying, the table has a digest of the places, in
// whole micrometres, from which they cannot be read.

/// Places that differ by no more than this are one, m.
const SAME_PLACE_M: f64 = 1e-6;

/// A published layout.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Layout {
    #[cfg_attr(not(test), expect(dead_code, reason = "for readers of the table"))]
    name: String,
    /// As people cite it.
    title: String,
    /// Where it was published, under which licence.
    #[cfg_attr(not(test), expect(dead_code, reason = "for readers of the table"))]
    source: String,
    /// For each size of the bones on which it was published: the factors of each body's meshes; bodies without their side.
    sizes: Vec<BTreeMap<String, [f64; 3]>>,
    /// Bodies and centres in them, m.
    places: Option<Vec<Place>>,
    /// Digest of the places, where they may not be copied.
    digest: Option<String>,
}

/// A body, and x, y, z of a centre in it, m.
#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Place(String, f64, f64, f64);

#[derive(Debug, Clone, Copy, PartialEq)]
struct Centre<'m> {
    body: &'m str,
    at_m: [f64; 3],
}

/// Places of a model, with their digest once a layout asks for it.
struct Places<'m> {
    list: Vec<Centre<'m>>,
    digest: OnceCell<String>,
    /// Centres seen from bones of other sizes, each with the digest for which it was asked.
    grown: RefCell<Vec<(Vec<Centre<'m>>, String)>>,
}

impl<'m> From<Vec<Centre<'m>>> for Places<'m> {
    fn from(list: Vec<Centre<'m>>) -> Self {
        Self { list, digest: OnceCell::new(), grown: RefCell::default() }
    }
}

/// What a layout says about a model that has it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum LayoutAnswer {
    /// Its bones are as large as published, or the layout grew with them.
    AsPublished,
    /// They are not: the first body that differs, how large it is, and how large it was.
    OtherSize {
        /// As people cite the layout.
        title: &'static str,
        body: String,
        /// The factors of its meshes along x, y and z.
        here: [f64; 3],
        published: [f64; 3],
    },
}

/// What the layout of `model` says; `None` where it is not known, or nothing shows how large the bones are.
fn answer(model: &Model, bones: &Bones) -> Option<LayoutAnswer> {
    let list = places(model)?;
    Answers::of(model, &list).layout.get_or_init(|| answer_of(list, bones)).clone()
}

/// What is known of one list of places on the bones of a model: a change leaves most places as they are.
#[derive(Debug, Default)]
struct Answers {
    places: Vec<(String, [f64; 3])>,
    layout: OnceLock<Option<LayoutAnswer>>,
    mirrored: OnceLock<Option<&'static str>>,
}

impl Answers {
    fn of(model: &Model, list: &[Centre<'_>]) -> Arc<Self> {
        let last = model.derived_from_bodies(|_| Mutex::new(Arc::<Self>::default()));
        let mut last = last.lock().unwrap_or_else(PoisonError::into_inner);
        let own = list.iter().map(|place| (place.body, place.at_m));
        if !own.clone().eq(last.places.iter().map(|(body, at_m)| (body.as_str(), *at_m))) {
            let places = own.map(|(body, at_m)| (body.to_owned(), at_m)).collect();
            *last = Arc::new(Self { places, ..Self::default() });
        }
        Arc::clone(&last)
    }
}

fn answer_of(list: Vec<Centre<'_>>, bones: &Bones) -> Option<LayoutAnswer> {
    let places = Places::from(list);
    let Some(layout) = layouts().iter().find(|layout| layout.is_of(&places)) else {
        let followed = layouts().iter().any(|layout| layout.grew_to(&places, bones));
        return followed.then_some(LayoutAnswer::AsPublished);
    };
    let sizes: Vec<(&str, [f64; 3])> =
        places.list.iter().filter_map(|place| Some((place.body, bones.size(place.body)?))).collect();
    if sizes.is_empty() {
        return None;
    }
    let differs = |published: &BTreeMap<String, [f64; 3]>| {
        sizes.iter().find_map(|&(body, here)| {
            let published = *published.get(published_name(body))?;
            (!same_size(here, published)).then(|| (body.to_owned(), here, published))
        })
    };
    // Where it fits none, the first is named.
    let found: Option<Vec<_>> = layout.sizes.iter().map(differs).collect();
    let Some((body, here, published)) = found.and_then(|found| found.into_iter().next()) else {
        return Some(LayoutAnswer::AsPublished);
    };
    Some(LayoutAnswer::OtherSize { title: &layout.title, body, here, published })
}

/// The published layout whose mirror image the spheres of `model` are, as people cite it: each foot has the places of the other one.
/// `None` where they are as published, too.
fn mirrored(model: &Model, bones: &Bones) -> Option<&'static str> {
    let list = places(model)?;
    *Answers::of(model, &list).mirrored.get_or_init(|| mirrored_of(list, bones))
}

fn mirrored_of(list: Vec<Centre<'_>>, bones: &Bones) -> Option<&'static str> {
    let mirrored = list.iter().map(Centre::mirrored).collect();
    let title = known(mirrored, bones)?.title.as_str();
    known(list, bones).is_none().then_some(title)
}

/// The layout of these places, in one of the sizes that were published or as it grows with the bones.
fn known(list: Vec<Centre<'_>>, bones: &Bones) -> Option<&'static Layout> {
    let places = Places::from(list);
    layouts().iter().find(|layout| layout.is_of(&places) || layout.grew_to(&places, bones))
}

/// Where the spheres that stand are; `None` if the place of one is not known, or there are none.
fn places(model: &Model) -> Option<Vec<Centre<'_>>> {
    let spheres = model.loaded_spheres(&model.force_ids());
    let place = |&id| {
        let body = model.sphere(id)?.body.as_deref()?;
        Some(Centre { body, at_m: model.centre_m(id)?.to_array() })
    };
    spheres.iter().map(place).collect::<Option<Vec<Centre<'_>>>>().filter(|places| !places.is_empty())
}

impl Layout {
    fn is_of(&self, places: &Places<'_>) -> bool {
        self.has(&places.list, |own| own == places.digest.get_or_init(|| digest(&places.list)))
    }

    /// Whether `list` are its places, or have the digest of them.
    fn has(&self, list: &[Centre<'_>], is_digest: impl FnOnce(&str) -> bool) -> bool {
        match (&self.places, &self.digest) {
            (Some(own), _) => {
                own.len() == list.len() && own.iter().all(|own| list.iter().any(|place| own.is(place)))
            }
            (None, Some(own)) => is_digest(own),
            (None, None) => false,
        }
    }

    /// Whether `places` are those of the layout times the factors by which each bone is larger than published.
    fn grew_to(&self, places: &Places<'_>, bones: &Bones) -> bool {
        self.sizes.iter().any(|published| {
            let back = places.list.iter().map(|&Centre { body, at_m }| {
                let (here, published) = (bones.size(body)?, published.get(published_name(body))?);
                let at_m = std::array::from_fn(|axis| at_m[axis] * (published[axis] / here[axis]));
                Some(Centre { body, at_m })
            });
            let back: Option<Vec<Centre<'_>>> = back.collect();
            back.is_some_and(|back| self.has(&back, |own| places.have_digest(&back, own)))
        })
    }
}

impl<'m> Places<'m> {
    /// Whether `grown`, which are these seen from bones of other sizes, have this digest.
    fn have_digest(&self, grown: &[Centre<'m>], own: &str) -> bool {
        let mut known = self.grown.borrow_mut();
        if let Some((_, digest)) = known.iter().find(|(list, _)| list == grown) {
            return digest == own;
        }
        let digest = digest(grown);
        let is_own = digest == own;
        known.push((grown.to_vec(), digest));
        is_own
    }
}

impl Centre<'_> {
    /// The place on the other foot that mirrors this one, in its frame.
    fn mirrored(&self) -> Self {
        let [x, y, z] = self.at_m;
        Self { at_m: [x, y, -z], ..*self }
    }
}

impl Place {
    fn is(&self, other: &Centre<'_>) -> bool {
        let near = |a: f64, b: f64| (a - b).abs() <= SAME_PLACE_M;
        let [x, y, z] = other.at_m;
        self.0 == other.body && near(self.1, x) && near(self.2, y) && near(self.3, z)
    }
}

/// Of places in whole micrometres, in the order of bodies.
fn digest(places: &[Centre<'_>]) -> String {
    #[expect(clippy::cast_possible_truncation, reason = "no foot is kilometres long")]
    let micrometres = |metres: f64| (metres * 1e6).round() as i64;
    let mut lines: Vec<String> = places
        .iter()
        .map(|Centre { body, at_m: [x, y, z] }| {
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

/// As the table calls the bones of a body: `calcn` of `calcn_r`.
fn published_name(body: &str) -> &str {
    ["_r", "_l"].iter().find_map(|side| body.strip_suffix(side)).unwrap_or(body)
}

fn layouts() -> &'static [Layout] {
    static LAYOUTS: OnceLock<Vec<Layout>> = OnceLock::new();
    // A test reads the table strictly; a program that could not would know none.
    LAYOUTS.get_or_init(|| serde_json::from_str(include_str!("layouts.json")).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::PathBuf;

    use super::*;

    /// Models of the corpus that have contacts, by name.
    fn published() -> Vec<(String, Model)> {
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
    fn no_published_model_is_reported() {
        for (name, model) in published() {
            let evidence = Evidence::of(&model, None);
            assert!(!evidence.is_wrong(), "{name}: {evidence:?}");
            assert_ne!(
                evidence,
                Evidence::Unknown,
                "{name}: its layout is in the table, or its bones are not scaled"
            );
        }
    }

    const FALISSE: &str = include_str!("../../../fixtures/check/known_contacts.osim");

    /// `text` with the sign of z changed in the place of each sphere.
    fn mirrored(text: &str) -> String {
        let of_sphere = |part: &str| {
            let start = part.find("<location>").unwrap() + "<location>".len();
            let end = start + part[start..].find('<').unwrap();
            let [x, y, z] = *part[start..end].split(' ').collect::<Vec<_>>() else { panic!("{part}") };
            let z: f64 = z.parse().unwrap();
            format!("{}{x} {y} {}{}", &part[..start], -z, &part[end..])
        };
        let mut parts = text.split("<ContactSphere ");
        let first = parts.next().unwrap().to_owned();
        parts.fold(first, |text, part| format!("{text}<ContactSphere {}", of_sphere(part)))
    }

    #[test]
    fn feet_with_the_places_of_the_other_foot_are_named() {
        let of = |text: &str| Evidence::of(&Model::parse(text).unwrap(), None);
        assert_eq!(of(FALISSE), Evidence::Right);
        let swapped = mirrored(FALISSE);
        assert_eq!(of(&swapped), Evidence::Mirrored("Falisse et al. (2022)"));
        assert_eq!(of(&mirrored(&swapped)), Evidence::Right);
        // On bones of another size, too: which foot it is comes first.
        let grown = swapped.replace("0.913924 0.913924 0.913924", "0.8 0.8 0.8");
        assert_eq!(of(&grown), Evidence::Mirrored("Falisse et al. (2022)"));
    }

    #[test]
    fn the_table_is_read_whole() {
        let layouts: Vec<Layout> = serde_json::from_str(include_str!("layouts.json")).unwrap();
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
    fn a_digest_sees_a_micrometre_and_not_the_order() {
        let heel = Centre { body: "calcn_r", at_m: [0.01, -0.02, 0.0] };
        let toe = Centre { body: "toes_r", at_m: [0.03, 0.0, 0.001] };
        let one = digest(&[heel, toe]);
        assert_eq!(one, digest(&[toe, heel]));
        assert_ne!(one, digest(&[Centre { at_m: [0.010001, -0.02, 0.0], ..heel }, toe]));
    }
}
