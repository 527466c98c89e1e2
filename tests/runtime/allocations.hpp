#pragma once

namespace mbrt::test {

/// How often this process has asked for memory, through operator new or, as Eigen does, through malloc.
long allocations();

}  // namespace mbrt::test
