//! `mpirun infoscene …`: ranks answer with the bytes of one process, and one that is killed is
//! named.
//!
//! They need Open MPI and a program that was built with the feature `mpi`; the variable
//! `INFOSCENE_PROGRAM` names one that is not cargo's.

use rand::{Rng as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The longest that a test waits for anything.
const PATIENCE: Duration = Duration::from_secs(60);

/// The longest that a job goes on without one of its ranks: some seconds.
const END: Duration = Duration::from_secs(15);

fn program() -> OsString {
    let given = std::env::var_os("INFOSCENE_PROGRAM");
    given.unwrap_or_else(|| assert_cmd::cargo::cargo_bin("infoscene").into_os_string())
}

/// The program on so many ranks; none is the program alone.
fn on_ranks(ranks: usize, arguments: &[&str]) -> Command {
    if ranks == 0 {
        let mut command = Command::new(program());
        command.args(arguments);
        return command;
    }
    let mut command = Command::new("mpirun");
    command
        .args(["--oversubscribe", "-n", &ranks.to_string()])
        .arg(program())
        .args(arguments)
        .env("OMPI_ALLOW_RUN_AS_ROOT", "1")
        .env("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1");
    command
}

fn output(ranks: usize, arguments: &[&str]) -> Output {
    on_ranks(ranks, arguments).output().unwrap()
}

fn stdout(ranks: usize, arguments: &[&str]) -> String {
    let output = output(ranks, arguments);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        output.status.success(),
        "{ranks} ranks: {arguments:?}: {told}"
    );
    String::from_utf8(output.stdout).unwrap()
}

/// All files of a store with their bytes.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if !path.parent().unwrap().ends_with("unfinished") {
                let name = path.strip_prefix(folder).unwrap().to_owned();
                found.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    found
}

const LIGHT: [&str; 4] = ["--reflectance", "all=0.8", "--emittance", "all=0,5=1"];

/// Files, sums and radiosities, held and from the store, of one to three ranks with one and two
/// threads: those of the program alone. Standard output has them once.
#[test]
#[ignore = "needs mpirun: cargo test --features mpi --test command mpirun -- --ignored"]
fn mpirun_gives_the_bytes_of_one_process() {
    let folder = tempfile::tempdir().unwrap();
    let scene = "cube:7";
    let store = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let alone = store("alone");
    stdout(0, &["form-factor", scene, "--store", &alone]);
    let from = ["--store", &alone];
    let questions = [
        [&["measure", scene][..], &[], &[]],
        [&["measure", scene], &from, &[]],
        [&["radiosity", scene], &[], &LIGHT],
        [&["radiosity", scene], &from, &LIGHT],
    ];
    let questions = questions.map(|parts| [&parts.concat()[..], &["--format", "json"]].concat());
    let expected = questions.each_ref().map(|question| stdout(0, question));
    for (ranks, threads) in [(1, "2"), (2, "1"), (3, "1"), (3, "2")] {
        for (question, expected) in questions.iter().zip(&expected) {
            let question = [&question[..], &["--threads", threads]].concat();
            assert!(
                stdout(ranks, &question) == *expected,
                "{ranks} ranks: {question:?}"
            );
        }
        let own = store(&format!("{ranks}-{threads}"));
        let told = stdout(
            ranks,
            &["form-factor", scene, "--store", &own, "--threads", threads],
        );
        // 294 rows in chunks of 64: five along a side
        assert!(
            told.contains("tiles computed") && told.contains("15"),
            "{told}"
        );
        assert!(
            files(Path::new(&own)) == files(Path::new(&alone)),
            "{ranks} ranks"
        );
    }
}

/// A refusal is told once, by the first rank, with the exit status that it has alone; other
/// questions are answered by one rank.
#[test]
#[ignore = "needs mpirun: cargo test --features mpi --test command mpirun -- --ignored"]
fn mpirun_speaks_once() {
    for (arguments, words) in [
        (vec!["measure", "no-such-scene"], "no-such-scene"),
        (
            vec!["measure", "cube:1", "--no-such-flag"],
            "--no-such-flag",
        ),
        (
            vec!["radiosity", "two-squares"],
            "no patch has a positive emittance",
        ),
    ] {
        let [one, several] = [0, 3].map(|ranks| output(ranks, &arguments));
        let told = String::from_utf8(several.stderr).unwrap();
        assert_eq!(one.status.code(), Some(2));
        assert_eq!(several.status.code(), Some(2), "{told}");
        let first = String::from_utf8(one.stderr).unwrap();
        assert!(first.contains(words) && told.contains(&first), "{told}");
        let first_line = first.lines().next().unwrap();
        assert_eq!(told.matches(first_line).count(), 1, "{told}");
    }
    let check = ["check", "cube:2"];
    assert_eq!(stdout(2, &check), stdout(0, &check));
}

