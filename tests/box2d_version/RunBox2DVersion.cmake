# SPDX-License-Identifier: MIT
# cmake -DMODE=... -P RunBox2DVersion.cmake: Shapes meets made-up versions of Box2D, in a folder that is made anew.
#   package      configures against an installed Box2D
#   source_tree  configures within a project that has Box2D among its sources
#   headers      compiles against headers whose version nobody tells
# Needs SOURCE_DIR, WORK_DIR, GENERATOR, CXX, the compiler, and CXX_ARGS: the arguments for cmake that choose it.
cmake_minimum_required(VERSION 3.25)

set(sentence "Shapes needs Box2D 2.4, from 2.4.1 on")
file(REMOVE_RECURSE ${WORK_DIR})

# Runs a command, which must succeed for an empty reason, and else must fail and say the reason.
function(expect reason)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  # CMake breaks and indents the lines of its messages.
  string(REGEX REPLACE "[ \n]+" " " flat "${output}")
  string(FIND "${flat}" "${reason}" at)
  if(reason AND (result EQUAL 0 OR at EQUAL -1))
    message(FATAL_ERROR "Expected a failure that says '${reason}', but got ${result}:\n${output}")
  elseif(NOT reason AND NOT result EQUAL 0)
    message(FATAL_ERROR "Expected success, but got ${result}:\n${output}")
  endif()
endfunction()

function(configure reason source)
  expect("${reason}" ${CMAKE_COMMAND} --fresh -S ${source} -B ${WORK_DIR}/build -G ${GENERATOR} ${CXX_ARGS}
         -DSHAPES_BUILD_TESTS=OFF -DSHAPES_BUILD_EXAMPLES=OFF -DSHAPES_BUILD_COMPARE=OFF ${ARGN})
endfunction()

function(use_package version reason)
  set(folder ${WORK_DIR}/box2d-${version})
  file(WRITE ${folder}/box2dConfig.cmake "add_library(box2d::box2d INTERFACE IMPORTED)\n")
  file(WRITE ${folder}/box2dConfigVersion.cmake "set(PACKAGE_VERSION ${version})\n")
  configure("${reason}" ${SOURCE_DIR} -Dbox2d_DIR=${folder} ${ARGN})
endfunction()

function(use_source_tree version reason)
  file(WRITE ${WORK_DIR}/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(Game LANGUAGES CXX)\n"
       "add_subdirectory(box2d)\nadd_subdirectory(${SOURCE_DIR} shapes)\n")
  file(WRITE ${WORK_DIR}/box2d/CMakeLists.txt "add_library(box2d INTERFACE)\n"
       "set_target_properties(box2d PROPERTIES VERSION ${version})\n"
       # Shapes is installed with its own targets only.
       "install(TARGETS box2d EXPORT box2d)\ninstall(EXPORT box2d DESTINATION box2d)\n")
  configure("${reason}" ${WORK_DIR})
endfunction()

function(use_header header reason)
  file(REMOVE_RECURSE ${WORK_DIR}/include)
  file(WRITE ${WORK_DIR}/include/box2d/box2d.h "")
  file(WRITE ${WORK_DIR}/include/box2d/${header} "")
  # Preprocessed only up to where the version is looked at: the system's own Box2D must not be seen instead.
  file(WRITE ${WORK_DIR}/include/Shapes/ShapeMath.h "")
  expect("${reason}" ${CXX} -x c++ -std=c++20 -E -nostdinc -I ${WORK_DIR}/include ${SOURCE_DIR}/src/box2d_backend/Convert.h)
endfunction()

if(MODE STREQUAL "package")
  use_package(3.0.0 "Box2D 3.0.0 was found, but ${sentence}")
  use_package(3.0.0 "" -DSHAPES_WITH_BOX2D=OFF)
  use_package(2.3.0 "Box2D 2.3.0 was found, but ${sentence}")
  use_package(2.4.0 "Box2D 2.4.0 was found, but ${sentence}")
  use_package(2.4.2 "") # the control
elseif(MODE STREQUAL "source_tree")
  use_source_tree(3.1.0 "Box2D 3.1.0 was found, but ${sentence}")
  use_source_tree(2.4.1 "") # the control
elseif(MODE STREQUAL "headers")
  use_header(base.h "${sentence}")      # 3
  use_header(b2_settings.h "${sentence}") # 2.4.0
  use_header(b2_common.h "")            # the control
endif()
