# SPDX-License-Identifier: MIT
# Builds TARGET of BUILD anew, says how long that took, and fails if it was more than LIMIT seconds.
# OBJECTS are what it is linked from beside the library, which stays.
file(REMOVE ${OBJECTS})
set(ENV{CCACHE_DISABLE} 1)
string(TIMESTAMP begin "%s%f")
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target ${TARGET} OUTPUT_VARIABLE output ERROR_VARIABLE output
                RESULT_VARIABLE result)
string(TIMESTAMP end "%s%f")
foreach(object ${OBJECTS})
  if(NOT result EQUAL 0 OR NOT EXISTS ${object})
    message(FATAL_ERROR "${TARGET} was not built:\n${output}")
  endif()
endforeach()
math(EXPR milliseconds "(${end} - ${begin}) / 1000")
math(EXPR limit "1000 * ${LIMIT}")
message("${TARGET} was built in ${milliseconds} ms")
if(milliseconds GREATER limit)
  message(FATAL_ERROR "expected at most ${LIMIT} seconds")
endif()
