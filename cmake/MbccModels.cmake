# Functions for projects that contain models. They work in the tree that builds mbcc and, after
# `find_package(mbcc CONFIG REQUIRED)`, with an installed mbcc. A model's output is made again when the model, a file
# that it imports, or mbcc itself changes.
#
#   mbcc_add_simulation(NAME MODEL.mbd)     a program: the simulation
#   mbcc_add_model(NAME MODEL.mbd [FLAG..]) a library to link: `#include "MODEL.hpp"` gives the class MODEL::Model;
#                                           flags are those of mbcc, such as `--method taylor`
#   mbcc_add_regression(NAME MODEL MODEL.mbd EMITTED FILE.cpp REFERENCE FILE.csv TOLERANCE X)
#                                           tests NAME.emitted, NAME.run, NAME.trajectory: FILE.cpp is what mbcc emits
#                                           for the model, and what it computes agrees with FILE.csv (see mbcc-compare)

include_guard(GLOBAL)
cmake_policy(VERSION 3.21)

# Makes OUTPUT from a model at build time. Further arguments are flags of mbcc.
function(mbcc_emit_ output model)
  add_custom_command(
    OUTPUT ${output}
    COMMAND mbcc::mbcc ${model} ${ARGN} -o ${output} --depfile ${output}.d
    DEPENDS ${model} mbcc::mbcc
    DEPFILE ${output}.d
    COMMENT "Compiling ${model}"
    VERBATIM)
endfunction()

# Sets MODEL to the model's path and STEM to a path in a directory of its own for what is made from it.
macro(mbcc_paths_ name model)
  get_filename_component(MODEL ${model} ABSOLUTE)
  get_filename_component(STEM ${model} NAME_WE)
  set(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name}.mbcc)
  file(MAKE_DIRECTORY ${DIRECTORY})
endmacro()

function(mbcc_add_simulation name model)
  mbcc_paths_(${name} ${model})
  mbcc_emit_(${DIRECTORY}/${STEM}.cpp ${MODEL})
  add_executable(${name} ${DIRECTORY}/${STEM}.cpp)
  target_link_libraries(${name} PRIVATE mbcc::runtime)
endfunction()

function(mbcc_add_model name model)
  mbcc_paths_(${name} ${model})
  mbcc_emit_(${DIRECTORY}/${STEM}.hpp ${MODEL} --library ${ARGN})
  add_custom_target(${name}_emitted DEPENDS ${DIRECTORY}/${STEM}.hpp)
  add_library(${name} INTERFACE)
  add_dependencies(${name} ${name}_emitted)
  target_include_directories(${name} INTERFACE ${DIRECTORY})
  target_link_libraries(${name} INTERFACE mbcc::runtime)
endfunction()

# Contraction of multiply-adds is off, so that the same numbers come out on every machine.
function(mbcc_add_regression name)
  cmake_parse_arguments(PARSE_ARGV 1 REGRESSION "" "MODEL;EMITTED;REFERENCE;TOLERANCE" "")
  foreach(argument MODEL EMITTED REFERENCE TOLERANCE)
    if(NOT DEFINED REGRESSION_${argument})
      message(FATAL_ERROR "mbcc_add_regression(${name}): ${argument} is missing")
    endif()
  endforeach()
  foreach(file MODEL EMITTED REFERENCE)
    get_filename_component(${file} ${REGRESSION_${file}} ABSOLUTE)
  endforeach()
  add_executable(${name}_regression ${EMITTED})
  target_link_libraries(${name}_regression PRIVATE mbcc::runtime)
  target_compile_options(${name}_regression PRIVATE -ffp-contract=off)
  add_dependencies(${name}_regression mbcc::mbcc mbcc::compare)

  set(result ${CMAKE_CURRENT_BINARY_DIR}/${name}_regression.csv)
  add_test(NAME ${name}.emitted COMMAND mbcc::mbcc verify ${MODEL} ${EMITTED})
  add_test(NAME ${name}.run COMMAND ${name}_regression --quiet --csv ${result})
  add_test(NAME ${name}.trajectory COMMAND mbcc::compare ${REFERENCE} ${result} ${REGRESSION_TOLERANCE})
  set_tests_properties(${name}.run PROPERTIES FIXTURES_SETUP ${name}.result)
  set_tests_properties(${name}.trajectory PROPERTIES FIXTURES_REQUIRED ${name}.result)
endfunction()
