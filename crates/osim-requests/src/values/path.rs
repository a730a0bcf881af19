//! Paths in JSON: text, or the bytes where a path is not text.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// How a path is written in JSON.
#[derive(Serialize, Deserialize)]
#[serde(untagged, deny_unknown_fields)]
enum WrittenPath {
    /// A path that is Unicode, as text.
    Text(String),
    /// As the bytes that the system has, where these are not UTF-8.
    Bytes { bytes: Vec<u8> },
}

/// The schema of a path.
#[cfg(feature = "schemas")]
pub(crate) fn schema() -> serde_json::Value {
    serde_json::json!({"anyOf": [
        {"type": "string", "minLength": 1},
        {
            "type": "object",
            "properties": {"bytes": {"type": "array", "items": {"type": "integer", "minimum": 0, "maximum": 255}}},
            "required": ["bytes"],
            "additionalProperties": false,
        },
    ]})
}

impl WrittenPath {
    /// How a path is written: as text, or as its bytes if it is not UTF-8.
    fn of(path: &Path) -> Self {
        match path.to_str() {
            Some(text) => Self::Text(text.to_owned()),
            None => Self::Bytes { bytes: path.as_os_str().as_encoded_bytes().to_vec() },
        }
    }

    fn path(self) -> Result<PathBuf, &'static str> {
        match self {
            Self::Text(text) if text.is_empty() => Err(EMPTY_PATH_MESSAGE),
            Self::Bytes { bytes } if bytes.is_empty() => Err(EMPTY_PATH_MESSAGE),
            Self::Text(text) => Ok(text.into()),
            Self::Bytes { bytes } => of_bytes(bytes).map(PathBuf::from),
        }
    }
}

#[cfg(unix)]
fn of_bytes(bytes: Vec<u8>) -> Result<OsString, &'static str> {
    Ok(std::os::unix::ffi::OsStringExt::from_vec(bytes))
}

#[cfg(not(unix))]
fn of_bytes(bytes: Vec<u8>) -> Result<OsString, &'static str> {
    String::from_utf8(bytes)
        .map(OsString::from)
        .map_err(|_| "a path that is not text cannot be given on this system")
}

/// The expected form of a path, for messages.
const EXPECTED_PATH: &str = "expected the name of a file, as text or as {\"bytes\": [...]}";

/// The message about an empty name.
const EMPTY_PATH_MESSAGE: &str = "it is empty, expected the name of a file";

/// A path as a value of JSON.
pub fn to_value(path: &Path) -> serde_json::Value {
    serde_json::to_value(WrittenPath::of(path)).unwrap_or_default()
}

/// How a field has one path, or none.
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
pub struct Optional;

impl Optional {
    /// Writes one path, or null.
    ///
    /// # Errors
    /// The errors of the serialiser.
    pub fn serialize<S: Serializer>(path: &Option<PathBuf>, serializer: S) -> Result<S::Ok, S::Error> {
        path.as_deref().map(WrittenPath::of).serialize(serializer)
    }

    /// Reads one path, or null.
    ///
    /// # Errors
    /// A value that is neither a path nor null.
    pub fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Option<PathBuf>, D::Error> {
        let written =
            Option::<WrittenPath>::deserialize(deserializer).map_err(|_| D::Error::custom(EXPECTED_PATH))?;
        written.map(WrittenPath::path).transpose().map_err(D::Error::custom)
    }
}

/// How a field has a list of paths, or one alone in its place.
#[cfg_attr(feature = "schemas", derive(schemars::JsonSchema), schemars(inline))]
pub struct List;

impl List {
    /// Writes a list of paths.
    ///
    /// # Errors
    /// The errors of the serialiser.
    pub fn serialize<S: Serializer>(paths: &[PathBuf], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(paths.iter().map(|path| WrittenPath::of(path)))
    }

    /// Reads a list of paths, or one.
    ///
    /// # Errors
    /// A value that is neither a path nor a list of paths.
    pub fn deserialize<'d, D: Deserializer<'d>>(deserializer: D) -> Result<Vec<PathBuf>, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum OneOrMany {
            One(WrittenPath),
            Many(Vec<WrittenPath>),
        }
        let written =
            match OneOrMany::deserialize(deserializer).map_err(|_| D::Error::custom(EXPECTED_PATH))? {
                OneOrMany::One(path) => vec![path],
                OneOrMany::Many(paths) => paths,
            };
        written.into_iter().map(WrittenPath::path).collect::<Result<_, _>>().map_err(D::Error::custom)
    }
}
