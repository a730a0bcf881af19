//! Writes a model file in other forms that OpenSim reads as the same model. Each byte of a file is one letter here, so that every file can
//! be a text.

/// A function that writes a model in another form; `None` if nothing in the model can be written in this form.
pub type Form = fn(&str) -> Option<String>;

/// Like [`Form`], as a closure that may hold values, such as a text that it inserts.
pub type Written = Box<dyn Fn(&str) -> Option<String>>;

/// All ways to write the text of a model that the tests try, each with a name for messages.
pub fn forms() -> Vec<(String, Written)> {
    let mut all: Vec<(String, Written)> = Vec::new();
    let plain: [(&str, Form); 9] = [
        ("as it is", |text| Some(text.to_owned())),
        ("CR LF", |text| Some(text.replace("\r\n", "\n").replace('\n', "\r\n"))),
        ("CR", |text| Some(text.replace("\r\n", "\n").replace('\n', "\r"))),
        ("one line", one_line),
        ("two blanks", |text| Some(text.replace('\t', "  "))),
        ("no indentation", |text| {
            Some(text.lines().map(|line| line.trim_start_matches(['\t', ' '])).collect::<Vec<_>>().join("\n"))
        }),
        ("blank lines", |text| Some(text.replace(">\n", ">\n\n \t\n"))),
        ("blanks behind", |text| Some(text.replace(">\n", "> \t\n"))),
        ("a form feed", |text| Some(text.replace(">\n", ">\x0c\n"))),
    ];
    for (name, form) in plain {
        all.push((name.to_owned(), Box::new(form)));
    }
    for between in [
        "<!-- a -->",
        "\n<!-- b -->",
        "<!-- c -->\n",
        "stray",
        "stray\n",
        " stray \n\t\t",
        "\nstray",
        "&amp;",
        "&amp;\n",
        "<![CDATA[x]]>",
        "<?own x?>\n",
        "\u{e9}",
    ] {
        for behind in [
            "</BodySet>",
            "</JointSet>",
            "</ForceSet>",
            "</objects>",
            "<objects>",
            "<ForceSet>",
            "</gravity>",
            "</ContactGeometrySet>",
            "</credits>",
        ] {
            let form = move |text: &str| {
                let with = text.replace(behind, &format!("{behind}{between}"));
                (with != text).then_some(with)
            };
            all.push((format!("{between:?} behind {behind}"), Box::new(form)));
        }
    }
    for set in ["ForceSet", "ContactGeometrySet"] {
        for written in SETS {
            let written = written.replace('S', set);
            let name = format!("{set} as {written:?}");
            all.push((name, Box::new(move |text: &str| with_set_written_as(text, set, &written))));
        }
    }
    for credits in CREDITS {
        let form = move |text: &str| with_credits(text, credits);
        all.push((format!("{credits:?}"), Box::new(form)));
    }
    all
}

/// Forms of a set without members; `S` is in the place of the name of the set.
const SETS: [&str; 24] = [
    "",
    "<S/>",
    "<S />",
    "<S  />",
    "<S\t/>",
    "<S name='s'/>",
    "<S name=\"\u{e9}\" />",
    "<S name='s'\n/>",
    "<S></S>",
    "<S> </S>",
    "<S>\n\n\t\t</S>",
    "<S><!--none--></S>",
    "<S>stray</S>",
    "<S><groups/></S>",
    "<S><objects/></S>",
    "<S><objects /></S>",
    "<S>\n\t\t\t<objects  />\n\t\t\t<groups/>\n\t\t</S>",
    "<S>\n\t\t\t<objects></objects>\n\t\t</S>",
    "<S><objects> </objects></S>",
    "<S>\n\t\t\t<objects>\n\t\t\t</objects>\n\t\t</S>",
    "<S><objects><!--none--></objects></S>",
    "<S>\n\t\t\t<objects>\n\t\t\t\t<!--none-->\n\t\t\t</objects>\n\t\t</S>",
    "<S>\n\t\t\t<objects>\n\t\t\t\tstray\n\t\t\t</objects>\n\t\t</S>",
    "stray <S name='s'>stray<objects \u{e9}='1'/>stray</S> stray",
];

