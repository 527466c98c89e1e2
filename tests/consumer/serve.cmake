# Installs, moves the prefix, and is then the user: commits what mbcc emits, builds, tests, edits an import, and links
# one program by hand with pkg-config. Every command must succeed.
cmake_policy(VERSION 3.21)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
file(RENAME ${WORK}/installed ${WORK}/moved)
file(COPY ${PROJECT}/ DESTINATION ${WORK}/project)
set(mbcc ${WORK}/moved/bin/mbcc)

if(NOT EXISTS ${WORK}/moved/share/man/man1/mbcc.1)
  message(FATAL_ERROR "the manual page is not installed")
endif()

# The user's commit: what mbcc emits, a careless edit of it, and a reference with one wrong digit.
run(${mbcc} project/pendulum.mbd -o project/pendulum.cpp)
file(READ ${WORK}/project/pendulum.cpp emitted)
file(WRITE ${WORK}/project/edited.cpp "${emitted}// faster!\n")
file(READ ${WORK}/project/pendulum.csv reference)
string(REPLACE "0.4503419" "0.4503418" wrong "${reference}")
file(WRITE ${WORK}/project/wrong.csv "${wrong}")

run(${CMAKE_COMMAND} -S project -B build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_CXX_FLAGS=${CXXFLAGS} -DCMAKE_PREFIX_PATH=${WORK}/moved)
run(${CMAKE_COMMAND} --build build)
run(${CMAKE_CTEST_COMMAND} --test-dir build --output-on-failure --no-tests=error)

# By hand, as the manual says it.
set(ENV{PKG_CONFIG_PATH} ${WORK}/moved/${LIBDIR}/pkgconfig)
run(sh -c "${CXX} ${CXXFLAGS} -std=c++20 -O2 project/pendulum.cpp $(pkg-config --cflags --libs mbrt) -o by_hand")
run(./by_hand --quiet --csv by_hand.csv)
run(moved/bin/mbcc-compare project/pendulum.csv by_hand.csv 1e-9)

# `mbcc run` builds with the runtime that it was installed with: it works, and notices when that one is damaged.
set(ENV{CXX} ${CXX})
set(ENV{XDG_CACHE_HOME} ${WORK}/cache)
run(${mbcc} run project/pendulum.mbd --quiet --csv run.csv)
run(moved/bin/mbcc-compare project/pendulum.csv run.csv 1e-9)
file(COPY ${WORK}/moved/ DESTINATION ${WORK}/damaged)
file(APPEND ${WORK}/damaged/include/mbrt/simulation.hpp "#error damaged\n")
set(ENV{XDG_CACHE_HOME} ${WORK}/another_cache)
execute_process(COMMAND damaged/bin/mbcc run project/pendulum.mbd --quiet WORKING_DIRECTORY ${WORK}
                RESULT_VARIABLE code ERROR_VARIABLE said)
if(code EQUAL 0 OR NOT said MATCHES "error damaged")
  message(FATAL_ERROR "mbcc run does not use the runtime beside it: exit code ${code}, ${said}")
endif()

# A change of an imported file reaches what was made from the model; without one nothing is made again.
function(modified variable)
  file(TIMESTAMP ${WORK}/build/swing.mbcc/pendulum.cpp time "%s")
  set(${variable} ${time} PARENT_SCOPE)
endfunction()
modified(first)
execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 1.1)
run(${CMAKE_COMMAND} --build build)
modified(second)
file(APPEND ${WORK}/project/rod.mbd "# longer\n")
run(${CMAKE_COMMAND} --build build)
modified(third)
if(NOT first STREQUAL second OR NOT second LESS third)
  message(FATAL_ERROR "emitted at ${first}, again at ${second} without a reason, and at ${third} after an import changed")
endif()
