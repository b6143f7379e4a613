//! Written scenes read back to the same bits.

use glam::DVec3;
use infoscene::geometry::Patch;
use infoscene::scene::files::{
    NonPlanarFaces, Source, read_obj, read_view3d, write_obj, write_view3d,
};
use infoscene::scene::{Channels, Material, NamedPatch, Scene};
use proptest::prelude::*;

/// A reflectance, often 0, next to 0 or next to 1.
fn reflectance() -> impl Strategy<Value = f64> {
    prop_oneof![
        0.0..1.0f64,
        (-300.0..0.0f64).prop_map(|exponent| 0.999 * 10f64.powf(exponent)),
        prop_oneof![
            Just(0.0),
            Just(0.1),
            Just(0.747),
            Just(5e-324),
            Just(1.0 - 0.5 * f64::EPSILON)
        ],
    ]
}

fn emittance() -> impl Strategy<Value = f64> {
    prop_oneof![
        0.0..10.0f64,
        (-300.0..300.0f64).prop_map(|exponent| 10f64.powf(exponent)),
        prop_oneof![Just(0.0), Just(-0.0), Just(f64::MAX), Just(5e-324)],
    ]
}

/// A polygon with corners around a point of an axis plane, or a free triangle; small, large and far
/// away.
fn patch(corners: std::ops::Range<usize>) -> impl Strategy<Value = Patch> {
    let place = prop_oneof![-1.0..1.0f64, Just(0.0), Just(-0.0), Just(0.1)];
    let turns = proptest::collection::vec((0.5..1.0f64, 0.9..1.0f64), corners);
    let frame = (0..3usize, -20..20i32, [place.clone(), place.clone(), place]);
    (turns, frame).prop_map(|(turns, (axis, scale, centre))| {
        let whole: f64 = turns.iter().map(|(turn, _)| turn).sum();
        let scale = 10f64.powi(scale);
        let mut angle = 0.0;
        let corners = turns.into_iter().map(|(turn, radius)| {
            angle += turn / whole * std::f64::consts::TAU;
            let flat = [radius * f64::cos(angle), radius * f64::sin(angle)];
            let mut corner = centre;
            corner[(axis + 1) % 3] += flat[0];
            corner[(axis + 2) % 3] += flat[1];
            DVec3::from_array(corner.map(|x| scale * x))
        });
        Patch::try_new(corners.collect()).unwrap()
    })
}

/// Every coordinate and material, bit for bit (`-0.0` and `0.0` are equal as numbers only).
fn bits(patches: &[NamedPatch]) -> Vec<u64> {
    let numbers = patches.iter().flat_map(|patch| {
        let corners = patch
            .shape()
            .corners()
            .iter()
            .flat_map(|corner| corner.to_array());
        let material = patch.material();
        let material = [
            material.reflectance().unwrap(),
            material.emittance().unwrap(),
        ];
        let material = material.map(|channels| [channels.r, channels.g, channels.b]);
        corners
            .chain(material.concat())
            .map(f64::to_bits)
            .collect::<Vec<_>>()
    });
    numbers.collect()
}

fn read_back_obj(scene: &Scene) -> Scene {
    let written = write_obj(scene, "room.mtl").unwrap();
    let library = |name: &str| {
        assert_eq!(name, "room.mtl");
        Ok(Source::new(name, written.mtl.as_str()))
    };
    let source = Source::new("room.obj", written.obj.as_str());
    read_obj(&source, &library, NonPlanarFaces::Refuse)
        .unwrap()
        .scene
}

fn read_back_vs3(scene: &Scene) -> Scene {
    let written = write_view3d(scene).unwrap();
    read_view3d(&Source::new("room.vs3", written), NonPlanarFaces::Refuse)
        .unwrap()
        .scene
}

