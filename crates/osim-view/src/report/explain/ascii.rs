//! Formulas for consoles that can only show ASCII.

/// Symbols and their spelling; longer ones first where one begins with another.
const SPELLING: &[(&str, &str)] = &[
    ("x̂", "xhat"),
    ("k̂", "khat"),
    ("ẋ⁻", "xdot_before"),
    ("ẋ", "xdot"),
    ("s/√m", "s/m^0.5"),
    ("√m/s", "m^0.5/s"),
    ("Δ", "Delta_"),
    ("α", "alpha"),
    ("γ", "gamma"),
    ("η", "eta"),
    ("μ", "mu"),
    ("ν", "nu"),
    ("π", "pi"),
    ("ρ", "rho"),
    ("σ", "sigma"),
    ("Σ", "sum"),
    ("∂", "d"),
    ("∝", "~"),
    ("∞", "infinity"),
    ("→", "->"),
    ("½", "1/2"),
    ("₁", "1"),
    ("₂", "2"),
    ("²", "^2"),
    ("³", "^3"),
    ("·", "*"),
    ("×", "x"),
    ("−", "-"),
    ("–", "-"),
    ("…", "..."),
    ("≤", "<="),
    ("≥", ">="),
];

/// `text` in ASCII; roots become `sqrt(…)`.
pub(super) fn ascii(text: &str) -> String {
    let mut out = text.to_owned();
    for (symbol, spelling) in SPELLING {
        out = out.replace(symbol, spelling);
    }
    roots(&out)
}

/// A root of one symbol gets brackets: nobody could see how far it reaches.
fn roots(text: &str) -> String {
    let mut parts = text.split('√');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        if part.starts_with('(') {
            out.push_str("sqrt");
            out.push_str(part);
            continue;
        }
        let end = part.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(part.len());
        let (symbol, rest) = part.split_at(end);
        out.push_str(&format!("sqrt({symbol}){rest}"));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::ascii;
    use crate::report::explain::equations::equations;

    #[test]
    fn formulas_keep_their_meaning() {
        assert_eq!(ascii("F_e = 4/3 η √R E* x^(3/2)"), "F_e = 4/3 eta sqrt(R) E* x^(3/2)");
        assert_eq!(ascii("f_n = √(k / M) / (2π)"), "f_n = sqrt(k / M) / (2pi)");
        assert_eq!(ascii("Δx̂ = 2 atanh(1 − 2 t) / (bd R)"), "Delta_xhat = 2 atanh(1 - 2 t) / (bd R)");
        assert_eq!(ascii("Σ 4/3 E*_i √R_i x^(3/2) = F"), "sum 4/3 E*_i sqrt(R_i) x^(3/2) = F");
        assert_eq!(ascii("x̂_c = √cf / R"), "xhat_c = sqrt(cf) / R");
    }

    #[test]
    fn every_equation_can_be_spelled() {
        for equation in equations() {
            let symbols = equation.symbols.iter().flat_map(|s| [s.symbol, s.meaning, s.unit]);
            let formulas = equation.forms.iter().flat_map(|form| [form.note, form.formula, form.unit]);
            for text in symbols.chain(formulas).chain([equation.label, equation.title, equation.source]) {
                assert!(ascii(text).is_ascii(), "{}", ascii(text));
            }
        }
    }
}
