//! Scale factors of each body, axis by axis, from the sources in their order.

use std::collections::BTreeMap;

use osim_model::{Anatomy, Document, Fault, FaultKind, Finding, FindingCode, Needed};

/// Offsets shorter than this say nothing about a factor, m.
const SHORTEST_OFFSET: f64 = 1e-6;
/// Sources that differ by more than this (relative) disagree.
const AGREEMENT: f64 = 0.01;
const AXES: [&str; 3] = ["x", "y", "z"];

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
}

/// Scale factors of all bodies of a scaled model.
///
/// ```
/// use std::collections::BTreeMap;
/// use osim_model::{Anatomy, Document, Model};
/// use osim_patch::{FactorSource, Factors, ScaleFile};
///
/// # let bytes: &[u8] = include_bytes!("../../../osim-model/tests/data/one_foot.osim");
/// // The file in which the Scale Tool says what it did: foot_r is 1.2 times as long.
/// let text = r#"<OpenSimDocument Version="40000"><ScaleSet><objects><Scale>
///     <scales>1.2 1.1 1</scales><segment>foot_r</segment><apply>true</apply>
/// </Scale></objects></ScaleSet></OpenSimDocument>"#;
/// let file = ScaleFile::read(&Document::parse(text)?)?;
///
/// // The model here has no meshes and no joints, which would say the same.
/// let anatomy = Anatomy::of(&Model::parse(bytes)?)?;
/// let factors = Factors::find(&anatomy, &anatomy, Some(&file), &BTreeMap::new())?;
/// assert_eq!(factors.of("foot_r")?, [1.2, 1.1, 1.0]);
/// assert_eq!(factors.bodies[0].axes[0].map(|axis| axis.source), Some(FactorSource::ScaleFile));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Factors {
    /// In file order of the scaled model.
    pub bodies: Vec<BodyFactors>,
    /// Where sources disagree by more than 1 %.
    pub warnings: Vec<Finding>,
}

/// Factors from the Scale Tool's applied ScaleSet file, by body name: see [`Factors`] for an example.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ScaleFile(BTreeMap<String, [f64; 3]>);

impl ScaleFile {
    /// Reads `<ScaleSet>`: `<Scale><scales>sx sy sz</scales><segment>body</segment><apply>true</apply></Scale>`.
    ///
    /// # Errors
    /// Another document, factors that are not three numbers above 0, or two that contradict each other.
    pub fn read(document: &Document) -> Result<Self, Fault> {
        Self::read_unlocated(document).map_err(|fault| fault.located(document.bytes()))
    }

    /// The factors of `body` along x, y and z.
    ///
    /// # Errors
    /// The file does not have it.
    pub fn of(&self, body: &str) -> Result<[f64; 3], Fault> {
        self.0.get(body).copied().ok_or_else(|| {
            Fault::refused(format!(
                "the ScaleSet has no factors of {body}, expected some for each body with spheres"
            ))
        })
    }

    fn read_unlocated(document: &Document) -> Result<Self, Fault> {
        let tree = document.tree();
        let root = document.data_root();
        if tree.name(root) != "ScaleSet" {
            let text = format!(
                "the document holds a <{}>, expected the <ScaleSet> that the Scale Tool writes (its output_scale_file)",
                tree.name(root)
            );
            return Err(Fault::over(FaultKind::Refused(text), tree.open_span(root)));
        }
        let mut factors: BTreeMap<String, [f64; 3]> = BTreeMap::new();
        let scales = tree.child(root, "objects").into_iter().flat_map(|objects| tree.children(objects));
        for scale in scales.filter(|&scale| tree.name(scale) == "Scale") {
            let Some(segment) = tree.child(scale, "segment").map(|segment| tree.text_of(segment)) else {
                continue;
            };
            let applied = document.flag(scale, "apply").unwrap_or(true);
            let values = if applied { document.triple(scale, "scales") } else { Some([1.0; 3]) };
            let Some(values) = values.filter(|values| values.iter().all(|value| *value > 0.0)) else {
                let text = format!("the scales of segment {segment} are not three numbers above 0");
                return Err(Fault::over(FaultKind::Refused(text), tree.span(scale)));
            };
            if factors.insert(segment.clone(), values).is_some_and(|other| other != values) {
                let text = format!("segment {segment} appears twice with different scales");
                return Err(Fault::over(FaultKind::Refused(text), tree.span(scale)));
            }
        }
        Ok(Self(factors))
    }
}

