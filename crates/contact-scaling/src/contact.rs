//! The contact parameters of a sphere in OpenSim's form, its friction, and published contacts.

use std::borrow::Cow;

use crate::error::{Result, require_non_negative, require_positive};
use crate::{Ratios, Scale, ScaleValues, SmoothingValues};

/// 2^(3/2), without unit: E₁* of each of two equal surfaces divided by their composite E*, by OpenSim's mixing rule (A.3), (A.4).
pub const SURFACE_OVER_COMPOSITE_MODULUS: f64 = 2.0 * std::f64::consts::SQRT_2;

/// The parameters of one contact, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactValues {
    /// E₁*, plane strain modulus of each of two equal surfaces, in N/m²: OpenSim's `stiffness`.
    pub plane_strain_modulus: f64,
    /// α, in s/m: OpenSim's `dissipation`. 0 is legal.
    pub dissipation: f64,
    /// The parameters that only `SmoothSphereHalfSpaceForce` has; `None` for `HuntCrossleyForce`.
    pub smoothing: Option<SmoothingValues>,
}

/// The contact of a sphere with a half-space, both of one material.
///
/// E₁*, bd and bv are above 0, α and cf are 0 or above, all finite: checked once, in [`Contact::new`].
///
/// ```
/// use contact_scaling::{Contact, ContactValues};
/// let contact = Contact::new(ContactValues { plane_strain_modulus: 1e6, dissipation: 2.0, smoothing: None })?;
/// assert!((contact.composite_modulus() - 353_553.39).abs() < 0.01); // Table 1: 0.354 MPa
/// # Ok::<(), contact_scaling::DomainError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact(ContactValues);

impl Contact {
    /// Checks the parameters and makes a contact of them.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless E₁* > 0, α ≥ 0, cf ≥ 0, bd > 0 and bv > 0, all finite.
    pub fn new(values: ContactValues) -> Result<Self> {
        require_positive("plane strain modulus", values.plane_strain_modulus)?;
        require_non_negative("dissipation", values.dissipation)?;
        if let Some(smoothing) = values.smoothing {
            require_non_negative("constant contact force", smoothing.constant_contact_force)?;
            require_positive("hertz smoothing", smoothing.hertz_smoothing)?;
            require_positive("hunt crossley smoothing", smoothing.hunt_crossley_smoothing)?;
        }
        Ok(Self(values))
    }

    /// A contact of parameters that are known to be valid.
    pub(crate) fn unchecked(values: ContactValues) -> Self {
        Self(values)
    }

    /// The parameters, by name.
    pub fn values(&self) -> ContactValues {
        self.0
    }

    /// E₁*, in N/m²: OpenSim's `stiffness`.
    pub fn plane_strain_modulus(&self) -> f64 {
        self.0.plane_strain_modulus
    }

    /// E* = E₁* / 2^(3/2), in N/m² (A.4).
    pub fn composite_modulus(&self) -> f64 {
        self.plane_strain_modulus() / SURFACE_OVER_COMPOSITE_MODULUS
    }

    /// α, in s/m: OpenSim's `dissipation`.
    pub fn dissipation(&self) -> f64 {
        self.0.dissipation
    }

    /// cf, bd and bv; `None` if the law is not smoothed.
    pub fn smoothing(&self) -> Option<SmoothingValues> {
        self.0.smoothing
    }

    /// The contact that is geometrically and dynamically similar to this one at another scale.
    ///
    /// Every parameter is multiplied once by its factor in [`Ratios`], so that ratios of 1 change no bit.
    /// It applies (10), (14), (C.2), (C.5) and (C.10). The products are not checked against the range of `f64`.
    #[must_use]
    pub fn scaled(&self, ratios: &Ratios) -> Self {
        let smoothing = self.smoothing().map(|s| SmoothingValues {
            constant_contact_force: s.constant_contact_force * ratios.constant_contact_force(),
            hertz_smoothing: s.hertz_smoothing * ratios.hertz_smoothing(),
            hunt_crossley_smoothing: s.hunt_crossley_smoothing * ratios.hunt_crossley_smoothing(),
        });
        Self(ContactValues {
            plane_strain_modulus: self.plane_strain_modulus() * ratios.plane_strain_modulus(),
            dissipation: self.dissipation() * ratios.dissipation(),
            smoothing,
        })
    }
}

