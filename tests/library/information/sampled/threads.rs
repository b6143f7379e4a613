//! A sample is the same for any number of threads.

use super::{scene, slabs};
use infoscene::information::{LineKind, LineSample};
use rayon::ThreadPoolBuilder;

#[test]
fn samples_do_not_depend_on_the_number_of_threads() {
    for (scene, kind) in [
        (scene("cube:3", 0), LineKind::Local),
        (scene("cube:3", 0), LineKind::Global),
        (slabs(2), LineKind::Global),
    ] {
        let samples = [1, 2, 5].map(|threads| {
            let pool = ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            // several chunks, the last of them short
            pool.install(|| LineSample::draw(&scene, kind, 30_001, 9).unwrap())
        });
        assert_eq!(samples[0], samples[1]);
        assert_eq!(samples[0], samples[2]);
        let other = LineSample::draw(&scene, kind, 30_001, 10).unwrap();
        assert_ne!(samples[0].counts, other.counts);
    }
}
