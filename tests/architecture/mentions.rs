//! Names in a module's items: its `use` lines, its children, and every path in its code.

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{Attribute, Item, UseTree, Visibility};

/// The segments of a path in code.
pub(crate) type Mention = Vec<String>;

/// One name of a `use` line.
pub(crate) struct UseLine {
    /// The name that it binds; `_` and `*` bind none.
    pub(crate) name: String,
    /// The path as it is written, without `*`.
    pub(crate) path: Vec<String>,
    /// Passed on to other modules.
    pub(crate) public: bool,
}

/// The names of one module, without those of its children and its tests.
#[derive(Default)]
pub(crate) struct Names {
    /// Children with a file of their own.
    pub(crate) declared: Vec<String>,
    /// Children written in the same file.
    pub(crate) inline: Vec<(String, Vec<Item>)>,
    pub(crate) uses: Vec<UseLine>,
    pub(crate) mentions: Vec<Mention>,
}

pub(crate) fn mentions(items: &[Item]) -> Names {
    let mut names = Names::default();
    items.iter().for_each(|item| names.visit_item(item));
    names
}

impl<'a> Visit<'a> for Names {
    fn visit_item(&mut self, item: &'a Item) {
        if !attributes(item).iter().any(is_of_tests) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_mod(&mut self, module: &'a syn::ItemMod) {
        let name = module.ident.to_string();
        match &module.content {
            None => self.declared.push(name),
            Some((_, items)) => self.inline.push((name, items.clone())),
        }
    }

    fn visit_item_use(&mut self, line: &'a syn::ItemUse) {
        let public = !matches!(line.vis, Visibility::Inherited);
        flatten(&line.tree, &mut Vec::new(), public, &mut self.uses);
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        self.mentions.push(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'a syn::Macro) {
        self.visit_path(&call.path);
        self.take_tokens(call.tokens.clone());
    }

    fn visit_attribute(&mut self, attribute: &'a Attribute) {
        if let syn::Meta::List(list) = &attribute.meta {
            self.take_tokens(list.tokens.clone());
        }
    }
}

impl Names {
    /// The paths among the tokens of a macro: names joined by `::`. A name after a dot is a field's or a method's.
    fn take_tokens(&mut self, tokens: TokenStream) {
        let (mut path, mut colons, mut dotted) = (Vec::new(), 0, false);
        for token in tokens {
            match token {
                TokenTree::Ident(name) => {
                    if colons != 2 {
                        self.end(&mut path);
                    }
                    if !(dotted && path.is_empty()) {
                        path.push(name.to_string());
                    }
                    (colons, dotted) = (0, false);
                }
                TokenTree::Punct(punct) if punct.as_char() == ':' => colons += 1,
                other => {
                    self.end(&mut path);
                    (colons, dotted) = (0, matches!(&other, TokenTree::Punct(punct) if punct.as_char() == '.'));
                    if let TokenTree::Group(group) = other {
                        self.take_tokens(group.stream());
                    }
                }
            }
        }
        self.end(&mut path);
    }

    fn end(&mut self, path: &mut Vec<String>) {
        if !path.is_empty() {
            self.mentions.push(std::mem::take(path));
        }
    }
}

/// The names that a tree of a `use` line binds.
fn flatten(tree: &UseTree, before: &mut Vec<String>, public: bool, into: &mut Vec<UseLine>) {
    let mut bind = |name: String, last: &str| {
        // `use a::b::{self}` binds `b`.
        let path: Vec<String> = before.iter().map(String::as_str).chain([last]).map(str::to_owned).collect();
        let is_self = last == "self" && path.len() > 1;
        let path = if is_self { before.clone() } else { path };
        let name = if is_self && name == "self" { path.last().cloned().unwrap_or_default() } else { name };
        into.push(UseLine { name, path, public });
    };
    match tree {
        UseTree::Name(name) => bind(name.ident.to_string(), &name.ident.to_string()),
        UseTree::Rename(rename) => bind(rename.rename.to_string(), &rename.ident.to_string()),
        UseTree::Glob(_) => into.push(UseLine { name: "*".to_owned(), path: before.clone(), public }),
        UseTree::Path(path) => {
            before.push(path.ident.to_string());
            flatten(&path.tree, before, public, into);
            before.pop();
        }
        UseTree::Group(group) => group.items.iter().for_each(|tree| flatten(tree, before, public, into)),
    }
}

fn is_of_tests(attribute: &Attribute) -> bool {
    attribute.path().is_ident("cfg")
        && matches!(&attribute.meta, syn::Meta::List(list) if list.tokens.to_string() == "test")
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}
