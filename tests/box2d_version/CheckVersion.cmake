# SPDX-License-Identifier: MIT
# Configures SOURCE_DIR against a made-up Box2D of another version in WORK_DIR: it has to be refused with a sentence
# that says which is needed. Without the engine the same Box2D does not matter: the control.
file(REMOVE_RECURSE ${WORK_DIR})
foreach(version 2.3.1 3.0.0)
  set(package ${WORK_DIR}/${version}/package)
  file(WRITE ${package}/box2dConfig.cmake "add_library(box2d::box2d INTERFACE IMPORTED)\n")
  file(WRITE ${package}/box2dConfigVersion.cmake
       "set(PACKAGE_VERSION ${version})\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
  foreach(with ON OFF)
    execute_process(
      COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${WORK_DIR}/${version}/${with} -G ${GENERATOR} ${CXX_ARGS}
              -Dbox2d_DIR=${package} -DSHAPES_WITH_BOX2D=${with} -DSHAPES_BUILD_TESTS=OFF -DSHAPES_BUILD_COMPARE=OFF
              -DSHAPES_BUILD_EXAMPLES=OFF
      RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    string(REGEX REPLACE "[ \n]+" " " output "${output}")
    if(with AND (result EQUAL 0 OR NOT output MATCHES "Box2D ${version} was found, but Shapes needs Box2D 2\\.4"))
      message(FATAL_ERROR "Box2D ${version} was not refused as it should be: ${output}")
    elseif(NOT with AND NOT result EQUAL 0)
      message(FATAL_ERROR "Box2D ${version} was refused though its engine is not wanted: ${output}")
    endif()
  endforeach()
endforeach()
