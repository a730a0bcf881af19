//! What is drawn: the contacts of a model or preset, and what they carry.

use std::path::Path;

use anyhow::{Result, anyhow, bail};
use contact_scaling::{Contact, Law, Preset, Ratios, Spheres};
use osim_patch::{Fault, FaultKind, MassRequest, Model, loaded_spheres};

use crate::args::PlotArgs;
use crate::drop::weighted;
use crate::failure::Failure;
use crate::load::Loaded;
use crate::look::View;
use crate::presets;
use crate::sources::Source;
use crate::verbs::sphere_count;
use crate::weighed::Weighed;

/// What the user says of how a body stands, where its file does not.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stance {
    /// `--spheres`.
    pub(crate) spheres: Option<f64>,
    /// `--stance-limbs`.
    pub(crate) stance_limbs: f64,
    /// `--gravity`.
    pub(crate) gravity_m_s2: Option<f64>,
}

impl Stance {
    fn of(args: &PlotArgs) -> Self {
        let counts = &args.counts;
        Self { spheres: counts.spheres, stance_limbs: counts.stance_limbs, gravity_m_s2: args.gravity }
    }
}

/// What a body weighs and on how many spheres it stands.
#[derive(Debug, Clone)]
pub(crate) struct Weight {
    pub(crate) mass_kg: f64,
    pub(crate) gravity_m_s2: f64,
    pub(crate) sphere_count: f64,
    /// The spheres, each with its share of those that stand.
    pub(crate) spheres: Vec<Spheres>,
}

impl Weight {
    /// M g, in N.
    pub(crate) fn body_weight_n(&self) -> f64 {
        self.mass_kg * self.gravity_m_s2
    }

    /// M g / n, in N.
    pub(crate) fn share_n(&self) -> f64 {
        self.body_weight_n() / self.sphere_count
    }
}

/// Spheres of one radius with one contact.
#[derive(Debug, Clone)]
pub(crate) struct Kind {
    /// Names of its spheres, shortened; empty where all spheres of the body are of this kind.
    pub(crate) spheres: String,
    pub(crate) radius_m: f64,
    pub(crate) contact: Contact,
}

/// One body to draw.
#[derive(Debug)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) kinds: Vec<Kind>,
    /// What it weighs; what is missing, where that is not known.
    pub(crate) weight: Result<Weight, Failure>,
    /// The mass its contacts stand for, likewise.
    contacts_mass_kg: Result<f64, Failure>,
    /// The two masses, where they disagree.
    pub(crate) weighed: Option<Weighed>,
}

impl Body {
    /// The model or preset `path`.
    ///
    /// # Errors
    /// Outside: wrong usage. Inside: the model cannot be read.
    pub(crate) fn named(path: &Path, args: &PlotArgs) -> Result<Result<Self, Failure>> {
        if let Some(preset) = presets::find(path, args.presets.as_deref())? {
            return Self::of_preset(&preset, args).map(Ok);
        }
        let may_be_file = path.exists() || path.as_os_str() == "-" || path.components().count() > 1;
        if !may_be_file && path.extension().is_none() {
            bail!(
                "'{}': there is no such file and no such preset, expected a model or one of: {}",
                path.display(),
                presets::names(args.presets.as_deref())
            );
        }
        let selection = args.choice.selection()?;
        let masses = args.masses.request()?;
        let read = |loaded: &Loaded| {
            loaded.with_model(|model| {
                let selected = selection.apply(model).map_err(|fault| loaded.failure(fault))?;
                let failed = |fault| loaded.failure(fault);
                let (name, stance) = (short_name(path), Stance::of(args));
                Self::of_model(name, model, &selected.forces, &masses, stance, &failed)
            })
        };
        let source = Source { path: path.to_owned(), folder: None };
        Ok(Loaded::read(&source, &args.parts).and_then(|loaded| read(&loaded)))
    }

    /// A model's chosen forces; `failed` names the file a fault is in.
    ///
    /// # Errors
    /// No chosen force applies, or a value is no number. What is not known of the weight is no error until it is needed.
    pub(crate) fn of_model(
        name: String,
        model: &Model,
        forces: &[usize],
        masses: &MassRequest,
        stance: Stance,
        failed: &dyn Fn(Fault) -> Failure,
    ) -> Result<Self, Failure> {
        let kinds = kinds(model, forces).map_err(failed)?;
        let weight = weight(model, forces, masses, stance).map_err(failed);
        let contacts_mass_kg = masses.of_contacts(model, &mut Vec::new()).map(|mass| mass.kg).map_err(failed);
        let weighed = Weighed::otherwise(model, masses);
        Ok(Self { name, kinds, weight, contacts_mass_kg, weighed })
    }

    /// A model as it was looked at.
    ///
    /// # Errors
    /// As [`of_model`](Self::of_model).
    pub(crate) fn seen(
        name: String,
        model: &Model,
        view: &View,
        failed: &dyn Fn(Fault) -> Failure,
    ) -> Result<Self, Failure> {
        let selected = view.selection.apply(model).map_err(failed)?;
        let looked = &view.stance;
        let stance =
            Stance { spheres: looked.spheres, stance_limbs: looked.limbs, gravity_m_s2: looked.gravity_m_s2 };
        Self::of_model(name, model, &selected.forces, &view.masses, stance, failed)
    }

