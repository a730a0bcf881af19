//! What spheres that are drawn as one curve are called.

/// Of more names than this, the first and the last are given.
const LISTED: usize = 4;
/// Endings by which models part the sides, and what they mean.
const SIDES: [(&str, &str); 4] = [("_r", "_l"), ("_R", "_L"), ("R", "L"), ("r", "l")];

/// Spheres by their names: all of them where they are few, those of both sides together; else how many they are, with the first
/// and the last.
pub(super) fn spheres(names: &[String]) -> String {
    if let Some(of_both) = of_both_sides(names) {
        return format!("{}, both sides", listed(&of_both));
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    listed(&names)
}

fn listed(names: &[&str]) -> String {
    match names {
        [first, .., last] if names.len() > LISTED => format!("{first} to {last} ({} spheres)", names.len()),
        few => few.join(", "),
    }
}

/// Names without their sides, where each stands there for the right and for the left.
fn of_both_sides(names: &[String]) -> Option<Vec<&str>> {
    SIDES.iter().find_map(|&(right, left)| {
        let of = |side: &str| -> Vec<&str> {
            names.iter().filter_map(|name| name.strip_suffix(side)).filter(|name| !name.is_empty()).collect()
        };
        let (of_right, of_left) = (of(right), of(left));
        let all = of_right.len() + of_left.len() == names.len() && !of_right.is_empty();
        (all && of_right.len() == of_left.len() && of_right.iter().all(|name| of_left.contains(name)))
            .then_some(of_right)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn called(names: &[&str], expected: &str) {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        assert_eq!(spheres(&names), expected);
    }

    #[test]
    fn few_spheres_are_named() {
        called(&["heel"], "heel");
        called(&["heel", "toe"], "heel, toe");
        called(&[], "");
    }

    #[test]
    fn spheres_of_both_sides_are_named_once() {
        called(&["heel_r", "toe_r", "heel_l", "toe_l"], "heel, toe, both sides");
        called(&["heel_r", "heel_l", "toe_r"], "heel_r, heel_l, toe_r");
        called(&["SmoothSphereHeelR", "SmoothSphereHeelL"], "SmoothSphereHeel, both sides");
        called(&["r", "l"], "r, l");
    }

    #[test]
    fn many_spheres_are_counted() {
        let names: Vec<String> =
            ["r", "l"].iter().flat_map(|side| (1..=5).map(move |i| format!("s{i}_{side}"))).collect();
        assert_eq!(spheres(&names), "s1 to s5 (5 spheres), both sides");
        called(&["a", "b", "c", "d", "e"], "a to e (5 spheres)");
    }
}
