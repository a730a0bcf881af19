//! The factors of the bodies that carry spheres: one question for those who ask no other.

use std::collections::BTreeMap;

use crate::model::{Anatomy, Fault, Model};

use super::copy::Difference;
use super::factors::Factors;

/// How the bodies that carry spheres were scaled, as two models show it.
///
/// ```
/// use osim_model::Model;
/// use osim_model::compare::SphereBodies;
///
/// # let text = include_str!("../../../tests/data/one_foot.osim");
/// // The foot became 1.2 times as long, with its bone.
/// let mesh = |factors: &str| {
///     let mesh = format!("<attached_geometry><Mesh name=\"bone\"><scale_factors>{factors}</scale_factors>\
///                         <mesh_file>foot.vtp</mesh_file></Mesh></attached_geometry>");
///     Model::parse(text.replace("<mass>10</mass>", &format!("{mesh}<mass>10</mass>")))
/// };
/// let found = SphereBodies::of(&mesh("1.2 1 1.1")?, &mesh("1 1 1")?)?;
/// assert!(found.is_scaled_copy());
/// assert_eq!(found.factors["foot_r"], Some([1.2, 1.0, 1.1]));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SphereBodies {
    /// What shows that the model is not a scaled copy of the reference; `None` where it is one.
    pub difference: Option<Difference>,
    /// Factors along x, y and z of each body that carries spheres in either model; `None` if something has to be asked.
    pub factors: BTreeMap<String, Option<[f64; 3]>>,
}

impl SphereBodies {
    /// Compares `scaled` with `reference`; nothing is asked.
    ///
    /// # Errors
    /// A frame that leads nowhere, or a radius that cannot be scaled.
    pub fn of(scaled: &Model, reference: &Model) -> Result<Self, Fault> {
        let (here, there) = (Anatomy::of(scaled)?, Anatomy::of(reference)?);
        let found = Factors::find(&here, &there, None, &BTreeMap::new())?;
        let carried = here.spheres.iter().chain(&there.spheres).filter_map(|sphere| sphere.body.clone());
        let carried = carried.filter(|body| here.has_body(body));
        let factors = carried.map(|body| (body.clone(), found.of(&body).ok())).collect();
        Ok(Self { difference: found.difference, factors })
    }

    /// Whether the model is the reference, scaled.
    #[must_use]
    pub const fn is_scaled_copy(&self) -> bool {
        self.difference.is_none()
    }
}
