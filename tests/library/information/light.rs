//! The information of light that is summed from pairs as they come, against that of the chain whose
//! matrix is held.

use crate::support::ranks::among;
use infoscene::chain::brightness_chain;
use infoscene::exchange::{
    Alone, Congruence, MatrixStore, Ranks, ScenePairs, Shard, StoredMatrix, Unheard,
};
use infoscene::information::{
    SceneInformation, brightness_information, entropy_rate, mutual_information, positional_entropy,
};
use infoscene::question::{Light, MaterialChanges, Measure, SceneChain, SceneSource};
use infoscene::scene::{Occlusion, Scene};
use infoscene::transport::{RadiositySolution, SceneExchange};

const TREATMENT: (Congruence, Occlusion) = (Congruence::Shared, Occlusion::Exact);

/// A cube of which two patches of different walls make one row, so that it sees itself, and an open
/// room in which blocks stand.
fn scenes() -> [Scene; 2] {
    let labels: Vec<usize> = (0..54).map(|patch| patch.max(1) % 53).collect();
    let cube = Scene::built_in("cube:3").unwrap();
    [
        cube.with_groups(&labels).unwrap(),
        Scene::built_in("cornell-box-blocks").unwrap(),
    ]
}

/// Reflectances from 0 to 0.9, one light, and rows without any light of their own: those that
/// reflect nothing stay dark.
fn lit(exchange: &SceneExchange<'_>) -> RadiositySolution {
    let rows = exchange.areas().len();
    let reflectances = (0..rows).map(|row| [0.0, 0.3, 0.6, 0.9][row % 4]).collect();
    let mut emittances = vec![0.0; rows];
    emittances[1] = 3.0;
    let system = exchange.system(reflectances).unwrap();
    system.radiosity(&emittances).unwrap()
}

/// Entropies agree to the rounding of n² terms, and what each row contributes, too, held, computed
/// again and from a store.
#[test]
fn light_summed_from_pairs_is_that_of_the_chain() {
    for scene in scenes() {
        let pairs = ScenePairs::try_new(&scene, 1e-12, TREATMENT.0, TREATMENT.1).unwrap();
        let exchange = SceneExchange::held(&pairs).unwrap();
        let light = lit(&exchange);
        assert!(light.values.contains(&0.0));
        let chain = brightness_chain(&pairs.exchange_areas().unwrap(), &light.values).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let store = MatrixStore::open(folder.path(), &scene, &pairs, TREATMENT, false).unwrap();
        store.fill(Shard::default()).unwrap();
        let stored = StoredMatrix::open(folder.path(), &scene, &pairs, TREATMENT).unwrap();
        let n = chain.states();
        // sums of n terms of at most one, weights and terms of some roundings
        let rounding = 16.0 * f64::EPSILON * f64::from(u32::try_from(n).unwrap());
        let close = |one: f64, other: f64| (one - other).abs() <= rounding;
        for found in [
            brightness_information(exchange.lower_pairs(), &light),
            brightness_information(&pairs, &light),
            brightness_information(&stored, &light),
        ] {
            let found: SceneInformation = found.unwrap();
            let bits = found.mutual_information;
            assert!(close(bits.value, mutual_information(&chain)));
            assert!(bits.value > 0.1 && bits.error > 0.0 && bits.error < 1e-6);
            assert!(close(found.positional_entropy, positional_entropy(&chain)));
            assert!(close(found.entropy_rate, entropy_rate(&chain)));
            for row in 0..n {
                assert!(close(found.weights[row], chain.stationary_probability(row)));
            }
            let terms = found.contributions.iter().sum::<f64>();
            assert!(close(terms, bits.value));
        }
    }
}

/// Several ranks have the same answer as one, to the last bit, held and from a store.
#[test]
fn ranks_share_out_the_chains_of_light() {
    for scene in scenes() {
        let folder = tempfile::tempdir().unwrap();
        let pairs = ScenePairs::try_new(&scene, 1e-12, TREATMENT.0, TREATMENT.1).unwrap();
        let store = MatrixStore::open(folder.path(), &scene, &pairs, TREATMENT, false).unwrap();
        store.fill(Shard::default()).unwrap();
        let answers = |ranks: &dyn Ranks| {
            let both = [None, Some(folder.path().to_owned())].map(|store| {
                let question = Measure {
                    scene: SceneSource::from(scene.clone()),
                    light: Light {
                        chain: SceneChain::Radiosity,
                        materials: MaterialChanges {
                            reflectance: vec!["all=0.5".parse().unwrap()],
                            emittance: vec!["all=0".parse().unwrap(), "3=1".parse().unwrap()],
                        },
                        ..Light::default()
                    },
                    store,
                    ..Measure::default()
                };
                question.ask_among(ranks, &Unheard).unwrap()
            });
            format!("{both:?}")
        };
        let expected = answers(&Alone);
        for count in [2, 3] {
            assert!(among(count, answers).iter().all(|found| *found == expected));
        }
    }
}
