//! Bodies as a tree of joints: which of them hang on each other. Each body is walked through once, however long a chain is.

use crate::model::{Anatomy, Side};
use foldhash::{HashMap, HashMapExt, HashSet, HashSetExt};

/// The bodies of a model and the joints between them.
pub(super) struct Tree<'t> {
    anatomy: &'t Anatomy,
}

impl<'t> Tree<'t> {
    pub(super) fn new(anatomy: &'t Anatomy) -> Self {
        Self { anatomy }
    }

    /// All bodies, in file order.
    pub(super) fn bodies(&self) -> impl Iterator<Item = &'t str> {
        self.anatomy.bodies.iter().map(String::as_str)
    }

    fn parent(&self, body: &str) -> Option<&'t str> {
        self.anatomy.joint_above(body).map(|joint| joint.parent.as_str())
    }

    /// `body` and those above it that are not in `seen` yet, which they are afterwards; with it the first above that was.
    fn up<'b>(&self, body: &'b str, seen: &mut HashSet<&'b str>) -> (Vec<&'b str>, Option<&'b str>)
    where
        't: 'b,
    {
        let (mut walked, mut next) = (Vec::new(), Some(body));
        while let Some(at) = next {
            if !seen.insert(at) {
                return (walked, Some(at));
            }
            walked.push(at);
            next = self.parent(at);
        }
        (walked, None)
    }

    /// Bodies of one side that hang on each other: each group in the order given, the groups in the order of their first.
    pub(super) fn connected<'b>(&self, bodies: &[&'b str]) -> Vec<Vec<&'b str>>
    where
        't: 'b,
    {
        let given: HashSet<&str> = bodies.iter().copied().collect();
        let above = |body: &'b str| {
            let parent = self.parent(body).filter(|parent| given.contains(parent))?;
            (Side::of_name(parent) == Side::of_name(body)).then_some(parent)
        };
        let mut group_of: HashMap<&str, usize> = HashMap::new();
        let mut groups = 0;
        for &body in bodies {
            let (mut walked, mut next, mut group) = (Vec::new(), Some(body), groups);
            while let Some(at) = next {
                if let Some(&known) = group_of.get(at) {
                    group = known;
                    break;
                }
                group_of.insert(at, groups);
                walked.push(at);
                next = above(at);
            }
            groups += usize::from(group == groups && !walked.is_empty());
            group_of.extend(walked.into_iter().map(|at| (at, group)));
        }
        let mut connected = vec![Vec::new(); groups];
        for body in bodies {
            if let Some(group) = group_of.get(body).and_then(|&group| connected.get_mut(group)) {
                group.push(*body);
            }
        }
        connected
    }

    /// Some bodies, and those by which they hang on each other, the one on which all hang first; `None` where there is no such.
    pub(super) fn joined<'b>(&self, bodies: &[&'b str]) -> Option<Vec<&'b str>>
    where
        't: 'b,
    {
        let mut seen = HashSet::new();
        let (first, _) = self.up(bodies.first()?, &mut seen);
        let steps: HashMap<&str, usize> =
            first.iter().enumerate().map(|(steps, &body)| (body, steps)).collect();
        let mut top = 0;
        for body in bodies.iter().skip(1) {
            let (_, met) = self.up(body, &mut seen);
            // Whoever met a walk that came before meets the first one where that did.
            top = top.max(met.map(|met| steps.get(met).copied().unwrap_or(0))?);
        }
        let top = *first.get(top)?;
        let (mut joined, mut seen) = (vec![top], HashSet::from_iter([top]));
        for body in bodies {
            let (walked, _) = self.up(body, &mut seen);
            joined.extend(walked.into_iter().rev());
        }
        Some(joined)
    }

    /// `bodies`, and those of the same side that hang on them and carry no sphere.
    pub(super) fn with_below<'b>(
        &self,
        mut bodies: Vec<&'b str>,
        side: Option<Side>,
        carriers: &HashSet<&str>,
    ) -> Vec<&'b str>
    where
        't: 'b,
    {
        let mut known: HashSet<&str> = bodies.iter().copied().collect();
        let mut at = 0;
        while let Some(body) = bodies.get(at).copied() {
            at += 1;
            for child in self.anatomy.joints_below(body).map(|joint| joint.child.as_str()) {
                let same = side.is_some() && Side::of_name(child) == side;
                if same && !carriers.contains(child) && known.insert(child) {
                    bodies.push(child);
                }
            }
        }
        bodies
    }

    /// The same bodies, those with fewer joints above them first.
    pub(super) fn top_first<'b>(&self, mut bodies: Vec<&'b str>) -> Vec<&'b str>
    where
        't: 'b,
    {
        let mut depths: HashMap<&str, usize> = HashMap::new();
        for &body in &bodies {
            let (mut walked, mut next) = (Vec::new(), Some(body));
            while let Some(at) = next.filter(|at| !depths.contains_key(at)) {
                // Until its depth is known, so that a circle of joints, which OpenSim refuses, has an end.
                depths.insert(at, 0);
                walked.push(at);
                next = self.parent(at);
            }
            let above = next.and_then(|known| depths.get(known)).map_or(0, |depth| depth + 1);
            depths.extend(walked.into_iter().rev().zip(above..));
        }
        bodies.sort_by_key(|body| depths.get(body).copied().unwrap_or(0));
        bodies
    }
}
