//! Items that a macro makes: their names, as far as they stand in the source.
//!
//! Nothing is expanded. `enum Kind` in the tokens of a call, or in the body of the `macro_rules!` that is called, is
//! taken for an item of the module in which the call stands.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::facts::{Item, Sight, Spaces};

/// The items whose names stand in the tokens of a call.
pub(crate) fn items_in_call(tokens: TokenStream) -> Vec<Item> {
    let mut items = Vec::new();
    collect(&tokens.into_iter().collect::<Vec<_>>(), &mut items);
    items
}

/// The items whose names stand in the bodies of a `macro_rules!`, the groups behind `=>`.
pub(crate) fn items_in_rules(tokens: TokenStream) -> Vec<Item> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut items = Vec::new();
    for three in tokens.windows(3) {
        if let [TokenTree::Punct(a), TokenTree::Punct(b), TokenTree::Group(body)] = three
            && a.as_char() == '='
            && b.as_char() == '>'
        {
            items.extend(items_in_call(body.stream()));
        }
    }
    items
}

/// Looks at one level of groups: what stands deeper is inside of an item, and no item of the module.
fn collect(tokens: &[TokenTree], items: &mut Vec<Item>) {
    for (at, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Ident(keyword) => {
                let name = tokens[at + 1..].iter().find_map(name_behind_keyword);
                if let (Some((spaces, is_trait)), Some(Some(name))) = (keyword_of(&keyword.to_string()), name)
                {
                    items.push(item(name, spaces, is_trait));
                }
            }
            TokenTree::Group(group) if is_repetition(tokens, at, group) => {
                collect(&group.stream().into_iter().collect::<Vec<_>>(), items);
            }
            _ => {}
        }
    }
}

/// The first name, past `mut` and `ref`; `Some(None)` where no name stands, as in `fn $name`.
fn name_behind_keyword(token: &TokenTree) -> Option<Option<String>> {
    match token {
        TokenTree::Ident(ident) if ident == "mut" || ident == "ref" => None,
        TokenTree::Ident(ident) if keyword_of(&ident.to_string()).is_some() || ident == "_" => Some(None),
        TokenTree::Ident(ident) => Some(Some(ident.to_string())),
        _ => Some(None),
    }
}

/// Which names a keyword makes, and whether it is `trait`.
fn keyword_of(keyword: &str) -> Option<(Spaces, bool)> {
    match keyword {
        "struct" => Some((Spaces::ITEMS, false)),
        "enum" | "type" | "union" => Some((Spaces::TYPES, false)),
        "trait" => Some((Spaces::TYPES, true)),
        "fn" | "const" | "static" => Some((Spaces::VALUES, false)),
        _ => None,
    }
}

/// `$( … )*`: what is repeated stands at the same level.
fn is_repetition(tokens: &[TokenTree], at: usize, group: &Group) -> bool {
    let before = at.checked_sub(1).and_then(|before| tokens.get(before));
    group.delimiter() == Delimiter::Parenthesis
        && matches!(before, Some(TokenTree::Punct(dollar)) if dollar.as_char() == '$')
}

/// How visible it is cannot be told in general: it is taken to be so in the whole crate.
fn item(name: String, spaces: Spaces, is_trait: bool) -> Item {
    Item { name, spaces, is_trait, variants: Vec::new(), sight: Sight::Depth(0), local: false }
}
