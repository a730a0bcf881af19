//! The numbers that a design request without a model gives, before other numbers are computed from them.

use contact_scaling::sizing::{KnownQuantities, Sizing, SizingError};
use contact_scaling::{DomainError, SharedLoad, SmoothingValues, modulus, restitution, smoothing};
use osim_model::messages::{Input, Phrase, phrase, readable};
use osim_model::{RadiusRule, Suspicion, YesQuestion};
use osim_patch::indentation_of_stress;
use osim_requests::options::AnswerOptions;
use osim_requests::{
    Count, DesignRequest, Kilograms, PoissonRatio, Positive, Radius, RelativeIndentation, RequestFault,
    RestitutionCoefficient,
};

/// The smallest radius, m, that is larger than the feet of any animal.
const RADIUS_OF_NO_FOOT_M: f64 = 1.0;

/// Asks about a radius that is too large to be in metres.
///
/// # Errors
/// The radius is that large, and the caller has not confirmed it.
pub(crate) fn require_plausible_radius(radius_m: f64, answers: &AnswerOptions) -> Result<(), RequestFault> {
    let question = YesQuestion::ImplausibleRadius;
    if radius_m < RADIUS_OF_NO_FOOT_M || answers.confirms(question) {
        return Ok(());
    }
    let metres = |per_metre: f64| readable(radius_m / per_metre);
    let text = phrase![
        "{} is larger than the feet of any animal: radii are in m, write {} if it is in mm, or {} if it is in cm";
        Input::Radius.with_value(readable(radius_m)), metres(1000.0), metres(100.0)
    ];
    Err(RequestFault::refused(Input::Radius, Suspicion::Other { question, text }.phrase()))
}

/// The numbers that a request for a design without a model gives, in SI units.
pub(super) struct DesignInputs {
    pub(super) mass_kg: Option<f64>,
    pub(super) spheres: Option<f64>,
    pub(super) gravity_m_s2: f64,
    load_n: Option<f64>,
    pub(super) radius_m: Option<f64>,
    pub(super) composite_modulus: Option<f64>,
    pub(super) modulus: ModulusSource,
    indentation: Option<f64>,
    /// The input that determines the indentation.
    pub(super) depth: Input,
    contact_stiffness: Option<f64>,
    /// Whether the load is one body weight, which the spheres carry in equilibrium.
    pub(super) is_body_weight: bool,
}

/// What E* follows from: Young's modulus, two surfaces, OpenSim's stiffness, or the other quantities.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum ModulusSource {
    Young,
    /// The plane strain moduli of two surfaces, N/m².
    TwoSurfaces([f64; 2]),
    Stiffness,
    Sizing,
}

impl ModulusSource {
    /// The numbers of the equations that give the modulus; `None` if the register of quantities already has the right number.
    pub(super) fn equation(self) -> Option<&'static str> {
        match self {
            Self::Young => Some("A.1, A.5"),
            Self::TwoSurfaces(_) => Some("A.1, A.2"),
            Self::Stiffness => Some("A.4"),
            Self::Sizing => None,
        }
    }
}

/// Turns the error of an equation that refuses a number into a fault of the request.
pub(crate) fn domain_fault(error: impl std::fmt::Display) -> RequestFault {
    RequestFault::general(error.to_string())
}

