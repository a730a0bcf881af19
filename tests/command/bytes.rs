//! Tests which bytes of a model change, and their new values. Expected numbers come from the paper's formulas, computed outside this
//! project.

use similar::{ChangeTag, TextDiff};

use crate::support::{TestDir, fixture};

/// Changed and inserted lines between two files: `(removed, added)`, trimmed.
pub(crate) fn line_changes(old: &[u8], new: &[u8]) -> (Vec<String>, Vec<String>) {
    let (old, new) = (String::from_utf8_lossy(old), String::from_utf8_lossy(new));
    let diff = TextDiff::from_lines(old.as_ref(), new.as_ref());
    let lines_with = |tag: ChangeTag| -> Vec<String> {
        let changes = diff.iter_all_changes().filter(|change| change.tag() == tag);
        changes.map(|change| change.value().trim().to_owned()).collect()
    };
    let (mut removed, mut added) = (lines_with(ChangeTag::Delete), lines_with(ChangeTag::Insert));
    // The note is at the end of the credits, which otherwise stay; without credits the note adds them.
    let credits = |lines: &mut Vec<String>| {
        lines.iter().position(|line| line.starts_with("<credits>")).map(|at| lines.remove(at))
    };
    if let Some(with_note) = credits(&mut added) {
        let without = line_without_note(&with_note);
        let before = credits(&mut removed).map(|before| line_without_note(&before));
        assert_eq!(before.unwrap_or_else(|| "<credits></credits>".to_owned()), without);
    }
    (removed, added)
}

/// The line without the note that this program writes into a model.
fn line_without_note(line: &str) -> String {
    let Some((before, rest)) = line.split_once("[contacts made for ") else { return line.to_owned() };
    let (_, after) = rest.split_once(")]").unwrap();
    format!("{}{after}", before.strip_suffix("; ").unwrap_or(before))
}

/// The number between the tags of a line.
pub(crate) fn number_between_tags(line: &str) -> f64 {
    let (_, rest) = line.split_once('>').unwrap();
    let text = rest.split('<').next().unwrap().trim();
    text.parse().unwrap_or_else(|_| panic!("no number in {line}"))
}

/// The lines that begin with the XML element `tag`.
pub(crate) fn lines_of_element<'l>(lines: &'l [String], tag: &str) -> Vec<&'l str> {
    let open = format!("<{tag}>");
    lines.iter().map(String::as_str).filter(|line| line.starts_with(&open)).collect()
}

/// Largest relative difference from a number that was computed with 60 digits and rounded once.
pub(crate) const LAST_BITS: f64 = 1e-15 * 4.0;

#[track_caller]
pub(crate) fn assert_close(value: f64, expected: f64, within: f64, what: &str) {
    assert!((value - expected).abs() <= within * expected.abs(), "{what}: {value:?}, expected {expected:?}");
}

#[test]
fn a_human_scaled_to_1190_kg_gets_the_numbers_of_the_equations() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190").succeeded().wrote(&["human.scaled.osim"]);
    let (removed, added) =
        line_changes(&fixture("table1/human_62kg_smooth_sphere.osim"), &dir.read("human.scaled.osim"));
    // 12 spheres and 12 forces: radius, stiffness and dissipation change, the three smoothing parameters are inserted.
    assert_eq!((removed.len(), added.len()), (36, 36 + 36));
    // Python 3, decimal, 60 digits: μ = 1190/62, ρ = μ^(1/3); E₁* × μ/ρ², α × ρ^(-1/2), cf × ρ², bd / ρ, bv × ρ^(-1/2).
    for (tag, expected) in [
        ("radius", 0.085_677_818_930_297_31),
        ("stiffness", 2_677_431.841_571_791),
        ("dissipation", 1.222_280_219_983_237_4),
        ("constant_contact_force", 7.168_641_266_262_512e-5),
        ("hertz_smoothing", 112.047_670_212_170_36),
        ("hunt_crossley_smoothing", 30.557_005_499_580_94),
    ] {
        let lines = lines_of_element(&added, tag);
        assert_eq!(lines.len(), 12, "{tag}");
        for line in lines {
            assert_close(number_between_tags(line), expected, LAST_BITS, tag);
        }
    }
    assert_eq!(dir.text("human.scaled.osim").matches("[contacts made for 1190 kg at ").count(), 1);
}

#[test]
fn mouse_contacts_scale_to_giraffe_contacts() {
    // Mouse → giraffe: the forces' numbers follow from the formulas alone, ρ = (1190/0.0209)^(1/3) = 38.46965...
    let dir = TestDir::with(&[("table1/mouse_hunt_crossley.osim", "mouse.osim")]);
    dir.run("mouse.osim --target-mass 1190 --no-note --yes implausible-radius").succeeded();
    let (removed, added) =
        line_changes(&fixture("table1/mouse_hunt_crossley.osim"), &dir.read("mouse.scaled.osim"));
    let ratio: f64 = 1190.0 / 0.0209;
    for (tag, exponent) in [("radius", 1.0 / 3.0), ("stiffness", 1.0 / 3.0), ("dissipation", -1.0 / 6.0)] {
        let (before, after) = (lines_of_element(&removed, tag), lines_of_element(&added, tag));
        assert_eq!((before.len(), after.len()), (4, 4), "{tag}");
        for (before, after) in before.iter().zip(&after) {
            assert_close(
                number_between_tags(after) / number_between_tags(before),
                ratio.powf(exponent),
                1e-14,
                tag,
            );
        }
    }
    assert_eq!(added.len(), 12, "without the note nothing else changes");
}

