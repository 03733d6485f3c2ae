# SPDX-License-Identifier: MIT
# Compiles CASE and requires it to fail with the sentence and the names that it begins with.
file(STRINGS ${CASE} lines LIMIT_COUNT 2)
list(GET lines 0 sentence)
list(GET lines 1 names)
string(REGEX REPLACE "^// " "" sentence "${sentence}")
string(REGEX MATCHALL "[a-z_]+" names "${names}")

execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only ${INCLUDES} ${CASE}
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(result EQUAL 0)
    message(FATAL_ERROR "${CASE} compiles")
endif()
foreach(wanted IN LISTS sentence names)
    string(FIND "${output}" "${wanted}" at)
    if(at EQUAL -1)
        message(FATAL_ERROR "'${wanted}' is not said:\n${output}")
    endif()
endforeach()
string(REGEX MATCHALL "error:" errors "${output}")
list(LENGTH errors count)
if(count GREATER 1)
    message(FATAL_ERROR "${count} errors where one sentence would do:\n${output}")
endif()
