//! Generators of valid objects, two thirds of the draws at the hard spots.
