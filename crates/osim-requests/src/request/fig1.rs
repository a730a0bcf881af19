//! Fig. 1 of the paper, which no equation gives: what it shows and what it needs.

use osim_model::messages::Phrase;

/// Why Fig. 1 is not drawn, what it needs, and how its models are made: a paragraph each.
#[must_use]
pub fn fig1() -> [Phrase; 3] {
    [WHY, NEEDS, MODELS].map(Phrase::template)
}

/// The same as the answer to somebody who wants it drawn.
#[must_use]
pub fn no_fig1() -> Phrase {
    Phrase::joined([WHY, MODELS].map(Phrase::template), " ").unwrap_or_default()
}

const WHY: &str =
    "Fig. 1 is not drawn: its points are simulated gaits of a bird with muscles, and no equation gives them.";

const NEEDS: &str = "It shows the cost of transport and the computing time over the stiffness E1* and the dissipation. To make it, you need \
                     OpenSim Moco 4.5, and the bird model with its code: doi:10.5281/zenodo.20730121.";

const MODELS: &str =
    "This program makes the models for it: `sweep MODEL grid=stiffness=x0.1..x10/9` (docs/sweep.md).";
