#pragma once
// The equations that bring a state back onto the constraints.

#include "mechanics/derivatives.hpp"

namespace mbcc::mechanics {

/// Errors of the constraints themselves, or of their rates.
enum class ErrorLevel { Position, Velocity };

/// `derivatives` with errors in the place of accelerations: A s = -h for displacements s of the coordinates, A s = -h'
/// (nonholonomic: -g) for changes s of the speeds, and no free motion. What `eliminate` then finds is the shortest s by
/// mass: one step of Newton's method. Nonholonomic rows do not bind coordinates; islands may lose all their rows.
Derivatives corrections(const Derivatives& derivatives, const model::System& system, ErrorLevel level,
                        graph::Graph& graph);

}  // namespace mbcc::mechanics
