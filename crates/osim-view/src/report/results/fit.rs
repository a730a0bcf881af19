//! A fit as text.

use contact_scaling::fit::{Doubt, Estimate, Fit};
use contact_scaling::limits;
use osim_model::messages::{Dialect, Input, phrase, readable, shown_path};
use osim_planning::FitResult;

use crate::report::layout::table;

/// The parameters with their confidence intervals, and whether the laws were made for this measurement.
#[must_use]
pub fn fit_text(result: &FitResult, dialect: &dyn Dialect) -> String {
    let fit = &result.fit;
    let mut text = format!(
        "{}: {} rows in the fit, n = {}, R = {} m\n\n{}\n\n",
        shown_path(&result.file),
        fit.rows.len(),
        readable(result.sphere_count),
        readable(result.radius_m),
        parameters(fit)
    );
    text.push_str(&format!(
        "R squared {:.6}; residuals have a standard deviation of {} N\n",
        fit.r_squared,
        readable(fit.residual_deviation_n)
    ));
    text.push_str(&format!(
        "largest indentation/radius {:.4}: {} the Hertz law ({})\n",
        fit.largest_relative_indentation,
        word(fit.within_hertz_limit),
        limits::INDENTATION.in_words()
    ));
    if fit.largest_relative_indentation > 1.0 {
        let question =
            phrase!["that is more than the whole radius: is ", Input::IndentationUnit, " right?\n"];
        text.push_str(&question.spelled(dialect));
    }
    text.push_str(&restitution(fit));
    for doubt in &fit.doubts {
        text.push_str(&format!("warning: {} [{}]\n", in_words(doubt), doubt.code()));
    }
    if fit.dissipation.is_some_and(|dissipation| dissipation.value < 0.0) {
        text.push_str(
            "the dissipation comes out below 0, which no model takes: check the sign of the speed\n",
        );
    }
    text
}

/// What a fit cannot say.
pub(super) fn in_words(doubt: &Doubt) -> String {
    match doubt {
        Doubt::LowRSquared { r_squared } => format!(
            "the law explains only {:.0} % of what the force does: look at the residuals before you use these values",
            100.0 * r_squared
        ),
        Doubt::Undetermined { parameter } => format!(
            "the 95 % interval of the {parameter} holds 0, so these data do not determine it: measure more, or other, \
             indentations and speeds",
            parameter = parameter.in_words()
        ),
        Doubt::NoResiduals => {
            "nothing is left over, as in calculated data: how sure the values are is not known".to_owned()
        }
        _ => doubt.code().to_owned(),
    }
}

/// A bound of an interval that may not be known.
fn bound(value: f64) -> String {
    if value.is_nan() { "not known".to_owned() } else { readable(value) }
}

fn word(within: bool) -> &'static str {
    if within { "within" } else { "outside" }
}

fn parameters(fit: &Fit) -> String {
    let mut table = table(&["parameter", "value", "95 % from", "to", "unit", "equation"]);
    let mut row = |name: &str, value: &Estimate, unit: &str, equation: &str| {
        let cells = [name, &readable(value.value), &bound(value.low), &bound(value.high), unit, equation];
        table.add_row(cells.map(str::to_owned).to_vec());
    };
    row("E* (composite)", &fit.composite_modulus, "N/m2", "(1)");
    row("stiffness to write (E1*)", &fit.plane_strain_modulus, "N/m2", "(A.4)");
    if let Some(dissipation) = &fit.dissipation {
        row("dissipation", dissipation, "s/m", "(12)");
    }
    if let Some(onset) = &fit.onset_m {
        row("contact onset", onset, "m", "(1)");
    }
    table.right_aligned(&[1, 2, 3]);
    table.trim_fmt()
}

fn restitution(fit: &Fit) -> String {
    match (fit.restitution, fit.within_hunt_crossley_limit, fit.largest_speed_m_s) {
        (Some(restitution), Some(within), Some(speed)) => format!(
            "restitution by (13) at the largest speed ({} m/s) {restitution:.4}: {} the Hunt-Crossley law ({})\n",
            readable(speed),
            word(within),
            limits::RESTITUTION.in_words()
        ),
        (None, Some(_), Some(speed)) => format!(
            "at the largest speed ({} m/s) (13) is outside its domain: the Hunt-Crossley law does not hold\n",
            readable(speed)
        ),
        _ => "no speed is known, so the force is taken as elastic and dissipation is not fitted\n".to_owned(),
    }
}
