//! The names of oracles.

use infoscene::hierarchy::{HierarchyError, OracleName};

#[test]
fn names_are_read_as_they_are_written() {
    for name in OracleName::ALL {
        assert_eq!(name.to_string().parse(), Ok(name));
    }
}

#[test]
fn an_unknown_name_is_refused_with_all_that_are_known() {
    let refusal = "entropy".parse::<OracleName>().unwrap_err().to_string();
    assert!(refusal.contains("entropy"), "{refusal}");
    for name in OracleName::ALL {
        assert!(refusal.contains(name.name()), "{refusal}");
    }
}

#[test]
fn the_true_error_asks_for_a_reference() {
    let refusal = OracleName::True.oracle(None).err();
    assert_eq!(refusal, Some(HierarchyError::NoReference));
}
