//! The verb `design`: computes parameters of contacts from the wanted properties.

use contact_scaling::SharedLoad;
use osim_inspect::{ContactsOrigin, LoadSharing, Stance, ways_within_hertz, weight_share_on_floor};
use osim_model::messages::{Input, Verb, phrase};
use osim_model::{
    CountedSpheres, Fault, GravityFor, Mass, MassRequest, MissingFact, Model, RadiusRule, Selected, Selection,
};
use osim_patch::{Design, DesignModulus, Plan, design};
use osim_requests::options::{CountOptions, InspectionOptions, LoadOptions, WantedOptions};
use osim_requests::{
    ConstantIndentation, DesignRequest, PoissonRatio, Positive, Radius, RelativeIndentation, RequestFault,
    RestitutionCoefficient,
};

use crate::prepared_change::{Planner, PreparedChange};
use crate::remarks::remark_on_limbs;

/// Plans the contact parameters that follow from a wanted behaviour.
pub(super) struct DesignPlanner {
    wanted: WantedOptions,
    stress_n_m2: Option<f64>,
    state_smoothing: Option<f64>,
    speed_smoothing: Option<f64>,
    load: LoadOptions,
    counts: CountOptions,
    selection: Selection,
    masses: MassRequest,
}

/// Checks a request that names models. ([`design_sheet`](crate::design_sheet) calculates a design without models.)
///
/// # Errors
/// Options that have no effect, or contradict each other.
pub(crate) fn prepare(request: DesignRequest) -> Result<PreparedChange, RequestFault> {
    let DesignRequest { models, output, answers, set_files, masses, choice, .. } = request.clone();
    let stance = request.counts.stance_options(request.wanted.impact_speed, request.load.gravity);
    let inspection = InspectionOptions { stance, masses, choice, set_files, answers };
    Ok(PreparedChange::new(Verb::Design, models, output, inspection, planner(request)?))
}

/// Makes the planner of a design. The verb `add` also uses it, to give numbers to new contacts.
///
/// # Errors
/// Options that have no effect, or contradict each other.
pub(super) fn planner(request: DesignRequest) -> Result<DesignPlanner, RequestFault> {
    let request = request.with_indentation_of_stiffness()?;
    refuse_useless_options(&request)?;
    Ok(DesignPlanner {
        stress_n_m2: request.stress.map(Positive::get),
        state_smoothing: request.state_smoothing.map(Positive::get),
        speed_smoothing: request.speed_smoothing.map(Positive::get),
        selection: request.choice.selection(),
        masses: request.masses.request(),
        wanted: request.wanted,
        load: request.load,
        counts: request.counts,
    })
}

/// Refuses options that have no effect in this request.
fn refuse_useless_options(request: &DesignRequest) -> Result<(), RequestFault> {
    let wanted = &request.wanted;
    let wants_depth = wanted.indentation.is_some() || request.stress.is_some();
    let refused = |input, message| Err(RequestFault::refused(input, message));
    if request.masses.contacts_mass.is_some() {
        let why = phrase![
            "{} has no effect here: a design follows from {} and the load";
            Input::ContactsMass, Input::Mass
        ];
        return refused(Input::ContactsMass, why);
    }
    if !wants_depth && (request.load.load.is_some() || request.load.body_weights.is_some()) {
        let why = phrase![
            "a load has no effect without {}: leave it out, or give the indentation that you want";
            Input::Indentation.with_placeholder("X")
        ];
        return Err(RequestFault::general(why));
    }
    let without_size = |radius: &Radius| matches!(radius.rule(), None | Some(RadiusRule::Isometric));
    if let Some(radius) = wanted.radius.filter(without_size) {
        let why = phrase![
            Input::Radius.with_value(radius.to_string()),
            " is not possible here, expected keep, a radius in metres or a factor like x1.5",
        ];
        return refused(Input::Radius, why);
    }
    if wanted.stiffness.is_some() && (wanted.radius.is_none() || wants_depth) {
        let call = Verb::Set.call_with_model().with_placeholder(Input::Stiffness, "VALUE");
        let why = phrase![
            "{} is known, not designed: it goes with {} alone, or write it with ";
            Input::Stiffness, Input::Radius
        ];
        let why = phrase![&why, call];
        return refused(Input::Stiffness, why);
    }
    if request.other_young.is_some() {
        let call = Verb::Set.call_with_model().with_placeholder(Input::Stiffness, "VALUE");
        let why = phrase!["{} is for a design without a model: write its result with "; Input::OtherYoung];
        return refused(Input::OtherYoung, phrase![&why, call]);
    }
    if wants_depth && wanted.young.is_some() {
        let depth = if request.stress.is_some() { Input::Stress } else { Input::Indentation };
        let why = phrase!["{} and {} both say what the stiffness is: leave one out"; depth, Input::Young];
        return refused(depth, why);
    }
    if wanted.contact_stiffness.is_some() && (wanted.indentation.is_none() || wanted.radius.is_some()) {
        let why = phrase![
            "with models, {} needs {}, and gives the radius: leave out {}";
            Input::ContactStiffness, Input::Indentation, Input::Radius
        ];
        return refused(Input::ContactStiffness, why);
    }
    let smoothing = request.state_smoothing.or(request.speed_smoothing);
    if !wanted.has_design() && request.stress.or(smoothing).is_none() {
        return Err(RequestFault::general(phrase![
            "nothing is asked for: give for example {}, {} or {}";
            Input::Indentation.with_placeholder("X"), Input::Restitution.with_placeholder("CR"),
            Input::ConstantIndentation.with_placeholder("X")
        ]));
    }
    Ok(())
}