#[test]
fn scaling_there_and_back_restores_the_numbers() {
    let dir = TestDir::with(&[("table1/giraffe_smooth_sphere.osim", "giraffe.osim")]);
    dir.run("giraffe.osim --target-mass 0.0209 -o small.osim").succeeded();
    dir.run("small.osim --target-mass 1190 -o back.osim").succeeded();
    let (removed, added) = line_changes(&dir.read("giraffe.osim"), &dir.read("back.osim"));
    let added: Vec<_> = added.iter().filter(|line| !line.starts_with("<!--")).collect();
    assert_eq!(removed.len(), added.len());
    for (before, after) in removed.iter().zip(added) {
        assert_close(number_between_tags(after), number_between_tags(before), 1e-14, before);
    }
}

#[test]
fn two_rescalings_in_turn_equal_one() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 3.7 -o a.osim").succeeded();
    dir.run("a.osim --target-mass 1190 -o two.osim").succeeded();
    dir.run("human.osim --target-mass 1190 -o one.osim").succeeded();
    let (one, two) = line_changes(&dir.read("one.osim"), &dir.read("two.osim"));
    assert_eq!(one.len(), two.len());
    for (one, two) in one.iter().zip(&two) {
        assert_close(number_between_tags(two), number_between_tags(one), 1e-14, one);
    }
}

#[test]
fn line_ends_and_byte_order_mark_are_preserved() {
    for (name, mark, crlf) in
        [("bytes_crlf", false, true), ("bytes_bom", true, false), ("bytes_mixed_ends", false, true)]
    {
        let dir = TestDir::with(&[(&format!("format/{name}.osim"), "model.osim")]);
        dir.run("model.osim --target-mass 492").succeeded();
        let (before, after) = (dir.read("model.osim"), dir.read("model.scaled.osim"));
        assert_eq!(after.starts_with(b"\xEF\xBB\xBF"), mark, "{name}");
        let bare_count =
            |bytes: &[u8]| bytes.windows(2).filter(|two| two[1] == b'\n' && two[0] != b'\r').count();
        let crlf_count = |bytes: &[u8]| bytes.windows(2).filter(|two| two == b"\r\n").count();
        assert_eq!(crlf_count(&before) > 0, crlf, "{name}");
        if name == "bytes_crlf" {
            // One note and one hertz_smoothing were inserted, with the file's own line ends.
            assert_eq!((bare_count(&after), crlf_count(&after)), (0, crlf_count(&before) + 2));
        }
    }
}

#[test]
fn bytes_that_are_not_text_are_preserved() {
    for (name, byte) in [("bytes_stray_0x96", 0x96), ("bytes_stray_in_name", 0xF6)] {
        let dir = TestDir::with(&[(&format!("format/{name}.osim"), "model.osim")]);
        dir.run("model.osim --target-mass 492 --no-note").succeeded();
        let after = dir.read("model.scaled.osim");
        assert_eq!(after.iter().filter(|&&value| value == byte).count(), 1, "{name}");
        let (removed, added) = line_changes(&dir.read("model.osim"), &after);
        assert_eq!((removed.len(), added.len()), (6, 6), "{name}: {added:?}");
    }
}

#[test]
fn inserted_elements_are_indented_like_their_siblings() {
    let dir = TestDir::with(&[("format/left_out_smoothing.osim", "model.osim")]);
    dir.run("model.osim --target-mass 492").succeeded();
    let text = dir.text("model.scaled.osim");
    // ρ = 2 exactly: cf 1e-5 × 4, bd 300 / 2, bv 50/√2.
    let (before, rest) = text
        .split_once(
            "\t\t\t\t\t<transition_velocity>0.17</transition_velocity>\n\
             \t\t\t\t\t<constant_contact_force>0.00004</constant_contact_force>\n\
             \t\t\t\t\t<hertz_smoothing>150</hertz_smoothing>\n\
             \t\t\t\t\t<hunt_crossley_smoothing>",
        )
        .unwrap_or_else(|| panic!("{text}"));
    assert!(
        !before.contains("_smoothing>")
            && rest.contains("</hunt_crossley_smoothing>\n\t\t\t\t</SmoothSphere"),
        "{text}"
    );
    assert_close(number_between_tags(&format!(">{rest}")), 35.355_339_059_327_38, LAST_BITS, "bv");
    assert!(text.contains("</gravity>\n\t\t<credits>[contacts made for 492 kg at "), "{text}");
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 -o a.osim").succeeded();
    dir.run("human.osim --target-mass 1190 -o b.osim").succeeded();
    assert_eq!(dir.read("a.osim"), dir.read("b.osim"));
    // No path, no time and no `--` in the note.
    let text = dir.text("a.osim");
    let note = text.lines().find(|line| line.contains("osim-contact-scale")).unwrap().trim();
    let inside = note.trim_start_matches("<!--").trim_end_matches("-->");
    assert!(!inside.contains("--") && !inside.contains("a.osim"), "{note}");
}
