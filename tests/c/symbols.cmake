# SPDX-License-Identifier: MIT
# Requires LIBRARY to export the functions of HEADER, and nothing beside them.
execute_process(COMMAND ${NM} --dynamic --defined-only --format=posix ${LIBRARY} OUTPUT_VARIABLE listing
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+" exported "${listing}")
list(TRANSFORM exported STRIP)
file(READ ${HEADER} header)
string(REGEX MATCHALL "crease_[a-z_]+\\(" declared "${header}")
list(TRANSFORM declared REPLACE "\\($" "")
list(REMOVE_DUPLICATES declared)
list(FILTER declared EXCLUDE REGEX "^$")
list(SORT declared)
list(SORT exported)
list(REMOVE_DUPLICATES exported)
list(LENGTH declared count)
if(count EQUAL 0 OR NOT declared STREQUAL exported)
    message(FATAL_ERROR "${HEADER} declares\n  ${declared}\nand ${LIBRARY} exports\n  ${exported}")
endif()
