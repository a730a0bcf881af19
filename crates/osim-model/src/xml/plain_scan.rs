//! A fast scan for files with only plain tags, quoted attributes, text and comments: nearly every model is such a file.
//!
//! The fast scan is several times as fast as a full parser. It stops at anything else (`&`, CDATA, DOCTYPE, names with unusual letters,
//! tags that do not match) and leaves the whole file to [`scan`](super::scan), which supports all of XML and reports errors. If the fast
//! scan finishes, both scans give the same pieces and elements: tests with all fixtures and real models, and a fuzz target, compare them.

use super::tree::{StoredElement, is_name_byte, is_space};

/// With more attributes than this on a tag, the file is left to the full scan, which finds repeated names.
const MOST_PLAIN_ATTRIBUTES: usize = 8;
/// The fewest bytes per piece in dense models. Used to reserve memory; reserved memory that is not needed costs nothing.
const FEWEST_FILE_BYTES_PER_PIECE: usize = 8;
/// The fewest bytes per element in dense models. Used to reserve memory.
const FEWEST_FILE_BYTES_PER_ELEMENT: usize = 20;
/// Texts up to this number of bytes are searched in steps of eight bytes, longer texts by memchr.
const MOST_SHORT_TEXT_BYTES: usize = 16;
/// The number whose eight bytes are all 1.
const ONE_IN_EACH_BYTE: u64 = u64::from_ne_bytes([1; 8]);

/// The pieces and elements of `text`, whose first byte is byte `base` of the file (after a byte order mark). `None` if the file is not
/// plain.
pub(super) fn scan_plain(text: &str, base: usize) -> Option<(Vec<u32>, Vec<StoredElement>)> {
    let length = text.len();
    let mut scan = PlainScan {
        bytes: text.as_bytes(),
        at: base,
        pieces: Vec::with_capacity(length / FEWEST_FILE_BYTES_PER_PIECE + 2),
        elements: Vec::with_capacity(length / FEWEST_FILE_BYTES_PER_ELEMENT + 1),
        open: Vec::new(),
    };
    if base > 0 {
        scan.pieces.push(0);
    }
    while scan.at < length {
        scan.piece()?;
    }
    let complete = scan.open.is_empty() && !scan.elements.is_empty();
    complete.then_some((scan.pieces, scan.elements))
}

/// The state of the fast scan of a plain file.
struct PlainScan<'t> {
    bytes: &'t [u8],
    /// Offset of the next byte to read.
    at: usize,
    pieces: Vec<u32>,
    elements: Vec<StoredElement>,
    /// Indices of the elements that are still open, the outermost first.
    open: Vec<u32>,
}

