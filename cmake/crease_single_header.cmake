# SPDX-License-Identifier: MIT
include_guard()

# crease_single_header(<target> <file>): a target that joins the pure headers and the GLSL in one file.
function(crease_single_header target output)
    set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/single_header.cmake)
    add_custom_command(
        OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -D ROOT=${PROJECT_SOURCE_DIR} -D OUTPUT=${output} -P ${script}
        DEPENDS ${headers} ${templates} ${script}
        COMMENT "crease: single header"
        VERBATIM)
    add_custom_target(${target} DEPENDS ${output})
endfunction()
