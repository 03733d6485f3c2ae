# SPDX-License-Identifier: MIT
include_guard()

# crease_add_shader(<target> [RECIPE] <recipe> [STAGE compute|fragment] [DIALECT vulkan|opengl]
#                   [SHAPE program|functions] [FORMAT header|spirv|glsl] [NAME <name>])
#
# Makes the shaders of a recipe while <target> is built, each call by a build step of its own. With FORMAT header, the
# default, <target> can `#include <NAME.hpp>`; with the others the files lie in <NAME>/ below the same include
# directory. NAME is an identifier, by default `shader`.
function(crease_add_shader target)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "RECIPE;STAGE;DIALECT;SHAPE;FORMAT;NAME" "")
    if(NOT arg_RECIPE)
        list(POP_FRONT arg_UNPARSED_ARGUMENTS arg_RECIPE)
    endif()
    if(NOT arg_RECIPE)
        message(FATAL_ERROR "crease_add_shader: the recipe is missing")
    endif()
    if(arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "crease_add_shader: what is '${arg_UNPARSED_ARGUMENTS}'?")
    endif()
    if(NOT TARGET crease::emit)
        message(FATAL_ERROR "crease_add_shader: crease was built without crease_emit; set CREASE_EMIT and CREASE_SPIRV")
    endif()
    foreach(choice "STAGE compute" "DIALECT vulkan" "SHAPE program" "FORMAT header" "NAME shader")
        string(REGEX MATCH "^([A-Z]+) (.+)$" matched "${choice}")
        if(NOT arg_${CMAKE_MATCH_1})
            set(arg_${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
        endif()
    endforeach()

    set(directory ${CMAKE_CURRENT_BINARY_DIR}/crease_shaders/${target})
    if(arg_FORMAT STREQUAL header)
        set(destination ${directory})
        set(output ${directory}/${arg_NAME}.hpp)
        set(stamp "")
    else()
        set(destination ${directory}/${arg_NAME})
        set(output ${destination}/emitted)
        set(stamp COMMAND ${CMAKE_COMMAND} -E touch ${output}) # which files a recipe makes is known only by then
    endif()
    add_custom_command(
        OUTPUT ${output}
        COMMAND crease::emit ${arg_RECIPE} --stage ${arg_STAGE} --dialect ${arg_DIALECT} --shape ${arg_SHAPE}
                --format ${arg_FORMAT} --name ${arg_NAME} -o ${destination}
        ${stamp}
        DEPENDS crease::emit
        COMMENT "crease: ${arg_RECIPE} (${arg_STAGE}, ${arg_DIALECT}, ${arg_SHAPE}, ${arg_FORMAT})"
        VERBATIM)
    target_sources(${target} PRIVATE ${output})
    target_include_directories(${target} PRIVATE ${directory})
endfunction()
