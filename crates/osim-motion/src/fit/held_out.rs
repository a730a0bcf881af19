//! A part fitted, and tried on the rest.

use super::data::FitTrial;
use super::result::HeldOut;

/// One foot fitted and the others tested; of one foot, each half fitted and the other tested. `tried` fits the one and gives the error at
/// the other, body weights.
pub(super) fn held_out(
    trials: &[FitTrial],
    tried: impl Fn(&[FitTrial], &[FitTrial]) -> Option<f64>,
) -> Vec<HeldOut> {
    let mut found = Vec::new();
    let mut add = |fitted: &str, tested: &str, parts: (Vec<FitTrial>, Vec<FitTrial>)| {
        let has_force = |trial: &FitTrial| trial.feet.iter().any(|foot| foot.has_force(trial.weight_n));
        // A foot in the air is nothing to fit to, and fits everything.
        if !(parts.0.iter().any(has_force) && parts.1.iter().any(has_force)) {
            return;
        }
        let Some(vertical_rms_bw) = tried(&parts.0, &parts.1) else { return };
        found.push(HeldOut { fitted: fitted.to_owned(), tested: tested.to_owned(), vertical_rms_bw });
    };
    let count = trials.iter().map(|trial| trial.feet.len()).min().unwrap_or(0);
    if count > 1 {
        for foot in 0..count {
            let name =
                |trial: &FitTrial| trial.feet.get(foot).map(|foot| foot.name.clone()).unwrap_or_default();
            let fitted = trials.first().map(name).unwrap_or_default();
            let only = |keep: &dyn Fn(usize) -> bool| -> Vec<FitTrial> {
                let of = |trial: &FitTrial| {
                    let feet = trial.feet.iter().enumerate().filter(|(index, _)| keep(*index));
                    FitTrial { feet: feet.map(|(_, foot)| foot.clone()).collect(), ..trial.clone() }
                };
                trials.iter().map(of).collect()
            };
            let parts = (only(&|index| index == foot), only(&|index| index != foot));
            let others = parts.1.first().into_iter().flat_map(|trial| &trial.feet);
            let tested: Vec<&str> = others.map(|foot| foot.name.as_str()).collect();
            add(&fitted, &tested.join(" and the "), parts.clone());
        }
        return found;
    }
    let half = |second: bool| -> Vec<FitTrial> {
        let of = |trial: &FitTrial| {
            let feet = trial.feet.iter().map(|foot| {
                let middle = foot.frames() / 2;
                if second { foot.part(middle, foot.frames()) } else { foot.part(0, middle) }
            });
            FitTrial { feet: feet.collect(), ..trial.clone() }
        };
        trials.iter().map(of).collect()
    };
    add("first half", "second half", (half(false), half(true)));
    add("second half", "first half", (half(true), half(false)));
    found
}
