//! SHA-256 digests of files, and of names where very many are compared.

use std::ffi::OsStr;

use sha2::{Digest, Sha256};

/// SHA-256 as 64 hexadecimal digits.
pub fn sha256(bytes: &[u8]) -> String {
    sha256_of_parts(std::iter::once(bytes))
}

/// SHA-256 of the bytes of `parts`, one after the other, as 64 hexadecimal digits.
pub(crate) fn sha256_of_parts<'p>(parts: impl Iterator<Item = &'p [u8]>) -> String {
    let mut hash = Sha256::new();
    parts.for_each(|part| hash.update(part));
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The first half of the SHA-256 of a name, which takes less memory than the name.
pub(crate) type NameDigest = [u8; 16];

pub(crate) fn digest_of_name(name: &OsStr) -> NameDigest {
    let whole: [u8; 32] = Sha256::digest(name.as_encoded_bytes()).into();
    std::array::from_fn(|at| whole[at])
}
