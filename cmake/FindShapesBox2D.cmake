# SPDX-License-Identifier: MIT
# Finds Box2D 2.4: the target shapes_box2d to build with, and SHAPES_BOX2D_TARGET, its name for the installed package.
# A source tree calls its target box2d, an installed package box2d::box2d.
if(NOT TARGET box2d AND NOT TARGET box2d::box2d)
  find_package(box2d CONFIG)
  if(NOT box2d_FOUND)
    message(FATAL_ERROR "Box2D 2.4 was not found (Debian: libbox2d-dev). -DSHAPES_WITH_BOX2D=OFF builds without it.")
  endif()
endif()
if(TARGET box2d::box2d)
  set(SHAPES_BOX2D_TARGET box2d::box2d)
else()
  set(SHAPES_BOX2D_TARGET box2d)
endif()

# A source tree in the same build says its version at the target, a package in a variable. Where neither is known,
# src/box2d_backend/Convert.h sees it by the headers.
get_target_property(shapes_box2d_version ${SHAPES_BOX2D_TARGET} VERSION)
if(NOT shapes_box2d_version)
  set(shapes_box2d_version "${box2d_VERSION}")
endif()
if(shapes_box2d_version AND (shapes_box2d_version VERSION_LESS 2.4.1 OR shapes_box2d_version VERSION_GREATER_EQUAL 2.5))
  message(FATAL_ERROR "Box2D ${shapes_box2d_version} was found, but Shapes needs Box2D 2.4, from 2.4.1 on: other versions "
                      "have another interface. -DSHAPES_WITH_BOX2D=OFF builds without it.")
endif()

add_library(shapes_box2d INTERFACE)
target_link_libraries(shapes_box2d INTERFACE ${SHAPES_BOX2D_TARGET})