proptest! {
    #[test]
    fn wavefront_reads_back(
        patches in proptest::collection::vec(
            (patch(3..9), [(); 3].map(|()| (reflectance(), emittance())), 0..3usize),
            1..8,
        ),
    ) {
        let mut counts = [0; 3];
        let patches = patches
            .into_iter()
            .map(|(shape, channels, name)| {
                let label = ["floor", "side wall", "a # 1"][name];
                counts[name] += 1;
                let name = format!("{label} {}", counts[name] - 1);
                let [r, g, b] = channels
                    .map(|(reflectance, emittance)| Material::try_new(reflectance, emittance))
                    .map(Result::unwrap);
                let patch = NamedPatch::new(name, shape).with_material(Channels { r, g, b });
                patch.with_wholes([label.to_owned()].into())
            });
        let scene = Scene::try_new(patches.collect()).unwrap();
        let back = read_back_obj(&scene);
        prop_assert_eq!(bits(back.patches()), bits(scene.patches()));
        prop_assert_eq!(back, scene);
    }

    #[test]
    fn view3d_reads_back(
        patches in proptest::collection::vec((patch(3..5), reflectance(), 0..4usize), 1..8),
        obstructions in proptest::collection::vec(patch(3..5), 0..3),
    ) {
        let rows: Vec<usize> = patches.iter().map(|(.., row)| *row).collect();
        let patches = patches.into_iter().map(|(shape, reflectance, row)| {
            let material = Material::try_new(reflectance, 0.0).unwrap();
            NamedPatch::new(format!("of row/{row}"), shape).with_material(material)
        });
        let scene = Scene::try_new(patches.collect())
            .unwrap()
            .with_groups(&rows)
            .unwrap();
        let fins = obstructions
            .into_iter()
            .map(|shape| NamedPatch::new("fin".to_owned(), shape));
        let scene = scene.with_obstructions(fins.collect());
        let back = read_back_vs3(&scene);
        prop_assert_eq!(bits(back.patches()), bits(scene.patches()));
        prop_assert_eq!(bits(back.obstructions()), bits(scene.obstructions()));
        prop_assert_eq!(back, scene);
    }
}

#[test]
fn built_in_scenes_and_bases_read_back() {
    for name in ["two-squares", "cube:3", "cornell-box"] {
        let scene = Scene::built_in(name).unwrap();
        assert_eq!(
            bits(read_back_obj(&scene).patches()),
            bits(scene.patches()),
            "{name}"
        );
    }
    // names that come from a file come back
    let scene = Scene::built_in("cornell-box").unwrap();
    assert_eq!(read_back_obj(&scene), scene);
    let square =
        Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y]).unwrap();
    let half = Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::Y]).unwrap();
    let patches = [half, square].map(|shape| NamedPatch::new("a".to_owned(), shape));
    let scene = Scene::try_new(patches.to_vec())
        .unwrap()
        .with_base(0, 1)
        .unwrap();
    assert_eq!(read_back_vs3(&scene), scene);
}

/// Names are made fit for the format, and nothing but the names changes.
#[test]
fn odd_names_do_not_spoil_a_file() {
    let shape = Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::Y]).unwrap();
    let names = [
        "",
        " ",
        "a\nf 1 2 3",
        "# none",
        "b \\",
        "/ c ! d",
        "0",
        "x 0",
        "\u{2028}",
    ];
    let patches = names.map(|name| NamedPatch::new(name.to_owned(), shape.clone()));
    let scene = Scene::try_new(patches.to_vec()).unwrap();
    assert_eq!(bits(read_back_obj(&scene).patches()), bits(scene.patches()));
    assert_eq!(bits(read_back_vs3(&scene).patches()), bits(scene.patches()));
}

#[test]
fn what_a_format_cannot_say_is_refused() {
    let room = Scene::built_in("cornell-box").unwrap();
    for library in ["", " ", "a#.mtl", "a\\", "a\nb", " a"] {
        let refusal = write_obj(&room, library).unwrap_err().to_string();
        assert!(refusal.contains("choose a name"), "{refusal}");
    }
    let refusal = write_view3d(&room).unwrap_err().to_string();
    assert!(
        refusal.contains("patch 1 (light 0) emits light"),
        "{refusal}"
    );
    let summed = room.clone().with_groups(&[0; 11]).unwrap();
    let fin = room.patches()[..1].to_vec();
    let square =
        Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y]).unwrap();
    let half = Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::Y]).unwrap();
    let parts = [half, square].map(|shape| NamedPatch::new("a".to_owned(), shape));
    let part = Scene::try_new(parts.to_vec())
        .unwrap()
        .with_base(0, 1)
        .unwrap();
    for (scene, says) in [
        (summed, "summed into one row"),
        (room.with_obstructions(fin), "only obstructs"),
        (part, "patch 0 lies in another one"),
    ] {
        let refusal = write_obj(&scene, "a.mtl").unwrap_err();
        assert_eq!(refusal.format, "Wavefront OBJ");
        assert!(refusal.to_string().contains(says), "{refusal}");
    }
    let corners = (0..5).map(|k| f64::from(k) * std::f64::consts::TAU / 5.0);
    let corners = corners.map(|angle| DVec3::new(angle.cos(), angle.sin(), 0.0));
    let pentagon = Patch::try_new(corners.collect()).unwrap();
    let scene = Scene::try_new(vec![NamedPatch::new("p".to_owned(), pentagon)]).unwrap();
    let refusal = write_view3d(&scene).unwrap_err().to_string();
    assert!(refusal.contains("patch 0 (p) has 5 corners"), "{refusal}");
}