// Friction of one sphere that slips, as both contact classes of OpenSim have it.

/// The friction parameters of a sphere, by name and not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionValues {
    /// Coefficient of friction near slip speed 0, without unit: OpenSim's `static_friction`.
    pub static_friction: f64,
    /// Coefficient of friction far above the transition velocity, without unit: OpenSim's `dynamic_friction`.
    pub dynamic_friction: f64,
    /// Coefficient of viscous friction, s/m: OpenSim's `viscous_friction`.
    pub viscous_friction: f64,
    /// Speed below which friction is smoothed, m/s: OpenSim's `transition_velocity`.
    pub transition_velocity: f64,
}

/// The friction of one sphere: friction force divided by normal force, at each slip speed.
///
/// Coefficients and the transition velocity are 0 or above: checked once, in [`Friction::new`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction(FrictionValues);

impl Friction {
    /// Checks the friction parameters and makes a friction of them.
    ///
    /// # Errors
    /// [`DomainError`](crate::DomainError) unless the coefficients and the transition velocity are finite and 0 or above.
    pub fn new(values: FrictionValues) -> Result<Self> {
        require_non_negative("static friction", values.static_friction)?;
        require_non_negative("dynamic friction", values.dynamic_friction)?;
        require_non_negative("viscous friction", values.viscous_friction)?;
        require_non_negative("transition velocity", values.transition_velocity)?;
        Ok(Self(values))
    }

    /// The friction coefficients and the transition velocity, by name.
    pub const fn values(&self) -> FrictionValues {
        self.0
    }

    /// Friction force over normal force at the slip speed v (m/s): min(v/vt, 1) (μd + 2 (μs − μd)/(1 + (v/vt)²)) + μv v.
    ///
    /// With vt = 0 it is plain Coulomb friction: μd + μv v, and 0 at rest.
    ///
    /// Not in the paper: both contact classes of OpenSim use this formula of Simbody's `HuntCrossleyForce`.
    ///
    /// ```
    /// # use contact_scaling::{Friction, FrictionValues};
    /// let values =
    ///     FrictionValues { static_friction: 0.8, dynamic_friction: 0.6, viscous_friction: 0.5, transition_velocity: 0.2 };
    /// let friction = Friction::new(values)?;
    /// assert_eq!(friction.coefficient(0.0), 0.0);
    /// // At the transition velocity: the static coefficient, and what is viscous.
    /// assert!((friction.coefficient(0.2) - (0.8 + 0.1)).abs() < 1e-15);
    /// # Ok::<(), contact_scaling::DomainError>(())
    /// ```
    pub fn coefficient(&self, slip_speed_m_s: f64) -> f64 {
        let FrictionValues { static_friction, dynamic_friction, viscous_friction, transition_velocity } =
            self.0;
        let relative = if slip_speed_m_s == 0.0 { 0.0 } else { slip_speed_m_s / transition_velocity };
        let dry = dynamic_friction + 2.0 * (static_friction - dynamic_friction) / (1.0 + relative * relative);
        relative.min(1.0) * dry + viscous_friction * slip_speed_m_s
    }

    /// The common coefficient of friction of two surfaces with different coefficients a and b, without unit: 2 a b/(a + b),
    /// and 0 if both are 0.
    ///
    /// Not in the paper: the mixing rule of Simbody's `HuntCrossleyForce`.
    ///
    /// ```
    /// # use contact_scaling::Friction;
    /// assert_eq!((Friction::mixed(0.8, 0.8), Friction::mixed(0.0, 0.8), Friction::mixed(0.0, 0.0)), (0.8, 0.0, 0.0));
    /// ```
    pub fn mixed(one: f64, other: f64) -> f64 {
        if one == other { one } else { 2.0 * one * other / (one + other) }
    }
}