impl Factors {
    /// Compares `scaled` with the `generic` model it came from. `given` has factors along x, y and z by body name, which count
    /// more than any other source; then `file`, meshes and joint offsets.
    ///
    /// # Errors
    /// A factor that is zero, negative or not finite, or one given for a body that is not there.
    pub fn find(
        scaled: &Anatomy,
        generic: &Anatomy,
        file: Option<&ScaleFile>,
        given: &BTreeMap<String, [f64; 3]>,
    ) -> Result<Self, Fault> {
        if let Some(name) = given.keys().find(|name| !scaled.bodies.contains(name)) {
            return Err(Fault::new(FaultKind::UnknownBody { body: name.clone() }));
        }
        let mut factors = Self { bodies: Vec::new(), warnings: Vec::new() };
        for body in &scaled.bodies {
            let some = |values: [f64; 3]| values.map(Some);
            let mut said = Vec::new();
            if let Some(values) = given.get(body) {
                said.push((FactorSource::Given, some(*values)));
            }
            if let Some(values) = file.and_then(|file| file.0.get(body)) {
                said.push((FactorSource::ScaleFile, some(*values)));
            }
            said.push((FactorSource::Mesh, mesh_factors(scaled, generic, body)));
            said.push((FactorSource::Joint, joint_factors(scaled, generic, body)));
            said.retain(|(_, values)| values.iter().any(Option::is_some));
            factors.add(body, said)?;
        }
        Ok(factors)
    }

    fn add(&mut self, body: &str, said: Vec<(FactorSource, [Option<f64>; 3])>) -> Result<(), Fault> {
        let mut axes = [None; 3];
        for (axis, name) in AXES.iter().enumerate() {
            let mut values = said.iter().filter_map(|(source, values)| Some((*source, values[axis]?)));
            let Some((source, factor)) = values.next() else { continue };
            if !(factor.is_finite() && factor > 0.0) {
                return Err(Fault::refused(format!(
                    "the {name} factor of body {body} is {factor} ({}), expected a finite number above 0",
                    source.as_str()
                )));
            }
            for (other, value) in values.filter(|(_, value)| (value - factor).abs() > AGREEMENT * factor) {
                self.warnings.push(Finding::new(
                    FindingCode::FactorsDisagree,
                    format!(
                        "body {body}, {name}: {} says {factor:.6}, {} says {value:.6}; took the first",
                        source.as_str(),
                        other.as_str()
                    ),
                ));
            }
            axes[axis] = Some(AxisFactor { factor, source });
        }
        self.bodies.push(BodyFactors { body: body.to_owned(), axes, sources: said });
        Ok(())
    }

    /// The factors of `body` along x, y and z.
    ///
    /// # Errors
    /// An axis that no source determines ([`Needed::BodyFactors`]): the body and axis are named.
    pub fn of(&self, body: &str) -> Result<[f64; 3], Fault> {
        let found = self.bodies.iter().find(|factors| factors.body == body);
        let axes = found.map(|factors| factors.axes).unwrap_or([None; 3]);
        let missing: Vec<&str> =
            AXES.iter().zip(&axes).filter(|(_, axis)| axis.is_none()).map(|(name, _)| *name).collect();
        match axes {
            [Some(x), Some(y), Some(z)] => Ok([x.factor, y.factor, z.factor]),
            _ => Err(Fault::new(Needed::BodyFactors { body: body.to_owned(), axes: missing })),
        }
    }
}

/// New over old factors of the body's meshes; where several meshes differ, the first in name order counts.
fn mesh_factors(scaled: &Anatomy, generic: &Anatomy, body: &str) -> [Option<f64>; 3] {
    let (Some(new), Some(old)) = (scaled.meshes.get(body), generic.meshes.get(body)) else {
        return [None; 3];
    };
    let pair = new.iter().find_map(|(file, new)| Some((new, old.get(file)?)));
    let Some((new, old)) = pair else { return [None; 3] };
    std::array::from_fn(|axis| (old[axis] != 0.0).then(|| new[axis] / old[axis]))
}

/// New over old translation of the same frame; the longest offset of each axis is the most exact.
fn joint_factors(scaled: &Anatomy, generic: &Anatomy, body: &str) -> [Option<f64>; 3] {
    let (Some(new), Some(old)) = (scaled.offsets.get(body), generic.offsets.get(body)) else {
        return [None; 3];
    };
    std::array::from_fn(|axis| {
        let pairs = old.iter().filter_map(|(name, old)| Some((old[axis], new.get(name)?[axis])));
        let longest = pairs
            .filter(|(old, _)| old.abs() > SHORTEST_OFFSET)
            .max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        longest.map(|(old, new)| new / old)
    })
}
