//! What a change does to the bottoms of spheres: bodies that stood at their default pose and no longer do, and feet that it makes
//! uneven.

use std::collections::HashMap;

use osim_inspect::{Bottom, LoadSharing, StandingBody};
use osim_model::feet::LEANING_RAD;
use osim_model::{Finding, FindingCode, Limb, Model, Property};
use osim_patch::Plan;

use crate::rules::bottoms_moved;
use crate::standing_bodies::standing_bodies;

/// Bottoms that move by less, in the radius of a sphere, do not matter.
const SMALL: f64 = 0.1;
/// A body whose lowest sphere is this near to its floor, in its radius, stands.
const STANDS: f64 = 0.5;

/// Findings about the bottoms that `plan` moves from where `before` has them to where `now` has them; `said` are those about the new
/// model that are known already.
///
/// Spheres that follow their bodies are where their bones put them, and before that they were left behind: what they did there is no
/// comparison. New spheres did not stand anywhere, and `add` says where they are.
pub(crate) fn moved_bottoms(plan: &Plan, before: &Model, now: &Model, said: &[Finding]) -> Vec<Finding> {
    let radii = plan.changes.iter().any(|change| change.property == Property::Radius);
    let follow = plan.moves.iter().any(|one| one.equation == "follow");
    if (!radii && plan.moves.is_empty()) || follow || !plan.objects().is_empty() {
        return Vec::new();
    }
    let Some((before, now)) = Bodies::of(before).zip(Bodies::of(now)) else { return Vec::new() };
    let mut found: Vec<Finding> = now.lost(&before).collect();
    // A foot is called uneven once.
    if !said.iter().any(|one| one.code() == FindingCode::UnevenBottoms) {
        found.extend(now.uneven(&before));
    }
    found
}

/// The bodies of a model over their floors.
struct Bodies<'m> {
    model: &'m Model,
    standing: Vec<StandingBody>,
    sharing: LoadSharing,
}

impl<'m> Bodies<'m> {
    /// `None` if it is not known where bodies are at the default pose.
    fn of(model: &'m Model) -> Option<Self> {
        let (standing, sharing) = standing_bodies(model).ok()?;
        Some(Self { model, standing, sharing })
    }

    fn bottoms(&self) -> HashMap<&str, &Bottom> {
        let all = self.standing.iter().flat_map(|body| &body.bottoms);
        all.map(|bottom| (bottom.path.as_str(), bottom)).collect()
    }

    /// Bodies that stood as they were `before` and do not now.
    fn lost(&self, before: &Self) -> impl Iterator<Item = Finding> {
        let several = self.standing.len() > 1;
        self.standing.iter().filter_map(move |now| {
            let before = before.standing.iter().find(|old| old.body == now.body)?;
            is_lost(before, now).then(|| bottoms_moved::of_body(before, now, several))?
        })
    }

    /// Limbs whose bottoms are less level than `before`.
    fn uneven(&self, before: &Self) -> Vec<Finding> {
        let (old, new) = (before.bottoms(), self.bottoms());
        let pair = |path: &str| Some((*old.get(path)?, *new.get(path)?));
        let limbs = self.sharing.limbs().known().unwrap_or_default().iter();
        let of_limb = |limb: &Limb| {
            let spheres = limb.spheres.iter().filter_map(|&id| self.model.sphere(id));
            uneven(&limb.name, &spheres.filter_map(|sphere| pair(&sphere.path)).collect::<Vec<_>>())
        };
        limbs.filter_map(of_limb).collect()
    }
}

/// Whether a body stood `before`, and is inside its floor or above it `now`, because its bottoms moved.
fn is_lost(before: &StandingBody, now: &StandingBody) -> bool {
    let Some((was, is)) = before.lowest().zip(now.lowest()) else { return false };
    let stood = was.height_m.abs() <= STANDS * was.radius_m;
    let is_off = is.height_m > STANDS * is.radius_m || now.is_inside_floor();
    stood && is_off && (is.height_m - was.height_m).abs() > SMALL * is.radius_m
}

/// What a change does to a limb whose bottoms it moves apart; each was at the first place and is at the second.
fn uneven(limb: &str, bottoms: &[(&Bottom, &Bottom)]) -> Option<Finding> {
    let heights = |of: fn(&(&Bottom, &Bottom)) -> f64| bottoms.iter().map(of).collect::<Vec<f64>>();
    let moved_m = spread(&heights(|(was, is)| is.height_m - was.height_m));
    let (before_m, now_m) =
        (spread(&heights(|(was, _)| was.height_m)), spread(&heights(|(_, is)| is.height_m)));
    let by_height = |a: &&Bottom, b: &&Bottom| a.height_m.total_cmp(&b.height_m);
    let lowest = bottoms.iter().map(|(_, is)| *is).min_by(by_height)?;
    let highest = bottoms.iter().map(|(_, is)| *is).max_by(by_height)?;
    let small_m = SMALL * lowest.radius_m;
    // Where a foot leans the pose decides which of its spheres is low.
    let leans = bottoms.iter().any(|(_, is)| is.tilt_rad > LEANING_RAD);
    let is_uneven = moved_m > small_m && now_m - before_m > small_m && !leans;
    is_uneven.then(|| bottoms_moved::of_limb(limb, before_m, lowest, highest))
}

fn spread(values: &[f64]) -> f64 {
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    most - least
}
