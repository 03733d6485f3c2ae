# SPDX-License-Identifier: MIT
include_guard()

# crease_add_shader(<target> [RECIPE] <recipe> [STAGE compute|fragment] [DIALECT vulkan|opengl|glsl_es:300|glsl_es:310|webgpu]
#                   [SHAPE program|functions] [FORMAT header|spirv|spirv-asm|glsl] [NAME <name>]
#                   [TARGET hlsl|msl|glsl-es|glsl|wgsl|spirv] [TARGET_VERSION <version>]
#                   [OPTIMISE speed|size] [STRIP] [TARGET_ENV vulkan1.0|vulkan1.1|vulkan1.2|vulkan1.3])
#
# Makes the shaders of a recipe while <target> is built, each call by a build step of its own. With FORMAT header, the
# default, <target> can `#include <NAME.hpp>`, which includes headers of crease; with the others, and with TARGET, another
# language, the files lie in NAME/ below the same include directory. NAME, by default `shader`, is an identifier that names the header, its namespace
# and the manifest NAME.json, which docs/manifest.md describes. What is not said is as the recipe says. The options of
# SPIR-V are those of crease_emit. WGSL needs node, and npm's naga-wasm in a node_modules of the current binary directory or
# of a folder above it.
#
# Where crease is part of the build, crease_emit is built for the first call; else it comes with the installed package.
function(crease_add_shader target)
    set(choices STAGE DIALECT SHAPE FORMAT TARGET OPTIMISE TARGET_ENV)
    cmake_parse_arguments(PARSE_ARGV 1 arg STRIP "RECIPE;NAME;TARGET_VERSION;${choices}" "")
    if(NOT TARGET ${target})
        message(FATAL_ERROR "crease_add_shader: there is no target '${target}'")
    endif()
    if(NOT arg_RECIPE)
        list(POP_FRONT arg_UNPARSED_ARGUMENTS arg_RECIPE)
    endif()
    if(NOT arg_RECIPE)
        message(FATAL_ERROR "crease_add_shader: the recipe is missing")
    endif()
    if(arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "crease_add_shader: what is '${arg_UNPARSED_ARGUMENTS}'?")
    endif()
    if(arg_KEYWORDS_MISSING_VALUES)
        message(FATAL_ERROR "crease_add_shader: nothing follows ${arg_KEYWORDS_MISSING_VALUES}")
    endif()
    if(NOT DEFINED arg_NAME)
        set(arg_NAME shader)
    endif()
    if(DEFINED arg_TARGET AND DEFINED arg_FORMAT)
        message(FATAL_ERROR "crease_add_shader: TARGET and FORMAT exclude each other: leave one out")
    endif()
    if(NOT DEFINED arg_FORMAT AND NOT DEFINED arg_TARGET)
        set(arg_FORMAT header)
    endif()
    crease_check_name(${target} "${arg_NAME}")
    set(STAGE_words compute fragment)
    set(DIALECT_words vulkan opengl glsl_es:300 glsl_es:310 webgpu)
    set(SHAPE_words program functions)
    set(FORMAT_words header spirv spirv-asm glsl)
    set(TARGET_words hlsl msl glsl-es glsl wgsl spirv)
    set(OPTIMISE_words speed size)
    set(TARGET_ENV_words vulkan1.0 vulkan1.1 vulkan1.2 vulkan1.3)
    set(options "")
    foreach(choice IN LISTS choices)
        if(NOT DEFINED arg_${choice})
            continue()
        endif()
        if(NOT arg_${choice} IN_LIST ${choice}_words)
            list(JOIN ${choice}_words ", " words)
            message(FATAL_ERROR "crease_add_shader: ${choice} is '${arg_${choice}}', and may be: ${words}")
        endif()
        string(TOLOWER --${choice} option)
        string(REPLACE _ - option ${option})
        list(APPEND options ${option} ${arg_${choice}})
    endforeach()
    if(DEFINED arg_TARGET_VERSION)
        list(APPEND options --target-version ${arg_TARGET_VERSION})
    endif()
    if(DEFINED arg_TARGET AND arg_TARGET STREQUAL wgsl)
        crease_expect_naga()
    endif()
    if(arg_STRIP)
        list(APPEND options --strip)
    endif()
    if(NOT TARGET crease::emit)
        crease_bring_emit()
    endif()

    # A directory for each name, so that a header of a name that is no longer used is not found.
    set(directory ${CMAKE_CURRENT_BINARY_DIR}/crease_shaders/${target}/${arg_NAME})
    if(DEFINED arg_FORMAT AND arg_FORMAT STREQUAL header)
        set(destination ${directory})
        set(header ${directory}/${arg_NAME}.hpp)
    else()
        set(destination ${directory}/${arg_NAME})
        set(header "")
    endif()
    set(output ${header} ${destination}/${arg_NAME}.json) # which files a recipe makes only the manifest knows
    add_custom_command(
        OUTPUT ${output}
        COMMAND crease::emit ${arg_RECIPE} ${options} --name ${arg_NAME} -o ${destination}
        DEPENDS crease::emit
        WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} # from where node looks for naga-wasm
        COMMENT "crease: ${arg_NAME} from ${arg_RECIPE}"
        VERBATIM)
    target_sources(${target} PRIVATE ${output})
    # Not target_link_libraries, whose two signatures do not mix in one target.
    target_include_directories(${target} PRIVATE
        ${directory} $<TARGET_PROPERTY:crease::crease,INTERFACE_INCLUDE_DIRECTORIES>)
    target_compile_features(${target} PRIVATE cxx_std_20)
endfunction()

# The names that crease_emit refuses too.
function(crease_check_name target name)
    file(STRINGS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/crease_reserved_names.inc taken REGEX "^\"")
    if(NOT name MATCHES "^[A-Za-z][A-Za-z0-9_]*$" OR name MATCHES "__" OR "\"${name}\"," IN_LIST taken)
        message(FATAL_ERROR "crease_add_shader: the NAME '${name}' is no C++ identifier, or is a word of C++, reserved or "
                            "another's")
    endif()
    get_property(names TARGET ${target} PROPERTY crease_shader_names)
    if(name IN_LIST names)
        message(FATAL_ERROR "crease_add_shader: ${target} has shaders of the NAME '${name}' already")
    endif()
    set_property(TARGET ${target} APPEND PROPERTY crease_shader_names ${name})
endfunction()

# What crease_emit makes WGSL by; it must be there before anything is built.
function(crease_expect_naga)
    find_program(CREASE_NODE node)
    mark_as_advanced(CREASE_NODE)
    set(result node)
    if(CREASE_NODE)
        execute_process(COMMAND ${CREASE_NODE} -e "require('node:module').createRequire(process.cwd() + '/').resolve('naga-wasm')"
                        WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
    endif()
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "crease_add_shader: TARGET wgsl needs node, and naga-wasm where node looks for packages from "
                            "${CMAKE_CURRENT_BINARY_DIR}: run `npm install naga-wasm@30.1.0` in it or in a folder above it")
    endif()
endfunction()

function(crease_bring_emit)
    cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH root)
    if(NOT EXISTS ${root}/tools/emit/CMakeLists.txt)
        message(FATAL_ERROR "crease_add_shader: this package of crease was installed without crease_emit; install one "
                            "that was built with CREASE_EMIT")
    endif()
    add_subdirectory(${root}/tools/emit ${CMAKE_BINARY_DIR}/crease_emit EXCLUDE_FROM_ALL)
endfunction()
