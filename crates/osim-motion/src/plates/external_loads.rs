//! OpenSim's `ExternalLoads`: which columns act on which body.

use osim_model::{Document, ElementId, opensim_text};

use crate::fault::MotionFault;

/// An `ExternalLoads` file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct ExternalLoads {
    /// Its loads, in order.
    pub all: Vec<Load>,
    /// What it says in `datafile`, as it stands.
    pub data_file: Option<String>,
}

/// One `ExternalForce`.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Load {
    /// Its name.
    pub name: String,
    /// Whether it acts at all.
    pub applies: bool,
    /// The body that it acts on.
    pub body: Option<String>,
    /// The frame of the force; ground where nothing is said.
    pub force_frame: String,
    /// The frame of the point.
    pub point_frame: String,
    /// What the columns of the force begin with.
    pub force: Option<String>,
    /// What the columns of its point begin with.
    pub point: Option<String>,
    /// What the columns of the moment begin with.
    pub torque: Option<String>,
}

impl ExternalLoads {
    /// Reads the file.
    ///
    /// # Errors
    /// A file that is not XML, or has another root than `ExternalLoads`.
    pub fn read(bytes: &[u8]) -> Result<Self, MotionFault> {
        let document =
            Document::parse(bytes.to_vec()).map_err(|fault| MotionFault::new(fault.to_string()))?;
        let tree = document.tree();
        let root = document.data_root();
        if tree.name(root) != "ExternalLoads" {
            return Err(MotionFault::new(format!(
                "it is a <{}>, not an <ExternalLoads>, which says which columns act on which body",
                tree.name(root)
            )));
        }
        let objects = tree.child(root, "objects");
        let forces = objects.into_iter().flat_map(|objects| tree.children(objects));
        let forces = forces.filter(|&id| matches!(tree.name(id), "ExternalForce" | "PrescribedForce"));
        let all = forces.map(|force| Load::read(&document, force)).collect();
        Ok(Self { all, data_file: text(&document, root, "datafile") })
    }

    /// The last part of `datafile`, whatever disk it was on.
    #[must_use]
    pub fn data_file_name(&self) -> Option<&str> {
        self.data_file.as_deref().and_then(|path| path.rsplit(['/', '\\']).next())
    }
}

impl Load {
    fn read(document: &Document, force: ElementId) -> Self {
        let tree = document.tree();
        let get = |tag| text(document, force, tag);
        // Before version 4, `isDisabled` said the opposite.
        let is_false = |text: &String| matches!(text.as_str(), "false" | "0");
        let applies = get("appliesForce").is_none_or(|text| !is_false(&text))
            && get("isDisabled").is_none_or(|text| is_false(&text));
        Self {
            name: tree.attribute(force, "name").unwrap_or_default().into_owned(),
            applies,
            body: get("applied_to_body"),
            force_frame: get("force_expressed_in_body").unwrap_or_default(),
            point_frame: get("point_expressed_in_body").unwrap_or_default(),
            force: get("force_identifier"),
            point: get("point_identifier"),
            torque: get("torque_identifier"),
        }
    }
}

/// The text of a child, if it says anything.
fn text(document: &Document, owner: ElementId, tag: &str) -> Option<String> {
    let tree = document.tree();
    let text = tree.text_of(tree.child(owner, tag)?);
    let text = opensim_text::trimmed(&text);
    (!text.is_empty() && text != "Unassigned").then(|| text.to_owned())
}
