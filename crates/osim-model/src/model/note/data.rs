//! What a note says.

use super::parts::NotedParts;
use super::step::Step;

/// Whether all contacts are made for one mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// They are: for the mass that the note gives, or, where it gives none, for what the bodies weighed.
    All,
    /// Something was left behind, or nobody can know.
    Partial,
}

/// The contents of a note: what its contacts were made for, written into the file when they were changed.
///
/// ```
/// use osim_model::{Document, Note, Scope};
///
/// let text = r#"<OpenSimDocument Version="40000"><Model name="walker">
/// <credits>A. Author; [contacts made for 500 kg at 9.81 m/s2 (osim-contact-scale 0.1.0; all; by rescale; sizes calcn_r=0.9,1,1; digest 0123456789abcdef; places fedcba9876543210; made -)]</credits>
/// </Model></OpenSimDocument>"#;
/// let note = Note::find(&Document::parse(text)?).expect("there is a note");
/// assert_eq!((note.contacts_mass_kg, note.gravity_m_s2, note.scope), (Some(500.0), Some(9.81), Scope::All));
/// assert_eq!((note.sizes[0].body.as_str(), note.sizes[0].factors), ("calcn_r", [0.9, 1.0, 1.0]));
/// // It is written as it was read.
/// assert!(text.contains(&note.text()));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    /// Version of the tool that wrote it.
    pub version: String,
    /// Mass the contacts were made for, kg; `None` where nobody knew.
    pub contacts_mass_kg: Option<f64>,
    /// Gravity the contacts were made for, m/s²; `None` where the model has none.
    pub gravity_m_s2: Option<f64>,
    /// All contacts or only some.
    pub scope: Scope,
    /// What was done to the contacts, the oldest step first: at least one.
    pub steps: Vec<Step>,
    /// Limbs that share the body weight, where somebody said how many.
    pub stance_limbs: Option<f64>,
    /// What the bodies weighed together when it was written, kg; `None` in notes of sets and of earlier versions.
    pub weighed_kg: Option<f64>,
    /// Mesh scale factors of the bodies that carried spheres when it was written.
    pub sizes: Vec<BodySize>,
    /// Digest of all contact values as written: the first 16 digits of their SHA-256.
    pub digest: String,
    /// The same of the radii alone; `None` in notes of earlier versions.
    pub radii: Option<String>,
    /// Names of the contacts and digests of their properties; `None` in notes of earlier versions.
    pub parts: Option<NotedParts>,
    /// The same of the spheres' locations; `None` in notes of earlier versions.
    pub places: Option<String>,
    /// What was added to the file for the note, one letter each; `-` for nothing.
    pub made: String,
    /// Names of the forces that were added beside others, as [`Note::operation_text`] has them; none where all were added.
    pub added: Vec<String>,
}

impl Note {
    /// What was done last.
    #[must_use]
    pub fn operation(&self) -> &str {
        self.steps.last().map_or("", |step| step.operation.as_str())
    }
}

/// The mesh scale factors of one body along x, y and z.
#[derive(Debug, Clone, PartialEq)]
pub struct BodySize {
    /// Name of the body.
    pub body: String,
    /// Factors along x, y and z of the body, above 0.
    pub factors: [f64; 3],
}

/// Something begins like a note and is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Unreadable;