// Published contacts, each with its source and the scale it was made for.

/// A published contact, with the scale of the body that it was made for.
#[derive(Debug, Clone, PartialEq)]
pub struct Preset {
    /// Name of the preset, such as `falisse2022`.
    pub name: Cow<'static, str>,
    /// The publication of the contact.
    pub source: Cow<'static, str>,
    /// The scale of the body that the contact was made for.
    pub scale: Scale,
    /// Contact of each sphere of the preset.
    pub contact: Contact,
}

/// The contacts of the human model of Falisse et al. (2022), from which the paper scales to all animals.
///
/// 62 kg on 6 spheres of R = 0.032 m with E₁* = 1 MPa, α = 2 s/m, cf = 1e-5 m², bd = 300 1/m and bv = 50 s/m,
/// under OpenSim's own gravity of 9.80665 m/s².
///
/// ```
/// let human = contact_scaling::falisse2022();
/// assert_eq!((human.scale.mass_kg(), human.contact.plane_strain_modulus()), (62.0, 1e6));
/// ```
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

/// The contacts of Moco's example of 3-D walking.
///
/// 85.3 kg on 6 spheres of R = 0.035 m with E₁* = 1 MPa, α = 2 s/m and OpenSim's smoothing.
///
/// ```
/// let walker = contact_scaling::moco_3d_walking();
/// assert_eq!((walker.scale.radius_m(), walker.scale.sphere_count()), (0.035, 6.0));
/// ```
pub fn moco_3d_walking() -> Preset {
    let mass_kg = 85.269_848_541_731_48;
    Preset {
        name: "moco-3d-walking".into(),
        source: "opensim-org/opensim-core: OpenSim/Examples/Moco/example3DWalking/\
                 subject_walk_scaled_ContactForceSet.xml and its geometry (Apache-2.0)"
            .into(),
        scale: Scale::unchecked(ScaleValues { mass_kg, radius_m: 0.035, ..falisse2022().scale.values() }),
        contact: falisse2022().contact,
    }
}

/// The contacts of osim-rl's model gait9dof18musc, a `HuntCrossleyForce`.
///
/// 79.7 kg on 2 spheres of R = 0.05 m with E₁* = 0.6 MPa and α = 1.5 s/m.
///
/// ```
/// let runner = contact_scaling::osim_rl();
/// assert_eq!((runner.scale.sphere_count(), runner.contact.dissipation()), (2.0, 1.5));
/// ```
pub fn osim_rl() -> Preset {
    let scale = ScaleValues { mass_kg: 79.6646, radius_m: 0.05, sphere_count: 2.0, gravity_m_s2: 9.80665 };
    let contact = ContactValues { plane_strain_modulus: 6e5, dissipation: 1.5, smoothing: None };
    Preset {
        name: "osim-rl".into(),
        source: "github.com/stanfordnmbl/osim-rl: osim/models/gait9dof18musc.osim (MIT)".into(),
        scale: Scale::unchecked(scale),
        contact: Contact::unchecked(contact),
    }
}

/// The preset called `name`; `None` if there is none.
///
/// ```
/// assert!(contact_scaling::preset("falisse2022").is_some());
/// assert!(contact_scaling::preset("nobody1900").is_none());
/// ```
pub fn preset(name: &str) -> Option<Preset> {
    PRESETS.iter().find(|(known, _)| *known == name).map(|(_, make)| make())
}

/// The names of all presets, for [`preset`].
pub fn preset_names() -> impl Iterator<Item = &'static str> {
    PRESETS.iter().map(|(name, _)| *name)
}

