//! Requests for knowledge without a model: presets, equations, codes, and the tables and figures of the paper.

use std::path::PathBuf;

use osim_model::messages::Phrase;

use crate::options::Format;
use crate::values::path;
use crate::values::serial::{self, fields};

fields! {
    /// Lists presets, or shows one.
    struct PresetsRequest {
        name: Option<String>,
        presets: Option<PathBuf> as "path::Optional",
        format: Format,
    }

    /// Explains equations, quantities, and the codes of findings and errors.
    struct ExplainRequest {
        topics: Vec<String> as "serial::Texts",
        format: Format,
        ascii: bool,
    }

    /// Compares Table 1 of the paper with what its equations give, and draws its figures 4 and C.5.
    struct ReproduceRequest {
        output_dir: Option<PathBuf> as "path::Optional",
        force: bool,
        format: Format,
    } where Needs("force", "output_dir");
}

// Fig. 1 of the paper, which no equation gives: what it shows and what it needs.

/// Three paragraphs about Fig. 1: the reason why it is not drawn, the data needed to draw it, and the way to make its models.
pub fn fig1() -> [Phrase; 3] {
    [WHY_FIG_1_IS_NOT_DRAWN, NEEDS_OF_FIG_1, MODELS_OF_FIG_1].map(Phrase::template)
}

/// The refusal to draw Fig. 1, with the reason.
pub fn no_fig1() -> Phrase {
    Phrase::joined([WHY_FIG_1_IS_NOT_DRAWN, MODELS_OF_FIG_1].map(Phrase::template), " ").unwrap_or_default()
}

/// Why the program does not draw Fig. 1 of the paper.
const WHY_FIG_1_IS_NOT_DRAWN: &str =
    "Fig. 1 is not drawn: its points are simulated gaits of a bird with muscles, and no equation gives them.";

/// What Fig. 1 of the paper shows, and which programs and models it needs.
const NEEDS_OF_FIG_1: &str = "It shows the cost of transport and the computing time over the stiffness E1* and the dissipation. To make it, you need \
                     OpenSim Moco 4.5, and the bird model with its code: doi:10.5281/zenodo.20730121.";

/// How to make the models for Fig. 1 of the paper.
const MODELS_OF_FIG_1: &str =
    "This program makes the models for it: `sweep MODEL grid=stiffness=x0.1..x10/9` (docs/sweep.md).";
