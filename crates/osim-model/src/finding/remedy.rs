//! Changes that put a finding right, as data: the command prints them, other front ends apply them.

use std::path::PathBuf;

use osim_messages::Dialect;

use crate::assignment::Assignment;
use crate::contacts::ForceKind;
use crate::fault::Question;
use crate::files::FileName;
use crate::pattern::Pattern;
use crate::property::Property;
use crate::selection::Selection;

/// A change that puts a finding right.
#[derive(Debug, Clone, PartialEq)]
pub struct Remedy {
    /// The model, as it was named.
    pub model: FileName,
    /// What is done with it.
    pub change: RemedyChange,
    /// Whose weight is carried, where that matters.
    pub load: Option<RemedyLoad>,
    /// Which forces.
    pub selection: Selection,
    /// The geometry set of a force set that stands alone.
    pub geometry: Option<PathBuf>,
    /// The model of a force set that stands alone.
    pub set_model: Option<PathBuf>,
    /// Questions that it would be asked, and that are answered by what was found.
    pub yes: Vec<Question>,
}

/// What a remedy does.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum RemedyChange {
    /// Contacts that were made for one mass, scaled to another.
    Rescale {
        /// The mass they were made for, kg.
        contacts_mass_kg: f64,
        /// The mass of the body, kg.
        target_mass_kg: f64,
    },
    /// Contacts of a preset.
    Transfer {
        /// Its name.
        from: &'static str,
    },
    /// The model's own contacts at its body's mass, on spheres that follow their bodies by the sizes in the note.
    FollowNote {
        /// The mass to scale to, kg.
        target_mass_kg: f64,
        /// Bottoms stay on the scaled sole.
        level: bool,
    },
    /// Contacts of the model that OpenSim scaled, and spheres that follow their bodies.
    Follow {
        /// That model, as it was named.
        from: PathBuf,
        /// The Scale Tool's ScaleSet, where one was named.
        body_scale_file: Option<PathBuf>,
        /// Bottoms stay on the scaled sole.
        level: bool,
        /// Spheres whose radii were changed since are placed again, too.
        replace_moved: bool,
    },
    /// Forces of a class, one for each sphere.
    Convert {
        /// The class.
        to: ForceKind,
    },
    /// Parameters from what is wanted.
    Design(RemedyDesign),
    /// Values, or factors.
    Set {
        /// Properties and what happens to them.
        assignments: Vec<(Property, Assignment)>,
    },
}

/// What is wanted of a contact; `None` is left as it is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RemedyDesign {
    /// x̂ under the load (11).
    pub indentation: Option<f64>,
    /// The load, in body weights, where it is not one.
    pub body_weights: Option<f64>,
    /// c_r (13).
    pub restitution: Option<f64>,
    /// Speed of the impact that it is about, m/s.
    pub impact_speed_m_s: Option<f64>,
    /// x̂_c (C.2).
    pub constant_indentation: Option<f64>,
    /// Δx̂ (C.8).
    pub state_width: Option<f64>,
}

/// Whose weight is carried, and by how many spheres: what was said of it is said again.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RemedyLoad {
    /// What the model weighs, kg.
    pub mass_kg: Option<f64>,
    /// Gravity that the model's own file does not say, m/s².
    pub gravity_m_s2: Option<f64>,
    /// Bodies that do not count.
    pub exclude_bodies: Vec<Pattern>,
    /// Spheres that share the weight.
    pub spheres: Option<f64>,
    /// Limbs that share the weight, where it is not one.
    pub stance_limbs: Option<f64>,
}

/// The words of a front end, for remedies too.
pub trait RemedyDialect: Dialect {
    /// A remedy, as the reader types it.
    fn remedy(&self, remedy: &Remedy) -> String;
}
