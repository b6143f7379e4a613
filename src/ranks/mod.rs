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
//! **Not covered**: ranks on machines that order bytes differently; lists of 2³¹ numbers.

use crate::exchange::Ranks;
use mpi::Threading;
use mpi::collective::CommunicatorCollectives as _;
use mpi::datatype::{Partition, PartitionMut};
use mpi::environment::Universe;
use mpi::topology::{Communicator as _, SimpleCommunicator};
use std::env;
use std::panic;

/// What engines tell a process that they start.
const STARTED: [&str; 3] = ["OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_SIZE"];

/// The exit status of a job whose rank has panicked.
const PANICKED: i32 = 101;

/// One rank of a job that `mpirun` has started.
pub struct Mpi {
    number: usize,
    count: usize,
    /// Its end is that of the job's messages.
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
        let sent: Vec<i32> = lists.iter().map(|list| length(list)).collect();
        let mut came = vec![0; self.count];
        world.all_to_all_into(&sent[..], &mut came[..]);
        let numbers = lists.concat();
        let mut found = vec![0.0; total(&came)];
        let places = [places(&sent), places(&came)];
        let given = Partition::new(&numbers[..], &sent[..], &places[0][..]);
        let mut taken = PartitionMut::new(&mut found[..], &came[..], &places[1][..]);
        world.all_to_all_varcount_into(&given, &mut taken);
        apart(&found, &came)
    }

    fn gather(&self, list: Vec<f64>) -> Vec<Vec<f64>> {
        let world = SimpleCommunicator::world();
        let mut came = vec![0; self.count];
        world.all_gather_into(&[length(&list)][..], &mut came[..]);
        let mut found = vec![0.0; total(&came)];
        let places = places(&came);
        let mut taken = PartitionMut::new(&mut found[..], &came[..], &places[..]);
        world.all_gather_varcount_into(&list[..], &mut taken);
        apart(&found, &came)
    }
}

/// The length of a list, as the engine counts.
fn length(list: &[f64]) -> i32 {
    let length = i32::try_from(list.len());
    length.unwrap_or_else(|_| panic!("a message of {} numbers is too long", list.len()))
}

/// The sum of lengths.
fn total(lengths: &[i32]) -> usize {
    let lengths = lengths.iter();
    lengths
        .map(|length| usize::try_from(*length).unwrap_or(0))
        .sum()
}

/// The place at which each list begins, one after the other.
fn places(lengths: &[i32]) -> Vec<i32> {
    let mut next = 0;
    let place = |length: &i32| {
        let place = next;
        next += length;
        place
    };
    lengths.iter().map(place).collect()
}

/// The lists that stand one after the other.
fn apart(numbers: &[f64], lengths: &[i32]) -> Vec<Vec<f64>> {
    let mut rest = numbers;
    let list = |length: &i32| {
        let (list, others) = rest.split_at(usize::try_from(*length).unwrap_or(0));
        rest = others;
        list.to_vec()
    };
    lengths.iter().map(list).collect()
}
