//! Options for the inspection of a model: the forces, the mass, and the spheres that share a load.

use std::collections::BTreeMap;
use std::path::PathBuf;

use osim_model::files::CompanionPaths;
use osim_model::messages::Input;
use osim_model::{MassRequest, MassesOfOtherRows, Pattern, Selection};

use crate::options::run::AnswerOptions;
use crate::values::serial::{self, fields};
use crate::values::{Acceleration, Count, Kilograms, Positive, path};

fields! {
    /// How a model is inspected.
    struct InspectionOptions {
        stance: ..StanceOptions,
        masses: ..MassOptions,
        choice: ..ForceOptions,
        set_files: ..SetFiles,
        answers: ..AnswerOptions,
    }

    /// Options for the choice of forces.
    struct ForceOptions {
        select: Vec<Pattern> as "serial::Texts",
        exclude: Vec<Pattern> as "serial::Texts",
        skip_disabled: bool,
    }

    /// Masses: which one is meant.
    struct MassOptions {
        contacts_mass: Option<Kilograms>,
        mass: Option<Kilograms>,
        exclude_body: Vec<Pattern> as "serial::Texts",
        /// Of a row of a table: what its other rows say of the same masses. No caller gives it.
        #[serde(skip)]
        #[cfg_attr(feature = "schemas", schemars(skip))]
        other_rows: BTreeMap<Input, MassesOfOtherRows>,
    }

    /// How many spheres share the body weight.
    struct CountOptions {
        spheres: Option<Count>,
        stance_limbs: Option<Count>,
    }

    /// Options for the load and the speed of figures.
    struct StanceOptions {
        spheres: Option<Count>,
        stance_limbs: Option<Count>,
        impact_speed: Option<Positive>,
        gravity: Option<Acceleration>,
    }

    /// The load on the spheres.
    struct LoadOptions {
        load: Option<Positive>,
        body_weights: Option<Positive>,
        gravity: Option<Acceleration>,
    } where Excludes("load", "body_weights");

    /// Files that belong to a standalone set.
    struct SetFiles {
        geometry: Option<PathBuf> as "path::Optional",
        model: Option<PathBuf> as "path::Optional",
    }
}

impl ForceOptions {
    pub fn selection(&self) -> Selection {
        Selection {
            select: self.select.clone(),
            exclude: self.exclude.clone(),
            skip_disabled: self.skip_disabled,
        }
    }
}

impl MassOptions {
    pub fn request(&self) -> MassRequest {
        MassRequest {
            contacts_mass_kg: self.contacts_mass.map(Kilograms::get),
            model_kg: self.mass.map(Kilograms::get),
            exclude_bodies: self.exclude_body.clone(),
            target_mass_kg: None,
            other_rows: self.other_rows.clone(),
        }
    }
}

impl CountOptions {
    /// The number n of spheres, if given.
    pub fn spheres(&self) -> Option<f64> {
        self.spheres.map(Count::get)
    }

    /// Number of limbs that share the weight: the given number, else the number `noted` in the model, else 1.
    pub fn stance_limbs(&self, noted: Option<f64>) -> f64 {
        self.stance_limbs.map(Count::get).or(noted).unwrap_or(1.0)
    }

    /// Options for figures of these spheres and limbs, with the impact speed and gravity.
    pub fn stance_options(
        &self,
        impact_speed: Option<Positive>,
        gravity: Option<Acceleration>,
    ) -> StanceOptions {
        StanceOptions { spheres: self.spheres, stance_limbs: self.stance_limbs, impact_speed, gravity }
    }
}

impl LoadOptions {
    /// The load in body weights, for a load that is not given in newtons.
    pub fn body_weights(&self) -> f64 {
        self.body_weights.map_or(1.0, Positive::get)
    }

    /// Gravity in the options of the load, if given.
    pub fn gravity(&self) -> Option<f64> {
        self.gravity.map(Acceleration::get)
    }
}

impl SetFiles {
    pub fn companion_paths(&self) -> CompanionPaths<'_> {
        CompanionPaths { geometry: self.geometry.as_deref(), model: self.model.as_deref() }
    }

    /// Paths of the motion's files that the request names.
    pub fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        [&self.geometry, &self.model].into_iter().flatten()
    }
}
