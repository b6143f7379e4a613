//! Ranks of a job that `mpirun` has started (feature `mpi`).
//!
//! ```text
//!   mpirun -n 4 infoscene form-factor SCENE --store DIR
//! ```
//!
//! The library deals out tiles and blocks, and adds up what they bring, through
//! [`Ranks`](crate::exchange::Ranks) alone; here is what makes of it messages. Sums are never left
//! to the engine (`MPI_SUM`), which adds in an order of its own.
//!
//! A process that no engine has started is none of several: it never touches the engine. A rank
//! that panics ends the job, as one that is killed does, and `mpirun` names it.
//!
//! The engine counts in 31 bits what a collective brings to a rank; longer lists take several.
//!
//! **Not covered**: ranks on machines that order bytes differently.

use crate::exchange::Ranks;
use mpi::Threading;
use mpi::collective::CommunicatorCollectives as _;
use mpi::datatype::{Partition, PartitionMut};
use mpi::environment::Universe;
use mpi::topology::{Communicator as _, SimpleCommunicator};
use std::env;
use std::ops::Range;
use std::panic;

/// Variables that engines set for a process that they start.
const STARTED: [&str; 3] = ["OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"];

/// The exit status of a job whose rank has panicked.
const PANICKED: i32 = 101;

/// The most numbers that one collective brings to a rank.
const MOST: usize = i32::MAX as usize;

/// One rank of a job that `mpirun` has started.
pub struct Mpi {
    number: usize,
    count: usize,
    /// The engine's state: where it ends, messages end.
    _universe: Universe,
}

impl Mpi {
    /// This process as a rank; none if no engine has started it.
    #[must_use]
    pub fn joined() -> Option<Box<dyn Ranks>> {
        if !STARTED.iter().any(|name| env::var_os(name).is_some()) {
            return None;
        }
        // messages are sent by the thread that asks, while others only compute
        let (universe, _) = mpi::initialize_with_threading(Threading::Serialized)?;
        let world = universe.world();
        let [number, count] = [world.rank(), world.size()].map(|n| usize::try_from(n).unwrap_or(0));
        let told = panic::take_hook();
        panic::set_hook(Box::new(move |information| {
            told(information);
            eprintln!("infoscene: rank {number} of {count} has panicked");
            SimpleCommunicator::world().abort(PANICKED);
        }));
        Some(Box::new(Self {
            number,
            count,
            _universe: universe,
        }))
    }
}

impl Ranks for Mpi {
    fn number(&self) -> usize {
        self.number
    }

    fn count(&self) -> usize {
        self.count
    }

    fn exchange(&self, lists: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        let world = SimpleCommunicator::world();
        let longest = lists.iter().map(Vec::len).max().unwrap_or(0);
        let told: Vec<usize> = lists
            .iter()
            .flat_map(|list| [list.len(), longest])
            .collect();
        let mut heard = vec![0; 2 * self.count];
        world.all_to_all_into(&told[..], &mut heard[..]);
        let lengths: Vec<usize> = heard.iter().step_by(2).copied().collect();
        let longest = heard.iter().skip(1).step_by(2).max();
        let longest = longest.copied().unwrap_or(0);
        self.in_portions(&lengths, longest, |portion, taken| {
            let parts = lists.iter().map(|list| &list[part(list.len(), portion)]);
            let (counts, numbers): (Vec<i32>, Vec<&[f64]>) =
                parts.map(|part| (count(part.len()), part)).unzip();
            let (numbers, places) = (numbers.concat(), places(&counts));
            let given = Partition::new(&numbers[..], &counts[..], &places[..]);
            world.all_to_all_varcount_into(&given, taken);
        })
    }

    fn gather(&self, list: Vec<f64>) -> Vec<Vec<f64>> {
        let world = SimpleCommunicator::world();
        let mut lengths = vec![0; self.count];
        world.all_gather_into(&[list.len()][..], &mut lengths[..]);
        let longest = lengths.iter().copied().max().unwrap_or(0);
        self.in_portions(&lengths, longest, |portion, taken| {
            world.all_gather_varcount_into(&list[part(list.len(), portion)], taken);
        })
    }
}

/// The numbers that one collective brings to a rank, and the list that each of them is part of.
type Taken<'n> = PartitionMut<'n, [f64], &'n [i32], &'n [i32]>;

impl Mpi {
    /// Receives lists of these lengths by as many collectives as the longest list of all ranks
    /// takes; each collective brings the same portion of every list.
    fn in_portions(
        &self,
        lengths: &[usize],
        longest: usize,
        collective: impl Fn(&Range<usize>, &mut Taken<'_>),
    ) -> Vec<Vec<f64>> {
        let mut lists: Vec<Vec<f64>> = lengths.iter().map(|_| Vec::new()).collect();
        let step = (MOST / self.count).max(1);
        for start in (0..longest).step_by(step) {
            let portion = start..start + step;
            let parts = lengths.iter().map(|length| part(*length, &portion).len());
            let parts: Vec<usize> = parts.collect();
            let counts: Vec<i32> = parts.iter().map(|part| count(*part)).collect();
            let places = places(&counts);
            let mut numbers = vec![0.0; parts.iter().sum()];
            let mut taken = PartitionMut::new(&mut numbers[..], &counts[..], &places[..]);
            collective(&portion, &mut taken);
            let mut rest = &numbers[..];
            for (list, part) in lists.iter_mut().zip(parts) {
                let (own, others) = rest.split_at(part);
                list.extend_from_slice(own);
                rest = others;
            }
        }
        lists
    }
}

/// The part of a list of this length that lies in a portion.
fn part(length: usize, portion: &Range<usize>) -> Range<usize> {
    portion.start.min(length)..portion.end.min(length)
}

/// A number of numbers, as the engine counts.
fn count(numbers: usize) -> i32 {
    debug_assert!(numbers <= MOST, "a portion is short");
    i32::try_from(numbers).unwrap_or(i32::MAX)
}

/// The place at which each list begins, one after the other.
fn places(counts: &[i32]) -> Vec<i32> {
    let mut next = 0;
    let place = |count: &i32| {
        let place = next;
        next += count;
        place
    };
    counts.iter().map(place).collect()
}
