# SPDX-License-Identifier: MIT
include(${CMAKE_CURRENT_LIST_DIR}/crease_find.cmake)

# What crease::spirv needs; glslang's package names Threads and does not look for it.
set(crease_spirv_packages Threads glslang SPIRV-Headers SPIRV-Tools-opt)

# The headers of these that crease::spirv includes, for targets that compile them once for all of their sources.
set(crease_spirv_includes <glslang/SPIRV/GlslangToSpv.h> <glslang/Public/ResourceLimits.h> <glslang/Public/ShaderLang.h>
                          <spirv-tools/libspirv.hpp> <spirv-tools/optimizer.hpp> <spirv/unified1/spirv.hpp>)

# crease_add_spirv(): the target crease::spirv, whose packages must have been found.
function(crease_add_spirv)
    cmake_path(GET CMAKE_CURRENT_FUNCTION_LIST_DIR PARENT_PATH root)
    file(GLOB headers CONFIGURE_DEPENDS ${root}/include/crease/spirv/*.hpp)
    add_library(crease_spirv INTERFACE)
    add_library(crease::spirv ALIAS crease_spirv)
    set_target_properties(crease_spirv PROPERTIES EXPORT_NAME spirv)
    target_sources(crease_spirv INTERFACE FILE_SET HEADERS BASE_DIRS ${root}/include
                                          FILES ${root}/include/crease/spirv.hpp ${headers})
    target_link_libraries(crease_spirv INTERFACE crease glslang::glslang glslang::SPIRV
                                                 glslang::glslang-default-resource-limits
                                                 SPIRV-Headers::SPIRV-Headers SPIRV-Tools-opt)
endfunction()
