//! The walk through the items of one module. It stops at modules in it, and steps over test code.

use syn::Attribute;
use syn::ext::IdentExt;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use super::facts::{Facts, Item, MacroRules, Sight, Spaces};
use super::generated::{items_in_call, items_in_rules};
use super::hidden::{is_constant, of_generics, variables};
use super::record::Record;
use super::test_code::{
    attribute_of_tests, of_impl_item, of_item, of_statement, of_trait_item, only_in_tests,
};
use super::tokens::{scan_attribute, scan_macro};

/// What these items of a module say.
pub(crate) fn gather(items: &[syn::Item]) -> Record<'_> {
    let mut walk = Walk { record: Record::default() };
    for item in items {
        walk.visit_item(item);
    }
    walk.record
}

/// Adds the doc comments in these attributes, those of a file or of a module.
pub(crate) fn docs_of(attributes: &[Attribute], facts: &mut Facts) {
    for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("doc")) {
        if let syn::Meta::NameValue(pair) = &attribute.meta
            && let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &pair.value
        {
            facts.doc(&text.value(), text.span().start().line);
        }
    }
}

struct Walk<'ast> {
    record: Record<'ast>,
}

/// Steps over a node that is for tests alone.
macro_rules! unless_in_tests {
    ($($method:ident($node:ty) $walk:path;)+) => {
        $(fn $method(&mut self, node: &'ast $node) {
            if only_in_tests(&node.attrs) {
                self.record.leave_out(node.span());
            } else {
                $walk(self, node);
            }
        })+
    };
}

