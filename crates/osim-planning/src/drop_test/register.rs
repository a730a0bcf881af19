//! The one register of the figures of a drop, and of the columns of its series. A new one is a new entry here, and a test.

use contact_scaling::drop_test::{DropReport, FirstContact, Lift, Sample};
use osim_inspect::Quantity;

use super::result::DropResult;

/// What an entry has beside its quantity.
struct Entry {
    row: DropRow,
    value: Value,
}

/// How to get a figure.
enum Value {
    /// It is always known.
    Always(fn(&DropResult) -> f64),
    /// It is known where the drop showed it.
    Shown(fn(&DropResult) -> Option<f64>),
}

use Value::{Always, Shown};

/// Where the table has a figure; JSON has all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DropRow {
    /// Nowhere: it is in the line above, or not shown.
    Nowhere,
    /// In the order of the register.
    Here,
    /// After all others.
    Last,
}

const fn nowhere(value: Value) -> Entry {
    Entry { row: DropRow::Nowhere, value }
}

const fn here(value: Value) -> Entry {
    Entry { row: DropRow::Here, value }
}

const fn last(value: Value) -> Entry {
    Entry { row: DropRow::Last, value }
}

osim_inspect::quantities! {
    /// A figure of a drop, see [`Quantity`]; in the order of the JSON.
    DropFigure: Entry {
        /// Mass M of the body.
        Mass = Quantity::new("mass_kg", "mass", "kg") => nowhere(Always(|drop| drop.values.mass_kg));
        /// Spheres n that share the weight.
        SphereCount = Quantity::new("sphere_count", "spheres", "") => nowhere(Always(|drop| drop.sphere_count));
        /// Gravity g.
        Gravity = Quantity::new("gravity_m_s2", "gravity", "m/s2") => nowhere(Always(|drop| drop.values.gravity_m_s2));
        /// Height of the sphere bottoms at the start.
        Height = Quantity::new("height_m", "height", "m") => nowhere(Always(|drop| drop.values.height_m));
        /// How long the body was followed.
        Duration = Quantity::new("duration_s", "duration", "s") => nowhere(Always(|drop| drop.values.duration_s));
        /// R = √(Σ R_i²/n): what lengths are divided by.
        ReferenceRadius = Quantity::new("reference_radius_m", "radius", "m")
            => nowhere(Always(|drop| drop.report.reference_radius_m));
        /// √(R/g): what to divide times by before animals of different size are compared.
        ReferenceTime = Quantity::new("reference_time_s", "time unit sqrt(R/g)", "s")
            => last(Always(|drop| drop.report.reference_time_s));
        /// x̂ at the end of the series.
        FinalIndentation = Quantity::new("final_relative_indentation", "indentation/radius at the end", "")
            => here(Always(|drop| drop.report.final_indentation_m / drop.report.reference_radius_m));
        /// x̂ that the Hertz law (1) gives under body weight: the x̂ of the paper, of `design` and of scaling.
        IndentationHertz = Quantity::INDENTATION_HERTZ.labelled("  at rest, Hertz law")
            => here(Always(|drop| drop.report.hertz_indentation_m / drop.report.reference_radius_m));
        /// x̂ where the force by the model's law at speed 0, (C.9) for a smoothed one, equals body weight.
        IndentationModelLaw = Quantity::INDENTATION_MODEL_LAW.labelled("  at rest, the model's law").by("")
            => here(Always(|drop| drop.report.equilibrium_indentation_m / drop.report.reference_radius_m));
        /// The largest force of all spheres together.
        PeakForce = Quantity::new("peak_force_n", "peak force", "N") => here(Always(|drop| drop.report.peak_force_n));
        /// The same over body weight.
        PeakForceBw = Quantity::new("peak_force_bw", "peak force/body weight", "")
            => here(Always(|drop| drop.report.peak_force_bw()));
        /// Slope of the force of one sphere where it rests, by the model's law; the mean of spheres that differ.
        EquilibriumStiffness
            = Quantity::new("equilibrium_stiffness_n_m", "stiffness of one sphere at rest, model's law", "N/m")
            => here(Always(|drop| drop.report.equilibrium_stiffness_n_m));
        /// The same by the Hertz law: the k of Table 1.
        HertzStiffness
            = Quantity::new("hertz_stiffness_n_m", "stiffness of one sphere at rest, Hertz", "N/m").by("B.1")
            => here(Always(|drop| drop.report.hertz_stiffness_n_m));
        /// Speed at height 0: smoothed forces brake before, so it is a little below √(2gh). Absent where the ground is not
        /// reached.
        ImpactSpeed = Quantity::IMPACT_SPEED
            => here(Shown(|drop| Some(first_contact(drop)?.impact_speed_m_s)));
        /// Restitution of an impact at this speed by (12), if there were no gravity.
        RestitutionExact = Quantity::RESTITUTION_EXACT.labelled("restitution without gravity, exact")
            => here(Shown(|drop| Some(first_contact(drop)?.restitution_exact)));
        /// The same by (13), 1 − α ẋ. Absent if it is below 0.
        RestitutionApproximate = Quantity::RESTITUTION_APPROXIMATE
            => here(Shown(|drop| first_contact(drop)?.restitution_approximate));
        /// Time from touch-down to lift-off. Absent where the body does not leave the ground again.
        ContactTime = Quantity::new("contact_time_s", "contact time", "s")
            => here(Shown(|drop| Some(lift(drop)?.contact_time_s)));
        /// Speed at lift-off. Absent where the body does not leave the ground again.
        ReboundSpeed = Quantity::new("rebound_speed_m_s", "rebound speed", "m/s")
            => here(Shown(|drop| Some(lift(drop)?.rebound_speed_m_s)));
    }
}

