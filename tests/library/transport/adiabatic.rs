//! Walls that absorb nothing: solved where light ends elsewhere, refused where it ends nowhere.

use super::{closed_scenes, radiosity, uneven};
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::numeric::Symmetric;
use infoscene::scene::{Material, NamedPatch, Occlusion, Scene};
use infoscene::study::light::stability::{StiffScene, exact_radiosities, worst_error};
use infoscene::transport::walks::Steering;
use infoscene::transport::{DenseExchange, ExchangeRows, RadiositySystem, TransportError};
use nalgebra::{DMatrix, dmatrix};

/// One black patch with E = 1 among walls with R = 1: `B = 1` everywhere.
#[test]
fn adiabatic_walls_take_the_brightness_of_the_light() {
    for (name, scene) in closed_scenes() {
        let exchange = scene.exchange_areas().unwrap();
        let n = exchange.rows();
        let of_first = |first: f64, other: f64| -> Vec<f64> {
            (0..n).map(|i| if i == 0 { first } else { other }).collect()
        };
        let found = radiosity(&exchange, &of_first(0.0, 1.0), &of_first(1.0, 0.0));
        assert!(found.relative_error < 1e-15, "{name}");
        for (patch, value) in found.values.iter().enumerate() {
            let error = (value - 1.0).abs();
            assert!(error <= found.relative_error, "{name}, {patch}: {error:e}");
        }
    }
}

/// Two parallel plates of which one reflects all: `B₁ = B₂ = E₁/(1 − R₁)`; both emit the more.
#[test]
fn a_plate_that_absorbs_nothing_is_as_bright_as_the_other() {
    let plates = RadiositySystem::of_matrix(&dmatrix![0.0, 2.0; 2.0, 0.0], vec![0.75, 1.0]);
    let plates = plates.unwrap();
    assert_eq!(plates.radiosity(&[1.0, 0.0]).unwrap().values, [4.0, 4.0]);
    // B₁ = R₁ B₂ and B₂ = 1 + B₁
    assert_eq!(plates.radiosity(&[0.0, 1.0]).unwrap().values, [3.0, 4.0]);
    // the plate that is looked at sees all that ends in it: I₁ = 1/(1 − R₁), I₂ = R₁ I₁
    let importance = plates.importance(&[1.0, 0.0]).unwrap();
    assert_eq!(importance.values, [4.0, 3.0]);
}

/// Two surfaces and a reradiating third one, by the network of resistances.
///
/// ```text
///   q₁ = (E_b1 − E_b2)/( (1−ε₁)/(ε₁A₁) + 1/(A₁F₁₂ + 1/(1/(A₁F₁R) + 1/(A₂F₂R))) + (1−ε₂)/(ε₂A₂) )
/// ```
///
/// Incropera, DeWitt, *Fundamentals of Heat and Mass Transfer*, §13.3.5, with E = ε E_b, R = 1 − ε.
#[test]
fn a_reradiating_wall_is_a_node_of_the_network() {
    // areas 1, 2 and 4: J₁₂ = 0.3, J₁R = 0.7, J₂R = 1.7, J_RR = 1.6
    let exchange = dmatrix![0.0, 0.3, 0.7; 0.3, 0.0, 1.7; 0.7, 1.7, 1.6];
    let ([e1, e2], [b1, b2]) = ([0.8, 0.4], [10.0, 1.0]);
    let around = 1.0 / (1.0 / 0.7 + 1.0 / 1.7);
    let surfaces = [(1.0 - e1) / e1, (1.0 - e2) / (e2 * 2.0)];
    let heat = (b1 - b2) / (surfaces[0] + 1.0 / (0.3 + around) + surfaces[1]);
    let (first, second) = (b1 - heat * surfaces[0], b2 + heat * surfaces[1]);
    let third = (0.7 * first + 1.7 * second) / (0.7 + 1.7);
    let room = RadiositySystem::of_matrix(&exchange, vec![1.0 - e1, 1.0 - e2, 1.0]).unwrap();
    let found = room.radiosity(&[e1 * b1, e2 * b2, 0.0]).unwrap();
    for (value, exact) in found.values.iter().zip([first, second, third]) {
        assert!((value / exact - 1.0).abs() < 1e-14, "{value} {exact}");
    }
}

