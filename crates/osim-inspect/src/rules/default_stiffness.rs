//! The remedy of a rule about models: a published model has a stiffness.

use osim_requests::Request;

use crate::findings::Remedies;

/// Contacts of a published model.
pub(crate) fn remedy(remedies: &Remedies<'_>) -> Option<Request> {
    remedies.published(None).map(Request::from)
}
