# SPDX-License-Identifier: MIT
# Joins the pure headers and all that they include, the GLSL too, into OUTPUT: each file once, in the order in
# which a compiler meets it.
cmake_minimum_required(VERSION 3.25)

function(append text)
    set_property(GLOBAL APPEND_STRING PROPERTY body "${text}")
endfunction()

function(append_glsl name)
    file(READ ${ROOT}/templates/${name} text)
    # The line of the fence in its own file, of which errors speak.
    string(FIND "${text}" "__LINE__, R\"glsl(" fence)
    string(SUBSTRING "${text}" 0 ${fence} before)
    string(REGEX MATCHALL "\n" lines "${before}")
    list(LENGTH lines line)
    math(EXPR line "${line} + 1")
    string(REPLACE "__LINE__, R\"glsl(" "${line}, R\"glsl(" text "${text}")
    append("${text}")
endfunction()

function(append_header name)
    get_property(seen GLOBAL PROPERTY seen)
    if(name IN_LIST seen)
        return()
    endif()
    set_property(GLOBAL APPEND PROPERTY seen ${name})
    file(READ ${ROOT}/include/${name} text)
    # Cut by hand, as a CMake list would swallow semicolons and brackets.
    while(NOT text STREQUAL "")
        string(FIND "${text}" "\n" end)
        math(EXPR next "${end} + 1")
        string(SUBSTRING "${text}" 0 ${next} line)
        string(SUBSTRING "${text}" ${next} -1 text)
        if(line MATCHES "^#include <(crease/[^>]+\\.hpp)>")
            append_header(${CMAKE_MATCH_1})
        elseif(line MATCHES "^#include <(crease/[^>]+\\.glsl)>")
            append_glsl(${CMAKE_MATCH_1})
        elseif(NOT line MATCHES "^(#pragma once|// SPDX)")
            append("${line}")
        endif()
    endwhile()
endfunction()

append("// SPDX-License-Identifier: MIT\n#pragma once\n")
append_header(crease/crease.hpp)
append_header(crease/second_camera.hpp)
get_property(body GLOBAL PROPERTY body)
file(WRITE ${OUTPUT} "${body}")
