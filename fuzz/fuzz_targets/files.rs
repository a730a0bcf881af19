#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| osim_fuzz::files(bytes));
