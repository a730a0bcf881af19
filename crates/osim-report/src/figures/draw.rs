//! The figure that a request asks for.

use contact_plots::{drop_figure, figure, force_figure, heat_map, loop_figure, state_figure};
use osim_inspect::series::Body;
use osim_model::files::Failure;
use osim_model::wording::Phrase;
use osim_requests::{AxesChoice, PlotKind, PlotRequest, Positive, fig1};

use super::axes::{Axes, units};
use super::drops::drops;
use super::force::force;
use super::heat::heat;
use super::loops::loops;
use super::paper::{fig_c5, fig4};
use super::state::state;
use super::svg::svg;

/// Draws `bodies` as `request` asks for: an SVG document.
///
/// # Errors
/// What a body weighs is not known where the figure needs it, or there are too many or too few of them.
pub fn draw(request: &PlotRequest, bodies: &[Body]) -> Result<String, Failure> {
    let wanted = request.axes.map(|axes| match axes {
        AxesChoice::Real => Axes::Real,
        _ => Axes::Dimensionless,
    });
    let units = units(bodies, wanted);
    let (height, title) = (request.fall.height.get(), request.title.as_deref());
    let duration = request.fall.duration.map(Positive::get);
    let drawn = match request.kind {
        Some(PlotKind::State) => state_figure(&state(bodies, units, title)?),
        Some(PlotKind::Loop) => loop_figure(&loops(bodies, units, height, title)?),
        Some(PlotKind::Drop) => drop_figure(&drops(bodies, height, duration, title)?),
        Some(PlotKind::Sweep) => {
            let (stiffness, dissipation) = (request.heat.stiffness, request.heat.dissipation);
            let map = heat(
                bodies,
                &request.heat_request(),
                |now| stiffness.values(now),
                |now| dissipation.values(now),
                title,
            )?;
            heat_map(&map)
        }
        Some(PlotKind::Fig1) => {
            let why = Phrase::joined(fig1(), " ").unwrap_or_default();
            return Err(Failure::outside("Fig. 1", "plot", why));
        }
        Some(PlotKind::Fig4) => figure(&fig4(title)?),
        Some(PlotKind::FigC5) => figure(&fig_c5(title)?),
        _ => force_figure(&force(bodies, units, title)?),
    };
    svg(drawn, bodies)
}
