#![allow(missing_docs)]
use infoscene::discretize::*;
use std::time::Instant;
fn main() {
    let arg: Vec<String> = std::env::args().collect();
    for (e, n) in [
        ([1.0; 3], 1),
        ([1.0; 3], 2),
        ([1.0; 3], 3),
        ([1.0; 3], 4),
        ([1.0; 3], 6),
        ([1.0; 3], 8),
        ([1.0; 3], 32),
        ([1.0; 3], 64),
        ([1.0, 1.0, 1000.], 8),
        ([1.0, 1.0, 1e-3], 8),
        ([1.0, 1.0, 1e6], 8),
        ([1.0, 1.0, 1e6], 64),
        ([1.0, 2.0, 3.0], 64),
        ([1.0, 1.0, 1e-3], 64),
    ] {
        let t = Instant::now();
        let i = BoxGrid::regular(e, n).unwrap().information();
        println!("{e:?} {n}: {i:?} {:?}", t.elapsed());
    }
    let n: usize = arg.get(1).map_or(8, |s| s.parse().unwrap());
    for e in [
        [1.0; 3],
        [1.0, 2.0, 3.0],
        [1.0, 1.0, 1000.0],
        [1., 1., 0.001],
    ] {
        let t = Instant::now();
        match BestGrid::find(e, n as u32) {
            Ok(b) => println!(
                "best {e:?} {:?} {:?} slope {:e} curv {:?} err {:e} {:?} {:?}",
                b.grid.lines(),
                b.information,
                b.slope,
                b.curvature,
                b.line_error,
                b.search,
                t.elapsed()
            ),
            Err(x) => println!("{x} {:?}", t.elapsed()),
        }
    }
}
