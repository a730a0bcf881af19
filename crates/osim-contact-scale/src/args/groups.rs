//! Options that several verbs share, grouped as the help shows them.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use globset::{Glob, GlobSet, GlobSetBuilder};
use osim_patch::{DissipationBy, LevelAxis, MassRequest, Property, PropertySet, RadiusRule, Selection};

use super::follow::AxisArg;
use super::values::{acceleration, count, glob, mass, positive_number, property, radius};
use crate::look::Stance;
use crate::run::Shard;

/// Masses: which one is meant.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Masses")]
pub(crate) struct MassArgs {
    /// Mass the contacts in the file stand for now, kg [default: the note in the file, else --mass]
    #[arg(long, value_name = "KG", value_parser = mass, allow_hyphen_values = true)]
    pub contacts_mass: Option<f64>,
    /// What this model weighs, kg [default: the sum of its bodies]
    #[arg(long, value_name = "KG", value_parser = mass, allow_hyphen_values = true)]
    pub mass: Option<f64>,
    /// Leave these bodies out of the sum (props, platforms); may be repeated
    #[arg(long, value_name = "GLOB", value_parser = glob, hide_short_help = true)]
    pub exclude_body: Vec<Glob>,
}

impl MassArgs {
    pub(crate) fn request(&self) -> anyhow::Result<MassRequest> {
        Ok(MassRequest {
            contacts_kg: self.contacts_mass,
            model_kg: self.mass,
            exclude_bodies: set_of(&self.exclude_body)?,
            target_kg: None,
        })
    }
}

/// What changes, and how.
#[derive(Debug, Default, Args)]
#[command(next_help_heading = "What changes")]
pub(crate) struct ScalingArgs {
    /// Radii: isometric (R ~ M^1/3), keep, a radius in metres, or a factor like x1.5
    /// [default: isometric with --target-mass, keep otherwise]
    #[arg(long, value_name = "RULE", value_parser = radius)]
    pub radius: Option<RadiusRule>,
    /// Move sphere centres so that bottoms stay on the sole while radii change
    #[arg(long)]
    pub level: bool,
    /// The axis of the spheres' frames that points up with the foot flat [default: nearest to -gravity]
    #[arg(long, value_enum, requires = "level", hide_short_help = true, allow_hyphen_values = true)]
    pub level_axis: Option<AxisArg>,
    /// Only these properties, separated by commas (OpenSim's names, and radius)
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = property)]
    pub only: Vec<Property>,
    /// Everything but these properties
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = property)]
    pub keep: Vec<Property>,
    /// What dissipation follows (14): R^-1/2 or M^-1/6
    #[arg(long, value_enum, default_value = "radius", hide_short_help = true)]
    pub dissipation_by: DissipationArg,
    /// Scale transition_velocity and viscous_friction too (an extension of the paper)
    #[arg(long, hide_short_help = true)]
    pub friction: bool,
    /// Gravity the contacts stand for now, m/s2 [default: the note's, else the model's]
    #[arg(long, value_name = "G", value_parser = acceleration, hide_short_help = true)]
    pub contacts_gravity: Option<f64>,
    /// Scale to this gravity too, m/s2 (an extension of the paper)
    #[arg(long, value_name = "G", value_parser = acceleration, hide_short_help = true)]
    pub target_gravity: Option<f64>,
}

#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub(crate) enum DissipationArg {
    #[default]
    Radius,
    Mass,
}

impl ScalingArgs {
    /// Refuses a choice of properties that leaves nothing.
    pub(crate) fn check(&self) -> anyhow::Result<()> {
        let never =
            self.only.iter().find(|p| matches!(p, Property::StaticFriction | Property::DynamicFriction));
        if let Some(property) = never {
            anyhow::bail!(
                "--only {property}: it has no dimension, so it is the same at every size; change it with set"
            );
        }
        let properties = self.properties();
        if Property::ALL.iter().all(|&property| !properties.contains(property)) {
            anyhow::bail!("--only and --keep leave no property to change");
        }
        Ok(())
    }

    pub(crate) fn properties(&self) -> PropertySet {
        // Naming a friction property in --only asks for it.
        let friction = self.friction
            || self
                .only
                .iter()
                .any(|p| matches!(p, Property::TransitionVelocity | Property::ViscousFriction));
        let all = PropertySet::default();
        let all = if friction { all.with_friction() } else { all };
        all.restricted(&self.only, &self.keep)
    }

    /// Where up is, if bottoms are to stay.
    pub(crate) fn level_axis(&self, gravity: Option<[f64; 3]>) -> Option<LevelAxis> {
        let axis = || self.level_axis.map_or_else(|| LevelAxis::of_gravity(gravity), AxisArg::axis);
        self.level.then(axis)
    }

    pub(crate) fn dissipation(&self) -> DissipationBy {
        match self.dissipation_by {
            DissipationArg::Radius => DissipationBy::Radius,
            DissipationArg::Mass => DissipationBy::Mass,
        }
    }
}

/// Which forces.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Which forces")]
pub(crate) struct ForceChoice {
    /// Only forces with such a name; may be repeated
    #[arg(long, value_name = "GLOB", value_parser = glob)]
    pub select: Vec<Glob>,
    /// No forces with such a name; may be repeated
    #[arg(long, value_name = "GLOB", value_parser = glob)]
    pub exclude: Vec<Glob>,
    /// Leave out forces that are switched off
    #[arg(long, hide_short_help = true)]
    pub skip_disabled: bool,
}

