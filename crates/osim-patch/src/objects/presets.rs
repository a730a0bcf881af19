//! Presets whose places are published, too: each is a small model of our own that says so.

/// Name and model.
const MODELS: [(&str, &str); 2] = [
    ("falisse2022", include_str!("presets/falisse2022.osim")),
    ("moco-2d-gait", include_str!("presets/moco-2d-gait.osim")),
];

/// The preset of that name as a model, if the places of its spheres are known.
///
/// ```
/// use osim_model::Model;
///
/// let text = osim_patch::preset_model("falisse2022").expect("its places are published");
/// let model = Model::parse(text)?;
/// assert_eq!((model.spheres().len(), model.spheres()[0].radius_m()?), (12, 0.032));
/// # Ok::<(), osim_model::Fault>(())
/// ```
#[must_use]
pub fn preset_model(name: &str) -> Option<&'static str> {
    MODELS.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

/// Names of the presets that have places.
pub fn presets_with_places() -> impl Iterator<Item = &'static str> {
    MODELS.iter().map(|(name, _)| *name)
}
