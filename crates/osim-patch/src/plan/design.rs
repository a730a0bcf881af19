//! Parameters from what is wanted, written into a model: (11), (A.5), (13), (C.2), (C.8), (C.10).

use contact_scaling::{
    RatioValues, Ratios, SharedLoad, design as wanted_of, modulus, restitution, smoothing,
};

use super::draft::{Draft, New, PropertySet};
use super::radii::{Radii, RadiusRule};
use super::rescale::{bottoms_remark, factor};
use super::surfaces::write_composite;
use super::{DissipationBy, Masses, NoteFacts, Plan};
use crate::error::Fault;
use crate::mass::Mass;
use crate::model::{Force, ForceKind, Model};
use crate::note::Scope;
use crate::number::readable;
use crate::property::Property;
use crate::select::Selected;
use crate::warning::{Warning, WarningCode};

/// How E₁* is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DesignModulus {
    /// By (11): this relative indentation under the load.
    Indentation(f64),
    /// By (A.1) and (A.5): this Young's modulus (N/m²) and Poisson's ratio on rigid ground.
    Young {
        /// E, N/m².
        young_n_m2: f64,
        /// ν.
        poisson: f64,
    },
}

/// What is wanted; `None` is left as it is (or follows a changed radius).
#[derive(Debug, Clone)]
pub struct Design {
    /// How E₁* is found.
    pub modulus: Option<DesignModulus>,
    /// Total load, N, and the spheres that share it; needed for [`DesignModulus::Indentation`].
    pub load: Option<SharedLoad>,
    /// Coefficient of restitution (13), and the impact speed in m/s (√(gR/2) where not given).
    pub restitution: Option<(f64, Option<f64>)>,
    /// x̂_c of (C.2).
    pub constant_indentation: Option<f64>,
    /// Threshold t and width Δx̂ of (C.8).
    pub state_width: Option<(f64, f64)>,
    /// Threshold t and width in m/s of (C.10).
    pub speed_width: Option<(f64, f64)>,
    /// What becomes of the radii.
    pub radius: RadiusRule,
    /// Mass the result stands for, where the load is body weight.
    pub mass: Option<Mass>,
    /// Gravity, m/s², where it is not the model's.
    pub gravity_m_s2: Option<f64>,
}

/// Plans a design onto the forces `selected` of `model`.
///
/// # Errors
/// A quantity outside its domain, something missing, or any error of [`super::rescale`].
pub fn design(model: &Model<'_, '_>, selected: &Selected, wanted: &Design) -> Result<Plan, Fault> {
    let mut draft = Draft::new(model);
    let properties = PropertySet::default();
    let radii = Radii::plan(&mut draft, &selected.forces, |_| wanted.radius, 1.0, &properties)?;
    radii.warn_mixed(&mut draft, &selected.forces);
    for &index in &selected.forces {
        let Some(force) = model.forces.get(index) else { continue };
        let radius = radii.mean_new(force);
        let own = RatioValues { mass: 1.0, sphere_count: 1.0, radius: radii.ratio(force), gravity: 1.0 };
        let own = Ratios::new(own).map_err(Fault::new)?;
        for property in Property::ALL.into_iter().filter(|&property| properties.contains(property)) {
            match wanted.value(property, force, radius, model)? {
                Some((to, equation)) => write_composite(&mut draft, index, property, to, equation)?,
                None => carry(&mut draft, index, force, property, &own)?,
            }
        }
    }
    let mut remarks = vec!["body masses and sphere locations stay as they are".to_owned()];
    remarks.extend(bottoms_remark(&radii));
    let Draft { changes, moves, mut warnings, .. } = draft;
    if changes.is_empty() {
        let text = "nothing that is wanted applies to these forces, or every value is already as wanted";
        warnings.push(Warning::new(WarningCode::NothingToChange, text));
    }
    let is_smooth = |force: &Force| force.kind == ForceKind::SmoothSphereHalfSpace;
    let smooth = selected.forces.iter().filter_map(|&index| model.forces.get(index)).any(is_smooth);
    let masses = wanted.mass.clone().map(|from| Masses { to_kg: from.kg, from });
    let plan = Plan {
        changes,
        moves,
        masses,
        taken: wanted.taken(),
        warnings,
        remarks,
        note: None,
        note_anyway: false,
    };
    Ok(plan.with_note(
        model,
        &NoteFacts {
            mass_kg: wanted.mass.as_ref().map(|mass| mass.kg),
            gravity_m_s2: wanted.gravity_m_s2.or(model.gravity()),
            scope: if wanted.is_complete(smooth) && selected.complete { Scope::All } else { Scope::Partial },
            operation: "design",
        },
    ))
}

