//! What one file alone says about its spheres, in the order in which it counts.

use crate::model::{Finding, Model, ScaledSinceNote};

use super::bones::{Bones, same_size};
use super::layouts::{self, LayoutAnswer};
use super::reach::{Reach, reaches};
use crate::compare::rules::{spheres_left_behind, spheres_misplaced, spheres_not_compared};

/// What is known of the places of spheres.
#[derive(Debug, Clone, PartialEq)]
pub enum Evidence {
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
    pub fn of(model: &Model, noted: Option<ScaledSinceNote>) -> Self {
        let bones = Bones::of(model);
        // A note says that spheres are where somebody put them.
        if let Some(title) = bones.and_then(|bones| layouts::mirrored(model, bones)) {
            return Self::Mirrored(title);
        }
        if let Some(noted) = noted {
            return if noted.is_scaled() { Self::Note(noted) } else { Self::Right };
        }
        let Some(bones) = bones else { return Self::Unscaled };
        match layouts::answer(model, bones) {
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
    pub fn is_wrong(&self) -> bool {
        matches!(self, Self::Note(_) | Self::OtherSize(_) | Self::Mirrored(_) | Self::Reach(_))
    }

    /// Whether spheres are known to be where they belong.
    pub fn is_right(&self) -> bool {
        matches!(self, Self::Right)
    }

    /// The finding that it is.
    pub fn finding(&self, model: &Model) -> Option<Finding> {
        match self {
            Self::Note(noted) => Some(spheres_left_behind::of_note(noted)),
            Self::OtherSize(LayoutAnswer::OtherSize { title, body, here, published }) => {
                Some(spheres_misplaced::of_layout(title, body, *here, *published))
            }
            Self::Mirrored(title) => Some(spheres_misplaced::of_mirrored(title)),
            Self::Reach(odd) => spheres_misplaced::of_reach(model, odd),
            Self::Unknown => Some(spheres_not_compared::of_scaled_bones()),
            Self::OtherSize(LayoutAnswer::AsPublished) | Self::Right | Self::Unscaled => None,
        }
    }
}

/// Whether meshes have the size of their files: factor 1, or another unit of length, such as 0.001.
fn is_unit(factors: [f64; 3]) -> bool {
    (-6..=3).any(|exponent| same_size(factors, [10_f64.powi(exponent); 3]))
}

#[cfg(test)]
mod tests {
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

    const FALISSE: &str = include_str!("../../../../../fixtures/check/known_contacts.osim");

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
}