fn facing_squares() -> Scene {
    let corners = |z: f64, turned: bool| {
        let mut corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        if turned {
            corners.reverse();
        }
        let corners = corners.map(|[x, y]| glam::DVec3::new(x, y, z));
        infoscene::Patch::try_new(corners.to_vec()).unwrap()
    };
    let patch = |name: &str, shape| NamedPatch::new(name.to_owned(), shape);
    let patches = vec![
        patch("floor", corners(0.0, false)),
        patch("ceiling", corners(1.0, true)),
    ];
    Scene::try_new(patches).unwrap()
}

/// What escapes is a sink: unit squares at distance 1, of which both reflect all.
#[test]
fn an_opening_is_a_sink() {
    // parallel unit squares at distance 1, analytic
    let form_factor = 0.199_824_895_698_387_38;
    let exchange = facing_squares().exchange_areas().unwrap();
    let found = radiosity(&exchange, &[1.0, 1.0], &[0.0, 1.0]);
    let ceiling = 1.0 / (1.0 - form_factor * form_factor);
    for (value, exact) in found.values.iter().zip([form_factor * ceiling, ceiling]) {
        assert!((value / exact - 1.0).abs() < 1e-13, "{value} {exact}");
    }
}

/// Rooms with walls of any reflectance up to 1, against enclosures of 256 bits.
#[test]
fn the_bound_holds_where_some_walls_absorb_nothing() {
    let cube = Scene::built_in("cube:2").unwrap();
    let cube = cube.exchange_areas().unwrap().into_values();
    for salt in 0..6 {
        let absorbed = 10f64.powi(-3 * salt);
        let reflectance = |patch: usize| match (patch + salt as usize) % 4 {
            0 => 1.0 - absorbed * (0.2 + 0.8 * uneven(patch, 3)),
            1 if salt % 2 == 0 => uneven(patch, 4),
            _ => 1.0,
        };
        let scene = StiffScene {
            name: format!("cube {salt}"),
            exchange: cube.clone(),
            reflectances: (0..24).map(reflectance).collect(),
            emittances: (0..24).map(|patch| uneven(patch, salt as usize)).collect(),
        };
        let exact = exact_radiosities(&scene, 256).unwrap();
        let room = RadiositySystem::of_matrix(&scene.exchange, scene.reflectances).unwrap();
        let found = room.radiosity(&scene.emittances).unwrap();
        let error = worst_error(&found.values, &exact);
        let bound = found.relative_error;
        assert!(
            error <= bound && bound < 1e-15,
            "{salt}: {error:e} {bound:e}"
        );
    }
}

/// Two closed rooms: the patches of the one that has no sink are named, and no others.
#[test]
fn a_room_without_a_sink_is_refused_by_name() {
    let cube = Scene::built_in("cube:1").unwrap().exchange_areas().unwrap();
    let matrix = cube.clone().into_values();
    let both = DMatrix::from_fn(12, 12, |i, j| {
        let is_one_room = (i < 6) == (j < 6);
        f64::from(is_one_room) * matrix[(i % 6, j % 6)]
    });
    let with = |absorbers: &[usize]| {
        let reflectance = |patch| f64::from(!absorbers.contains(&patch));
        RadiositySystem::of_matrix(&both, (0..12).map(reflectance).collect())
    };
    assert!(with(&[3, 7]).is_ok());
    let none: &[usize] = &[];
    for (absorbers, expected) in [(&[3][..], 6..12), (&[7], 0..6), (none, 0..6)] {
        let refusal = with(absorbers).unwrap_err();
        let TransportError::NoSink { group } = refusal else {
            panic!("{refusal}");
        };
        assert_eq!(group.patches, expected.collect::<Vec<_>>());
    }
    let many = with(&[3]).unwrap_err().to_string();
    assert!(many.starts_with("patches 6, 7, 8, 9, 10, 11: "), "{many}");
    let white = [Material::try_new(1.0, 0.0).unwrap(); 6];
    let named = RadiositySystem::of(&cube, &white).unwrap_err().to_string();
    assert!(named.contains("0 (floor 0,0), 1 (ceiling 0,0)"), "{named}");
    // a patch that sees itself alone, as a summed row may
    let alone = RadiositySystem::of_matrix(&dmatrix![1.0], vec![1.0]).unwrap_err();
    assert!(alone.to_string().starts_with("patch 0: "), "{alone}");
}

