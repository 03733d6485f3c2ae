# SPDX-License-Identifier: MIT
include(${CMAKE_CURRENT_LIST_DIR}/crease_spirv_target.cmake)

# What crease::translate needs beside what crease::spirv does: SPIRV-Cross, a package for each of its libraries.
set(crease_translate_packages spirv_cross_core spirv_cross_glsl spirv_cross_hlsl spirv_cross_msl)

# crease_add_translate(): the target crease::translate, whose packages must have been found, as crease::spirv must.
function(crease_add_translate)
    cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH root)
    file(GLOB headers CONFIGURE_DEPENDS ${root}/include/crease/translate/*.hpp)
    add_library(crease_translate INTERFACE)
    add_library(crease::translate ALIAS crease_translate)
    set_target_properties(crease_translate PROPERTIES EXPORT_NAME translate)
    target_sources(crease_translate INTERFACE FILE_SET HEADERS BASE_DIRS ${root}/include
                                              FILES ${root}/include/crease/translate.hpp ${headers})
    target_link_libraries(crease_translate INTERFACE crease_spirv spirv-cross-hlsl spirv-cross-msl spirv-cross-glsl
                                                     spirv-cross-core)
endfunction()
