//! How Hertz / Hunt–Crossley contact parameters scale with body size (Van Bijlert 2026).
