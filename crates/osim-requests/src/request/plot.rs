//! Requests for figures, and their style.

use std::path::PathBuf;

use osim_model::messages::{Input, Phrase, phrase};

use crate::fault::RequestFault;
use crate::options::{AnswerOptions, CountOptions, FallOptions, ForceOptions, MassOptions, SetFiles};
use crate::request::inspect::AngleChoice;
use crate::request::knowledge::no_fig1;
use crate::values::serial::{self, choices, fields};
use crate::values::{Acceleration, Dpi, FigureWidth, FontSize, Grid, Kilograms, Span, path};

fields! {
    /// How a figure looks.
    struct FigureOptions {
        title: Option<String>,
        label: Vec<String> as "serial::Texts",
        width: Option<FigureWidth>,
        font_size: FontSize,
        x_range: Option<Span>,
        y_range: Option<Span>,
        dpi: Dpi,
    }

    /// The grid of a heat map.
    struct HeatOptions {
        quantity: QuantityChoice,
        stiffness: Grid = Grid::factors(0.1, 10.0, 25),
        dissipation: Grid = Grid::factors(0.1, 4.0, 25),
        table: Option<PathBuf> as "path::Optional",
        value_column: Option<String>,
        x_column: Option<String>,
        y_column: Option<String>,
        value_range: Option<Span>,
    }

    /// Draws what contacts do.
    struct PlotRequest {
        kind: Option<PlotKind>,
        models: Vec<PathBuf> as "path::List",
        output: Option<PathBuf> as "path::Optional",
        data: Option<PathBuf> as "path::Optional",
        force: bool,
        target_mass: Option<Kilograms>,
        axes: Option<AxesChoice>,
        geometry_dir: Option<PathBuf> as "path::Optional",
        motion: Option<PathBuf> as "path::Optional",
        plates: Option<PathBuf> as "path::Optional",
        loads: Option<PathBuf> as "path::Optional",
        angles: Option<AngleChoice>,
        presets: Option<PathBuf> as "path::Optional",
        gravity: Option<Acceleration>,
        fall: ..FallOptions,
        heat: ..HeatOptions,
        looks: ..FigureOptions,
        counts: ..CountOptions,
        masses: ..MassOptions,
        choice: ..ForceOptions,
        set_files: ..SetFiles,
        answers: ..AnswerOptions,
    } where
        Required("kind"), Required("output"), Needs("plates", "motion"), Needs("loads", "plates"),
        Needs("angles", "motion"), Needs("table", "value_column"), Needs("value_column", "table"),
        Needs("x_column", "table"), Needs("y_column", "table");
}

choices! {
    /// The quantity that the colours of a heat map show.
    QuantityChoice: Indentation {
        Indentation = "indentation", "Relative indentation at rest under body weight, by the Hertz law";
        Restitution = "restitution", "Coefficient of restitution at the impact speed of the fall, exact";
        PeakForce = "peak-force", "Peak force over body weight in the fall";
    }

    /// The kind of plot.
    PlotKind {
        Force = "force", "Force against indentation: Hertz, with cf, smoothed";
        State = "state", "Contact state against indentation";
        Loop = "loop", "Dissipation: force while a sphere goes in and out";
        Drop = "drop", "Drop test: force against time and non-dimensional time";
        Sweep = "sweep", "A quantity over stiffness and dissipation, as a heat map";
        Feet = "feet", "Feet from the side and from above: bones, joints, spheres to scale";
        Motion = "motion", "Along a recorded motion: force beside the plates', x/R of each sphere";
        Fig1 = "fig1", "The paper's Fig. 1: not drawn; the output says what it needs";
        Fig4 = "fig4", "The paper's Fig. 4";
        FigC5 = "fig-c5", "The paper's Fig. C.5";
    }

    /// Units of indentation and force.
    AxesChoice {
        Dimensionless = "dimensionless", "x/R, and force over the sphere's share of the weight";
        Real = "real", "mm and N";
    }
}

impl PlotRequest {
    /// Whether the plot is a figure of the paper, with the animals of the paper.
    pub(crate) fn is_of_paper(&self) -> bool {
        matches!(self.kind, Some(PlotKind::Fig4 | PlotKind::FigC5))
    }

    /// Refuses a wrong number of models for the plot, and the figure that cannot be drawn.
    ///
    /// # Errors
    /// Too many models, no model, or Fig. 1.
    pub fn check_models(&self) -> Result<(), RequestFault> {
        if self.kind == Some(PlotKind::Fig1) {
            return Err(RequestFault::general(no_fig1()));
        }
        if self.is_of_paper() && (!self.models.is_empty() || self.target_mass.is_some()) {
            return Err(RequestFault::general(phrase![
                "fig4 and fig-c5 redraw the paper's own animals: leave out models and ",
                Input::TargetMass,
            ]));
        }
        let is_motion = self.kind == Some(PlotKind::Motion);
        if is_motion != self.motion.is_some() {
            let text = match is_motion {
                true => "the plot of motion needs a recording: give ",
                false => "only the plot of motion takes a recording: leave out ",
            };
            return Err(RequestFault::general(phrase![text, Input::Motion.with_placeholder("FILE")]));
        }
        if self.heat.table.is_some() {
            if self.kind != Some(PlotKind::Sweep) || !self.models.is_empty() || self.target_mass.is_some() {
                let why = "a table is drawn by `plot kind=sweep`, without a model: leave out models and the target mass";
                return Err(RequestFault::refused(Input::Table, Phrase::template(why)));
            }
            return Ok(());
        }
        if !self.is_of_paper() && self.models.is_empty() {
            let why = "nothing to draw: name a model, or a preset such as falisse2022";
            return Err(RequestFault::general(why));
        }
        Ok(())
    }

    /// The mass to which the drawn contacts are scaled, kg.
    pub fn target_mass_kg(&self) -> Option<f64> {
        self.target_mass.map(Kilograms::get)
    }
}
