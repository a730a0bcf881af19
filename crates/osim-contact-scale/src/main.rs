//! The command `osim-contact-scale`.

use std::process::ExitCode;

fn main() -> ExitCode {
    osim_contact_scale::main()
}
