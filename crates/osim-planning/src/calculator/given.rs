//! What a request for a design gives, before anything is derived.

use contact_scaling::sizing::Known;
use contact_scaling::{DomainError, SharedLoad, modulus};
use osim_model::RadiusRule;
use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_requests::{
    Count, DesignRequest, Kilograms, PoissonRatio, Positive, RelativeIndentation, RequestFault,
};

use crate::gravity::STANDARD_GRAVITY_M_S2;

/// What is known.
pub(super) struct Given {
    pub(super) mass_kg: Option<f64>,
    pub(super) spheres: Option<f64>,
    pub(super) gravity_m_s2: f64,
    load_n: Option<f64>,
    pub(super) radius_m: Option<f64>,
    pub(super) composite_modulus: Option<f64>,
    pub(super) modulus: ModulusFrom,
    indentation: Option<f64>,
    contact_stiffness: Option<f64>,
    /// Whether the load is what the spheres carry at rest.
    pub(super) is_body_weight: bool,
}

/// Where the composite modulus comes from.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum ModulusFrom {
    Young,
    Stiffness,
    Sizing,
}

impl ModulusFrom {
    /// The equation it follows by, if it is another than the register has.
    pub(super) fn equation(self) -> Option<&'static str> {
        match self {
            Self::Young => Some("A.1, A.5"),
            Self::Stiffness => Some("A.4"),
            Self::Sizing => None,
        }
    }
}

/// What an equation refuses.
pub(super) fn refused(error: impl std::fmt::Display) -> RequestFault {
    RequestFault::general(error.to_string())
}

impl Given {
    /// # Errors
    /// A radius that is about a model, or body weights without a mass.
    pub(super) fn new(request: &DesignRequest) -> Result<Self, RequestFault> {
        let wanted = &request.wanted;
        let radius_m = match wanted.radius() {
            None => None,
            Some(RadiusRule::Metres(metres)) => Some(metres),
            Some(_) => {
                let message = phrase![
                    Input::Radius,
                    " needs metres here: there is no model whose radius could be kept or multiplied",
                ];
                return Err(RequestFault::refused(Input::Radius, message));
            }
        };
        let gravity_m_s2 = request.load.gravity().unwrap_or(STANDARD_GRAVITY_M_S2);
        let mass_kg = request.masses.mass.map(Kilograms::get);
        if request.load.body_weights.is_some() && mass_kg.is_none() {
            let message = phrase![Input::BodyWeights, " needs ", Input::Mass.like("KG")];
            return Err(RequestFault::refused(Input::BodyWeights, message));
        }
        let weight = mass_kg.map(|kg| kg * gravity_m_s2 * request.load.body_weights());
        let young = wanted.young.map(Positive::get).zip(wanted.poisson.map(PoissonRatio::get));
        let (composite_modulus, modulus) = match (young, wanted.stiffness) {
            // A soft body on rigid ground (A.5): E* is the body's own plane strain modulus.
            (Some((young, poisson)), _) => {
                (Some(modulus::plane_strain(young, poisson).map_err(refused)?), ModulusFrom::Young)
            }
            (None, Some(surface)) => {
                let composite = modulus::composite_of_equal(surface.get(), modulus::MixingRule::Sherman);
                (Some(composite.map_err(refused)?), ModulusFrom::Stiffness)
            }
            (None, None) => (None, ModulusFrom::Sizing),
        };
        let load = request.load.load.map(Positive::get);
        Ok(Self {
            mass_kg,
            spheres: request.counts.spheres.map(Count::get),
            gravity_m_s2,
            load_n: load.or(weight),
            radius_m,
            composite_modulus,
            modulus,
            indentation: wanted.indentation.map(RelativeIndentation::get),
            contact_stiffness: wanted.contact_stiffness.map(Positive::get),
            is_body_weight: load.is_none() && request.load.body_weights() == 1.0,
        })
    }

