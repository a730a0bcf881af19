//! The factors of one body, and where they come from.

use crate::model::Fault;
use foldhash::{HashMap, HashMapExt};

pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// Where a factor comes from, in the order in which sources are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum FactorSource {
    /// The caller.
    Given,
    /// The Scale Tool's applied ScaleSet.
    ScaleFile,
    /// `scale_factors` of the body's meshes.
    Mesh,
    /// Translations of frames fixed to the body: joint offsets.
    Joint,
    /// The ratio of distances from the body's origin to a joint below it: one factor for all axes, between different models.
    Distance,
    /// The factors of the body that it hangs on.
    Above,
}

impl FactorSource {
    /// As in reports and JSON.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::ScaleFile => "scale file",
            Self::Mesh => "mesh",
            Self::Joint => "joint offset",
            Self::Distance => "joint distance",
            Self::Above => "body above",
        }
    }
}

/// The factor of one axis of one body.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct AxisFactor {
    /// New length over old length.
    pub factor: f64,
    /// Where it comes from.
    pub source: FactorSource,
}

/// The factors of one body.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct BodyFactors {
    /// Name of the body.
    pub body: String,
    /// Along x, y and z of the body; `None` where no source says it.
    pub axes: [Option<AxisFactor>; 3],
    /// What each source says along x, y and z, in their order.
    pub sources: Vec<(FactorSource, [Option<f64>; 3])>,
    /// What has to be answered before its factors are known. It is asked only where they are needed, by [`Factors::of`](super::Factors::of).
    pub question: Option<Fault>,
}

/// The factors of all bodies, by name: of several bodies of one name the first counts.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct ByName(HashMap<String, usize>);

impl ByName {
    pub(super) fn of(bodies: &[BodyFactors]) -> Self {
        let mut places = HashMap::new();
        for (at, factors) in bodies.iter().enumerate() {
            places.entry(factors.body.clone()).or_insert(at);
        }
        Self(places)
    }

    /// Where `body` is among all.
    pub(super) fn place(&self, body: &str) -> Option<usize> {
        self.0.get(body).copied()
    }

    /// The factors of the body called `body` among `bodies`.
    pub(super) fn axes(&self, bodies: &[BodyFactors], body: &str) -> [Option<AxisFactor>; 3] {
        let found = self.place(body).and_then(|at| bodies.get(at));
        found.map(|factors| factors.axes).unwrap_or([None; 3])
    }
}

/// Length of a vector.
pub(super) fn length([x, y, z]: [f64; 3]) -> f64 {
    libm::sqrt(x * x + y * y + z * z)
}
