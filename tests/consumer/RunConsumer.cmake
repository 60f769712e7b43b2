# SPDX-License-Identifier: MIT
# cmake -DMODE=... -P RunConsumer.cmake: a test of the library as others get it, in a folder that is made anew.
#   find_package      installs the build, builds the consumer against it and runs it
#   add_subdirectory  builds the consumer with the source tree in it and runs it
#   component         asks the installed package for the component box2d, and for one that does not exist
# Needs SOURCE_DIR, BUILD_DIR, WORK_DIR, CONFIG, GENERATOR, BACKEND, WITH_BOX2D, SHARED, and CXX_ARGS: the arguments for
# cmake that choose the same compiler and flags.
cmake_minimum_required(VERSION 3.25)

function(run name)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${name} failed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_line line)
  string(FIND "\n${output}" "\n${line}\n" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "The consumer did not print '${line}' but:\n${output}")
  endif()
endfunction()

function(build_and_run)
  run("configuring the consumer" ${configure} ${ARGN})
  run("building the consumer" ${CMAKE_COMMAND} --build ${WORK_DIR}/build --config ${CONFIG})
  run("the consumer" ${WORK_DIR}/build/consumer)
  message(STATUS "The consumer printed:\n${output}")
  expect_line("engine: ${BACKEND}")
  if(WITH_BOX2D)
    expect_line("box2d: yes")
  else()
    expect_line("box2d: no")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
set(configure ${CMAKE_COMMAND} -S ${SOURCE_DIR}/tests/consumer -B ${WORK_DIR}/build -G ${GENERATOR}
              -DCMAKE_BUILD_TYPE=${CONFIG} ${CXX_ARGS})

if(MODE STREQUAL "add_subdirectory")
  set(subdirectory -DSHAPES_SOURCE_DIR=${SOURCE_DIR} -DBUILD_SHARED_LIBS=${SHARED} -DSHAPES_BACKEND=${BACKEND}
                   -DSHAPES_WITH_BOX2D=${WITH_BOX2D})
  run("configuring the consumer with the library in it" ${configure} ${subdirectory})
  # The library is compiled once more: as one file, not optimised, and the half without Box2D, whose flags and targets
  # the other modes use. It is a shared one in a project that hides its own symbols.
  string(TOUPPER ${CONFIG} config)
  set(BACKEND native)
  set(WITH_BOX2D OFF)
  build_and_run(${subdirectory} -DSHAPES_BACKEND=native -DSHAPES_WITH_BOX2D=OFF -DCMAKE_UNITY_BUILD=ON
                -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 -DBUILD_SHARED_LIBS=ON -DCMAKE_CXX_VISIBILITY_PRESET=hidden
                -DCMAKE_VISIBILITY_INLINES_HIDDEN=ON -DCMAKE_CXX_FLAGS_${config}=-O0)
  return()
endif()

run("installing" ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix --config ${CONFIG})
if(WITH_BOX2D)
  set(box2d_headers 1)
else()
  set(box2d_headers 0)
endif()
file(GLOB_RECURSE found ${WORK_DIR}/prefix/*/Box2D.h)
list(LENGTH found count)
if(NOT count EQUAL box2d_headers)
  message(FATAL_ERROR "Expected ${box2d_headers} Box2D.h to be installed, but found: ${found}")
endif()
set(use_package -DCMAKE_PREFIX_PATH=${WORK_DIR}/prefix -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
if(MODE STREQUAL "find_package")
  build_and_run(${use_package})
  return()
endif()

function(expect_component component is_there reason)
  execute_process(COMMAND ${configure} ${use_package} -DSHAPES_COMPONENTS=${component}
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  # CMake breaks and indents the lines of its messages.
  string(REGEX REPLACE "[ \n]+" " " flat "${output}")
  if(is_there AND NOT result EQUAL 0)
    message(FATAL_ERROR "The component ${component} was not found:\n${output}")
  elseif(NOT is_there AND (result EQUAL 0 OR NOT flat MATCHES "${reason}"))
    message(FATAL_ERROR "Expected a failure that says '${reason}', but got ${result}:\n${output}")
  endif()
endfunction()

expect_component(box2d ${WITH_BOX2D} "was built without the component box2d")
expect_component(box3d OFF "has no component box3d")
