//! Remarks on a fit to recordings.

use osim_model::messages::{Input, Phrase, phrase, shown};
use osim_motion::Summary;
use osim_motion::fit::{FitBounds, FitTrial, FittedParameter, MotionFit};

/// The recordings do not determine the stiffness if the largest stiffness that fits nearly as well is more than this many times the
/// smallest.
const WIDE_STIFFNESS_RATIO: f64 = 3.0;
/// The recordings do not determine the dissipation if the dissipations that fit nearly as well differ by more than this, s/m.
const WIDE_DISSIPATION_S_M: f64 = 1.0;
/// The recordings do not determine stiffness and height separately if the correlation of the two is larger than this.
const STRONG_CORRELATION: f64 = 0.95;

/// All remarks on a fit. `others` are the names of forces that use the same floor and were not chosen.
pub(super) fn remarks(
    fit: &MotionFit,
    trials: &[FitTrial],
    (before, after): (&Summary, &Summary),
    bounds: &FitBounds,
    others: &[String],
) -> Vec<Phrase> {
    let mut remarks = remarks_on_feet(before, after);
    remarks.extend(remarks_on_feet_without_force(trials));
    for (trial, rms_bw) in fit.trials_rms_bw.iter().enumerate().skip(1) {
        remarks.push(
            format!("trial {}: the error of all its feet is {rms_bw:.3} body weights (rms)", trial + 1)
                .into(),
        );
    }
    remarks.extend(remark_if_worse(fit, bounds));
    for one in &fit.held_out {
        remarks.push(
            format!(
                "held out: fitted to the {}, the error at the {} is {:.3} body weights (rms)",
                one.fitted, one.tested, one.vertical_rms_bw
            )
            .into(),
        );
    }
    for (trial, up) in fit.floor_up_m.iter().enumerate() {
        // If spheres move, the floor of the first trial stays, and heights of floors begin with the second trial.
        let number = trial + usize::from(fit.spheres_down_m.is_some());
        remarks.push(remark_on_floor(number, fit.trials_rms_bw.len(), up));
    }
    remarks.extend(remark_on_other_forces(others));
    if let Some(down) = &fit.spheres_down_m {
        remarks.push(remark_on_moved_spheres(down));
    }
    if let Some(factor) = &fit.stiffness_factor {
        remarks.push(remark_on_stiffness(factor));
    }
    remarks.extend(fit.stiffness_height_correlation.and_then(remark_on_correlation));
    if let Some(dissipation) = &fit.dissipation {
        remarks.push(remark_on_dissipation(dissipation));
    }
    if let Some(scatter) = remark_on_scatter(before) {
        remarks.push(scatter);
    }
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
        remarks.push(
            format!("{} frames are left out: a foot seems to stand beside the plates", fit.beside).into(),
        );
    }
    remarks.push("friction is not fitted: how feet slip in kinematics is mostly error".into());
    remarks
}

fn remarks_on_feet(before: &Summary, after: &Summary) -> Vec<Phrase> {
    let pairs = before.feet.iter().zip(&after.feet);
    pairs
        .filter_map(|(old, new)| {
            let (old, new) = (old.comparison.as_ref()?, (&new.foot.name, new.comparison.as_ref()?));
            let bw = |force_n: f64| force_n / before.weight_n;
            let (name, new) = new;
            Some(Phrase::from(format!(
                "{name}: error of the force {:.3} body weights (rms), {:.3} before; up to {:.2} where the plates measured up to {:.2}",
                bw(new.normal_rms_n),
                bw(old.normal_rms_n),
                bw(new.peak_n),
                bw(new.measured_peak_n)
            )))
        })
        .collect()
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
    if fit.after.vertical_rms_bw <= fit.before.vertical_rms_bw {
        return None;
    }
    let mut text = format!(
        "the fitted model is further from the measured force than the model as it is ({:.3} body weights, {:.3} before)",
        fit.after.vertical_rms_bw, fit.before.vertical_rms_bw
    );
    if bounds.most_relative_indentation.is_some() && fit.before.largest_relative_indentation > 1.0 {
        text.push_str(&format!(
            ": its spheres are up to x/R {:.2} deep, deeper than the bound allows",
            fit.before.largest_relative_indentation
        ));
    }
    Some(text.into())
}

