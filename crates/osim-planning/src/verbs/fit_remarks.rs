//! Remarks on a fit to recordings.

use osim_model::messages::{Input, Phrase, phrase, shown};
use osim_motion::Summary;
use osim_motion::fit::{FitBounds, FitTrial, FittedParameter, HeldOut, MotionFit};
use osim_patch::FittedFoot;

/// The recordings do not determine stiffness and height separately if the correlation of the two is larger than this.
const STRONG_CORRELATION: f64 = 0.95;

/// All remarks on a fit. `others` are the names of forces that use the same floor and were not chosen.
pub(super) fn remarks(
    fit: &MotionFit,
    trials: &[FitTrial],
    (before, feet): (&Summary, &[FittedFoot]),
    bounds: &FitBounds,
    others: &[String],
) -> Vec<Phrase> {
    let mut remarks: Vec<Phrase> = feet.iter().map(remark_on_foot).collect();
    remarks.extend(remarks_on_feet_without_force(trials));
    for (trial, rms_bw) in fit.trials_rms_bw.iter().enumerate().skip(1) {
        let (number, text) = (trial + 1, "the error of all its feet is");
        remarks.push(format!("trial {number}: {text} {rms_bw:.3} body weights (rms)").into());
    }
    remarks.extend(remark_if_worse(fit, bounds));
    for HeldOut { fitted, tested, vertical_rms_bw } in &fit.held_out {
        let text = format!("cross-validation: fitted to the {fitted}, the error at the {tested} is");
        remarks.push(format!("{text} {vertical_rms_bw:.3} body weights (rms)").into());
    }
    // If spheres move, the floor of the first trial stays, and heights of floors begin with the second trial.
    let first = 1 + usize::from(fit.spheres_down_m.is_some());
    for (number, up) in (first..).zip(&fit.floor_up_m) {
        let of_trial =
            if fit.trials_rms_bw.len() > 1 { format!(" of trial {number}") } else { String::new() };
        let height = height_in_words(up, ["down", "up"], bound_in_words(up));
        remarks.push(format!("the floor{of_trial} goes {height}").into());
    }
    remarks.extend(remark_on_other_forces(others));
    remarks.extend(fit.spheres_down_m.as_ref().map(|down| {
        let height = height_in_words(down, ["up", "down"], " in their bodies, and the floor stays");
        Phrase::from(format!("all spheres go {height}"))
    }));
    let contact = fit.stiffness_factor.iter().chain(&fit.dissipation).chain(&fit.undetermined);
    remarks.extend(contact.map(|one| parameter_in_words(one).into()));
    remarks.extend(remark_on_correlation(fit));
    remarks.extend(remark_on_scatter(before));
    let is_deep = fit.after.largest_relative_indentation > 0.999;
    if bounds.most_relative_indentation.is_some() && (is_deep || fit.floor_up_m.iter().any(|up| up.at_bound))
    {
        remarks.push(phrase![
            "a sphere is as deep as its radius, which is the bound: ",
            Input::Unbounded,
            " would let it go deeper, and fit closer, but the law holds up to x/R 0.16"
        ]);
    }
    if fit.beside > 0 {
        let text = "frames are left out: a foot seems to stand beside the plates";
        remarks.push(format!("{} {text}", fit.beside).into());
    }
    remarks.push("friction is not fitted: how feet slip in kinematics is mostly error".into());
    remarks
}

/// A remark on each foot: how far its force was from the plates before the fit, and is after it.
fn remark_on_foot(foot: &FittedFoot) -> Phrase {
    let (name, after, before) = (&foot.name, foot.vertical_rms_bw, foot.vertical_rms_before_bw);
    let text = format!("{name}: error of the force {after:.3} body weights (rms), {before:.3} before; up to");
    let (peak, plates) = (foot.peak_bw, foot.measured_peak_bw);
    format!("{text} {peak:.2} where the plates measured up to {plates:.2}").into()
}

