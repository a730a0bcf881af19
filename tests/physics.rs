//! The verbs that work with the paper's equations, from outside.
