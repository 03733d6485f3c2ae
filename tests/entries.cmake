# SPDX-License-Identifier: MIT
# Checks that the entries of a doctest program run each of its test cases once.
# command: the program; filters: the options of each entry, one a list item.
function(list_test_cases result)
    execute_process(COMMAND ${command} --list-test-cases --no-colors=true ${ARGN} OUTPUT_VARIABLE text
                    COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX REPLACE "\\[doctest\\][^\n]*\n|=+\n" "" text "${text}")
    string(REGEX REPLACE "[][;]" "," text "${text}") # of which CMake makes lists
    string(REGEX MATCHALL "[^\n]+" names "${text}")
    set(${result} "${names}" PARENT_SCOPE)
endfunction()

list_test_cases(all)
set(run "")
foreach(filter IN LISTS filters)
    list_test_cases(some "${filter}")
    if(some STREQUAL "")
        message(FATAL_ERROR "the entry '${filter}' of ${command} runs no test case: mend its filter")
    endif()
    list(APPEND run ${some})
endforeach()
list(SORT all)
list(SORT run)
set(left_out ${all})
list(REMOVE_ITEM left_out ${run})
if(NOT left_out STREQUAL "")
    message(FATAL_ERROR "no entry of ${command} runs '${left_out}': mend their filters")
endif()
if(all STREQUAL "" OR NOT all STREQUAL run)
    message(FATAL_ERROR "entries of ${command} run a test case twice: mend their filters.\nthey run: ${run}")
endif()