/// Credits of models in all forms. The last ones have notes of contacts that were removed.
const CREDITS: [&str; 23] = [
    "",
    "<credits/>",
    "<credits />",
    "<credits  />",
    "<credits\n\t/>",
    "<credits></credits>",
    "<credits> </credits>",
    "<credits\t>A</credits >",
    "<credits by='me'/>",
    "<credits by=\"\u{e9}\" />",
    "<credits by='me'></credits>",
    "<credits by='me'>A</credits>",
    "<credits>A;</credits>",
    "<credits>A; </credits>",
    "<credits>\n\t\t\tA;\n\t\t\t&amp; B\n\t\t</credits>",
    "<credits>A <!-- c --></credits>",
    "<credits><!-- c -->A</credits>",
    "<credits><!-- c --></credits>",
    "<credits><![CDATA[ A & B; ]]></credits>",
    "<credits><![CDATA[]]></credits>",
    "<credits>A [contacts made for fun]</credits>",
    "<credits>\u{e9}; [contacts made for 12 kg at 9.8 m/s2 (osim-contact-scale 0.0.9; all; by add; sizes none; \
     record 0000000000000000 00000000 00000000 1:00000000 1:00000000 0000.-.-.-.-.-.-.-.-; made fgOhc)]</credits>",
    "<credits>[contacts made for 12 kg at 9.8 m/s2 (osim-contact-scale 0.0.9; all; by add; sizes none; \
     record 0000000000000000 00000000 00000000 1:00000000 1:00000000 0000.-.-.-.-.-.-.-.-; made -)];\n\tB</credits>",
];

/// The document without white space between tags.
fn one_line(text: &str) -> Option<String> {
    let mut made = String::new();
    for part in text.split_inclusive('>') {
        let begins_with_tag = part.trim_start().starts_with('<');
        made.push_str(if begins_with_tag { part.trim_start() } else { part });
    }
    Some(made)
}

/// The model with its first element `tag` replaced by `written`, or with `written` added if it has no such element; `None` if the element
/// has members.
fn with_set_written_as(text: &str, tag: &str, written: &str) -> Option<String> {
    let Some((span, inner)) = element(text, tag) else {
        let at = text.rfind("</Model>")?;
        return Some(format!("{}\t{written}\n\t{}", &text[..at], &text[at..]));
    };
    let is_member = |part: &str| {
        let name = part.split([' ', '>', '/', '\t', '\n', '\r']).next().unwrap_or_default();
        !["", "objects", "groups", "!--none--"].contains(&name) && !name.starts_with('!')
    };
    if inner.split('<').skip(1).any(is_member) {
        return None;
    }
    Some(format!("{}{written}{}", &text[..span.start], &text[span.end..]))
}

fn with_credits(text: &str, credits: &str) -> Option<String> {
    let bare = match element(text, "credits") {
        Some((span, _)) if text[..span.start].contains("<Model") => {
            format!("{}{}", &text[..span.start], &text[span.end..])
        }
        Some(_) => return None,
        None => text.to_owned(),
    };
    let model = bare.find("<Model")?;
    let at = model + bare[model..].find('>')? + 1;
    Some(format!("{}\n\t\t{credits}{}", &bare[..at], &bare[at..]))
}

/// The first element called `tag`: its range of bytes, and its content.
fn element<'t>(text: &'t str, tag: &str) -> Option<(std::ops::Range<usize>, &'t str)> {
    let tag_begins = format!("<{tag}");
    let mut starts = text.match_indices(&tag_begins).map(|(at, _)| at);
    let start =
        starts.find(|at| !text[at + tag.len() + 1..].starts_with(|letter: char| letter.is_alphanumeric()))?;
    let open = start + text[start..].find('>')? + 1;
    if text[..open].ends_with("/>") {
        return Some((start..open, ""));
    }
    let close = format!("</{tag}>");
    let end = open + text[open..].find(&close)?;
    Some((start..end + close.len(), &text[open..end]))
}

/// The bytes of a file as a text with one letter for each byte.
pub fn letters(bytes: &[u8]) -> String {
    bytes.iter().map(|&byte| char::from(byte)).collect()
}

/// The bytes for a text with one letter for each byte.
pub fn bytes(letters: &str) -> Vec<u8> {
    letters.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap_or(b'?')).collect()
}