    pub(super) fn shared_load(&self) -> Result<Option<SharedLoad>, DomainError> {
        self.load_n.zip(self.spheres).map(|(load, spheres)| SharedLoad::new(load, spheres)).transpose()
    }

    /// What is known of one sphere at its load.
    pub(super) fn known(&self, load: Option<&SharedLoad>) -> Known {
        Known {
            load_per_sphere_n: load.map(SharedLoad::per_sphere_n),
            radius_m: self.radius_m,
            relative_indentation: self.indentation,
            composite_modulus_n_m2: self.composite_modulus,
            stiffness_n_m: self.contact_stiffness,
        }
    }

    /// Whether something is wanted that only follows from a whole sizing.
    pub(super) fn needs_sizing(&self) -> bool {
        self.indentation.is_some() || self.contact_stiffness.is_some()
    }

    /// What to add.
    pub(super) fn missing(&self) -> RequestFault {
        let load = self.load_n.is_some() && self.spheres.is_some();
        let have: [(bool, &str, Phrase); 5] = [
            (
                load,
                "load per sphere",
                phrase![
                    Input::Mass.like("KG"),
                    " (or ",
                    Input::Load.like("N"),
                    ") with ",
                    Input::Spheres.like("N"),
                ],
            ),
            (self.radius_m.is_some(), "radius", Input::Radius.like("METRES").into()),
            (self.indentation.is_some(), "indentation", Input::Indentation.like("X").into()),
            (
                self.composite_modulus.is_some(),
                "modulus",
                phrase![
                    Input::Stiffness.like("E1"),
                    " (or ",
                    Input::Young.like("E"),
                    " with ",
                    Input::Poisson.like("NU"),
                    ")",
                ],
            ),
            (
                self.contact_stiffness.is_some(),
                "contact stiffness",
                Input::ContactStiffness.like("N/M").into(),
            ),
        ];
        let known: Vec<_> = have.iter().filter(|(have, ..)| *have).map(|(_, name, _)| *name).collect();
        let known = if known.is_empty() { "nothing".to_owned() } else { known.join(", ") };
        let mut message = phrase![
            format!("too little is known: three quantities give the rest, known: {known}"),
            &self.half_a_load(),
            "; add of: ",
        ];
        for (index, (.., input)) in have.iter().filter(|(have, ..)| !have).enumerate() {
            if index > 0 {
                message.push("; ");
            }
            message.push(input);
        }
        RequestFault::general(message)
    }

    fn half_a_load(&self) -> Phrase {
        match (self.load_n.is_some(), self.spheres.is_some()) {
            (true, false) => phrase!["; the load needs ", Input::Spheres.like("N"), " too"],
            (false, true) => phrase![
                "; ",
                Input::Spheres,
                " needs ",
                Input::Mass.like("KG"),
                " or ",
                Input::Load.like("N"),
                " too",
            ],
            _ => phrase![],
        }
    }

    /// What disagrees, by the name and in the unit in which it was given.
    pub(super) fn contradiction(&self, quantity: &str, given: f64, follows: f64) -> RequestFault {
        let surface = |composite| {
            modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman).unwrap_or(composite)
        };
        let (input, given, follows): (Phrase, f64, f64) = match (quantity, self.modulus) {
            ("load", _) => ("the load on each sphere, N,".into(), given, follows),
            ("radius", _) => (Input::Radius.into(), given, follows),
            ("indentation", _) => (Input::Indentation.into(), given, follows),
            ("modulus", ModulusFrom::Stiffness) => {
                (Input::Stiffness.into(), surface(given), surface(follows))
            }
            ("modulus", _) => (
                phrase![Input::Young, " and ", Input::Poisson, ": the composite modulus, N/m2,"],
                given,
                follows,
            ),
            _ => (Input::ContactStiffness.into(), given, follows),
        };
        RequestFault::general(phrase![
            &input,
            format!(
                " is given as {}, but {} follows from the other quantities: leave one out",
                readable(given),
                readable(follows)
            ),
        ])
    }
}