/// The process of a rank of a job.
fn process_of(job: &Child, rank: &str) -> Option<u32> {
    let wanted = format!("OMPI_COMM_WORLD_RANK={rank}");
    let processes = fs::read_dir("/proc").unwrap().filter_map(|entry| {
        let name = entry.ok()?.file_name().into_string().ok()?;
        name.parse::<u32>().ok()
    });
    processes.into_iter().find(|process| {
        let read = |file: &str| fs::read(format!("/proc/{process}/{file}")).unwrap_or_default();
        let status = String::from_utf8_lossy(&read("status")).into_owned();
        let is_child = status
            .lines()
            .any(|line| line == format!("PPid:\t{}", job.id()));
        let environment = read("environ");
        let mut names = environment.split(|byte| *byte == 0);
        is_child && names.any(|name| name == wanted.as_bytes())
    })
}

/// Waits until something holds, or the job has ended.
fn wait_until(job: &mut Child, holds: impl Fn(&Child) -> bool) {
    let start = Instant::now();
    while !holds(job) && job.try_wait().unwrap().is_none() {
        assert!(start.elapsed() < PATIENCE, "nothing has happened");
        sleep(Duration::from_millis(5));
    }
}

/// Starts a job, kills a rank when something holds, and returns what `mpirun` says of it; nothing
/// if the job was done before.
fn killed(arguments: &[&str], rank: &str, holds: impl Fn() -> bool) -> Option<String> {
    let mut command = on_ranks(3, arguments);
    let mut job = command
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    wait_until(&mut job, |_| holds());
    let process = process_of(&job, rank)?;
    let end = Instant::now();
    assert!(kill(process).success());
    let output = job.wait_with_output().unwrap();
    assert!(end.elapsed() < END, "the job went on");
    if output.status.success() {
        return None;
    }
    Some(String::from_utf8_lossy(&output.stderr).into_owned())
}

/// A rank that is killed ends the job, and is named; a restart with another number of ranks
/// finishes to the bytes of a run that nothing has stopped: of a store, and of radiosities over it.
#[test]
#[ignore = "needs mpirun: cargo test --features mpi --test command mpirun -- --ignored"]
fn mpirun_goes_on_after_a_rank_was_killed() {
    let folder = tempfile::tempdir().unwrap();
    let [alone, own] = ["alone", "own"].map(|name| folder.path().join(name));
    let [alone_name, own_name] = [&alone, &own].map(|path| path.to_str().unwrap());
    let fill = |name| {
        [
            "form-factor",
            "cube:8",
            "--every-pair",
            "--store",
            name,
            "--resume",
        ]
    };
    stdout(0, &fill(alone_name));
    let chunks = own.join("form_factors/c");
    let told = killed(&fill(own_name), "1", || chunks.exists());
    let told = told.expect("a store is not filled before its second chunk is there");
    assert!(told.contains("rank 1 "), "{told}");
    let left = files(&own).len();
    assert!(left < files(&alone).len(), "{left} files");
    stdout(2, &fill(own_name));
    assert!(files(&own) == files(&alone));

    let question = [
        "radiosity",
        "cube:8",
        "--every-pair",
        "--format",
        "json",
        "--resume",
    ];
    let over = |store| [&question[..], &LIGHT[..], &["--store", store]].concat();
    let expected = stdout(0, &over(alone_name));
    let products = own.join("form_factors/products");
    let kept = || fs::read_dir(&products).map_or(0, Iterator::count);
    for (rank, wanted) in [("2", 3), ("0", 9)] {
        // a solution that is faster than its killer has answered
        drop(killed(&over(own_name), rank, || kept() >= wanted));
    }
    assert!(stdout(2, &over(own_name)) == expected);
    assert!(files(&own) == files(&alone));
}

/// Jobs that are killed in a series of each kind.
const KILLS: usize = 25;