/// Exchange that may be 0 is no way to a sink; what certainly exchanges is one.
#[test]
fn a_sink_must_be_certain() {
    let exchange = Symmetric::filled(2, 1e-9);
    let with = |bound: f64| {
        let errors = Symmetric::filled(2, bound);
        let rows = ExchangeRows {
            own: vec![1.0; 2],
            own_bounds: vec![0.0; 2],
            open_areas: vec![None; 2],
        };
        let exchange = DenseExchange::from(exchange.clone());
        let errors = DenseExchange::from(errors);
        RadiositySystem::try_new(exchange, Some(errors), rows, vec![0.5, 1.0])
    };
    assert!(with(0.9e-9).is_ok());
    assert!(matches!(with(1e-9), Err(TransportError::NoSink { group }) if group.patches == [1]));
    let opening = |area: f64| {
        let rows = ExchangeRows {
            own: vec![0.0; 2],
            own_bounds: vec![1e-10; 2],
            open_areas: vec![Some(area); 2],
        };
        let exchange = DenseExchange::from(exchange.clone());
        RadiositySystem::try_new(exchange, None, rows, vec![1.0, 1.0])
    };
    assert!(opening(1.2e-9).is_ok());
    assert!(opening(1.05e-9).is_err());
}

/// Form factors asked for 1e-4 only: their bound holds for the adiabatic walls of a lit room.
#[test]
fn form_factor_errors_of_adiabatic_rooms_stay_within_their_bound() {
    let scene = Scene::built_in("cornell-box").unwrap();
    let n = scene.patches().len();
    let reflectances: Vec<f64> = (0..n).map(|i| if i == 1 { 0.3 } else { 1.0 }).collect();
    let emittances: Vec<f64> = (0..n).map(|i| f64::from(i == 4)).collect();
    let solved = |tolerance: f64| {
        let pairs = ScenePairs::try_new(&scene, tolerance, Congruence::Ignored, Occlusion::Refuse);
        radiosity(
            &pairs.unwrap().exchange_areas().unwrap(),
            &reflectances,
            &emittances,
        )
    };
    let (rough, exact) = (solved(1e-4), solved(1e-13));
    let [bounds, exactly] = [&rough, &exact].map(|found| found.form_factor_errors.clone().unwrap());
    for i in 0..n {
        let error = (rough.values[i] - exact.values[i]).abs();
        let bound = bounds[i] + exactly[i] + 1e-15 * exact.values[i];
        assert!(error <= bound, "{i}: {error:e} > {bound:e}");
    }
}

/// A walk that would be cut off gives no estimate: hardly any light ends in this room.
#[test]
fn endless_walks_are_refused() {
    let with = |reflectance: f64| {
        let room = dmatrix![0.0, 1.0; 1.0, 0.0];
        let room = RadiositySystem::of_matrix(&room, vec![1.0, reflectance]).unwrap();
        room.gathering_walks(0, &[1.0, 0.0], Steering::FormFactors, 1, 1)
    };
    assert!(with(0.5).is_ok());
    let refusal = with(1.0 - 1e-9).unwrap_err();
    assert!(
        matches!(refusal, TransportError::EndlessWalk { .. }),
        "{refusal}"
    );
}
