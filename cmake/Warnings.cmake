# mbcc_warnings: what this project holds its own code and the code that mbcc emits to. Linked privately, exported to
# nobody. The presets make every one of them an error. -Wrestrict of g++ 12 is wrong about std::string's operator+.
add_library(mbcc_warnings INTERFACE)
target_compile_options(
  mbcc_warnings
  INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Woverloaded-virtual
            -Wnon-virtual-dtor -Wcast-align -Wcast-qual -Wdouble-promotion -Wformat=2 -Wundef -Wunused
            $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond -Wduplicated-branches -Wlogical-op -Wno-restrict>)
