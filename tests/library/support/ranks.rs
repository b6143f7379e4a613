//! Ranks that are threads of one process: what they share is what processes would.

use infoscene::exchange::Ranks;
use std::sync::{Arc, Barrier, Mutex, PoisonError};

/// A table of lists, by sender and receiver.
type Table = Vec<Vec<Vec<f64>>>;

/// One of several threads that share out work.
pub struct Thread {
    number: usize,
    table: Arc<Mutex<Table>>,
    met: Arc<Barrier>,
}

impl Ranks for Thread {
    fn number(&self) -> usize {
        self.number
    }

    fn count(&self) -> usize {
        self.table
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .len()
    }

    fn exchange(&self, lists: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        self.table.lock().unwrap()[self.number] = lists;
        self.met.wait();
        let table = self.table.lock().unwrap().clone();
        // nobody writes before all have read
        self.met.wait();
        table
            .into_iter()
            .map(|mut lists| lists.swap_remove(self.number))
            .collect()
    }

    fn gather(&self, list: Vec<f64>) -> Vec<Vec<f64>> {
        self.exchange(vec![list; self.count()])
    }
}

/// The answers of so many ranks, each given by a thread of its own.
pub fn among<T: Send>(count: usize, answer: impl Fn(&dyn Ranks) -> T + Sync) -> Vec<T> {
    let table = Arc::new(Mutex::new(vec![Vec::new(); count]));
    let met = Arc::new(Barrier::new(count));
    std::thread::scope(|scope| {
        let threads = (0..count).map(|number| {
            let rank = Thread {
                number,
                table: Arc::clone(&table),
                met: Arc::clone(&met),
            };
            scope.spawn(|| {
                let rank = rank;
                answer(&rank)
            })
        });
        let threads: Vec<_> = threads.collect();
        threads
            .into_iter()
            .map(|thread| thread.join().unwrap())
            .collect()
    })
}
