# SPDX-License-Identifier: MIT
# Finds Box2D 2.4: the target shapes_box2d to build with, and SHAPES_BOX2D_TARGET, its name for the installed package.
# A source tree calls its target box2d, an installed package box2d::box2d.
if(NOT TARGET box2d AND NOT TARGET box2d::box2d)
  find_package(box2d CONFIG)
  if(NOT box2d_FOUND)
    message(FATAL_ERROR "Box2D 2.4 was not found (Debian: libbox2d-dev). -DSHAPES_WITH_BOX2D=OFF builds without it.")
  endif()
  if(NOT box2d_VERSION MATCHES "^2\\.4")
    message(FATAL_ERROR "Box2D ${box2d_VERSION} was found, but Shapes needs Box2D 2.4: other versions have another "
                        "interface. -DSHAPES_WITH_BOX2D=OFF builds without it.")
  endif()
endif()
add_library(shapes_box2d INTERFACE)
if(TARGET box2d::box2d)
  set(SHAPES_BOX2D_TARGET box2d::box2d)
else()
  set(SHAPES_BOX2D_TARGET box2d)
endif()
target_link_libraries(shapes_box2d INTERFACE ${SHAPES_BOX2D_TARGET})