impl PlainScan<'_> {
    fn byte(&self, at: usize) -> u8 {
        // No tag or text continues after the end: 0 was refused before and matches nothing.
        self.bytes.get(at).copied().unwrap_or(0)
    }

    /// Reads the next piece; `None` if the file is not plain there.
    fn piece(&mut self) -> Option<()> {
        if self.byte(self.at) != b'<' {
            return self.text();
        }
        match self.byte(self.at + 1) {
            b'/' => self.close(),
            b'!' => self.comment(),
            b'?' => self.instruction(),
            _ => self.tag(),
        }
    }

    /// Stores the piece that ends at `end`.
    fn push(&mut self, end: usize) {
        self.pieces.push(self.at as u32);
        self.at = end;
    }

    /// Reads the text up to the next tag; `None` if the file is not plain there.
    fn text(&mut self) -> Option<()> {
        let rest = self.bytes.get(self.at..)?;
        let length = text_length(rest);
        let text = rest.get(..length)?;
        let inside = !self.open.is_empty();
        if rest.get(length) == Some(&b'&') || !(inside || text.iter().all(|&byte| is_space(byte))) {
            return None;
        }
        self.push(self.at + length);
        Some(())
    }

    /// Reads a start tag, `<name …>` or `<name …/>`.
    fn tag(&mut self) -> Option<()> {
        let name_len = self.name(self.at + 1)?;
        let after = self.at + 1 + name_len;
        // Most tags have no attributes.
        let end = if matches!(self.byte(after), b'>' | b'/') { after } else { self.attributes(after)? };
        let empty = self.byte(end) == b'/';
        let end = if empty { end + 1 } else { end };
        let is_second_root = self.open.is_empty() && !self.elements.is_empty();
        if self.byte(end) != b'>' || is_second_root {
            return None;
        }
        let (open, id) = (self.pieces.len() as u32, self.elements.len() as u32);
        let parent = self.open.last().copied().unwrap_or(0);
        let (name_start, name_len) = (self.at as u32 + 1, name_len as u32);
        let subtree_end = id + 1;
        self.elements.push(StoredElement { open, close: open, parent, subtree_end, name_start, name_len });
        self.push(end + 1);
        if !empty {
            self.open.push(id);
        }
        Some(())
    }

    /// Reads the end tag `</name>` of the innermost open element.
    fn close(&mut self) -> Option<()> {
        let id = self.open.pop()? as usize;
        let (close, subtree_end) = (self.pieces.len() as u32, self.elements.len() as u32);
        let element = self.elements.get_mut(id)?;
        let (start, name_len) = (element.name_start as usize, element.name_len as usize);
        (element.close, element.subtree_end) = (close, subtree_end);
        let (from, end) = (self.at + 2, self.at + 2 + name_len);
        let same = self.bytes.get(from..end)? == self.bytes.get(start..start + name_len)?;
        if !same || self.byte(end) != b'>' {
            return None;
        }
        self.push(end + 1);
        Some(())
    }

    fn comment(&mut self) -> Option<()> {
        let from = self.at + 4;
        let rest = self.bytes.get(from..)?;
        let is_comment = self.bytes.get(self.at..from)? == b"<!--";
        if !is_comment || rest.starts_with(b">") || rest.starts_with(b"->") {
            return None;
        }
        // Few comments hold a `>` before their end, so looking for one letter is quicker than for three.
        let is_end = |&at: &usize| rest.get(..at).is_some_and(|before| before.ends_with(b"--"));
        let end = from + memchr::memchr_iter(b'>', rest).find(is_end)? + 1;
        self.push(end);
        Some(())
    }

    fn instruction(&mut self) -> Option<()> {
        let from = self.at + 2;
        if !self.byte(from).is_ascii_alphabetic() {
            return None;
        }
        let rest = self.bytes.get(from..)?;
        let is_end = |&at: &usize| rest.get(..at).is_some_and(|before| before.ends_with(b"?"));
        let end = from + memchr::memchr_iter(b'>', rest).find(is_end)? + 1;
        self.push(end);
        Some(())
    }

    fn name(&self, from: usize) -> Option<usize> {
        let rest = self.bytes.get(from..)?;
        let length = rest.iter().position(|&byte| !is_name_byte(byte))?;
        rest.first().filter(|&&first| first.is_ascii_alphabetic() || first == b'_').map(|_| length)
    }

    /// The end of the attributes that begin at `at`: the index of `>` or `/`.
    fn attributes(&self, mut at: usize) -> Option<usize> {
        let mut keys: [&[u8]; MOST_PLAIN_ATTRIBUTES] = [&[]; MOST_PLAIN_ATTRIBUTES];
        let mut count = 0;
        loop {
            let blanks = self.bytes.get(at..)?.iter().position(|&byte| !is_space(byte))?;
            at += blanks;
            if matches!(self.byte(at), b'>' | b'/') {
                return Some(at);
            }
            let length = self.name(at).filter(|_| blanks > 0)?;
            let key = self.bytes.get(at..at + length)?;
            if keys.get(..count)?.contains(&key) {
                return None;
            }
            *keys.get_mut(count)? = key;
            count += 1;
            at = self.value(at + length)?;
        }
    }

    /// The index after the `="value"` of an attribute that begins at `at`; `None` if the file is not plain there.
    fn value(&self, at: usize) -> Option<usize> {
        let quote = self.byte(at + 1);
        if self.byte(at) != b'=' || !matches!(quote, b'"' | b'\'') {
            return None;
        }
        let value = self.bytes.get(at + 2..)?;
        let length = value.iter().position(|&byte| byte == quote || matches!(byte, b'<' | b'>' | b'&'))?;
        (self.byte(at + 2 + length) == quote).then_some(at + 3 + length)
    }
}

