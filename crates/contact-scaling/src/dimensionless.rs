//! Dimensionless contacts: the parameters that are equal in two similar contacts.

use crate::{Contact, ContactValues, SURFACE_OVER_COMPOSITE_MODULUS, Scale, SmoothingValues, design};

/// The parameters of a contact, made dimensionless with a [`Scale`].
///
/// | parameter | formed from |
/// |---|---|
/// | modulus | Ê = E* n R² / (M g), with the *composite* E* = E₁* / 2^(3/2) |
/// | dissipation | α √(g R) |
/// | constant indentation | √cf / R |
/// | Hertz smoothing | bd R |
/// | Hunt–Crossley smoothing | bv √(g R) |
///
/// Two bodies whose contacts have equal dimensionless parameters have the same motion in dimensionless time: (8), (14), (C.2),
/// (C.5), (C.10).
///
/// ```
/// use contact_scaling::{DimensionlessContact, falisse2022};
/// let human = falisse2022();
/// let dimensionless = DimensionlessContact::of(&human.contact, &human.scale);
/// assert!((dimensionless.relative_indentation() - 0.353).abs() < 5e-4); // Table 1
/// assert!((dimensionless.hertz_smoothing().unwrap() - 9.6).abs() < 1e-12); // under (C.5)
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DimensionlessContact {
    modulus: f64,
    dissipation: f64,
    /// √cf / R, bd R and bv √(g R).
    smoothing: Option<[f64; 3]>,
}

impl DimensionlessContact {
    /// The dimensionless form of `contact` on a body of scale `scale`.
    pub fn of(contact: &Contact, scale: &Scale) -> Self {
        let radius = scale.radius_m();
        let speed = scale.speed_m_s();
        Self {
            modulus: contact.composite_modulus() * radius * radius / scale.load_per_sphere_n(),
            dissipation: contact.dissipation() * speed,
            smoothing: contact.smoothing().map(|s| {
                let constant_indentation = s.constant_contact_force.sqrt() / radius;
                [constant_indentation, s.hertz_smoothing * radius, s.hunt_crossley_smoothing * speed]
            }),
        }
    }

    /// Ê = E* n R² / (M g), with the composite E*.
    pub fn modulus(&self) -> f64 {
        self.modulus
    }

    /// Dimensionless dissipation α √(g R).
    pub fn dissipation(&self) -> f64 {
        self.dissipation
    }

    /// x̂_c = √cf / R; `None` for a law without smoothing.
    pub fn constant_indentation(&self) -> Option<f64> {
        self.smoothing.map(|[constant_indentation, ..]| constant_indentation)
    }

    /// b_x̂ = bd R; `None` for a law without smoothing.
    pub fn hertz_smoothing(&self) -> Option<f64> {
        self.smoothing.map(|[_, hertz_smoothing, _]| hertz_smoothing)
    }

    /// bv √(g R); `None` for a law without smoothing.
    pub fn hunt_crossley_smoothing(&self) -> Option<f64> {
        self.smoothing.map(|[.., hunt_crossley_smoothing]| hunt_crossley_smoothing)
    }

    /// Relative indentation x̂ under body weight by the Hertz law: (3 / (4 Ê))^(2/3).
    ///
    /// It is (11) solved for x̂, without cf and bd; with a smoothed law, the indentation at equilibrium is another.
    pub fn relative_indentation(&self) -> f64 {
        design::relative_depth(1.0, self.modulus, 1.0)
    }

    /// Whether two contacts have equal parameters, each within `rel_tol` times the larger value.
    ///
    /// A smoothed contact is never equal to a contact without smoothing.
    pub fn agrees_with(&self, other: &Self, rel_tol: f64) -> bool {
        let close = |a: f64, b: f64| (a - b).abs() <= rel_tol * a.abs().max(b.abs());
        let smoothing = match (self.smoothing, other.smoothing) {
            (None, None) => true,
            (Some(a), Some(b)) => a.into_iter().zip(b).all(|(a, b)| close(a, b)),
            _ => false,
        };
        smoothing && close(self.modulus, other.modulus) && close(self.dissipation, other.dissipation)
    }

    /// The contact with these dimensionless parameters on a body of scale `scale`.
    ///
    /// For rescaling prefer [`Contact::scaled`]: dimensionless parameters add rounding errors in the last bits.
    pub fn dimensional(&self, scale: &Scale) -> Contact {
        let radius = scale.radius_m();
        let speed = scale.speed_m_s();
        Contact::unchecked(ContactValues {
            plane_strain_modulus: self.modulus * SURFACE_OVER_COMPOSITE_MODULUS * scale.load_per_sphere_n()
                / (radius * radius),
            dissipation: self.dissipation / speed,
            smoothing: self.smoothing.map(|[depth, hertz, hunt_crossley]| SmoothingValues {
                constant_contact_force: (depth * radius) * (depth * radius),
                hertz_smoothing: hertz / radius,
                hunt_crossley_smoothing: hunt_crossley / speed,
            }),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Ratios, ScaleValues, falisse2022};
    use proptest::prelude::*;

    #[test]
    fn dimensionless_parameters_of_falisse_are_those_of_the_paper() {
        let human = falisse2022();
        let d = DimensionlessContact::of(&human.contact, &human.scale);
        assert!((d.constant_indentation().unwrap() - 0.0988).abs() < 5e-5); // under (C.2)
        assert!((d.hertz_smoothing().unwrap() - 9.6).abs() < 1e-12); // under (C.5)
        // Under (C.10): b = bv √R = 8.94; here with √g.
        let b = d.hunt_crossley_smoothing().unwrap() / 9.80665_f64.sqrt();
        assert!((b - 8.94).abs() < 5e-3);
    }

    #[test]
    fn a_smoothed_and_an_unsmoothed_contact_never_agree() {
        let human = falisse2022();
        let plain = Contact::new(ContactValues { smoothing: None, ..human.contact.values() }).unwrap();
        let a = DimensionlessContact::of(&human.contact, &human.scale);
        let b = DimensionlessContact::of(&plain, &human.scale);
        assert!(!a.agrees_with(&b, 1.0));
        assert!(a.agrees_with(&a, 0.0) && b.agrees_with(&b, 0.0));
    }

    prop_compose! {
        fn any_scale()(mass_kg in 1e-3..1e4, radius_m in 1e-3..0.5, sphere_count in 1.0..50.0, gravity_m_s2 in 1.0..25.0)
            -> Scale {
            Scale::new(ScaleValues { mass_kg, radius_m, sphere_count, gravity_m_s2 }).unwrap()
        }
    }

    proptest! {
        #[test]
        fn rescaling_keeps_the_dimensionless_contact(a in any_scale(), b in any_scale()) {
            let contact = falisse2022().contact;
            let scaled = contact.scaled(&Ratios::between(&a, &b).unwrap());
            let before = DimensionlessContact::of(&contact, &a);
            let after = DimensionlessContact::of(&scaled, &b);
            prop_assert!(before.agrees_with(&after, 1e-14));
            let through = DimensionlessContact::of(&before.dimensional(&b), &b);
            prop_assert!(through.agrees_with(&before, 1e-14));
        }
    }
}
