//! Several remedies as one command.

use osim_model::Pattern;
use osim_requests::options::WantedOptions;
use osim_requests::{DesignRequest, Request};

/// A request to try, and the remedies that it does.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Candidate {
    pub(super) request: Request,
    pub(super) parts: Vec<Request>,
}

impl Candidate {
    pub(super) fn alone(request: Request) -> Self {
        Self { parts: vec![request.clone()], request }
    }
}

/// Remedies that do the same to other forces, each group as one that names all of them.
pub(super) fn joined(remedies: &[Request]) -> Vec<Candidate> {
    let mut groups: Vec<Candidate> = Vec::new();
    for remedy in remedies {
        let both = |group: &Candidate| with_forces(&group.request, remedy);
        match groups.iter_mut().find_map(|group| both(group).map(|both| (group, both))) {
            Some((group, both)) => {
                group.request = both;
                group.parts.push(remedy.clone());
            }
            None => groups.push(Candidate::alone(remedy.clone())),
        }
    }
    groups.retain(|group| group.parts.len() > 1);
    groups
}

/// `one` for the forces of `other`, too; `None` where they differ in anything else, or one is for all forces.
fn with_forces(one: &Request, other: &Request) -> Option<Request> {
    let (mut all, mut more) = (one.clone(), other.clone());
    let (before, added) = (std::mem::take(forces(&mut all)?), std::mem::take(forces(&mut more)?));
    let are_chosen = !added.is_empty() && !before.is_empty();
    if !are_chosen || all != more {
        return None;
    }
    forces(&mut all)?.extend(before.into_iter().chain(added));
    Some(all)
}

/// The forces that a request chooses, of a request that can be for some.
fn forces(request: &mut Request) -> Option<&mut Vec<Pattern>> {
    match request {
        Request::Set(request) => Some(&mut request.choice.select),
        Request::Convert(request) => Some(&mut request.choice.select),
        _ => None,
    }
}

/// Everything that the designs want, in one; `None` where there are not several. Where two want other numbers of the same, the first
/// counts.
pub(super) fn merged(candidates: &[Candidate]) -> Option<Candidate> {
    let designs: Vec<&DesignRequest> = candidates
        .iter()
        .filter_map(|candidate| match &candidate.request {
            Request::Design(design) => Some(&**design),
            _ => None,
        })
        .collect();
    let (first, others) = designs.split_first().filter(|(_, others)| !others.is_empty())?;
    let mut all: DesignRequest = (*first).clone();
    for other in others {
        add(&mut all.wanted, &other.wanted);
    }
    let parts = designs.into_iter().map(|design| design.clone().into()).collect();
    Some(Candidate { request: all.into(), parts })
}

/// Wants what `other` wants, too, where nothing is wanted of that yet.
fn add(wanted: &mut WantedOptions, other: &WantedOptions) {
    wanted.indentation = wanted.indentation.or(other.indentation);
    wanted.restitution = wanted.restitution.or(other.restitution);
    wanted.impact_speed = wanted.impact_speed.or(other.impact_speed);
    wanted.constant_indentation = wanted.constant_indentation.or(other.constant_indentation);
    wanted.state_width = wanted.state_width.or(other.state_width);
}
