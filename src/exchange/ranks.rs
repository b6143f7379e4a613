//! Processes that share out a pass: the ranks of a job.
//!
//! Parts of a pass, tiles or blocks of rows, are dealt out by their number: part k is rank
//! `k mod N`'s. What the parts bring to each place is handed to the rank that the place belongs to,
//! and added there in the order of the parts. So the sums have the same bits for any number of
//! ranks; they are gathered once.
//!
//! Every rank asks the same passes in the same order, and all learn of the failure of one
//! ([`failure`]), which is named by its number: what ranks do together begins with asking whether
//! all are well, and nothing after that can fail. A rank that fails elsewhere need only ask once
//! more.
//!
//! **Not covered**: a rank that dies, which whoever started the ranks sees; ranks whose processors
//! order bytes differently.

use std::fmt;
use std::ops::Range;

/// The processes that share out a pass, as one of them sees them.
///
/// Each call is answered when all ranks have made it.
pub trait Ranks: Sync {
    /// The number of this rank, from 0.
    fn number(&self) -> usize;

    /// The number of ranks, ≥ 1.
    fn count(&self) -> usize;

    /// Sends the k-th list to rank k; returns the lists that came, by their senders.
    fn exchange(&self, lists: Vec<Vec<f64>>) -> Vec<Vec<f64>>;

    /// Gives a list to all ranks; returns the lists of all, in their order.
    fn gather(&self, list: Vec<f64>) -> Vec<Vec<f64>>;
}

/// One process that does everything.
#[derive(Debug, Clone, Copy, Default)]
pub struct Alone;

impl Ranks for Alone {
    fn number(&self) -> usize {
        0
    }

    fn count(&self) -> usize {
        1
    }

    fn exchange(&self, lists: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        lists
    }

    fn gather(&self, list: Vec<f64>) -> Vec<Vec<f64>> {
        vec![list]
    }
}

/// The failure of one rank, which ends the work of all.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("rank {rank}: {reason}")]
pub struct RankFailed {
    /// The number of the rank.
    pub rank: usize,
    /// The reason.
    pub reason: String,
}

/// The failure of the first rank that has a reason, known to all when all have asked.
pub fn failure(ranks: &dyn Ranks, reason: Option<&str>) -> Option<RankFailed> {
    let told = gather_texts(ranks, reason).into_iter().enumerate();
    let mut failures =
        told.filter_map(|(rank, reason)| reason.map(|reason| RankFailed { rank, reason }));
    failures.next()
}

/// The texts that ranks have to tell, in their order, known to all when all have told theirs.
pub(crate) fn gather_texts(ranks: &dyn Ranks, text: Option<&str>) -> Vec<Option<String>> {
    let letters = |text: &str| text.bytes().map(f64::from).collect::<Vec<_>>();
    // an empty text is one, too
    let told = text.map(|text| [vec![0.0], letters(text)].concat());
    let all = ranks.gather(told.unwrap_or_default());
    let text = |numbers: Vec<f64>| {
        let (_, letters) = numbers.split_first()?;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "bytes, as they were sent"
        )]
        let bytes: Vec<u8> = letters.iter().map(|letter| *letter as u8).collect();
        Some(String::from_utf8_lossy(&bytes).into_owned())
    };
    all.into_iter().map(text).collect()
}

/// A result on which all ranks agree: an error if one of them has one.
pub(crate) fn agreed<T, E: fmt::Display + From<RankFailed>>(
    ranks: &dyn Ranks,
    result: Result<T, E>,
) -> Result<T, E> {
    if ranks.count() == 1 {
        return result;
    }
    let reason = result.as_ref().err().map(ToString::to_string);
    match failure(ranks, reason.as_deref()) {
        // what all refuse for the same reason keeps its error
        Some(failed) if reason.as_ref() != Some(&failed.reason) => Err(failed.into()),
        _ => result,
    }
}

/// Some places, and what a part of a pass brings to each of them.
pub(crate) type Brought<'n> = (Range<usize>, &'n [f64]);

/// The parts of a pass, dealt out to ranks, and the places that they bring sums to.
#[derive(Clone, Copy)]
pub(crate) struct Deal<'r> {
    ranks: &'r dyn Ranks,
    places: usize,
}

impl<'r> Deal<'r> {
    /// A pass that brings sums to so many places.
    pub(crate) fn new(ranks: &'r dyn Ranks, places: usize) -> Self {
        Self { ranks, places }
    }

    /// The number of places.
    pub(crate) const fn places(&self) -> usize {
        self.places
    }