impl ForceChoice {
    pub(crate) fn selection(&self) -> anyhow::Result<Selection> {
        Ok(Selection {
            select: set_of(&self.select)?,
            exclude: set_of(&self.exclude)?,
            skip_disabled: self.skip_disabled,
        })
    }
}

/// Files that belong to a standalone set.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Standalone sets")]
pub(crate) struct PartArgs {
    /// The ContactGeometrySet (or model) that holds the spheres of a standalone ForceSet
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub geometry: Option<PathBuf>,
    /// The model a standalone ForceSet belongs to, for its masses and joints
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub model: Option<PathBuf>,
}

/// Where results go.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct OutputArgs {
    /// Write to this file (one model; - is standard output) [default: NAME.scaled.osim beside the model]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Write the changed ContactGeometrySet of a standalone ForceSet to this file
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub geometry_output: Option<PathBuf>,
    /// Write into this folder
    #[arg(short = 'd', long, value_name = "DIR", conflicts_with = "output")]
    pub output_dir: Option<PathBuf>,
    /// Change the model itself and keep the old one as NAME.osim.bak
    #[arg(long, conflicts_with_all = ["output", "output_dir", "geometry_output"])]
    pub in_place: bool,
    /// With --in-place: keep no backup
    #[arg(long, requires = "in_place", hide_short_help = true)]
    pub no_backup: bool,
    /// Replace existing files
    #[arg(long)]
    pub force: bool,
    /// Leave no note (a comment line) in the model
    #[arg(long, hide_short_help = true)]
    pub no_note: bool,
}

/// How a run goes about its work and what it tells.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct RunArgs {
    /// Write nothing, only say what would change
    #[arg(long)]
    pub dry_run: bool,
    /// Show the changes as a unified diff too
    #[arg(long)]
    pub diff: bool,
    /// How to print [default: table; lines if more than 10 models]
    #[arg(long, value_enum)]
    pub format: Option<RunFormat>,
    /// Print errors only
    #[arg(long, hide_short_help = true)]
    pub quiet: bool,
    /// Write a page for browsers too (.html): tables, plots, findings
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Models to work on at once [default: one per processor]
    #[arg(long, value_name = "N", hide_short_help = true)]
    pub jobs: Option<NonZeroUsize>,
    /// Keep a line per model in this file (.csv or .ndjson)
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub summary: Option<PathBuf>,
    /// Pass over models that --summary says are done, if nothing has changed since
    #[arg(long, requires = "summary", conflicts_with = "dry_run", hide_short_help = true)]
    pub resume: bool,
    /// Only share I of N of the models, for job arrays
    #[arg(long, value_name = "I/N", hide_short_help = true)]
    pub shard: Option<Shard>,
}

impl RunArgs {
    pub(crate) fn is_json(&self) -> bool {
        self.format == Some(RunFormat::Json)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum RunFormat {
    /// Every number that changes
    Table,
    /// One line per model
    Lines,
    /// One JSON object per model and line
    Json,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people
    #[default]
    Table,
    /// One JSON object per model and line
    Json,
}

/// How `inspect` and `check` print.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum SheetFormat {
    /// For people
    #[default]
    Table,
    /// One JSON object per model and line
    Json,
    /// One table for spreadsheets, one header for all models
    Csv,
}

impl From<Format> for SheetFormat {
    fn from(format: Format) -> Self {
        match format {
            Format::Table => Self::Table,
            Format::Json => Self::Json,
        }
    }
}

/// The page that `inspect` and `check` write.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct ReportArgs {
    /// Write a page for browsers too (.html): tables, plots, findings
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// Replace an existing report
    #[arg(long, requires = "report")]
    pub force: bool,
}

/// How a model is looked at.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct ViewArgs {
    #[command(flatten)]
    pub stance: StanceArgs,
    #[command(flatten)]
    pub masses: MassArgs,
    #[command(flatten)]
    pub choice: ForceChoice,
    #[command(flatten)]
    pub parts: PartArgs,
}

/// What the figures are made for.
#[derive(Debug, Clone, Args)]
#[command(next_help_heading = "What the figures are made for")]
pub(crate) struct StanceArgs {
    /// Spheres that share the body weight, all stance limbs together [default: as found per limb]
    #[arg(long, value_name = "N", value_parser = count)]
    pub spheres: Option<f64>,
    /// Limbs that share the body weight
    #[arg(long, value_name = "N", value_parser = count, default_value = "1")]
    pub stance_limbs: f64,
    /// Impact speed for the restitution, m/s [default: sqrt(gR/2), a fall from a quarter of the radius]
    #[arg(long, value_name = "M/S", value_parser = positive_number)]
    pub impact_speed: Option<f64>,
}

impl Default for StanceArgs {
    fn default() -> Self {
        Self { spheres: None, stance_limbs: 1.0, impact_speed: None }
    }
}

impl StanceArgs {
    pub(crate) fn stance(&self) -> Stance {
        Stance {
            spheres: self.spheres,
            limbs: self.stance_limbs,
            impact_speed_m_s: self.impact_speed,
            gravity_m_s2: None,
        }
    }
}

/// Patterns as one matcher.
pub(crate) fn set_of(globs: &[Glob]) -> anyhow::Result<GlobSet> {
    let mut builder = GlobSetBuilder::new();
    for glob in globs {
        builder.add(glob.clone());
    }
    Ok(builder.build()?)
}
