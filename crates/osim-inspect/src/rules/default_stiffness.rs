//! The remedy of a rule about models: a published model has a stiffness.

use osim_requests::Request;

use crate::findings::Remedies;

/// The preset whose contacts are proposed where a model's own make no sense.
const PRESET: &str = "falisse2022";

/// Contacts of a published model.
pub(crate) fn remedy(remedies: &Remedies<'_>) -> Option<Request> {
    // A transfer takes the model's own gravity.
    let known = remedies.has_own_gravity() && remedies.weighed && remedies.counted;
    known.then(|| remedies.transfer(PRESET.into()).map(Request::from))?
}
