//! The font of the pictures and of the measure of texts.

/// Arimo (SIL Open Font License 1.1), the letters figures need; `fonts/README.md` says how it was made. Its letters are as
/// wide as Arial's.
pub(crate) const FONT: &[u8] = include_bytes!("../fonts/Arimo-subset.ttf");
