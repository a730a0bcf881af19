//! Explanations for people, in letters that the reader's terminal can show.

use contact_scaling::Equation;
use contact_scaling::equations::reference;
use osim_model::Rule;
use osim_model::messages::{Dialect, Phrase};

use crate::report::explain::equations::sentence_of_use;
use crate::report::explain::errors::ErrorCode;
use crate::report::explain::topic::{QuantityTopic, Topic};
use crate::report::layout::{table, wrap_options};

/// The whole explanation of one topic as text, in lines of at most `width` columns.
pub fn text(topic: Topic, dialect: &dyn Dialect, letters: Alphabet, width: usize) -> String {
    match topic {
        Topic::Equation(equation) => equation_text(equation, dialect, letters, width),
        Topic::Quantity(quantity) => quantity_text(quantity, dialect, letters, width),
        Topic::Finding(rule) => finding_text(rule, dialect, width),
        Topic::Error(error) => error_text(error, dialect, width),
    }
}

fn equation_text(equation: &Equation, dialect: &dyn Dialect, letters: Alphabet, width: usize) -> String {
    let spelled = |template: &'static str| letters.convert(&Phrase::template(template).spelled(dialect));
    let mut text = format!("{}  {}\n\n", reference(equation.label), equation.title);
    for form in equation.forms {
        let variant = if form.variant.is_empty() { String::new() } else { format!("    ({})", form.variant) };
        text.push_str(&letters.convert(&format!("    {}{variant}\n", form.formula)));
    }
    let mut symbols = table(&["symbol", "meaning", "unit"]);
    for symbol in equation.symbols {
        symbols.add_row([symbol.symbol, symbol.meaning, symbol.unit].map(spelled).to_vec());
    }
    if !equation.symbols.is_empty() {
        text.push_str(&format!("\n{}\n", symbols.fitted(width)));
    }
    text.push('\n');
    text.push_str(&paragraph("Source: ", &spelled(equation.source), width));
    text.push_str(&paragraph("Used:   ", &sentence_of_use(equation.label).spelled(dialect), width));
    text.push_str(&book_line("Book:   ", "equations"));
    text
}

fn quantity_text(quantity: &QuantityTopic, dialect: &dyn Dialect, letters: Alphabet, width: usize) -> String {
    let mut parts =
        vec![("What:  ", quantity.what().spelled(dialect)), ("Unit:  ", quantity.unit_in_words().to_owned())];
    if !quantity.symbols.is_empty() {
        parts.push(("Also:  ", quantity.symbols.join(", ")));
    }
    if !quantity.equation.is_empty() {
        parts.push(("By:    ", reference(quantity.equation)));
    }
    parts.extend(quantity.limit.clone().map(|limit| ("Limit: ", limit)));
    parts.push(("Trap:  ", quantity.trap().spelled(dialect)));
    let body: String =
        parts.into_iter().map(|(label, body)| paragraph(label, &letters.convert(&body), width)).collect();
    format!("{} (quantity)\n\n{body}", quantity.name)
}

fn finding_text(rule: &Rule, dialect: &dyn Dialect, width: usize) -> String {
    let repair = rule.repair.sentence().into();
    let parts =
        [("What: ", rule.what()), ("Why:  ", rule.why()), ("Do:   ", rule.advice()), ("Fix:  ", repair)];
    let body: String =
        parts.into_iter().map(|(label, body)| paragraph(label, &body.spelled(dialect), width)).collect();
    format!("{}\n\n{body}{}", rule.code, book_line("Book: ", "findings"))
}

fn error_text(error: &ErrorCode, dialect: &dyn Dialect, width: usize) -> String {
    let parts = [("Means: ", error.means()), ("Do:    ", error.way_out())];
    let body: String =
        parts.into_iter().map(|(label, body)| paragraph(label, &body.spelled(dialect), width)).collect();
    format!("{} (error)\n\n{body}{}", error.code, book_line("Book:  ", "errors"))
}

