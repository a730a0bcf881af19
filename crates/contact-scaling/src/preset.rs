//! Published contacts, each with its source and the scale it was made for.

use std::borrow::Cow;

use crate::{Contact, ContactValues, Scale, ScaleValues, SmoothingValues};

/// A contact somebody published, with the body it was made for.
#[derive(Debug, Clone, PartialEq)]
pub struct Preset {
    /// The name to ask for it by: `falisse2022`.
    pub name: Cow<'static, str>,
    /// Who published it, where.
    pub source: Cow<'static, str>,
    /// The body the contact was made for.
    pub scale: Scale,
    /// The contact itself.
    pub contact: Contact,
}

/// The human of Falisse et al. (2022): the paper's base, and the model its readers know.
///
/// 62 kg on 6 spheres of R = 0.032 m with E₁* = 1 MPa, α = 2 s/m, cf = 1e-5 m², bd = 300 1/m and bv = 50 s/m,
/// under OpenSim's own gravity of 9.80665 m/s².
///
/// ```
/// let human = contact_scaling::falisse2022();
/// assert_eq!((human.scale.mass_kg(), human.contact.plane_strain_modulus()), (62.0, 1e6));
/// ```
#[must_use]
pub fn falisse2022() -> Preset {
    let scale = ScaleValues { mass_kg: 62.0, radius_m: 0.032, sphere_count: 6.0, gravity_m_s2: 9.80665 };
    let contact = ContactValues {
        plane_strain_modulus: 1e6,
        dissipation: 2.0,
        smoothing: Some(SmoothingValues::OPENSIM_DEFAULT),
    };
    Preset {
        name: "falisse2022".into(),
        source: "Falisse A, Afschrift M, De Groote F (2022). Modeling toes contributes to realistic stance \
                 knee mechanics in three-dimensional predictive simulations of walking. PLoS ONE 17(1): \
                 e0256311; as scaled and printed in Van Bijlert (2026), Table 1"
            .into(),
        scale: Scale::unchecked(scale),
        contact: Contact::unchecked(contact),
    }
}

/// The preset of that name, if there is one.
///
/// ```
/// assert!(contact_scaling::preset("falisse2022").is_some());
/// assert!(contact_scaling::preset("nobody1900").is_none());
/// ```
#[must_use]
pub fn preset(name: &str) -> Option<Preset> {
    PRESETS.iter().find(|(known, _)| *known == name).map(|(_, make)| make())
}

/// The names [`preset`] knows.
pub fn preset_names() -> impl Iterator<Item = &'static str> {
    PRESETS.iter().map(|(name, _)| *name)
}

type Make = fn() -> Preset;
const PRESETS: [(&str, Make); 1] = [("falisse2022", falisse2022)];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_is_valid_and_answers_to_its_name() {
        for name in preset_names() {
            let found = preset(name).unwrap();
            assert_eq!(found.name, name);
            assert_eq!(Scale::new(found.scale.values()), Ok(found.scale));
            assert_eq!(Contact::new(found.contact.values()), Ok(found.contact));
            assert!(!found.source.is_empty());
        }
    }
}
