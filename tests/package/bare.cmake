# SPDX-License-Identifier: MIT
# A machine with no library: the headers are all there, each part that lacks one says so in a line, and what is asked
# for fails in a sentence.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BUILD})
set(nothing "")
foreach(package Boost CLI11 doctest Doxygen embree fmt glm glslang nlohmann_json OpenEXR PkgConfig PNG Python3
                SPIRV-Headers SPIRV-Tools-opt Threads Vulkan spirv_cross_core spirv_cross_glsl spirv_cross_hlsl
                spirv_cross_msl)
    list(APPEND nothing -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
set(configure ${CMAKE_COMMAND} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER} ${nothing})

run(${configure} -S ${ROOT} -B ${BUILD}/all)
foreach(part SPIRV TRANSLATE VULKAN EMIT TOOLS TESTS)
    string(REGEX MATCHALL "crease: CREASE_${part} is off, as it needs [^\n]+" lines "${run_output}")
    list(LENGTH lines count)
    if(NOT count EQUAL 1)
        message(FATAL_ERROR "${count} lines, not 1, say that CREASE_${part} is off:\n${run_output}")
    endif()
endforeach()
run(${CMAKE_COMMAND} --build ${BUILD}/all) # the C library, which needs none either
run(${CMAKE_COMMAND} --install ${BUILD}/all --prefix ${BUILD}/prefix)
run(${configure} -S ${CMAKE_CURRENT_LIST_DIR}/find_package -B ${BUILD}/host -D CMAKE_PREFIX_PATH=${BUILD}/prefix)
run(${CMAKE_COMMAND} --build ${BUILD}/host)
require_shader(${BUILD}/host/consumer)

require_failure("CREASE_SPIRV needs Threads, glslang, SPIRV-Headers, SPIRV-Tools-opt. install it or set CREASE_SPIRV to"
                ${configure} -S ${ROOT} -B ${BUILD}/asked -D CREASE_SPIRV=ON)
require_failure("crease_emit, which crease_add_shader runs, needs Threads, glslang" ${configure}
                -S ${CMAKE_CURRENT_LIST_DIR}/add_subdirectory -B ${BUILD}/shader -D CREASE_SOURCE=${ROOT}
                -D WITH_SHADER=ON)