/// A list of topics by kind, in lines of at most `width` columns.
pub fn list(topics: &[Topic], dialect: &dyn Dialect, letters: Alphabet, width: usize) -> String {
    let (mut equations, mut quantities, mut findings, mut errors) = (
        table(&["equation", "what it says"]),
        table(&["quantity", "what it is"]),
        table(&["finding", "what it is"]),
        table(&["error", "what it means"]),
    );
    for topic in topics {
        let (table, name, what) = match topic {
            Topic::Equation(equation) => {
                (&mut equations, reference(equation.label), letters.convert(equation.title))
            }
            Topic::Quantity(quantity) => {
                let what = letters.convert(&quantity.what().spelled(dialect));
                (&mut quantities, quantity.name.to_owned(), what)
            }
            Topic::Finding(rule) => {
                (&mut findings, rule.code.as_str().to_owned(), rule.what().spelled(dialect))
            }
            Topic::Error(error) => {
                let means = letters.convert(&error.means().spelled(dialect));
                (&mut errors, error.code.to_owned(), means)
            }
        };
        table.add_row([name, what]);
    }
    quantities.unbroken(0);
    [equations, quantities, findings, errors].map(|table| format!("{}\n", table.fitted(width))).join("\n")
}

/// The line with the page of the documentation that has all topics of one kind.
fn book_line(label: &str, page: &str) -> String {
    format!("{label}docs/reference/{page}.md\n")
}

fn paragraph(label: &str, body: &str, width: usize) -> String {
    let body = format!("{}.", body.trim_ascii().trim_end_matches('.'));
    let indent = " ".repeat(label.len());
    let options = wrap_options(width).initial_indent(label).subsequent_indent(&indent);
    format!("{}\n", textwrap::fill(&body, options))
}

/// Whether a text may have letters outside ASCII.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Alphabet {
    #[default]
    Unicode,
    /// Only ASCII, for old consoles: `alpha`, `sqrt(R)`.
    Ascii,
}

impl Alphabet {
    /// The `text` in these letters. This has to be done before lines are broken, because the spellings differ in length.
    pub(super) fn convert(self, text: &str) -> String {
        match self {
            Self::Unicode => text.to_owned(),
            Self::Ascii => ascii(text),
        }
    }
}

// Formulas for consoles that can only show ASCII.

/// Symbols and their ASCII spelling. If one symbol begins with another, the longer symbol comes first.
const SPELLINGS_OF_SYMBOLS: &str = "x̂:xhat k̂:khat ẋ⁻:xdot_before ẋ:xdot s/√m:s/m^0.5 √m/s:m^0.5/s Δ:Delta_ \
     α:alpha γ:gamma η:eta μ:mu ν:nu π:pi ρ:rho σ:sigma Σ:sum ∂:d ∝:~ ∞:infinity →:-> ½:1/2 ₁:1 ₂:2 ²:^2 ³:^3 \
     ·:* ×:x −:- –:- …:... ≤:<= ≥:>=";

/// `text` in ASCII: roots become `sqrt(…)`.
pub(super) fn ascii(text: &str) -> String {
    let mut out = text.to_owned();
    for (symbol, spelling) in SPELLINGS_OF_SYMBOLS.split(' ').filter_map(|pair| pair.split_once(':')) {
        out = out.replace(symbol, spelling);
    }
    roots_with_brackets(&out)
}

/// Writes a root with brackets around its symbol, because in ASCII the reader could not see how far the root extends.
fn roots_with_brackets(text: &str) -> String {
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
    fn formulas_keep_their_meaning_in_ascii() {
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
            let formulas = equation.forms.iter().flat_map(|form| [form.variant, form.formula, form.unit]);
            for text in symbols.chain(formulas).chain([equation.label, equation.title, equation.source]) {
                assert!(ascii(text).is_ascii(), "{}", ascii(text));
            }
        }
    }
}