impl Planner for DesignPlanner {
    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        self.plan_for(model, &self.selection.apply(model)?)
    }
}

impl DesignPlanner {
    /// The load on the spheres, and the mass whose weight it is; `None` if the design needs no load.
    fn load_per_sphere(
        &self,
        model: &Model,
        selected: &Selected,
    ) -> Result<(Option<SharedLoad>, Option<Mass>), Fault> {
        if self.wanted.indentation.is_none() && self.stress_n_m2.is_none() {
            return Ok((None, None));
        }
        let sharing = LoadSharing::of(model, &selected.forces);
        let limbs = self.counts.stance_limbs(model.noted_stance_limbs());
        let count = sharing.count(self.counts.spheres(), limbs, CountedSpheres::Model)?;
        let (load_n, mass) = match self.load.load {
            Some(load) => (load.get(), None),
            None => {
                let mass = self.masses.model_mass(model)?;
                let gravity = self.load.gravity().or(model.gravity()).filter(|&gravity| gravity > 0.0);
                let purpose = GravityFor::Load;
                let gravity = gravity.ok_or_else(|| Fault::new(MissingFact::Gravity { purpose }))?;
                let along_normal = gravity * weight_share_on_floor(model, &sharing.forces);
                (mass.kg * along_normal * self.load.body_weights(), Some(mass))
            }
        };
        Ok((Some(SharedLoad::new(load_n, count).map_err(Fault::new)?), mass))
    }

    /// The mass that the contacts were made for before the design; `None` if it is uncertain.
    fn contacts_mass(&self, model: &Model, selected: &Selected) -> Option<Mass> {
        let origin = ContactsOrigin::find(model, &selected.forces, &self.masses, &Stance::default()).ok()?;
        origin.refuse_other_body(model, &self.masses, Input::ContactsMass).ok().map(|()| origin.mass)
    }

    /// Plans the design of the forces `selected` of `model`.
    pub(super) fn plan_for(&self, model: &Model, selected: &Selected) -> Result<Plan, Fault> {
        let options = &self.wanted;
        let (load, target_mass) = self.load_per_sphere(model, selected)?;
        let young = options.young.map(Positive::get).zip(options.poisson.map(PoissonRatio::get));
        let width = |width: Option<Positive>| width.map(|width| (options.threshold.get(), width.get()));
        let wanted = Design {
            modulus: match (options.indentation.map(RelativeIndentation::get), self.stress_n_m2, young) {
                (Some(x), ..) => Some(DesignModulus::Indentation(x)),
                (None, Some(stress), _) => Some(DesignModulus::Stress(stress)),
                (None, None, Some((young_n_m2, poisson))) => {
                    Some(DesignModulus::Young { young_n_m2, poisson })
                }
                (None, None, None) => options.stiffness.map(|known| DesignModulus::Known(known.get())),
            },
            load,
            restitution: options
                .restitution
                .map(RestitutionCoefficient::get)
                .map(|restitution| (restitution, options.impact_speed.map(Positive::get))),
            constant_indentation: options.constant_indentation.map(ConstantIndentation::get),
            state_width: width(options.state_width),
            speed_width: width(options.speed_width),
            state_smoothing: self.state_smoothing,
            speed_smoothing: self.speed_smoothing,
            radius: options.radius().unwrap_or(RadiusRule::Keep),
            contact_stiffness_n_m: options.contact_stiffness.map(Positive::get),
            contacts_mass: self.contacts_mass(model, selected),
            target_mass,
            gravity_m_s2: self.load.gravity(),
        };
        let mut plan = design(model, selected, &wanted)?;
        let limbs = remark_on_limbs(&self.counts, model, Some(&selected.forces));
        plan.remarks.extend(wanted.load.and(limbs));
        let ways = options.indentation.and_then(|x| ways_within_hertz(x.get()));
        plan.remarks.extend(ways.map(|ways| phrase!["Hertz' law is not accurate at this x/R: ", ways]));
        Ok(plan)
    }
}