impl<'ast> Visit<'ast> for Walk<'ast> {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        let for_tests = only_in_tests(of_item(item));
        if let syn::Item::Mod(module) = item {
            self.record.child(module, for_tests);
            if !for_tests {
                docs_of(&module.attrs, &mut self.record.facts);
            }
        }
        if for_tests {
            self.record.leave_out(item.span());
        } else if !matches!(item, syn::Item::Mod(_)) {
            self.record.hidden.push(of_generics(item));
            visit::visit_item(self, item);
            self.record.hidden.pop();
        }
    }

    fn visit_stmt(&mut self, node: &'ast syn::Stmt) {
        if only_in_tests(of_statement(node)) && !matches!(node, syn::Stmt::Item(_)) {
            self.record.leave_out(node.span());
        } else {
            visit::visit_stmt(self, node);
        }
    }

    fn visit_impl_item(&mut self, node: &'ast syn::ImplItem) {
        if only_in_tests(of_impl_item(node)) {
            self.record.leave_out(node.span());
        } else {
            visit::visit_impl_item(self, node);
        }
    }

    fn visit_trait_item(&mut self, node: &'ast syn::TraitItem) {
        if only_in_tests(of_trait_item(node)) {
            self.record.leave_out(node.span());
        } else {
            visit::visit_trait_item(self, node);
        }
    }

    unless_in_tests! {
        visit_arm(syn::Arm) visit::visit_arm;
        visit_field(syn::Field) visit::visit_field;
        visit_field_value(syn::FieldValue) visit::visit_field_value;
        visit_variant(syn::Variant) visit::visit_variant;
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.record.import(item);
    }

    fn visit_item_extern_crate(&mut self, item: &'ast syn::ItemExternCrate) {
        self.record.import_crate(item);
    }

    fn visit_item_macro(&mut self, item: &'ast syn::ItemMacro) {
        let tokens = &item.mac.tokens;
        if let Some(ident) = &item.ident {
            let name = ident.unraw().to_string();
            let (spaces, sight, local) = (Spaces::MACROS, Sight::Depth(0), self.record.depth > 0);
            let (is_trait, variants) = (false, Vec::new());
            self.record.facts.items.push(Item {
                name: name.clone(),
                spaces,
                is_trait,
                variants,
                sight,
                local,
            });
            self.record.facts.macros.push(MacroRules { name, defines: items_in_rules(tokens.clone()) });
            scan_macro(tokens.clone(), &mut self.record.facts);
            return;
        }
        self.record.facts.items.extend(items_in_call(tokens.clone()));
        let called = item.mac.path.segments.last();
        self.record.facts.called.extend(called.map(|name| name.ident.unraw().to_string()));
        visit::visit_item_macro(self, item);
    }

    fn visit_item_const(&mut self, item: &'ast syn::ItemConst) {
        self.record.define(&item.ident, Spaces::VALUES, &item.vis);
        visit::visit_item_const(self, item);
    }

    fn visit_item_static(&mut self, item: &'ast syn::ItemStatic) {
        self.record.define(&item.ident, Spaces::VALUES, &item.vis);
        visit::visit_item_static(self, item);
    }

    fn visit_item_struct(&mut self, item: &'ast syn::ItemStruct) {
        let spaces = if matches!(item.fields, syn::Fields::Named(_)) { Spaces::TYPES } else { Spaces::ITEMS };
        self.record.define(&item.ident, spaces, &item.vis);
        visit::visit_item_struct(self, item);
    }

    fn visit_item_union(&mut self, item: &'ast syn::ItemUnion) {
        self.record.define(&item.ident, Spaces::TYPES, &item.vis);
        visit::visit_item_union(self, item);
    }

    fn visit_item_enum(&mut self, item: &'ast syn::ItemEnum) {
        let variants = item.variants.iter().map(|variant| variant.ident.unraw().to_string()).collect();
        self.record.define_with(&item.ident, Spaces::TYPES, &item.vis, false, variants);
        visit::visit_item_enum(self, item);
    }

    fn visit_item_trait(&mut self, item: &'ast syn::ItemTrait) {
        self.record.define_with(&item.ident, Spaces::TYPES, &item.vis, true, Vec::new());
        visit::visit_item_trait(self, item);
    }

    fn visit_item_trait_alias(&mut self, item: &'ast syn::ItemTraitAlias) {
        self.record.define_with(&item.ident, Spaces::TYPES, &item.vis, true, Vec::new());
        visit::visit_item_trait_alias(self, item);
    }

    fn visit_item_type(&mut self, item: &'ast syn::ItemType) {
        self.record.define(&item.ident, Spaces::TYPES, &item.vis);
        visit::visit_item_type(self, item);
    }

    fn visit_foreign_item_fn(&mut self, item: &'ast syn::ForeignItemFn) {
        self.record.define(&item.sig.ident, Spaces::VALUES, &item.vis);
        visit::visit_foreign_item_fn(self, item);
    }

    fn visit_foreign_item_static(&mut self, item: &'ast syn::ForeignItemStatic) {
        self.record.define(&item.ident, Spaces::VALUES, &item.vis);
        visit::visit_foreign_item_static(self, item);
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.record.define(&item.sig.ident, Spaces::VALUES, &item.vis);
        self.record.hidden.push(variables(|names| names.visit_item_fn(item)));
        visit::visit_item_fn(self, item);
        self.record.hidden.pop();
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.record.hidden.push(variables(|names| names.visit_impl_item_fn(item)));
        visit::visit_impl_item_fn(self, item);
        self.record.hidden.pop();
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        self.record.hidden.push(variables(|names| names.visit_trait_item_fn(item)));
        visit::visit_trait_item_fn(self, item);
        self.record.hidden.pop();
    }

    fn visit_block(&mut self, block: &'ast syn::Block) {
        self.record.depth += 1;
        visit::visit_block(self, block);
        self.record.depth -= 1;
    }

    /// `pub(in crate::x)` names no item.
    fn visit_visibility(&mut self, _: &'ast syn::Visibility) {}

    fn visit_expr_path(&mut self, path: &'ast syn::ExprPath) {
        self.qualified(path.qself.as_ref(), &path.path, Spaces::VALUES);
    }

    fn visit_type_path(&mut self, path: &'ast syn::TypePath) {
        self.qualified(path.qself.as_ref(), &path.path, Spaces::TYPES);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.record.mention(path, Spaces::ITEMS);
        visit::visit_path(self, path);
    }

    /// A name in a pattern is a variable, or a constant that a glob has brought in.
    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        if is_constant(&pattern.ident) {
            self.record.mention(&pattern.ident.clone().into(), Spaces::VALUES);
        }
        visit::visit_pat_ident(self, pattern);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        self.record.mention(&called.path, Spaces::MACROS);
        scan_macro(called.tokens.clone(), &mut self.record.facts);
    }

    fn visit_attribute(&mut self, attribute: &'ast Attribute) {
        let path = attribute.path();
        docs_of(std::slice::from_ref(attribute), &mut self.record.facts);
        if ["doc", "cfg", "path"].iter().any(|name| path.is_ident(name)) || attribute_of_tests(attribute) {
            return;
        }
        if path.segments.len() > 1 {
            self.record.mention(path, Spaces::ALL);
        }
        match &attribute.meta {
            syn::Meta::Path(_) => {}
            syn::Meta::List(list) => scan_attribute(list.tokens.clone(), &mut self.record.facts),
            syn::Meta::NameValue(pair) => self.visit_expr(&pair.value),
        }
    }

    fn visit_lit(&mut self, literal: &'ast syn::Lit) {
        match literal {
            syn::Lit::Str(text) => self.record.literal(&text.token()),
            syn::Lit::ByteStr(text) => self.record.literal(&text.token()),
            syn::Lit::CStr(text) => self.record.literal(&text.token()),
            _ => {}
        }
    }
}

impl<'ast> Walk<'ast> {
    /// `<Type as Trait>::name`: the type and the trait are named, what comes behind belongs to them.
    fn qualified(&mut self, of: Option<&'ast syn::QSelf>, path: &'ast syn::Path, want: Spaces) {
        match of {
            None => self.record.mention(path, want),
            Some(of) => {
                self.visit_qself(of);
                if of.position > 0 {
                    self.record.mention(path, Spaces::ITEMS);
                }
            }
        }
        visit::visit_path(self, path);
    }
}
