# SPDX-License-Identifier: MIT
# Runs PROGRAM, which has to print what is in the file EXPECTED, and nothing else.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE result)
file(READ ${EXPECTED} expected)
if(NOT result EQUAL 0 OR NOT output STREQUAL expected OR NOT errors STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} ended with ${result} and printed\n${output}${errors}expected\n${expected}")
endif()
