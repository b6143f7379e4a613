//! Maps over indices on all threads, the module itself: nothing of it is public.

#[path = "../../../src/numeric/parallel.rs"]
mod parallel;

use parallel::{parallel_map, try_parallel_map};
use std::time::Duration;

#[test]
fn answers_stand_in_the_order_of_their_indices() {
    let squares: Vec<usize> = (0..1000).map(|index| index * index).collect();
    assert_eq!(parallel_map(1000, &|index| index * index), squares);
    assert_eq!(
        try_parallel_map(1000, &|index| Ok::<_, ()>(index * index)),
        Ok(squares)
    );
    assert!(parallel_map(0, &|index| index).is_empty());
}

#[test]
fn the_first_error_is_given_whichever_thread_finds_one() {
    let odd_from = |start: usize, index: usize| {
        if index < start {
            // another thread comes upon a later error first
            std::thread::sleep(Duration::from_micros(20));
        }
        if index >= start && index % 2 == 1 {
            Err(index)
        } else {
            Ok(index)
        }
    };
    for _ in 0..5 {
        assert_eq!(
            try_parallel_map(1000, &|index| odd_from(300, index)),
            Err(301)
        );
    }
    assert_eq!(
        try_parallel_map(1000, &|index| odd_from(999, index)),
        Err(999)
    );
}
