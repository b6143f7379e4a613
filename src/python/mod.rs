//! The Python module `infoscene`: the questions of this crate, asked from Python.
//!
//! ```text
//!   infoscene/*.py        meshes of any kind → arrays; answers → typed objects
//!   infoscene._infoscene  this module: arrays → scene → question → arrays
//! ```
//!
//! Each function here takes a scene and a call (threads, a callback) as the package's Python code
//! prepares them, asks one question of [`question`](crate::question), and returns a dictionary:
//! columns of numbers are NumPy arrays, records have the keys of the JSON that the command prints.
//! A refusal becomes a `ValueError` that names the mend in Python's words.
//!
//! A question is answered by threads of its own while the caller's waits without the interpreter's
//! lock, hears Ctrl-C, and tells a callback how far it is.
//!
//! **Not here**: computations; types and words for people, which stand in the Python files beside
//! this one. `maturin` builds both into a wheel, as `pyproject.toml` says.

mod arrays;
mod call;
mod claims;
mod form_factors;
mod information;
mod laws;
mod light;
mod materials;
mod mends;
mod refusal;
mod scene;

use pyo3::prelude::*;

/// The extension module: what `infoscene/__init__.py` builds upon.
#[pymodule(gil_used = false)]
fn _infoscene(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(form_factors::form_factors, module)?)?;
    module.add_function(wrap_pyfunction!(form_factors::point_form_factors, module)?)?;
    module.add_function(wrap_pyfunction!(laws::matrix_laws, module)?)?;
    module.add_function(wrap_pyfunction!(information::measure, module)?)?;
    module.add_function(wrap_pyfunction!(information::best_split, module)?)?;
    module.add_function(wrap_pyfunction!(light::radiosity, module)?)?;
    module.add_function(wrap_pyfunction!(light::refine, module)?)?;
    module.add_function(wrap_pyfunction!(claims::reproduce, module)?)?;
    Ok(())
}
