//! Bytes of plain names and blanks between them.

/// Whether `byte` may be in a plain name.
pub(super) fn is_plain(byte: u8) -> bool {
    NAME.get(byte as usize).is_some_and(|&plain| plain)
}

/// Whether XML calls `byte` white space.
pub(super) fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\n' | b'\t' | b'\r')
}

static NAME: [bool; 256] = {
    let mut table = [false; 256];
    let mut byte = 0_u8;
    while byte < 128 {
        table[byte as usize] = byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.' | b':' | b'-');
        byte += 1;
    }
    table
};