/// The length of the text at the start of `rest`, up to `<` or `&`. Most texts are a line end with tabs, or one number. For these, a search
/// in steps of eight bytes is faster than memchr.
fn text_length(rest: &[u8]) -> usize {
    let mut length = 0;
    while let Some(eight) = rest.get(length..).and_then(|rest| rest.first_chunk::<8>()) {
        if length == MOST_SHORT_TEXT_BYTES {
            break;
        }
        let word = u64::from_le_bytes(*eight);
        let are = |letter: u8| zero_byte_bits(word ^ (ONE_IN_EACH_BYTE * u64::from(letter)));
        let ends = are(b'<') | are(b'&');
        if ends != 0 {
            return length + ends.trailing_zeros() as usize / 8;
        }
        length += 8;
    }
    let behind = rest.get(length..).unwrap_or_default();
    memchr::memchr2(b'<', b'&', behind).map_or(rest.len(), |at| length + at)
}

/// Sets the highest bit of the lowest zero byte of `word`. Higher bits of the result have no meaning.
const fn zero_byte_bits(word: u64) -> u64 {
    word.wrapping_sub(ONE_IN_EACH_BYTE) & !word & (ONE_IN_EACH_BYTE << 7)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_ends_before_the_first_tag_or_reference() {
        for length in 0..40 {
            for end in ["<", "&", "<&", "&<", "<<<<<<<<<", ""] {
                for letter in ["a", "\n", "\u{7f}", "=", ";", "'", "\u{e9}"] {
                    let text = letter.repeat(length);
                    let rest = format!("{text}{end}");
                    assert_eq!(text_length(rest.as_bytes()), text.len(), "{rest}");
                    assert_eq!(
                        text_length(format!("{rest}{}", "b".repeat(20)).as_bytes()),
                        if end.is_empty() { text.len() + 20 } else { text.len() }
                    );
                }
            }
        }
    }

    #[track_caller]
    fn assert_left_to_full_scan(text: &str) {
        assert!(scan_plain(text, 0).is_none(), "{text}");
    }

    #[test]
    fn the_fast_scan_reads_models_without_special_xml() {
        for text in [
            "<a/>",
            "<a></a>",
            "<?xml version=\"1.0\"?>\n<a x='1' y=\"2\" ><b::c>1 > 0</b::c><!-- <!-- é -->\r\n</a>\n",
        ] {
            assert!(scan_plain(text, 0).is_some(), "{text}");
        }
    }

    #[test]
    fn files_with_special_xml_are_left_to_the_full_scan() {
        for text in [
            "",
            " ",
            "x<a/>",
            "<a/>x",
            "<a/><b/>",
            "<a><b></a></b>",
            "<a>",
            "</a>",
            "<a",
            "<a x='1'",
            "<a x=1/>",
            "<a x='1'y='2'/>",
            "<a x='1' x='2'/>",
            "<a x='<'/>",
            "<a>&amp;</a>",
            "<a><![CDATA[1]]></a>",
            "<!DOCTYPE a><a/>",
            "<é/>",
            "<a / >",
            "</a >",
            "<a><!--></a>-->",
            "<a><!-- </a>",
            "<? x?><a/>",
        ] {
            assert_left_to_full_scan(text);
        }
    }
}