/// A changed radius carries along what is not designed.
fn carry(
    draft: &mut Draft<'_, '_, '_>,
    index: usize,
    force: &Force,
    property: Property,
    own: &Ratios,
) -> Result<(), Fault> {
    let Some((factor, equation)) = factor(property, own, DissipationBy::Radius) else { return Ok(()) };
    for set in 0..force.sets.len() {
        if let Some(from) = draft.current(index, set, property)? {
            draft.parameter(index, set, property, New::times(from, factor, equation))?;
        }
    }
    Ok(())
}

impl Design {
    /// Whether every property the paper scales is designed; a HuntCrossleyForce has no smoothing.
    fn is_complete(&self, smooth: bool) -> bool {
        let smoothing =
            self.constant_indentation.is_some() && self.state_width.is_some() && self.speed_width.is_some();
        self.modulus.is_some() && self.restitution.is_some() && (smoothing || !smooth)
    }

    fn value(
        &self,
        property: Property,
        force: &Force,
        radius_m: f64,
        model: &Model<'_, '_>,
    ) -> Result<Option<(f64, &'static str)>, Fault> {
        let smooth = force.kind == ForceKind::SmoothSphereHalfSpace;
        Ok(match property {
            Property::Stiffness => match self.modulus {
                Some(modulus) => Some(self.modulus(modulus, radius_m)?),
                None => None,
            },
            Property::Dissipation => match self.restitution {
                Some((restitution, speed)) => {
                    let speed = speed
                        .map_or_else(|| default_speed(self.gravity_m_s2.or(model.gravity()), radius_m), Ok)?;
                    Some((restitution::dissipation(restitution, speed).map_err(Fault::new)?, "13"))
                }
                None => None,
            },
            Property::ConstantContactForce if smooth => match self.constant_indentation {
                Some(x) => Some((smoothing::constant_contact_force(x, radius_m).map_err(Fault::new)?, "C.2")),
                None => None,
            },
            Property::HertzSmoothing if smooth => match self.state_width {
                Some((t, width)) => Some((
                    smoothing::hertz_smoothing_for_width(t, width, radius_m).map_err(Fault::new)?,
                    "C.8",
                )),
                None => None,
            },
            Property::HuntCrossleySmoothing if smooth => match self.speed_width {
                Some((t, width)) => Some((
                    smoothing::hunt_crossley_smoothing_for_speed_width(t, width).map_err(Fault::new)?,
                    "C.10",
                )),
                None => None,
            },
            _ => None,
        })
    }

    fn modulus(&self, modulus: DesignModulus, radius_m: f64) -> Result<(f64, &'static str), Fault> {
        match modulus {
            DesignModulus::Indentation(x) => {
                let Some(load) = &self.load else {
                    return Err(Fault::refused(
                        "an indentation needs a load: say --load N, or --body-weights with a model that has gravity",
                    ));
                };
                let composite = wanted_of::composite_modulus(radius_m, x, load).map_err(Fault::new)?;
                let equal = modulus::of_equal_surfaces(composite, modulus::MixingRule::Sherman);
                Ok((equal.map_err(Fault::new)?, "11"))
            }
            DesignModulus::Young { young_n_m2, poisson } => {
                Ok((modulus::stiffness_on_rigid_ground(young_n_m2, poisson).map_err(Fault::new)?, "A.5"))
            }
        }
    }

    fn taken(&self) -> String {
        let mut parts = Vec::new();
        if let Some(load) = &self.load {
            parts.push(format!("{} N on {} spheres", readable(load.load_n()), load.sphere_count()));
        }
        if let Some(mass) = &self.mass {
            parts.push(format!("model weighs {} kg ({})", readable(mass.kg), mass.told_by));
        }
        match self.modulus {
            Some(DesignModulus::Indentation(x)) => {
                parts.push(format!("relative indentation {}", readable(x)));
            }
            Some(DesignModulus::Young { young_n_m2, poisson }) => {
                parts.push(format!(
                    "Young's modulus {} N/m2, Poisson's ratio {poisson}",
                    readable(young_n_m2)
                ));
            }
            None => {}
        }
        if let Some((restitution, _)) = self.restitution {
            parts.push(format!("restitution {}", readable(restitution)));
        }
        if let Some(x) = self.constant_indentation {
            parts.push(format!("constant indentation {}", readable(x)));
        }
        if let Some((t, width)) = self.state_width {
            parts.push(format!("contact transition over {} radii (threshold {t})", readable(width)));
        }
        if let Some((t, width)) = self.speed_width {
            parts.push(format!("speed transition over {} m/s (threshold {t})", readable(width)));
        }
        if parts.is_empty() { "another radius".to_owned() } else { parts.join("; ") }
    }
}

/// The impact speed of a fall from a quarter of the radius, √(gR/2): the paper's drop test.
fn default_speed(gravity: Option<f64>, radius_m: f64) -> Result<f64, Fault> {
    match gravity.filter(|&gravity| gravity > 0.0) {
        Some(gravity) => restitution::drop_speed(gravity, radius_m).map_err(Fault::new),
        None => Err(Fault::refused(
            "the model has no gravity: say how fast contacts begin with --impact-speed M/S",
        )),
    }
}
