//! Reports: answers as text.

mod finite;
