//! Names in a sentence.

/// The first of `names`, up to `most` of them, and how many more there are: a message stays readable.
///
/// ```
/// use osim_model::messages::listed;
///
/// assert_eq!(listed(&["heel_r", "heel_l", "toe_r"], 2), "heel_r, heel_l and 1 more");
/// assert_eq!(listed(&["heel_r", "heel_l"], 2), "heel_r, heel_l");
/// ```
#[must_use]
pub fn listed<S: AsRef<str>>(names: &[S], most: usize) -> String {
    let first = names.iter().take(most).map(AsRef::as_ref).collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(most) {
        0 => first,
        more => format!("{first} and {more} more"),
    }
}