impl DesignInputs {
    /// Reads the numbers of the request.
    ///
    /// # Errors
    ///
    /// The radius is relative to a model, or body weights are given without a mass.
    pub(super) fn new(request: &DesignRequest) -> Result<Self, RequestFault> {
        let wanted = &request.clone().with_indentation_of_stiffness()?.wanted;
        let radius_m = match wanted.radius.map(Radius::rule) {
            None => None,
            Some(Some(RadiusRule::Metres(metres))) => {
                require_plausible_radius(metres, &request.answers)?;
                Some(metres)
            }
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
            let message = phrase![Input::BodyWeights, " needs ", Input::Mass.with_placeholder("KG")];
            return Err(RequestFault::refused(Input::BodyWeights, message));
        }
        let weight = mass_kg.map(|kg| kg * gravity_m_s2 * request.load.body_weights());
        let young = wanted.young.map(Positive::get).zip(wanted.poisson.map(PoissonRatio::get));
        let other = request.other_young.map(Positive::get).zip(request.other_poisson.map(PoissonRatio::get));
        let of_material = |(young, poisson)| modulus::plane_strain(young, poisson).map_err(domain_fault);
        let (composite_modulus, modulus) = match (young, wanted.stiffness) {
            (Some(young), _) => match (of_material(young)?, other.map(of_material).transpose()?) {
                // A soft body on rigid ground (A.5): E* is the body's own plane strain modulus.
                (own, None) => (Some(own), ModulusSource::Young),
                (own, Some(other)) => {
                    let composite = modulus::composite_johnson(own, other).map_err(domain_fault)?;
                    (Some(composite), ModulusSource::TwoSurfaces([own, other]))
                }
            },
            (None, Some(surface)) => {
                let composite = modulus::composite_of_equal(surface.get(), modulus::MixingRule::Sherman);
                (Some(composite.map_err(domain_fault)?), ModulusSource::Stiffness)
            }
            (None, None) => (None, ModulusSource::Sizing),
        };
        let load = request.load.load.map(Positive::get);
        let spheres = request.counts.spheres.map(Count::get);
        let load_n = load.or(weight);
        let indentation = match (request.stress.map(Positive::get), load_n.zip(spheres), radius_m) {
            (None, ..) => wanted.indentation.map(RelativeIndentation::get),
            (Some(stress), Some((load, spheres)), Some(radius)) => Some(
                indentation_of_stress(stress, load / spheres, radius)
                    .map_err(|why| RequestFault::refused(Input::Stress, why))?,
            ),
            (Some(_), ..) => {
                let message = phrase![
                    "{} needs a load on a number of spheres, and {}";
                    Input::Stress, Input::Radius.with_placeholder("METRES")
                ];
                return Err(RequestFault::refused(Input::Stress, message));
            }
        };
        Ok(Self {
            mass_kg,
            spheres,
            gravity_m_s2,
            load_n,
            radius_m,
            composite_modulus,
            modulus,
            indentation,
            depth: match (request.stress, request.dimensionless_stiffness) {
                (Some(_), _) => Input::Stress,
                (None, Some(_)) => Input::DimensionlessStiffness,
                (None, None) => Input::Indentation,
            },
            contact_stiffness: wanted.contact_stiffness.map(Positive::get),
            is_body_weight: load.is_none() && request.load.body_weights() == 1.0,
        })
    }

    /// The load on all spheres, if load and number of spheres are given.
    pub(super) fn shared_load(&self) -> Result<Option<SharedLoad>, DomainError> {
        self.load_n.zip(self.spheres).map(|(load, spheres)| SharedLoad::new(load, spheres)).transpose()
    }

    /// The given quantities of one sphere under its load.
    pub(super) fn known_quantities(&self, load: Option<&SharedLoad>) -> KnownQuantities {
        KnownQuantities {
            load_per_sphere_n: load.map(SharedLoad::per_sphere_n),
            radius_m: self.radius_m,
            relative_indentation: self.indentation,
            composite_modulus_n_m2: self.composite_modulus,
            stiffness_n_m: self.contact_stiffness,
        }
    }

    /// Whether the request wants a number for which all quantities of a sphere under its load have to be known.
    pub(super) fn needs_sizing(&self) -> bool {
        self.indentation.is_some() || self.contact_stiffness.is_some()
    }