/// A remark if forces that were not chosen use the floor which the fit moves.
fn remark_on_other_forces(others: &[String]) -> Option<Phrase> {
    let first = others.first()?;
    let more = if others.len() > 1 { format!(" and {} more", others.len() - 1) } else { String::new() };
    Some(format!(
        "the floor is also that of {}{more}, not chosen: their depth changes with it, and nothing was fitted to them",
        shown(first)
    )
    .into())
}

/// The range of the fitted height, m, counted in the direction of the height.
fn range_along_direction(height: &FittedParameter) -> (f64, f64) {
    match height.nearly_as_good {
        (low_m, high_m) if height.value < 0.0 => (-high_m, -low_m),
        range => range,
    }
}

fn remark_on_moved_spheres(down: &FittedParameter) -> Phrase {
    let way = if down.value < 0.0 { "up" } else { "down" };
    let (low_m, high_m) = range_along_direction(down);
    // Adding 0 removes the sign of a negative zero.
    let tenths = |metres: f64| (1e4 * metres).round() / 10.0 + 0.0;
    format!(
        "all spheres go {way} by {:.1} mm in their bodies, and the floor stays; {:.1} to {:.1} mm fit nearly as well",
        1e3 * down.value.abs(),
        tenths(low_m),
        tenths(high_m)
    )
    .into()
}

fn remark_on_correlation(correlation: f64) -> Option<Phrase> {
    (correlation.abs() > STRONG_CORRELATION).then(|| {
        format!("the data hardly separate the stiffness from the height of the floor (correlation {correlation:.2})").into()
    })
}

fn remark_on_floor(trial: usize, trials: usize, up: &FittedParameter) -> Phrase {
    let way = if up.value < 0.0 { "down" } else { "up" };
    let of_trial = if trials > 1 { format!(" of trial {}", trial + 1) } else { String::new() };
    let (low_m, high_m) = range_along_direction(up);
    let bound = if up.at_bound { ", the bound of the search" } else { "" };
    format!(
        "the floor{of_trial} goes {way} by {:.1} mm{bound}; {:.1} to {:.1} mm fit nearly as well",
        1e3 * up.value.abs(),
        1e3 * low_m,
        1e3 * high_m
    )
    .into()
}

fn remark_on_stiffness(factor: &FittedParameter) -> Phrase {
    let (low, high) = factor.nearly_as_good;
    let bound = if factor.at_bound { ", the bound of the search" } else { "" };
    let mut text = format!(
        "stiffness: {:.3} times that of the model{bound}; {low:.2} to {high:.2} times fit nearly as well",
        factor.value
    );
    if high / low > WIDE_STIFFNESS_RATIO {
        text.push_str(": it is not determined");
        return phrase![text, ". Keep the published one with ", Input::Fit.with_value("height")];
    }
    text.into()
}

fn remark_on_dissipation(dissipation: &FittedParameter) -> Phrase {
    let (low, high) = dissipation.nearly_as_good;
    let mut text =
        format!("dissipation: {:.2} s/m; {low:.2} to {high:.2} s/m fit nearly as well", dissipation.value);
    if high - low > WIDE_DISSIPATION_S_M {
        text.push_str(": it is not determined");
    }
    text.into()
}

/// A remark if the height of a foot in stance varies by more than the radius of the spheres.
fn remark_on_scatter(before: &Summary) -> Option<Phrase> {
    let widest = before.feet.iter().filter_map(|foot| foot.stance_scatter_m).reduce(f64::max)?;
    let radius_m = before.smallest_radius_m?;
    (widest > radius_m).then(|| {
        format!(
            "in the recording, the height of the feet in stance varies by {:.0} mm, more than the radius ({:.0} mm): the stiffness cannot be determined",
            1e3 * widest,
            1e3 * radius_m
        )
        .into()
    })
}
