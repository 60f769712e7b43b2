# SPDX-License-Identifier: MIT
# cmake -DPROGRAM=shapes-compare -DPAGE=shapes-compare.1 -P CheckMan.cmake: the manual page names every option of the
# program, and nothing that the program does not have.
execute_process(COMMAND ${PROGRAM} --help-all OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PAGE} page)
string(REPLACE "\\-" "-" page "${page}")
set(expression "--[a-z][a-z-]+")
string(REGEX MATCHALL "${expression}" options "${help}")
string(REGEX MATCHALL "${expression}" named "${page}")
list(REMOVE_DUPLICATES options)
list(REMOVE_DUPLICATES named)
list(SORT options)
list(SORT named)
list(LENGTH options count)
if(count LESS 10 OR NOT options STREQUAL named)
  message(FATAL_ERROR "The program has the options ${options}, the manual page ${named}")
endif()