    /// A fault that lists the inputs that are missing; some of these have to be added.
    pub(super) fn missing_inputs(&self) -> RequestFault {
        let load = self.load_n.is_some() && self.spheres.is_some();
        let have: [(bool, &str, Phrase); 5] = [
            (
                load,
                "load per sphere",
                phrase![
                    "{} (or {}) with {}";
                    Input::Mass.with_placeholder("KG"), Input::Load.with_placeholder("N"),
                    Input::Spheres.with_placeholder("N")
                ],
            ),
            (self.radius_m.is_some(), "radius", Input::Radius.with_placeholder("METRES").into()),
            (self.indentation.is_some(), "indentation", Input::Indentation.with_placeholder("X").into()),
            (
                self.composite_modulus.is_some(),
                "modulus",
                phrase![
                    "{} (or {} with {})";
                    Input::Stiffness.with_placeholder("E1"), Input::Young.with_placeholder("E"),
                    Input::Poisson.with_placeholder("NU")
                ],
            ),
            (
                self.contact_stiffness.is_some(),
                "contact stiffness",
                Input::ContactStiffness.with_placeholder("N/M").into(),
            ),
        ];
        let known: Vec<_> = have.iter().filter(|(have, ..)| *have).map(|(_, name, _)| *name).collect();
        let known = if known.is_empty() { "nothing".to_owned() } else { known.join(", ") };
        let mut message = phrase![
            "too little is known: three quantities give the rest, known: {known}{}; add of: ";
            &self.missing_part_of_load()
        ];
        let others = have.iter().filter(|(have, ..)| !have).map(|(.., input)| input.clone());
        message.push(&Phrase::joined(others, "; ").unwrap_or_default());
        RequestFault::general(message)
    }

    /// The end of a message, if only the load or only the number of spheres is given.
    fn missing_part_of_load(&self) -> Phrase {
        match (self.load_n.is_some(), self.spheres.is_some()) {
            (true, false) => phrase!["; the load needs ", Input::Spheres.with_placeholder("N"), " too"],
            (false, true) => phrase![
                "; {} needs {} or {} too";
                Input::Spheres, Input::Mass.with_placeholder("KG"), Input::Load.with_placeholder("N")
            ],
            _ => phrase![],
        }
    }

    /// The fault that a given quantity contradicts the value that follows from the others. It has the name and the unit in which the
    /// quantity was given.
    fn contradiction(&self, quantity: &str, given: f64, follows: f64) -> RequestFault {
        let surface = |composite| {
            modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman).unwrap_or(composite)
        };
        let (input, given, follows): (Phrase, f64, f64) = match (quantity, self.modulus) {
            ("load", _) => ("the load on each sphere, N,".into(), given, follows),
            ("radius", _) => (Input::Radius.into(), given, follows),
            ("indentation", _) if self.depth == Input::Indentation => (self.depth.into(), given, follows),
            ("indentation", _) => (phrase!["x/R by ", self.depth], given, follows),
            ("modulus", ModulusSource::Stiffness) => {
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
            "{} is given as {}, but {} follows from the other quantities: leave one out";
            &input, readable(given), readable(follows)
        ])
    }
}

// The share of the Hertz force that a smoothed contact has at rest.

/// The largest number of iterations for a radius, if dissipation and load both depend on it. Each iteration brings the radius at least
/// three times closer.
const MOST_RADIUS_ITERATIONS: u32 = 60;

/// A smoothed contact that does not move, by (C.9) at speed 0.
#[derive(Clone, Copy)]
pub(super) struct RestingContact {
    /// The force of the contact at speed 0 over the Hertz force.
    pub(super) speed_state: f64,
    dissipation_s_m: f64,
    smoothing_s_m: f64,
    /// Whether the smoothing is OpenSim's default, because none was given.
    is_default: bool,
}

