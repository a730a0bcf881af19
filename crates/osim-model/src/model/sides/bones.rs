//! How large the bones of one side are, compared with those of the other.

use std::collections::BTreeMap;

use foldhash::HashMap;

use crate::model::side::without_side;
use crate::model::typed_model::Model;

/// Sizes of the bones that carry spheres: factors of their meshes, and distances between their joints.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bones<'m> {
    model: &'m Model,
}

impl<'m> Bones<'m> {
    pub(crate) fn of(model: &'m Model) -> Self {
        Self { model }
    }

    /// The longest bone of the limb to which `body` belongs, m; `None` where no body of it has two joints.
    pub(crate) fn longest_of_limb_m(&self, body: &str) -> Option<f64> {
        self.model.joint_distances().of_limb(body)
    }

    /// By how much the body `left` is larger than `right`, along x, y and z: by their meshes, else by the distances between
    /// their joints; `None` where neither says it.
    pub(crate) fn ratios(&self, left: &str, right: &str) -> Option<[f64; 3]> {
        self.of_meshes(left, right).or_else(|| {
            let distances = self.model.joint_distances();
            let ratio = distances.of_body(left)? / distances.of_body(right)?;
            (ratio.is_finite() && ratio > 0.0).then_some([ratio; 3])
        })
    }

    /// The same by meshes; `None` where no mesh shows the same bone, or these do not agree.
    fn of_meshes(&self, left: &str, right: &str) -> Option<[f64; 3]> {
        let meshes = self.model.body_facts.mesh_factors(self.model.components());
        let (left, right) = (meshes.get(left)?, meshes.get(right)?);
        let mut ratios = same_bones(left, right).into_iter().filter_map(|(l, r)| ratio(l, r));
        let first = ratios.next()?;
        ratios.all(|other| other.into_iter().zip(first).all(|(a, b)| close(a, b))).then_some(first)
    }
}

type Factors<'b> = (&'b [f64; 3], &'b [f64; 3]);

/// The factors of meshes of the same bone: by their names, else in their order.
fn same_bones<'b>(
    left: &'b BTreeMap<String, [f64; 3]>,
    right: &'b BTreeMap<String, [f64; 3]>,
) -> Vec<Factors<'b>> {
    let by_name: HashMap<String, &[f64; 3]> =
        right.iter().map(|(file, factors)| (without_side(file), factors)).collect();
    let named: Vec<Factors<'b>> =
        left.iter().filter_map(|(file, l)| Some((l, *by_name.get(&without_side(file))?))).collect();
    let in_order = || left.values().zip(right.values()).collect();
    if named.is_empty() && left.len() == right.len() { in_order() } else { named }
}

/// Left over right. An axis without a number takes the mean of the others, so that it does not end the comparison; `None` where
/// no axis has one.
fn ratio(left: &[f64; 3], right: &[f64; 3]) -> Option<[f64; 3]> {
    // A mirrored mesh has a negative factor.
    let of_axes: [f64; 3] = std::array::from_fn(|axis| (left[axis] / right[axis]).abs());
    let is_known = |ratio: &f64| ratio.is_finite() && *ratio > 0.0;
    let known: Vec<f64> = of_axes.into_iter().filter(is_known).collect();
    #[expect(clippy::cast_precision_loss, reason = "at most three axes")]
    let mean = known.iter().sum::<f64>() / known.len() as f64;
    (!known.is_empty()).then(|| of_axes.map(|ratio| if is_known(&ratio) { ratio } else { mean }))
}

/// Whether two values are the same, apart from rounding.
pub(crate) fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-6 * expected.abs()
}