/// Starts a job on so many ranks, none for the program alone, and kills it, or one of its ranks, at
/// a random moment of the time that it takes; whether it was still running.
fn killed_at_random(random: &mut ChaCha8Rng, arguments: &[&str], most: Duration) -> bool {
    let ranks = random.random_range(0..=3);
    let mut job = on_ranks(ranks, arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    if ranks > 0 {
        // mpirun takes a moment of its own
        wait_until(&mut job, |job| process_of(job, "0").is_some());
    }
    sleep(most.mul_f64(random.random_range(0.0..1.0)));
    let process = match ranks {
        0 => Some(job.id()),
        _ => process_of(&job, &random.random_range(0..ranks).to_string()),
    };
    let is_running = job.try_wait().unwrap().is_none();
    let process = process.filter(|_| is_running);
    let is_killed = process.is_some_and(|process| kill(process).success());
    let end = Instant::now();
    let output = job.wait_with_output().unwrap();
    assert!(end.elapsed() < END, "the job went on");
    // a job that nobody has killed does not fail
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(is_killed || output.status.success(), "{told}");
    is_killed && !output.status.success()
}

fn kill(process: u32) -> ExitStatus {
    let mut kill = Command::new("kill");
    kill.args(["-9", &process.to_string()])
        .stderr(Stdio::null());
    kill.status().unwrap()
}

/// A store that is filled, and radiosities over it that are solved for, by the program alone and by
/// one to three ranks, killed fifty times at random moments: what was there stays and is right, and
/// the last run finishes with the bytes of one that nothing has stopped.
#[test]
#[ignore = "minutes, needs mpirun: cargo test --features mpi --test command fifty -- --ignored"]
fn fifty_kills_lose_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let [alone, own] = ["alone", "own"].map(|name| folder.path().join(name));
    let [alone_name, own_name] = [&alone, &own].map(|path| path.to_str().unwrap());
    let fill = |name| {
        [
            "form-factor",
            "cube:10",
            "--every-pair",
            "--store",
            name,
            "--resume",
        ]
    };
    let solve = |name| {
        let question = [
            "radiosity",
            "cube:10",
            "--every-pair",
            "--format",
            "json",
            "--resume",
        ];
        [&question[..], &LIGHT[..], &["--store", name]].concat()
    };
    let timed = |arguments: &[&str]| {
        let start = Instant::now();
        (stdout(0, arguments), start.elapsed())
    };
    let (_, filling) = timed(&fill(alone_name));
    let (expected, solving) = timed(&solve(alone_name));
    let whole = files(&alone);
    let mut random = ChaCha8Rng::seed_from_u64(22);

    let (mut kills, mut runs) = (0, 0);
    while kills < KILLS {
        let before = if own.exists() {
            files(&own)
        } else {
            BTreeMap::new()
        };
        kills += usize::from(killed_at_random(&mut random, &fill(own_name), filling));
        let after = if own.exists() {
            files(&own)
        } else {
            BTreeMap::new()
        };
        assert!(
            before.keys().all(|file| after.contains_key(file)),
            "a file is lost"
        );
        for (file, bytes) in &after {
            assert!(whole.get(file) == Some(bytes), "{}", file.display());
        }
        runs += 1;
        if after.len() == whole.len() && kills < KILLS {
            fs::remove_dir_all(&own).unwrap();
        }
    }
    stdout(2, &fill(own_name));
    assert!(files(&own) == whole, "{kills} kills of {runs} runs");

    let products = Path::new("form_factors/products");
    let (mut kills, mut runs) = (0, 0);
    while kills < KILLS {
        kills += usize::from(killed_at_random(&mut random, &solve(own_name), solving));
        // the products come and go with solutions, the matrix stays
        let mut after = files(&own);
        after.retain(|file, _| !file.starts_with(products));
        assert!(after == whole, "after {kills} kills");
        runs += 1;
    }
    assert!(
        stdout(3, &solve(own_name)) == expected,
        "{kills} kills of {runs} runs"
    );
    assert!(files(&own) == whole);
}

/// The study of scale is measured by the ranks of the job, told once; what one sends to another is
/// measured, too.
#[test]
#[ignore = "needs mpirun: cargo test --features mpi --test command own_scale -- --ignored"]
fn ranks_measure_their_own_scale() {
    let told = stdout(2, &["study", "scale", "--quick", "--format", "json"]);
    let study: serde_json::Value = serde_json::from_str(&told).unwrap();
    let rows = study["rows"].as_array().unwrap();
    let mut measured = rows
        .iter()
        .filter(|row| row["basis"] == "measured" && row["memory"].is_number());
    assert!(measured.all(|row| row["ranks"] == 2 && row["nodes"] == 1));
    for case in ["a message of nothing", "sent to other ranks by each"] {
        let row = rows.iter().find(|row| row["case"] == case);
        assert!(
            row.is_some_and(|row| row["value"].as_f64() > Some(0.0)),
            "{case}"
        );
    }
    // on one machine the network of a cluster is taken for granted
    let network = rows
        .iter()
        .find(|row| row["case"] == "b, network of a node");
    assert_eq!(network.unwrap()["basis"], "assumed");
}
