//! Lengths in as many decimals as a model needs.

use osim_inspect::InspectedSphere;

/// Decimals that show a hundredth of the smallest radius.
pub fn decimals(spheres: &[InspectedSphere]) -> usize {
    let radii =
        spheres.iter().map(|sphere| sphere.radius_m).filter(|radius| *radius > 0.0 && radius.is_finite());
    let smallest = radii.fold(1.0, f64::min);
    let mut decimals = 2;
    let mut unit = smallest;
    while unit < 1.0 && decimals < 12 {
        unit *= 10.0;
        decimals += 1;
    }
    decimals
}

/// A length or coordinate, in m.
pub fn metres(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    // Nobody's coordinate is -0.0000.
    if text.chars().all(|letter| matches!(letter, '-' | '0' | '.')) { "0".to_owned() } else { text }
}
