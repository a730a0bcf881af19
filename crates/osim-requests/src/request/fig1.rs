//! Fig. 1 of the paper, which no equation gives: what it shows and what it needs.

use osim_messages::Phrase;

/// What Fig. 1 shows, what it needs, what of that is published, and how its models are made: a paragraph each.
#[must_use]
pub fn fig1() -> [Phrase; 4] {
    [
        "Fig. 1 is not drawn: each of its points is a gait simulation of a model with muscles, which no equation gives.",
        "It shows a sweep of E1* (OpenSim's stiffness) and of the dissipation alpha of the bird of van Bijlert et al. \
         (2024b), walking at 1.25 m/s: (A) the metabolic cost of transport and (B) the time to converge, both from a good \
         initial guess, and (C) which optimisations failed (no convergence within 3000 iterations) from a quasi-random one.",
        "It needs the optimal-control solver OpenSim Moco 4.5 (direct collocation), the bird model with its simulation code, a \
         walking simulation that has converged as the good guess, and computing time. Models and code are published at \
         doi:10.5281/zenodo.20730121; the details are in the supplement of the paper. This program has neither Moco nor that \
         model, nor the values of the sweep: the paper itself prints only that the bottom row of (C) has a dimensionless \
         stiffness of 1.2.",
        "What this program does for it is to make the models: `sweep MODEL grid=stiffness=x0.1..x10/9`, with a second \
         `grid=dissipation=0.5,1,2`. See docs/sweep.md; let Moco run each of them.",
    ]
    .map(Phrase::template)
}
