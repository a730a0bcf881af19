//! `plot`: what contacts do, as SVG or PNG.
//!
//! `body` reads models and presets, `series` computes points with the library of equations, `contact_plots` draws them.

pub(crate) mod body;
mod output;
mod paper;
pub(crate) mod series;
mod sweep;

use anyhow::{Result, anyhow, bail};
use contact_plots::{
    DropFigure, ForceAxis, ForceFigure, IndentationAxis, LoopFigure, StateFigure, drop_figure, figure,
    force_figure, heat_map, loop_figure, state_figure,
};

use crate::args::{AxesArg, Length, PlotArgs, PlotKind};
use crate::failure::Failure;
use crate::terminal::{Exit, Terminal};
use body::Body;
use output::Output;
use series::Axes;

/// Draws and writes one figure.
///
/// # Errors
/// Wrong usage: an ending that is no picture's, a body too many or too few, a file that is there already.
pub(crate) fn run(args: &PlotArgs, terminal: &mut Terminal) -> Result<Exit> {
    let output = Output::of(args)?;
    let of_paper = matches!(args.kind, PlotKind::Fig4 | PlotKind::FigC5);
    if of_paper && (!args.models.is_empty() || args.target_mass.is_some()) {
        bail!("fig4 and fig-c5 redraw the paper's own animals: leave out models and --target-mass");
    }
    if !of_paper && args.models.is_empty() {
        bail!("nothing to draw: name a model, or a preset such as falisse2022");
    }
    let drawn = match bodies(args)? {
        Ok(bodies) => svg(&bodies, args).map(|svg| (svg, bodies)),
        Err(failure) => Err(failure),
    };
    match drawn {
        Ok((svg, bodies)) => {
            for body in &bodies {
                if let Some(weighed) = &body.weighed {
                    terminal.note(&weighed.warning(&body.name))?;
                }
            }
            output.write(&svg, &bodies, args, terminal)
        }
        Err(failure) => {
            terminal.error(&failure.text());
            Ok(Exit::Failed)
        }
    }
}

/// All bodies of the figure: those that were named, each followed by its scaled self where one is asked for.
fn bodies(args: &PlotArgs) -> Result<Result<Vec<Body>, Failure>> {
    let mut bodies = Vec::new();
    for path in &args.models {
        let body = match Body::named(path, args)? {
            Ok(body) => body,
            Err(failure) => return Ok(Err(failure)),
        };
        let scaled = match args.target_mass.map(|target| body.scaled(target)).transpose() {
            Ok(scaled) => scaled,
            Err(failure) => return Ok(Err(failure)),
        };
        bodies.push(body);
        bodies.extend(scaled);
    }
    Ok(Ok(bodies))
}

/// The units asked for, else those that compare well: newtons for one contact, shares of the weight for several.
fn axes(bodies: &[Body], wanted: Option<AxesArg>) -> Axes {
    let single = series::kinds(bodies).count() == 1;
    let indentation = match wanted {
        Some(AxesArg::Real) => IndentationAxis::Millimetre,
        _ => IndentationAxis::Relative,
    };
    let shares = wanted.map_or(!single, |wanted| wanted == AxesArg::Dimensionless);
    let force = if shares { ForceAxis::WeightShare } else { ForceAxis::Newton };
    Axes { indentation, force }
}

/// The figure of some bodies.
fn svg(bodies: &[Body], args: &PlotArgs) -> Result<String, Failure> {
    let axes = axes(bodies, args.axes);
    let drawn = match args.kind {
        PlotKind::Force => force_figure(&force(bodies, axes, args)?),
        PlotKind::State => state_figure(&state(bodies, axes, args)?),
        PlotKind::Loop => loop_figure(&loops(bodies, axes, args)?),
        PlotKind::Drop => drop_figure(&drop(bodies, args)?),
        PlotKind::Sweep => heat_map(&sweep::map(only(bodies, "a sweep")?, args)?),
        PlotKind::Fig4 => figure(&paper::fig4(args.title.as_deref()).map_err(|error| of_paper(&error))?),
        PlotKind::FigC5 => figure(&paper::fig_c5(args.title.as_deref()).map_err(|error| of_paper(&error))?),
    };
    let name = names(bodies);
    drawn.map_err(|error| {
        let error = match error {
            contact_plots::PlotError::TooMany { .. } => anyhow!("{error}: choose with --select GLOB"),
            error => anyhow!("{error}"),
        };
        Failure::outside(&name, "plot", &error)
    })
}

