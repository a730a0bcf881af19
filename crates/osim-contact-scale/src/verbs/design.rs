//! `design` with models: parameters from what is wanted.

use anyhow::{Result, bail};
use contact_scaling::SharedLoad;
use osim_patch::{
    Design, DesignModulus, Fault, FaultKind, Mass, MassRequest, Model, Plan, RadiusRule, Selection, design,
};

use super::sphere_count;
use crate::args::{CountArgs, DesignArgs, LoadArgs, StanceArgs, ViewArgs, WantedArgs};
use crate::run::{Planner, Verb};

/// `design` with models.
struct Designing {
    wanted: WantedArgs,
    load: LoadArgs,
    counts: CountArgs,
    selection: Selection,
    masses: MassRequest,
    view: ViewArgs,
    options: String,
}

/// # Errors
/// Options that say nothing, or contradict each other.
pub(crate) fn verb(args: DesignArgs) -> Result<Verb> {
    check(&args)?;
    let DesignArgs { models, wanted, load, masses, counts, choice, output, run: _, parts } = args;
    let planner = Designing {
        options: format!("design {wanted:?} {load:?} {masses:?} {counts:?} {choice:?}"),
        view: ViewArgs {
            stance: StanceArgs {
                spheres: counts.spheres,
                stance_limbs: counts.stance_limbs,
                impact_speed: wanted.impact_speed,
            },
            masses: masses.clone(),
            choice: choice.clone(),
            ..ViewArgs::default()
        },
        wanted,
        load,
        counts,
        selection: choice.selection()?,
        masses: masses.request()?,
    };
    Ok(Verb { models, output, parts, planner: Box::new(planner) })
}

fn check(args: &DesignArgs) -> Result<()> {
    let wanted = &args.wanted;
    let sizes = wanted.indentation.is_some() || wanted.young.is_some();
    let asks = sizes
        || wanted.restitution.is_some()
        || wanted.constant_indentation.is_some()
        || wanted.state_width.is_some()
        || wanted.speed_width.is_some()
        || wanted.radius.is_some();
    if args.masses.contacts_mass.is_some() {
        bail!("--contacts-mass says nothing here: a design follows from --mass and the load");
    }
    if wanted.indentation.is_none() && (args.load.load.is_some() || args.load.body_weights.is_some()) {
        bail!(
            "a load says nothing without --indentation X: leave it out, or say the indentation it shall give"
        );
    }
    if wanted.radius == Some(RadiusRule::Isometric) {
        bail!(
            "--radius isometric says nothing here, expected keep, a radius in metres or a factor like x1.5"
        );
    }
    if wanted.stiffness.is_some() {
        bail!("--stiffness is known, not designed: write it with set MODEL stiffness=VALUE");
    }
    if wanted.indentation.is_some() && wanted.young.is_some() {
        bail!("--indentation and --young both say what the stiffness is: leave one out");
    }
    if wanted.contact_stiffness.is_some() && (wanted.indentation.is_none() || wanted.radius.is_some()) {
        bail!(
            "with models, --contact-stiffness needs --indentation, and gives the radius: leave out --radius"
        );
    }
    if !asks {
        bail!(
            "nothing is wanted: say for example --indentation X, --restitution CR or --constant-indentation X"
        );
    }
    Ok(())
}

impl Designing {
    fn load(&self, model: &Model) -> Result<(Option<SharedLoad>, Option<Mass>), Fault> {
        let args = self;
        if args.wanted.indentation.is_none() {
            return Ok((None, None));
        }
        let count = match args.counts.spheres {
            Some(count) => count,
            None => sphere_count(model, args.counts.stance_limbs, "--spheres")?,
        };
        let (load_n, mass) = match args.load.load {
            Some(load) => (load, None),
            None => {
                let mass = self.masses.of_model(model)?;
                let gravity = args.load.gravity.or(model.gravity()).filter(|&gravity| gravity > 0.0);
                let Some(gravity) = gravity else {
                    return Err(Fault::new(FaultKind::Refused(
                        "the model has no gravity, so body weight is nothing: say --gravity G or --load N"
                            .to_owned(),
                    )));
                };
                let load = mass.kg * gravity * args.load.body_weights.unwrap_or(1.0);
                (load, Some(mass))
            }
        };
        Ok((Some(SharedLoad::new(load_n, count).map_err(Fault::new)?), mass))
    }
}

impl Planner for Designing {
    fn name(&self) -> &'static str {
        "design"
    }

    fn view(&self) -> ViewArgs {
        self.view.clone()
    }

    fn options(&self) -> String {
        self.options.clone()
    }

    fn plan(&self, model: &Model) -> Result<Plan, Fault> {
        let selected = self.selection.apply(model)?;
        let wanted = &self.wanted;
        let (load, mass) = self.load(model)?;
        let modulus = match (wanted.indentation, wanted.young.zip(wanted.poisson)) {
            (Some(x), _) => Some(DesignModulus::Indentation(x)),
            (None, Some((young_n_m2, poisson))) => Some(DesignModulus::Young { young_n_m2, poisson }),
            (None, None) => None,
        };
        let radius = match (wanted.contact_stiffness, wanted.indentation, &load) {
            (Some(k), Some(x), Some(load)) => {
                let radius = contact_scaling::design::radius_for_stiffness(k, x, load).map_err(Fault::new)?;
                RadiusRule::Designed(radius)
            }
            _ => wanted.radius.unwrap_or(RadiusRule::Keep),
        };
        let width = |width: Option<f64>| width.map(|width| (wanted.threshold, width));
        design(
            model,
            &selected,
            &Design {
                modulus,
                load,
                restitution: wanted.restitution.map(|restitution| (restitution, wanted.impact_speed)),
                constant_indentation: wanted.constant_indentation,
                state_width: width(wanted.state_width),
                speed_width: width(wanted.speed_width),
                radius,
                mass,
                gravity_m_s2: self.load.gravity,
            },
        )
    }
}
