//! What all models of a run share.

use osim_requests::options::RunOptions;

use super::journal::Journal;
use super::resume::PreviousRun;
use crate::folders::Folders;

/// How a run goes about its work, the same for all models.
pub(super) struct Context<'r> {
    pub(super) run: &'r RunOptions,
    pub(super) folders: Folders,
    pub(super) journal: Option<Journal>,
    pub(super) previous: PreviousRun,
}