    /// The ranks.
    pub(crate) const fn ranks(&self) -> &'r dyn Ranks {
        self.ranks
    }

    /// The parts of this rank among consecutive ones.
    pub(crate) fn own_parts(&self, parts: Range<usize>) -> impl Iterator<Item = usize> + use<> {
        let (number, count) = (self.ranks.number(), self.ranks.count());
        parts.filter(move |part| part % count == number)
    }

    /// The places whose sums a rank adds up.
    fn places_of(&self, rank: usize) -> Range<usize> {
        let start = |rank: usize| self.places * rank / self.ranks.count();
        start(rank)..start(rank + 1)
    }

    /// The places whose sums this rank adds up.
    pub(crate) fn own_places(&self) -> Range<usize> {
        self.places_of(self.ranks.number())
    }

    /// Hands what consecutive parts bring to those whose places they are, and adds what comes to
    /// this rank's places, in the order of the parts.
    ///
    /// **Arguments** `width`: the numbers a place; `shape`: the ranges of places that a part brings
    /// something to; `own`: the numbers for each of these ranges, of this rank's parts; `add`:
    /// takes what one part brings, places and the numbers for them.
    pub(crate) fn deliver(
        &self,
        parts: Range<usize>,
        width: usize,
        shape: &dyn Fn(usize) -> Vec<Range<usize>>,
        own: &[Vec<&[f64]>],
        add: &mut dyn FnMut(&[Brought<'_>]),
    ) {
        if self.ranks.count() == 1 {
            for (part, numbers) in parts.zip(own) {
                let brought = shape(part).into_iter().zip(numbers.iter().copied());
                add(&brought.collect::<Vec<_>>());
            }
            return;
        }
        let to_rank = |rank: usize| {
            let places = self.places_of(rank);
            let mut list = Vec::new();
            for (part, numbers) in self.own_parts(parts.clone()).zip(own) {
                for (whole, numbers) in shape(part).into_iter().zip(numbers) {
                    let met = common(&whole, &places);
                    let [start, end] = [met.start, met.end].map(|at| (at - whole.start) * width);
                    list.extend_from_slice(&numbers[start..end]);
                }
            }
            list
        };
        let lists = (0..self.ranks.count()).map(to_rank).collect();
        let came = self.ranks.exchange(lists);
        let mut read = vec![0; came.len()];
        for part in parts {
            let from = part % self.ranks.count();
            let brought = shape(part).into_iter().map(|whole| {
                let places = common(&whole, &self.own_places());
                let start = read[from];
                read[from] += places.len() * width;
                (places, &came[from][start..read[from]])
            });
            add(&brought.collect::<Vec<_>>());
        }
    }

    /// Gives all ranks what each has of consecutive parts, so many numbers a part, in the order of
    /// the parts.
    pub(crate) fn share(
        &self,
        parts: Range<usize>,
        width: usize,
        own: Vec<f64>,
        take: &mut dyn FnMut(&[f64]),
    ) {
        let all = self.ranks.gather(own);
        let mut read = vec![0; all.len()];
        for part in parts {
            let from = part % self.ranks.count();
            take(&all[from][read[from]..read[from] + width]);
            read[from] += width;
        }
    }

    /// Gives all ranks several lists of a number for each place, from what each rank has of one
    /// after the other for its own places.
    pub(crate) fn complete_each<const P: usize>(&self, own: Vec<f64>) -> [Vec<f64>; P] {
        let all = self.ranks.gather(own);
        std::array::from_fn(|list| {
            let of_rank = |(rank, numbers): (usize, &Vec<f64>)| {
                let places = self.places_of(rank).len();
                numbers[list * places..(list + 1) * places].to_vec()
            };
            all.iter().enumerate().flat_map(of_rank).collect()
        })
    }

    /// Gives all ranks the numbers of all places, from those of each one's own.
    pub(crate) fn complete(&self, own: Vec<f64>) -> Vec<f64> {
        self.ranks.gather(own).concat()
    }
}

/// The places in both ranges; an empty range inside of the first, if there are none.
fn common(whole: &Range<usize>, part: &Range<usize>) -> Range<usize> {
    let start = part.start.clamp(whole.start, whole.end);
    start..part.end.clamp(start, whole.end)
}

/// The ranks that share out the passes of a scene's pairs.
#[derive(Clone, Copy)]
pub(crate) struct Team<'p>(pub(crate) &'p dyn Ranks);

impl fmt::Debug for Team<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "rank {} of {}", self.0.number(), self.0.count())
    }
}
