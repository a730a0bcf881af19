//! Works on many items, such as models, on several threads, and hands over the results in the order of the items.

use std::collections::VecDeque;
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc;
use std::thread::available_parallelism;

use osim_requests::Jobs;
use rayon::ThreadPoolBuilder;

use crate::fault::{Context, LibraryFault};

/// Most finished results that wait for an earlier result, so that one slow model does not fill the memory with results of later models.
const MOST_WAITING_RESULTS: usize = 512;

/// Most threads, or four per processor if that is more. More threads would only wait for each other.
const MOST_THREADS: usize = 64;

/// The number of threads to use: the number `asked` for, else one per processor; at most one per item.
pub(crate) fn thread_count(asked: Option<Jobs>, items: usize) -> usize {
    // Counting the processors takes time: Linux reads three files.
    if items <= 1 {
        return 1;
    }
    let all = available_parallelism().map_or(1, NonZeroUsize::get);
    let most = MOST_THREADS.max(all.saturating_mul(4)).min(items);
    asked.map_or(all, |jobs| jobs.get().into()).min(most)
}

/// Does `work` for every item on `thread_count` threads and hands the results to `each` in the order of the items.
///
/// A panic of `work` continues on the calling thread, so that nobody waits for a result that never comes.
///
/// # Errors
/// The first error of `each`, after which no further item is begun; or threads that cannot be started.
pub fn work_in_order<T: Sync, R: Send, E: From<LibraryFault>>(
    items: &[T],
    thread_count: usize,
    work: impl Fn(&T) -> R + Sync,
    mut each: impl FnMut(&T, R) -> Result<(), E>,
) -> Result<(), E> {
    if thread_count <= 1 {
        return items.iter().try_for_each(|item| each(item, work(item)));
    }
    let pool =
        ThreadPoolBuilder::new().num_threads(thread_count).build().context(|| "cannot start threads")?;
    let (work, (sender, receiver)) = (&work, mpsc::channel());
    pool.in_place_scope_fifo(|scope| {
        let mut waiting: VecDeque<Option<R>> = VecDeque::new();
        let mut begun = 0;
        let mut waiting_items = items.iter();
        loop {
            while let Some(item) = items.get(begun).filter(|_| waiting.len() < MOST_WAITING_RESULTS) {
                let (sender, index) = (sender.clone(), begun);
                // Sending fails only after an error of `each`, when the result is not needed any more.
                let caught = move || catch_unwind(AssertUnwindSafe(|| work(item)));
                scope.spawn_fifo(move |_| drop(sender.send((index, caught()))));
                waiting.push_back(None);
                begun += 1;
            }
            let first = begun - waiting.len();
            if waiting.is_empty() {
                return Ok(());
            }
            let (index, result) = receiver.recv().context(|| "a thread ended without a result")?;
            let result = result.unwrap_or_else(|panic| resume_unwind(panic));
            if let Some(place) = waiting.get_mut(index - first) {
                *place = Some(result);
            }
            while waiting.front().is_some_and(Option::is_some) {
                if let (Some(Some(result)), Some(item)) = (waiting.pop_front(), waiting_items.next()) {
                    each(item, result)?;
                }
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::Duration;

    use super::*;

    #[test]
    fn results_come_in_the_order_of_the_items() {
        let items: Vec<usize> = (0..2000).collect();
        let most = thread_count("4096".parse().ok(), items.len());
        assert!(most >= MOST_THREADS);
        for threads in [1, 2, 7, most] {
            let mut reported = Vec::new();
            let slow = |&item: &usize| {
                if item.is_multiple_of(500) {
                    std::thread::sleep(Duration::from_millis(5));
                }
                item * 2
            };
            work_in_order(&items, threads, slow, |&item, result| {
                reported.push((item, result));
                Ok::<(), LibraryFault>(())
            })
            .unwrap();
            assert_eq!(reported, items.iter().map(|&item| (item, item * 2)).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_panic_continues_on_the_calling_thread() {
        let items: Vec<usize> = (0..10).collect();
        for threads in [1, 2] {
            let work = |&item: &usize| assert_ne!(item, 7, "the seventh");
            let ended =
                catch_unwind(|| work_in_order(&items, threads, work, |_, ()| Ok::<(), LibraryFault>(())));
            let panic = ended.unwrap_err();
            assert!(panic.downcast_ref::<String>().unwrap().contains("the seventh"), "{threads} threads");
        }
    }

    #[test]
    fn an_error_ends_the_work_early() {
        let items: Vec<usize> = (0..10_000).collect();
        let done = AtomicUsize::new(0);
        let count = |_: &usize| done.fetch_add(1, Ordering::Relaxed);
        let stop = |&item: &usize, _| if item == 3 { Err(LibraryFault::new("stop")) } else { Ok(()) };
        assert!(work_in_order(&items, 2, count, stop).is_err());
        assert!(done.load(Ordering::Relaxed) <= 4 + MOST_WAITING_RESULTS);
    }
}
