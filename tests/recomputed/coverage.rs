//! Every row of every reference file has exactly one recomputation.

use crate::reference::{FILES, rows};
use crate::{cube_grids, form_factors, section_4_2, splits};

/// The ids of the rows of the four files are the ids claimed by the modules, once each.
#[test]
fn each_row_is_claimed_by_exactly_one_recomputation() {
    for file in FILES {
        let mut claimed = match file {
            "form_factors" => form_factors::IDS.map(String::from).to_vec(),
            "splits" => splits::ids(),
            "section_4_2" => section_4_2::ids(),
            "cube_grids" => cube_grids::ids(),
            other => panic!("no module recomputes {other}.csv"),
        };
        let mut stated: Vec<String> = rows(file).iter().map(|row| row["id"].clone()).collect();
        claimed.sort();
        stated.sort();
        assert_eq!(claimed, stated, "{file}.csv");
    }
}

/// The four files are all there are, beside `occlusion.json`: its values are of two integrals that
/// nothing here recomputes, and are judged by `library::form_factor::occlusion` with their
/// uncertainties.
#[test]
fn no_reference_file_is_left_out() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/data/reference");
    let entries = std::fs::read_dir(folder).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut tables: Vec<String> = names
        .filter_map(|name| name.strip_suffix(".csv").map(String::from))
        .collect();
    tables.sort();
    let mut known = FILES.map(String::from);
    known.sort();
    assert_eq!(tables, known);
}
