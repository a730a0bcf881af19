//! Remarks on what the feet that get spheres consist of.

use osim_model::feet::{Movements, Sole};
use osim_model::messages::{Phrase, shown};
use osim_model::{Model, Side, without_side};

/// What a user may not expect of feet with `soles`: one side alone, parts that get nothing, and feet that do not bend.
pub(crate) fn parts_of_feet(model: &Model, soles: &[Sole]) -> Vec<Phrase> {
    let feet = Feet { model, soles };
    [feet.one_side(), feet.left_out(), feet.rigid(), feet.one_piece()].into_iter().flatten().collect()
}

struct Feet<'f> {
    model: &'f Model,
    soles: &'f [Sole],
}

impl<'f> Feet<'f> {
    fn bodies(&self) -> impl Iterator<Item = &'f str> {
        self.soles.iter().flat_map(|sole| &sole.bodies).map(String::as_str)
    }

    /// Each joint from a body of a foot to one below it.
    fn joints_below(&self) -> impl Iterator<Item = (&'f str, &'f str)> {
        let model = self.model;
        self.bodies().flat_map(move |body| {
            let below = model.joints().iter().filter(move |joint| joint.parent.as_deref() == Some(body));
            below.filter_map(move |joint| Some((body, joint.child.as_deref()?)))
        })
    }

    fn has(&self, body: &str) -> bool {
        self.bodies().any(|own| own == body)
    }

    /// The bodies of the other side, where only one side gets spheres.
    fn one_side(&self) -> Option<Phrase> {
        let other = |body: &&str| {
            let is_counterpart = |there: &str| {
                without_side(there) == without_side(body)
                    && Side::of_name(there).is_some_and(|side| Some(side) != Side::of_name(body))
            };
            let there = self.model.bodies().iter().map(|there| there.name.as_str());
            there.filter(|there| is_counterpart(there)).find(|there| !self.has(there))
        };
        let missing: Vec<&str> = self.bodies().filter_map(|body| other(&body)).collect();
        said(&missing, |bodies| format!("one side alone gets spheres: the other side has {bodies}"))
    }

    /// Bodies that hang on a foot and get nothing.
    fn left_out(&self) -> Option<Phrase> {
        let out: Vec<&str> =
            self.joints_below().map(|(_, child)| child).filter(|child| !self.has(child)).collect();
        said(&out, |bodies| {
            format!("no spheres under {bodies}: part of the foot, but not among the bodies that were given")
        })
    }

    /// Parts of a foot that do not move against each other.
    fn rigid(&self) -> Option<Phrase> {
        let movements = Movements::of(self.model);
        let inside = self.joints_below().filter(|(_, child)| self.has(child));
        let stiff = inside.filter(|(parent, child)| {
            movements.between(parent, child).is_some_and(|freedom| !freedom.is_any())
        });
        let welded: Vec<&str> = stiff.map(|(_, child)| child).collect();
        said(&welded, |bodies| {
            format!(
                "the foot does not bend: nothing is free in the joint of {bodies} (welded, locked or prescribed)"
            )
        })
    }

    /// Feet of one body, on which nothing hangs.
    fn one_piece(&self) -> Option<Phrase> {
        let single = self.soles.iter().filter_map(|sole| match sole.bodies.as_slice() {
            [only] => Some(only.as_str()),
            _ => None,
        });
        let single: Vec<&str> =
            single.filter(|body| !self.joints_below().any(|(parent, _)| parent == *body)).collect();
        said(&single, |bodies| format!("feet of one rigid piece: {bodies}"))
    }
}

fn said(bodies: &[&str], text: impl FnOnce(String) -> String) -> Option<Phrase> {
    let listed: Vec<String> = bodies.iter().map(|body| shown(body).to_string()).collect();
    (!listed.is_empty()).then(|| text(listed.join(", ")).into())
}
