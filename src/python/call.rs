//! A question that is answered while Python listens.
//!
//! ```text
//!   Python's thread   waits, without the lock → every 50 ms: signals? callback → …
//!   threads of ours   the question → begin, advance, tell → … → the answer
//! ```
//!
//! The threads are a pool for each call. A pool that outlived the call would be missing in a
//! process that is forked from this one, as `multiprocessing` does, and the child would wait for
//! it forever.
//!
//! Where Ctrl-C is pressed, or the callback raises an exception, the caller has it at once. The
//! threads unwind when they report progress next, and drop what they have; nothing waits for them
//! longer than half a second.

use super::refusal::Refusal;
use crate::exchange::Progress;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// The time between two looks at signals and at progress.
const BEAT: Duration = Duration::from_millis(50);

/// The time that a computation has to end once it is given up.
const GRACE: Duration = Duration::from_millis(500);

/// The stack of each thread: as much as the main thread of the command has.
const STACK: usize = 8 << 20;

/// The way in which a question is asked.
#[derive(FromPyObject)]
pub(super) struct Call {
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
}

/// A listener whose notes another thread reads.
#[derive(Default)]
struct Watch {
    is_stopped: AtomicBool,
    done: AtomicU64,
    words: Mutex<Words>,
}

/// The words of progress.
#[derive(Clone, Default, PartialEq)]
struct Words {
    total: u64,
    name: String,
    state: String,
}

/// The payload of a computation that was given up.
struct Stopped;

impl Watch {
    fn words(&self) -> MutexGuard<'_, Words> {
        self.words.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Unwinds if the computation is given up.
    fn go_on(&self) {
        if self.is_stopped.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Stopped));
        }
    }
}

impl Progress for Watch {
    fn begin(&self, units: u64, name: &str) {
        self.go_on();
        let mut words = self.words();
        self.done.store(0, Ordering::Relaxed);
        (words.total, words.name) = (units, name.to_owned());
    }

    fn advance(&self, finished: usize) {
        self.go_on();
        self.done.fetch_add(finished as u64, Ordering::Relaxed);
    }

    fn tell(&self, state: &str) {
        self.go_on();
        state.clone_into(&mut self.words().state);
    }
}

/// A callback, and what it was told last.
struct Teller<'c> {
    callback: Option<&'c Py<PyAny>>,
    last: (u64, Words),
}

impl Teller<'_> {
    /// Tells the callback how far the computation is, if that has changed.
    fn tell(&mut self, py: Python<'_>, watch: &Watch) -> PyResult<()> {
        let Some(callback) = self.callback else {
            return Ok(());
        };
        let words = watch.words().clone();
        let now = (watch.done.load(Ordering::Relaxed), words);
        if now != self.last {
            self.last.clone_from(&now);
            let (done, words) = now;
            callback.call1(py, (done, words.total, words.name, words.state))?;
        }
        Ok(())
    }
}

/// Answers a question on threads of its own.
///
/// # Errors
/// The refusal as a `ValueError`; what a signal or the callback raises.
pub(super) fn answered<T: Send + 'static>(
    py: Python<'_>,
    call: &Call,
    question: impl FnOnce(&dyn Progress) -> Result<T, Refusal> + Send + 'static,
) -> PyResult<T> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(call.threads.unwrap_or(0))
        .thread_name(|index| format!("infoscene {index}"))
        .stack_size(STACK)
        .build()
        .map_err(|error| PyRuntimeError::new_err(format!("no threads can be started: {error}")))?;
    let watch = Arc::new(Watch::default());
    let mut teller = Teller {
        callback: call.progress.as_ref(),
        last: Default::default(),
    };
    let (sender, mut receiver) = channel();
    let listener = Arc::clone(&watch);
    pool.spawn(move || {
        let answer = catch_unwind(AssertUnwindSafe(|| question(&*listener)));
        // nobody waits for the answer of a question that was given up
        drop(sender.send(answer));
    });
    loop {
        let (back, answer) = py.detach(move || {
            let answer = receiver.recv_timeout(BEAT);
            (receiver, answer)
        });
        receiver = back;
        let is_over = !matches!(answer, Err(RecvTimeoutError::Timeout));
        let told = teller.tell(py, &watch).and_then(|()| py.check_signals());
        match (answer, told) {
            (Ok(Ok(Ok(answer))), Ok(())) => return Ok(answer),
            (Ok(Ok(Err(refusal))), Ok(())) => return Err(PyValueError::new_err(refusal.0)),
            (Ok(Err(panic)), Ok(())) => resume_unwind(panic),
            (Err(RecvTimeoutError::Disconnected), Ok(())) => {
                return Err(PyRuntimeError::new_err(
                    "the computation ended without an answer",
                ));
            }
            (Err(RecvTimeoutError::Timeout), Ok(())) => {}
            (_, Err(raised)) => {
                watch.is_stopped.store(true, Ordering::Relaxed);
                if !is_over {
                    py.detach(move || drop(receiver.recv_timeout(GRACE)));
                }
                return Err(raised);
            }
        }
    }
}
