use glam::DVec3;
use infoscene::form_factor::*;
use infoscene::geometry::Patch;
fn pts(s: &str) -> Vec<DVec3> {
    s.split(' ')
        .map(|c| {
            let v: Vec<f64> = c.split(',').map(|x| x.parse().unwrap()).collect();
            DVec3::new(v[0], v[1], v[2])
        })
        .collect()
}
#[test]
fn rows() {
    for l in std::fs::read_to_string("/tmp/ff.txt").unwrap().lines() {
        let f: Vec<&str> = l.split('|').collect();
        let (p, q) = (Patch::try_new(pts(f[1])), Patch::try_new(pts(f[2])));
        let (p, q) = match (p, q) {
            (Ok(p), Ok(q)) => (Polygon::new(&p), Polygon::new(&q)),
            (a, b) => {
                println!("{} {:?} {:?}", f[0], a.err(), b.err());
                continue;
            }
        };
        let x: f64 = f[3].parse().unwrap();
        let t = std::time::Instant::now();
        let mut r = p.exchange_area(&q, 1e-12);
        for _ in 0..100 {
            r = p.exchange_area(&q, 1e-12);
        }
        let t = t.elapsed().as_secs_f64() / 101.0 * 1e6;
        match r {
            Ok(a) => {
                let v = a.exchange.value;
                println!(
                    "{:28} {:.3e} err {:.1e} bound {:.1e} {} {:.2}us {}",
                    f[0],
                    x,
                    (v - x).abs() / x,
                    a.exchange.error_bound / x,
                    a.route.name(),
                    t,
                    if (v - x).abs() > a.exchange.error_bound + 2e-16 * x {
                        "VIOLATION"
                    } else {
                        ""
                    }
                )
            }
            Err(e) => println!("{} {e}", f[0]),
        }
    }
}
use rand::{Rng, SeedableRng};
#[test]
fn ratios() {
    let mut r = rand_chacha::ChaCha8Rng::seed_from_u64(5);
    for (n, d) in [(3, 2.5), (4, 2.5), (4, 1.6), (4, 8.0), (4, 30.0)] {
        let mut stats = std::collections::BTreeMap::<&str, Vec<(f64, f64)>>::new();
        let mut mkp = || {
            // dyadic planar: triangles, quads as parallelograms on dyadic coords
            let mut p = |r: &mut rand_chacha::ChaCha8Rng| {
                let mut v = || {
                    DVec3::new(
                        r.random_range(-512..512) as f64,
                        r.random_range(-512..512) as f64,
                        r.random_range(-512..512) as f64,
                    ) / 1024.0
                };
                (v(), v(), v())
            };
            let (a, b, c) = p(&mut r);
            let (e, f, g) = p(&mut r);
            let dir = DVec3::new(1.0, 0.5, 0.25) * d / 1.15;
            let dir = (dir * 1024.0).round() / 1024.0;
            let mk = |o: DVec3, u: DVec3, v: DVec3| {
                if n == 3 {
                    vec![o, o + u, o + v]
                } else {
                    vec![o, o + u, o + u + v, o + v]
                }
            };
            (
                Patch::try_new(mk(a, b, c)).ok(),
                Patch::try_new(mk(dir + e, f, g)).ok(),
            )
        };
        for _ in 0..400 {
            let (Some(p), Some(q)) = mkp() else { continue };
            let (p, q) = (Polygon::new(&p), Polygon::new(&q));
            let Ok(t) = p.exchange_area_by(Route::DoubleDouble, &q, 1e-16) else {
                continue;
            };
            let x = t.exchange.value;
            if x <= 0.0 || t.exchange.error_bound > 1e-14 * x {
                continue;
            }
            for route in [Route::Contour, Route::PointToPolygon, Route::Kernel] {
                if let Ok(a) = p.exchange_area_by(route, &q, 1e-12) {
                    let err = (a.exchange.value - x).abs();
                    if err > a.exchange.error_bound {
                        println!(
                            "VIOLATION {route:?} {x} {err:e} {:e}",
                            a.exchange.error_bound
                        )
                    }
                    stats
                        .entry(route.name())
                        .or_default()
                        .push((err / x, a.exchange.error_bound / x));
                }
            }
            let a = p.exchange_area(&q, 1e-12).unwrap();
            stats
                .entry(match a.route {
                    Route::Contour => "z contour",
                    Route::PointToPolygon => "z p2p",
                    Route::Kernel => "z kernel",
                    _ => "z other",
                })
                .or_default()
                .push(((a.exchange.value - x).abs() / x, a.exchange.error_bound / x));
        }
        println!("n {n} d {d}");
        for (k, v) in stats {
            let m = |f: &dyn Fn(&(f64, f64)) -> f64| {
                let mut w: Vec<f64> = v.iter().map(|x| f(x).log10()).collect();
                w.sort_by(f64::total_cmp);
                (w[w.len() / 2], w[w.len() * 9 / 10])
            };
            println!(
                "  {k:18} {} log10 err {:.1?} bound {:.1?}",
                v.len(),
                m(&|x| x.0),
                m(&|x| x.1)
            );
        }
    }
}
#[test]
fn prof() {
    let f = |v: &[(f64, f64, f64)]| {
        let m = glam::DMat3::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
        Polygon::new(
            &Patch::try_new(v.iter().map(|c| m * DVec3::new(c.0, c.1, c.2)).collect()).unwrap(),
        )
    };
    let a = f(&[
        (0.0, 0.0, 0.0),
        (1.0, 0.0, 0.0),
        (1.0, 1.0, 0.0),
        (0.0, 1.0, 0.0),
    ]);
    let b = f(&[
        (0.0, 0.0, 0.0),
        (0.0, 1.0, 0.0),
        (0.7, 1.0, 0.9),
        (0.7, 0.0, 0.9),
    ]);
    println!("{:?}", a.exchange_area(&b, 1e-12));
    for _ in 0..2_000_000 {
        std::hint::black_box(a.exchange_area(std::hint::black_box(&b), 1e-12)).ok();
    }
}
#[test]
fn prof2() {
    let f = |v: &[(f64, f64, f64)]| {
        Polygon::new(
            &Patch::try_new(v.iter().map(|c| DVec3::new(c.0, c.1, c.2)).collect()).unwrap(),
        )
    };
    let a = f(&[
        (0.0, 0.0, 0.0),
        (1.0, 0.0, 0.0),
        (1.0, 1.0, 0.0),
        (0.0, 1.0, 0.0),
    ]);
    let b = f(&[
        (0.25, 0.0, 1.0),
        (0.25, 1.0, 1.0),
        (2.0, 1.0, 1.0),
        (2.0, 0.0, 1.0),
    ]);
    println!("{:?}", a.exchange_area(&b, 1e-12));
    for _ in 0..5_000_000 {
        std::hint::black_box(a.exchange_area(std::hint::black_box(&b), 1e-12)).ok();
    }
}
