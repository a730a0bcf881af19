//! The user's choice of forces.

use crate::model::pattern::Pattern;

/// The user's choice of forces, by name.
///
/// Say what is chosen and take the rest from [`Selection::default`]: fields may be added.
///
/// ```
/// # let model = osim_model::Model::parse(include_bytes!("../../tests/data/one_foot.osim").as_slice())?;
/// use osim_model::Selection;
///
/// // All forces in which a moving sphere meets a half-space: contact_heel_r is the only one.
/// let selected = Selection::default().apply(&model)?;
/// assert!(selected.complete);
/// assert_eq!(model.names_of(&selected.forces), "contact_heel_r");
///
/// // Those of the left foot: there are none.
/// let left = "*_l".parse().map(|pattern| Selection { select: vec![pattern], ..Selection::default() });
/// assert_eq!(left.unwrap().apply(&model).unwrap_err().code(), "refused");
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Selection {
    /// Only forces whose name is as one of these says; empty for the default choice.
    pub select: Vec<Pattern>,
    /// Never forces whose name is as one of these says.
    pub exclude: Vec<Pattern>,
    /// Whether forces that are switched off are left out.
    pub skip_disabled: bool,
}
