# SPDX-License-Identifier: MIT
# Requires that programs which nobody names leave no byte of GLSL in the object file, and that the one named does.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(MAKE_DIRECTORY ${BUILD})
function(has_glsl source result)
    run(${COMPILER} -std=c++20 -I${ROOT}/include -I${ROOT}/templates -c ${source} -o ${BUILD}/object.o)
    file(STRINGS ${BUILD}/object.o found REGEX "crease_receiver|#version|crease_evaluate")
    list(LENGTH found count)
    set(${result} ${count} PARENT_SCOPE)
endfunction()

has_glsl(${CMAKE_CURRENT_LIST_DIR}/unused.cpp count)
if(NOT count EQUAL 0)
    message(FATAL_ERROR "${count} lines of GLSL in an object that names no program")
endif()
has_glsl(${CMAKE_CURRENT_LIST_DIR}/consumer.cpp count)
if(count EQUAL 0)
    message(FATAL_ERROR "this test finds no GLSL where there is some")
endif()
