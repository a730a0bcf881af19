//! Forces that the OpenSim of an old document does not know.

use osim_model::messages::Phrase;
use osim_model::{Class, ForceKind};
use osim_patch::{Deed, Rebuilt};

/// Documents before this version are of OpenSim 1 to 3.
const OF_OPENSIM_4: u32 = 40_000;

/// What to know of smooth forces that `rebuilt` adds to a document of an OpenSim before 4: they came with OpenSim 4.1 (its list of
/// changes), which reads such documents too.
pub(crate) fn too_new(rebuilt: &Rebuilt) -> Option<Phrase> {
    let smooth = ForceKind::SmoothSphereHalfSpace.as_str();
    let is_new = |object: &osim_patch::ObjectChange| object.deed == Deed::Added && object.class == smooth;
    let is_old = rebuilt.model().document().version() < OF_OPENSIM_4;
    (is_old && rebuilt.objects.iter().any(is_new)).then(|| {
        let text = format!(
            "the document is of an OpenSim before 4, and {smooth} came with OpenSim 4.1, which reads it; for older programs the \
             forces have to be of the class {}",
            Class::HuntCrossleyForce.tag()
        );
        text.into()
    })
}