fn of_paper(error: &anyhow::Error) -> Failure {
    let name = paper::SOURCE;
    Failure::outside(name, "plot", error)
}

fn names(bodies: &[Body]) -> String {
    bodies.iter().map(|body| body.name.as_str()).collect::<Vec<_>>().join(", ")
}

/// The title asked for, else what the figure shows of whom.
fn title(what: &str, bodies: &[Body], args: &PlotArgs) -> String {
    match (&args.title, bodies) {
        (Some(title), _) => title.clone(),
        (None, [one]) => format!("{what}: {}", one.name),
        (None, _) => what.to_owned(),
    }
}

/// The one body of a figure that is about one.
fn only<'b>(bodies: &'b [Body], what: &str) -> Result<&'b Body, Failure> {
    match bodies {
        [one] => Ok(one),
        _ => Err(Failure::outside(
            &names(bodies),
            "plot",
            &anyhow!("{what} is about one body: name one model, without --target-mass"),
        )),
    }
}

fn force(bodies: &[Body], axes: Axes, args: &PlotArgs) -> Result<ForceFigure, Failure> {
    let depth = series::depth(bodies);
    let curves = series::kinds(bodies).map(|(body, kind)| series::force(body, kind, axes, depth));
    Ok(ForceFigure {
        title: title("Contact force", bodies, args),
        indentation: axes.indentation,
        force: axes.force,
        bodies: curves.collect::<Result<_, _>>()?,
        limits: series::hertz_limit(axes),
    })
}

fn state(bodies: &[Body], axes: Axes, args: &PlotArgs) -> Result<StateFigure, Failure> {
    let mut curves = Vec::new();
    let mut limits = Vec::new();
    for (body, kind) in series::kinds(bodies) {
        curves.extend(series::state(body, kind, axes)?);
        limits = series::thresholds(kind, axes);
    }
    if curves.is_empty() {
        let error = anyhow!(
            "a HuntCrossleyForce has no contact state to draw: there, contact is a step; plot force shows its law"
        );
        return Err(Failure::outside(&names(bodies), "plot", &error));
    }
    // Thresholds are a contact's own; several would be a forest of lines.
    if curves.len() > 1 {
        limits.clear();
    }
    Ok(StateFigure {
        title: title("Contact state", bodies, args),
        indentation: axes.indentation,
        bodies: curves,
        limits,
    })
}

fn loops(bodies: &[Body], axes: Axes, args: &PlotArgs) -> Result<LoopFigure, Failure> {
    let kinds: Vec<_> = series::kinds(bodies).collect();
    let mut loops = Vec::new();
    let mut elastic = Vec::new();
    for &(body, kind) in &kinds {
        let impact = series::impact_speed(body, kind, args.fall.height)?;
        if kinds.len() > 1 {
            let mut one = series::hysteresis(body, kind, axes, impact)?;
            one.name = format!("{}: {}", series::name_of(body, kind), one.name);
            loops.push(one);
            continue;
        }
        elastic = series::elastic(body, kind, axes)?;
        for share in [0.25, 0.5, 1.0] {
            loops.push(series::hysteresis(body, kind, axes, share * impact)?);
        }
    }
    let from = match args.fall.height {
        Length::Metres(metres) => format!("{} m", osim_patch::readable(metres)),
        Length::Radii(radii) => format!("{} R", osim_patch::readable(radii)),
    };
    Ok(LoopFigure {
        title: title("Dissipation", bodies, args),
        motion: format!(
            "Half a sine wave, as deep as twice the body weight presses by the Hertz law; it begins with the speed in \
             the legend, the largest of them that of a fall from {from}. The restitution is that of a free impact at that \
             speed, by the exact law."
        ),
        indentation: axes.indentation,
        force: axes.force,
        elastic,
        loops,
        limits: series::hertz_limit(axes),
    })
}

fn drop(bodies: &[Body], args: &PlotArgs) -> Result<DropFigure, Failure> {
    let duration = match args.fall.duration {
        Some(duration) => duration,
        None => series::duration(bodies)?,
    };
    let falls = bodies.iter().map(|body| series::fall(body, args.fall.height, duration));
    let from = match args.fall.height {
        Length::Metres(metres) => format!("{} m", osim_patch::readable(metres)),
        Length::Radii(radii) => format!("{} sphere radii", osim_patch::readable(radii)),
    };
    Ok(DropFigure {
        title: title("Drop test", bodies, args),
        conditions: format!("They fall from {from}."),
        bodies: falls.collect::<Result<_, _>>()?,
    })
}
