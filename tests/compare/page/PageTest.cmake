# SPDX-License-Identifier: MIT
# The tests of report.html in a browser; GoogleTest is there already.
find_program(SHAPES_CHROMIUM NAMES chromium-headless-shell chromium chromium-browser google-chrome
             DOC "A Chromium that runs without a window")
if(SHAPES_SANITIZE)
  # It writes what the other tests write, and leaves the rest to the browser.
elseif(SHAPES_CHROMIUM)
  add_executable(shapes-page-tests ${CMAKE_CURRENT_LIST_DIR}/../ReportPageTest.cpp)
  target_include_directories(shapes-page-tests PRIVATE ${CMAKE_CURRENT_LIST_DIR}/.. ${CMAKE_CURRENT_LIST_DIR}/../..)
  target_link_libraries(shapes-page-tests PRIVATE shapes-compare-parts shapes_flags GTest::gtest_main
                                                  nlohmann_json::nlohmann_json)
  target_compile_definitions(shapes-page-tests PRIVATE SHAPES_CHROMIUM="${SHAPES_CHROMIUM}"
                                                       SHAPES_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                       SHAPES_SCENES_DIR="${CMAKE_CURRENT_SOURCE_DIR}/scenes"
                                                       SHAPES_COMPARE="$<TARGET_FILE:shapes-compare>")
  add_dependencies(shapes-page-tests shapes-compare)
  shapes_add_runs(shapes-page-tests 4)
else()
  message(STATUS "report.html is not tested in a browser: there is none; the Debian package is chromium-headless-shell")
endif()
