# SPDX-License-Identifier: MIT
# report.html: its parts and Chart.js become part of the program, so that the page needs nothing but itself.
find_file(SHAPES_CHART_JS chart.min.js
          PATHS /usr/share/javascript/chart.js /usr/share/nodejs/chart.js/dist NO_DEFAULT_PATH
          DOC "Chart.js 3, the minified file")
if(NOT SHAPES_CHART_JS)
  message(FATAL_ERROR "Chart.js was not found, which the report of shapes-compare draws its plots with: install the "
                      "Debian package libjs-chart.js, set SHAPES_CHART_JS to a chart.min.js of version 3, or set "
                      "SHAPES_BUILD_COMPARE to OFF")
endif()

set(page_files ${SHAPES_CHART_JS})
foreach(part report.html report.css failure.js format.js data.js summary.js matrix.js plotparts.js plots.js histograms.js
             tables.js effects.js metrics.js camera.js drawing.js replay.js report.js)
  list(APPEND page_files ${CMAKE_CURRENT_SOURCE_DIR}/report/page/${part})
endforeach()
add_custom_command(
  OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/PageTexts.h
  COMMAND ${CMAKE_COMMAND} -DOUT=${CMAKE_CURRENT_BINARY_DIR}/PageTexts.h "-DFILES=${page_files}"
          -P ${CMAKE_CURRENT_SOURCE_DIR}/report/EmbedText.cmake
  DEPENDS ${page_files} ${CMAKE_CURRENT_SOURCE_DIR}/report/EmbedText.cmake
  VERBATIM)
target_sources(shapes-compare-parts PRIVATE report/Html.cpp ${CMAKE_CURRENT_BINARY_DIR}/PageTexts.h)
