//! Long names.

use osim_model::messages::shown;

/// A name in at most `width` columns: its middle is left out, since names differ at their ends; what cannot be seen in it is
/// escaped.
#[must_use]
pub fn clipped(name: &str, width: usize) -> String {
    let name = shown(name).to_string();
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= width || width < 3 {
        return name;
    }
    let end = width / 2;
    let start = width - end - 1;
    let (first, last) = (letters.iter().take(start), letters.iter().skip(letters.len() - end));
    first.chain(&['~']).chain(last).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_both_ends() {
        assert_eq!(clipped("heel_r", 10), "heel_r");
        assert_eq!(clipped("SmoothSphere_forefoot_med_r", 11), "Smoot~med_r");
        assert_eq!(clipped("SmoothSphere_forefoot_med_r", 11).chars().count(), 11);
    }
}