impl RestingContact {
    /// The contact for the wanted numbers; `None` if no smoothing is wanted, or no dissipation is known.
    fn from_wanted(
        request: &DesignRequest,
        radius_m: Option<f64>,
        gravity_m_s2: f64,
    ) -> Result<Option<Self>, RequestFault> {
        let wanted = &request.wanted;
        let given =
            [request.state_smoothing, request.speed_smoothing, wanted.state_width, wanted.speed_width];
        if given.iter().all(Option::is_none) && wanted.constant_indentation.is_none() {
            return Ok(None);
        }
        let fall = || radius_m.map(|radius| restitution::drop_speed(gravity_m_s2, radius)).transpose();
        let speed = match wanted.impact_speed.map(Positive::get) {
            Some(speed) => Some(speed),
            None => fall().map_err(domain_fault)?,
        };
        let target = wanted.restitution.map(RestitutionCoefficient::get);
        let Some((target, speed)) = target.zip(speed) else { return Ok(None) };
        let dissipation_s_m = restitution::dissipation(target, speed).map_err(domain_fault)?;
        let wanted_s_m = speed_smoothing(request, radius_m)?;
        let smoothing_s_m = wanted_s_m.unwrap_or(SmoothingValues::OPENSIM_DEFAULT.hunt_crossley_smoothing);
        let speed_state =
            smoothing::speed_state_at_rest(dissipation_s_m, smoothing_s_m).map_err(domain_fault)?;
        Ok(Some(Self { speed_state, dissipation_s_m, smoothing_s_m, is_default: wanted_s_m.is_none() }))
    }

    /// A sentence for the results, if the force at speed 0 visibly differs from the Hertz force.
    pub(super) fn remark(self) -> Option<String> {
        let share = readable(self.speed_state);
        let default = if self.is_default { " (OpenSim's default)" } else { "" };
        (share != "1").then(|| {
            format!(
                "at rest the smoothed force is {share} of the Hertz force, by (C.9) at speed 0 with dissipation {} and \
                 hunt_crossley_smoothing {}{default}; load, modulus and stiffness are made for that",
                readable(self.dissipation_s_m),
                readable(self.smoothing_s_m),
            )
        })
    }
}

/// The wanted bv, s/m, by the width in speed or by b_ẋ (C.10); `None` if none is wanted, or the radius that b_ẋ needs is not known.
///
/// # Errors
/// A number outside its domain.
pub(super) fn speed_smoothing(
    request: &DesignRequest,
    radius_m: Option<f64>,
) -> Result<Option<f64>, RequestFault> {
    let threshold = request.wanted.threshold.get();
    let of_width =
        |width: Positive| smoothing::hunt_crossley_smoothing_for_speed_width(threshold, width.get());
    let reduced = request.speed_smoothing.zip(radius_m);
    let of_reduced =
        |(reduced, radius): (Positive, f64)| smoothing::hunt_crossley_smoothing(reduced.get(), radius);
    let known = request.wanted.speed_width.map(of_width).or(reduced.map(of_reduced));
    known.transpose().map_err(domain_fault)
}

/// All quantities of a sphere under its load, if enough of them are known, and the smoothed contact at speed 0 from which they were
/// computed.
///
/// # Errors
/// A number outside its domain, or numbers that contradict each other.
pub(super) fn solve_at_rest(
    known: &KnownQuantities,
    inputs: &DesignInputs,
    request: &DesignRequest,
) -> Result<(Option<Sizing>, Option<RestingContact>), RequestFault> {
    let mut radius = inputs.radius_m;
    let mut solution = (None, None);
    for _ in 0..MOST_RADIUS_ITERATIONS {
        let at_rest = RestingContact::from_wanted(request, radius, inputs.gravity_m_s2)?;
        let sizing = match known.solve_smoothed(at_rest.map_or(1.0, |known| known.speed_state)) {
            Ok(sizing) => Some(sizing),
            // Some figures need no sizing.
            Err(SizingError::Insufficient { .. }) => None,
            Err(SizingError::Contradictory { quantity, given: given_value, follows }) => {
                return Err(inputs.contradiction(quantity, given_value, follows));
            }
            Err(error) => return Err(domain_fault(error)),
        };
        solution = (sizing, at_rest);
        let next = sizing.map(|sizing| sizing.radius_m).or(radius);
        if next == radius {
            break;
        }
        radius = next;
    }
    Ok(solution)
}

/// Standard gravity, which a design without a gravity takes, m/s².
pub(crate) const STANDARD_GRAVITY_M_S2: f64 = 9.80665;
