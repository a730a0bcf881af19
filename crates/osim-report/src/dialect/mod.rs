//! How a command line, a request in JSON, Python and a page spell what the reader can say or do.

mod command_line;
mod front_end;
mod json_request;
mod page;
mod python;
mod remedy;
mod shell;

pub use command_line::CommandLine;
pub use front_end::FrontEnd;
pub use json_request::JsonRequest;
pub use page::Page;
pub use python::{Python, python_keyword, python_quoted};
pub use shell::shell_quoted;
