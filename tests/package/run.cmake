# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)

# Runs a command, and gives what it says in run_output.
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    set(run_output "${output}" PARENT_SCOPE)
    if(NOT result EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}\n${output}")
    endif()
endfunction()

function(require_failure sentence)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    string(REGEX REPLACE "[ \n]+" " " output "${output}") # CMake breaks lines
    if(result EQUAL 0 OR NOT output MATCHES "${sentence}")
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}\nought to say '${sentence}' and fail:\n${output}")
    endif()
endfunction()

function(require_shader program)
    execute_process(COMMAND ${program} RESULT_VARIABLE result OUTPUT_VARIABLE output)
    if(NOT result EQUAL 0 OR NOT output MATCHES "^// [^\n]*\n#version 450\n.*void main\\(\\)")
        message(FATAL_ERROR "${program} prints no shader:\n${output}")
    endif()
endfunction()
