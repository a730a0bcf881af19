//! Published layouts of contact spheres, `layouts.json`, and the sizes of bones on which they were published.
//!
//! A layout is recognised by its places. If its licence does not allow copying, the table has a digest of the places, in
//! whole micrometres, from which they cannot be read.

use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use crate::model::Model;
use serde::Deserialize;
use sha2::{Digest, Sha256};

use super::bones::{Bones, same_size};

/// Places that differ by no more than this are one, m.
const SAME_PLACE_M: f64 = 1e-6;

/// A published layout.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Layout {
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
pub(super) struct Place(String, f64, f64, f64);

/// A place in a model.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Centre<'m> {
    body: &'m str,
    at_m: [f64; 3],
}

/// Places of a model, with their digest once a layout asks for it.
struct Places<'m> {
    list: Vec<Centre<'m>>,
    digest: OnceCell<String>,
    /// The same seen from bones of other sizes, those of which somebody asked for the digest.
    grown: RefCell<Vec<(Vec<Centre<'m>>, String)>>,
}

impl<'m> From<Vec<Centre<'m>>> for Places<'m> {
    fn from(list: Vec<Centre<'m>>) -> Self {
        Self { list, digest: OnceCell::new(), grown: RefCell::default() }
    }
}

/// What a layout says about a model that has it.
#[derive(Debug, Clone, PartialEq)]
pub enum LayoutAnswer {
    /// Its bones are as large as published, or the layout grew with them.
    AsPublished,
    /// They are not: the first body that differs, how large it is, and how large it was.
    OtherSize {
        /// As people cite the layout.
        title: &'static str,
        /// A body whose bones have another size.
        body: String,
        /// The factors of its meshes along x, y and z.
        here: [f64; 3],
        /// Those with which the layout was published.
        published: [f64; 3],
    },
}

/// What the layout of `model` says; `None` where it is not known, or nothing shows how large the bones are.
pub(super) fn answer(model: &Model, bones: &Bones) -> Option<LayoutAnswer> {
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
        let last = model.of_bodies(|_| Mutex::new(Arc::<Self>::default()));
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
            let published = *published.get(without_side(body))?;
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
pub(super) fn mirrored(model: &Model, bones: &Bones) -> Option<&'static str> {
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
        Some(Centre { body, at_m: model.centre_m(id)? })
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
                let (here, published) = (bones.size(body)?, published.get(without_side(body))?);
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
    /// The same place on the other foot, in its frame.
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

/// `calcn` of `calcn_r`.
fn without_side(body: &str) -> &str {
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

    use super::*;

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