/// Remarks on feet that the fit left out, because no force was measured under them.
fn remarks_on_feet_without_force(trials: &[FitTrial]) -> Vec<Phrase> {
    let mut names: Vec<&str> =
        trials.iter().flat_map(|trial| &trial.without_force).map(String::as_str).collect();
    names.sort_unstable();
    names.dedup();
    let said = |name: &str| format!("{name}: left out, because the plates measured no force under it").into();
    names.into_iter().map(said).collect()
}

/// A remark if the errors of the fitted model, compared with the plates, are larger than those of the original model.
fn remark_if_worse(fit: &MotionFit, bounds: &FitBounds) -> Option<Phrase> {
    let (after, before) = (fit.after.vertical_rms_bw, fit.before.vertical_rms_bw);
    let depth = fit.before.largest_relative_indentation;
    let text = "the fitted model is further from the measured force than the model as it is";
    let mut text = format!("{text} ({after:.3} body weights, {before:.3} before)");
    if bounds.most_relative_indentation.is_some() && depth > 1.0 {
        text.push_str(&format!(": its spheres are up to x/R {depth:.2} deep, deeper than the bound allows"));
    }
    (after > before).then(|| text.into())
}

/// A remark if forces that were not chosen use the floor which the fit moves.
fn remark_on_other_forces(others: &[String]) -> Option<Phrase> {
    let first = others.first()?;
    let more = if others.len() > 1 { format!(" and {} more", others.len() - 1) } else { String::new() };
    let text = "not chosen: their depth changes with it, and nothing was fitted to them";
    Some(format!("the floor is also that of {}{more}, {text}", shown(first)).into())
}

/// A remark if the stiffness and the height of the first trial depend on each other.
fn remark_on_correlation(fit: &MotionFit) -> Option<Phrase> {
    let is_wanted =
        |[first, second]: &[String; 2]| first == "stiffness_factor" && second != "dissipation_s_m";
    let (_, correlation) = fit.correlations.iter().find(|(names, _)| is_wanted(names))?;
    let text = "the data hardly separate the stiffness from the height of the floor";
    (correlation.abs() > STRONG_CORRELATION).then(|| format!("{text} (correlation {correlation:.2})").into())
}

fn bound_in_words(one: &FittedParameter) -> &'static str {
    if one.at_bound { ", the bound of the search" } else { "" }
}

/// A height in its direction, one of two `ways`, and the range of heights.
fn height_in_words(height: &FittedParameter, ways: [&str; 2], more: &str) -> String {
    let (low_m, high_m) = height.nearly_as_good;
    let (way, low_m, high_m) =
        if height.value < 0.0 { (ways[0], -high_m, -low_m) } else { (ways[1], low_m, high_m) };
    // Adding 0 removes the sign of a negative zero.
    let [value, low, high] = [height.value.abs(), low_m, high_m].map(|m| (1e4 * m).round() / 10.0 + 0.0);
    format!("{way} by {value:.1} mm{more}; {low:.1} to {high:.1} mm fit nearly as well")
}

/// A stiffness or dissipation, and the range of its values.
pub(super) fn parameter_in_words(one: &FittedParameter) -> String {
    let ((low, high), bound) = (one.nearly_as_good, bound_in_words(one));
    let (best, unit) = match one.name.as_str() {
        "stiffness_factor" => (format!("stiffness: {:.3} times that of the model", one.value), "times"),
        _ => (format!("dissipation: {:.2} s/m", one.value), "s/m"),
    };
    let stays = if one.is_written { "" } else { ": it is not determined, and that of the model stays" };
    format!("{best}{bound}; {low:.2} to {high:.2} {unit} fit nearly as well{stays}")
}

/// A remark if the height of a foot in stance varies by more than the radius of the spheres.
fn remark_on_scatter(before: &Summary) -> Option<Phrase> {
    let widest = before.feet.iter().filter_map(|foot| foot.stance_scatter_m).reduce(f64::max)?;
    let radius_m = before.smallest_radius_m?;
    let (scatter, radius) = (1e3 * widest, 1e3 * radius_m);
    let text = format!("in the recording, the height of the feet in stance varies by {scatter:.0} mm");
    let text = format!("{text}, more than the radius ({radius:.0} mm): a stiffness fits this recording only");
    (widest > radius_m).then(|| text.into())
}
