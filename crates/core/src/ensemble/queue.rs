//! Which runs are left, and the threads that take them.

use super::{Caller, Rows};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
use std::thread;
use std::time::Duration;

/// How often the calling thread looks up when it has no work of its own left.
const LOOK: Duration = Duration::from_millis(20);

/// The work of one thread, which reports now and then and stops when it hears false.
pub type Work<'a> = dyn Fn(&mut dyn FnMut() -> bool) -> Rows + Sync + 'a;

/// The runs that are not begun yet.
pub struct Queue {
    runs: usize,
    threads: usize,
    next: AtomicUsize,
    done: AtomicUsize,
    busy: AtomicUsize,
    stopped: AtomicBool,
}

impl Queue {
    pub fn new(runs: usize, threads: usize) -> Self {
        Self {
            runs,
            threads: threads.min(runs.max(1)),
            next: AtomicUsize::new(0),
            done: AtomicUsize::new(0),
            busy: AtomicUsize::new(0),
            stopped: AtomicBool::new(false),
        }
    }

    /// The next run, if there is one.
    pub fn take(&self) -> Option<usize> {
        let run = self.next.fetch_add(1, Relaxed);
        (run < self.runs).then_some(run)
    }

    pub fn note_done(&self) {
        self.done.fetch_add(1, Relaxed);
    }

    pub fn is_stopped(&self) -> bool {
        self.stopped.load(Relaxed)
    }

    /// Lets all threads work; what each of them has done.
    pub fn share(&self, caller: Caller<'_>, work: &Work<'_>) -> Vec<Rows> {
        let parts = Mutex::new(Vec::new());
        let (around, progress) = (caller.around, caller.progress);
        let one = |report: &mut dyn FnMut() -> bool| {
            around(&mut || {
                let rows = work(report);
                parts.lock().unwrap_or_else(|e| e.into_inner()).push(rows);
            });
        };
        let mut report = || {
            if !self.is_stopped() && !progress(self.done.load(Relaxed)) {
                self.stopped.store(true, Relaxed);
            }
            !self.is_stopped()
        };
        let helpers = self.threads - 1;
        let pool = (helpers > 0).then(|| rayon::ThreadPoolBuilder::new().num_threads(helpers).build());
        // A machine that gives no more threads does the work with the one there is.
        let Some(Ok(pool)) = pool else {
            one(&mut report);
            return parts.into_inner().unwrap_or_default();
        };
        self.busy.store(helpers, Relaxed);
        pool.in_place_scope(|scope| {
            for _ in 0..helpers {
                scope.spawn(|_| {
                    let _leaving = Leaving(&self.busy);
                    one(&mut || !self.is_stopped());
                });
            }
            one(&mut report);
            while self.busy.load(Relaxed) > 0 && report() {
                thread::park_timeout(LOOK);
            }
        });
        parts.into_inner().unwrap_or_default()
    }
}

/// Counts a thread out, however it ends.
struct Leaving<'a>(&'a AtomicUsize);

impl Drop for Leaving<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Relaxed);
    }
}