    fn of_preset(preset: &Preset, args: &PlotArgs) -> Result<Self> {
        let scale = &preset.scale;
        let law = Law::of(&preset.contact, scale.radius_m())?;
        let sphere_count = args.counts.spheres.unwrap_or(scale.sphere_count());
        let weight = Weight {
            mass_kg: args.masses.mass.unwrap_or(scale.mass_kg()),
            gravity_m_s2: args.gravity.unwrap_or(scale.gravity_m_s2()),
            sphere_count,
            spheres: vec![Spheres::new(law, sphere_count)?],
        };
        let kind = Kind { spheres: String::new(), radius_m: scale.radius_m(), contact: preset.contact };
        let contacts_mass_kg = Ok(args.masses.contacts_mass.unwrap_or(scale.mass_kg()));
        Ok(Self {
            name: preset.name.to_string(),
            kinds: vec![kind],
            weight: Ok(weight),
            contacts_mass_kg,
            weighed: None,
        })
    }

    /// Contacts of which nobody asks what they carry.
    pub(crate) fn without_weight(name: String, kinds: Vec<Kind>, why: &Failure) -> Self {
        Self { name, kinds, weight: Err(why.clone()), contacts_mass_kg: Err(why.clone()), weighed: None }
    }

    /// The same body after `--target-mass`: radii isometric, every parameter by its equation.
    ///
    /// # Errors
    /// The mass its contacts stand for is not known, or the ratio leaves the range of numbers.
    pub(crate) fn scaled(&self, target_kg: f64) -> Result<Self, Failure> {
        let from_kg = *self.contacts_mass_kg.as_ref().map_err(Failure::clone)?;
        let failed = |error: &dyn std::fmt::Display| self.failure(&anyhow!("{error}"));
        let ratios = Ratios::isometric(target_kg / from_kg).map_err(|error| failed(&error))?;
        let kinds = self.kinds.iter().map(|kind| Kind {
            spheres: kind.spheres.clone(),
            radius_m: kind.radius_m * ratios.radius(),
            contact: kind.contact.scaled(&ratios),
        });
        let kinds: Vec<Kind> = kinds.collect();
        let weight = match &self.weight {
            Err(failure) => Err(failure.clone()),
            Ok(weight) => Ok(Weight {
                mass_kg: target_kg,
                spheres: scaled_spheres(&self.kinds, &kinds, &weight.spheres)
                    .map_err(|error| failed(&error))?,
                ..*weight
            }),
        };
        let name = format!("{}, scaled to {} kg", self.name, osim_patch::readable(target_kg));
        Ok(Self { name, kinds, weight, contacts_mass_kg: Ok(target_kg), weighed: None })
    }

    /// What it weighs, where it must be known.
    pub(crate) fn weight(&self) -> Result<&Weight, Failure> {
        self.weight.as_ref().map_err(Failure::clone)
    }

    /// Something that went wrong with it.
    pub(crate) fn failure(&self, error: &anyhow::Error) -> Failure {
        Failure::outside(&self.name, "plot", error)
    }
}

/// The file's name without its folders, which would fill a legend.
fn short_name(path: &Path) -> String {
    path.file_stem().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

/// The spheres with each law replaced by its scaled one; their counts stay.
fn scaled_spheres(
    before: &[Kind],
    after: &[Kind],
    spheres: &[Spheres],
) -> Result<Vec<Spheres>, contact_scaling::DomainError> {
    let mut scaled = Vec::new();
    for one in spheres {
        for (old, new) in before.iter().zip(after) {
            if Law::of(&old.contact, old.radius_m)? == *one.law() {
                scaled.push(Spheres::new(Law::of(&new.contact, new.radius_m)?, one.count())?);
            }
        }
    }
    Ok(scaled)
}

/// The kinds of spheres among the forces, in the order of the file.
fn kinds(model: &Model, forces: &[usize]) -> Result<Vec<Kind>, Fault> {
    let mut kinds: Vec<(Kind, Vec<String>)> = Vec::new();
    for sphere in loaded_spheres(model, forces)? {
        let name = model.spheres.get(sphere.sphere).map(|sphere| sphere.name.clone()).unwrap_or_default();
        let same = |kind: &Kind| kind.radius_m == sphere.radius_m && kind.contact == sphere.contact;
        match kinds.iter_mut().find(|(kind, _)| same(kind)) {
            Some((_, names)) => names.push(name),
            None => {
                let kind =
                    Kind { spheres: String::new(), radius_m: sphere.radius_m, contact: sphere.contact };
                kinds.push((kind, vec![name]));
            }
        }
    }
    if kinds.is_empty() {
        return Err(Fault::new(FaultKind::Refused(
            "none of the chosen forces applies: there is no contact to draw".to_owned(),
        )));
    }
    let single = kinds.len() == 1;
    let named = kinds.into_iter().map(|(kind, names)| {
        let spheres = if single { String::new() } else { shortened(&names) };
        Kind { spheres, ..kind }
    });
    Ok(named.collect())
}

/// The first name and how many more there are.
fn shortened(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [first, rest @ ..] => format!("{first} + {}", rest.len()),
    }
}

fn weight(
    model: &Model,
    forces: &[usize],
    masses: &MassRequest,
    stance: Stance,
) -> Result<Weight, Fault> {
    let mass_kg = masses.of_model(model)?.kg;
    let sphere_count = match stance.spheres {
        Some(count) => count,
        None => sphere_count(model, stance.stance_limbs, "--spheres")?,
    };
    let gravity = stance.gravity_m_s2.or(model.gravity().filter(|&gravity| gravity > 0.0));
    let Some(gravity_m_s2) = gravity else {
        return Err(Fault::new(FaultKind::Refused(
            "the model has no gravity: say it with --gravity G".to_owned(),
        )));
    };
    Ok(Weight { mass_kg, gravity_m_s2, sphere_count, spheres: weighted(model, forces, sphere_count)? })
}