impl DropFigure {
    /// Where the table has it.
    #[must_use]
    pub const fn row(self) -> DropRow {
        self.entry().row
    }

    /// Whether every drop has it; else it may be absent.
    #[must_use]
    pub const fn is_always_known(self) -> bool {
        matches!(self.entry().value, Always(_))
    }

    /// Its value, where the drop showed it.
    #[must_use]
    pub fn value(self, drop: &DropResult) -> Option<f64> {
        match self.entry().value {
            Always(value) => Some(value(drop)),
            Shown(value) => value(drop),
        }
    }
}

fn first_contact(drop: &DropResult) -> Option<FirstContact> {
    drop.report.first_contact
}

fn lift(drop: &DropResult) -> Option<Lift> {
    first_contact(drop)?.end
}

/// How to get the value of a column at one moment.
type AtMoment = fn(&DropReport, &Sample) -> f64;

osim_inspect::quantities! {
    /// A column of the series of a drop, see [`Quantity`].
    DropColumn: AtMoment {
        /// Time.
        Time = Quantity::new("time_s", "time", "s") => |_, sample| sample.time_s;
        /// Height of the sphere bottoms; below 0 they are in the ground.
        Height = Quantity::new("height_m", "height", "m") => |_, sample| sample.height_m;
        /// Speed, upwards.
        Speed = Quantity::new("speed_m_s", "speed", "m/s") => |_, sample| sample.speed_m_s;
        /// Force of all spheres.
        Force = Quantity::new("force_n", "force", "N") => |_, sample| sample.force_n;
        /// The same over body weight.
        ForceBw = Quantity::new("force_bw", "force/body weight", "")
            => |report, sample| sample.force_n / report.body_weight_n;
        /// Time over √(R/g).
        DimensionlessTime = Quantity::new("dimensionless_time", "time/sqrt(R/g)", "")
            => |report, sample| sample.time_s / report.reference_time_s;
    }
}

impl DropColumn {
    /// Its value at one moment.
    #[must_use]
    pub fn value(self, report: &DropReport, sample: &Sample) -> f64 {
        (self.entry())(report, sample)
    }
}
