//! The remedy of a rule about models: a small constant indentation.

use contact_scaling::limits::SUGGESTED_CONSTANT_INDENTATION;
use osim_requests::Request;

use crate::findings::Remedies;

pub(crate) fn remedy(remedies: &Remedies<'_>) -> Option<Request> {
    remedies.constant_indentation(SUGGESTED_CONSTANT_INDENTATION)
}
