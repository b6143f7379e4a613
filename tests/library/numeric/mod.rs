//! Numbers: intervals, duals, elementary functions, certified roots and maxima, integrals.

mod certified_maxima;
mod certified_points;
mod certified_roots;
mod digamma;
mod dilogarithms;
mod dual_numbers;
mod elementary;
mod extremes;
mod interval_ends;
mod intervals;
mod optimisers;
mod parallel_maps;
mod rank_correlations;
mod series;
mod units;
