#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| osim_fuzz::verbs(bytes));
libfuzzer_sys::fuzz_mutator!(|bytes: &mut [u8], size: usize, max_size: usize, seed: u32| {
    osim_fuzz::mutate(bytes, size, max_size, seed)
});
