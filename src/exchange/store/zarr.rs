//! The metadata by which a store is a group of arrays in Zarr, version 3.
//!
//! <https://zarr-specs.readthedocs.io/en/latest/v3/core/index.html>

use super::StoreError;
use super::chunk::{AREAS, Aside, BOUNDS, FORM_FACTORS};
use std::path::Path;

/// Writes the metadata of a matrix of so many rows, in chunks of so many.
pub(super) fn write(
    aside: &Aside,
    folder: &Path,
    rows: usize,
    side: usize,
) -> Result<(), StoreError> {
    let group = "{\"zarr_format\": 3, \"node_type\": \"group\", \"attributes\": {\"about\": \
                 \"form_factors[i, j] is from row i to row j; bounds are on absolute errors; NaN is \
                 not computed yet\"}}\n";
    aside.write(&folder.join("zarr.json"), group.as_bytes())?;
    for (name, kind, shape, chunk) in [
        (FORM_FACTORS, "float64", vec![rows; 2], vec![side; 2]),
        (BOUNDS, "float32", vec![rows; 2], vec![side; 2]),
        (AREAS, "float64", vec![rows], vec![rows]),
    ] {
        let text = array(kind, &shape, &chunk);
        aside.write(&folder.join(name).join("zarr.json"), text.as_bytes())?;
    }
    Ok(())
}

fn array(kind: &str, shape: &[usize], chunk: &[usize]) -> String {
    format!(
        "{{\"zarr_format\": 3, \"node_type\": \"array\", \"shape\": {shape:?}, \"data_type\": \
         \"{kind}\", \"chunk_grid\": {{\"name\": \"regular\", \"configuration\": \
         {{\"chunk_shape\": {chunk:?}}}}}, \"chunk_key_encoding\": {{\"name\": \"default\", \
         \"configuration\": {{\"separator\": \"/\"}}}}, \"fill_value\": \"NaN\", \"codecs\": \
         [{{\"name\": \"bytes\", \"configuration\": {{\"endian\": \"little\"}}}}], \
         \"attributes\": {{}}}}\n"
    )
}