type MakePreset = fn() -> Preset;
/// The names of all presets, each with the function that makes it.
const PRESETS: [(&str, MakePreset); 3] =
    [("falisse2022", falisse2022), ("moco-3d-walking", moco_3d_walking), ("osim-rl", osim_rl)];

#[cfg(test)]
mod tests {
    use super::*;

    const SMOOTH: SmoothingValues = SmoothingValues::OPENSIM_DEFAULT;
    const VALUES: ContactValues =
        ContactValues { plane_strain_modulus: 1e6, dissipation: 2.0, smoothing: Some(SMOOTH) };

    #[test]
    fn every_field_is_checked_by_name() {
        let refused = |values| Contact::new(values).unwrap_err().quantity();
        let smooth = |smoothing| ContactValues { smoothing: Some(smoothing), ..VALUES };
        assert_eq!(refused(ContactValues { plane_strain_modulus: 0.0, ..VALUES }), "plane strain modulus");
        assert_eq!(refused(ContactValues { dissipation: -1.0, ..VALUES }), "dissipation");
        let cf = SmoothingValues { constant_contact_force: -1e-9, ..SMOOTH };
        assert_eq!(refused(smooth(cf)), "constant contact force");
        let bd = SmoothingValues { hertz_smoothing: 0.0, ..SMOOTH };
        assert_eq!(refused(smooth(bd)), "hertz smoothing");
        let bv = SmoothingValues { hunt_crossley_smoothing: f64::NAN, ..SMOOTH };
        assert_eq!(refused(smooth(bv)), "hunt crossley smoothing");
    }

    #[test]
    fn no_dissipation_and_no_constant_force_are_legal_and_stay() {
        let smoothing = Some(SmoothingValues { constant_contact_force: 0.0, ..SMOOTH });
        let contact = Contact::new(ContactValues { dissipation: 0.0, smoothing, ..VALUES }).unwrap();
        let scaled = contact.scaled(&Ratios::isometric(7.0).unwrap());
        assert_eq!(scaled.dissipation(), 0.0);
        assert_eq!(scaled.smoothing().unwrap().constant_contact_force, 0.0);
    }

    #[test]
    fn ratios_of_one_change_no_bit() {
        let odd = ContactValues {
            plane_strain_modulus: 1_234_567.890_123_4,
            dissipation: 0.1 + 0.2,
            smoothing: Some(SMOOTH),
        };
        let contact = Contact::new(odd).unwrap();
        assert_eq!(contact.scaled(&Ratios::identity()), contact);
    }

    #[test]
    fn friction_far_above_the_transition_velocity_is_dynamic() {
        let values = FrictionValues {
            static_friction: 0.9,
            dynamic_friction: 0.5,
            viscous_friction: 0.0,
            transition_velocity: 1e-6,
        };
        let friction = Friction::new(values).unwrap();
        assert!((friction.coefficient(1.0) - 0.5).abs() < 1e-11);
        let coulomb = Friction::new(FrictionValues { transition_velocity: 0.0, ..values }).unwrap();
        assert_eq!([0.0, 1e-9, 1.0].map(|speed| coulomb.coefficient(speed)), [0.0, 0.5, 0.5]);
        assert!(Friction::new(FrictionValues { transition_velocity: -0.1, ..values }).is_err());
        assert!(Friction::new(FrictionValues { dynamic_friction: -0.1, ..values }).is_err());
        assert!(Friction::new(FrictionValues { viscous_friction: f64::NAN, ..values }).is_err());
    }

    #[test]
    fn every_preset_is_valid_and_is_found_by_its_name() {
        for name in preset_names() {
            let found = preset(name).unwrap();
            assert_eq!(found.name, name);
            assert_eq!(Scale::new(found.scale.values()), Ok(found.scale));
            assert_eq!(Contact::new(found.contact.values()), Ok(found.contact));
            assert!(!found.source.is_empty());
        }
    }
}
