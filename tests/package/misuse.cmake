# SPDX-License-Identifier: MIT
# Requires that crease_add_shader refuses, while CMake configures, what it cannot make.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BUILD})
function(refuses sentence)
    list(JOIN ARGN "\\;" arguments)
    require_failure("${sentence}" ${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR}/misuse -B ${BUILD}
                    -D CREASE_SOURCE=${ROOT} "-D ARGUMENTS=${arguments}")
endfunction()

set(recipe directions:8x4/single_layer/hbao)
foreach(name class 1x co_yield std crease linux _a a__b a-b a/b "a b")
    refuses("the NAME '${name}' is no C.. identifier, or is a word of C.., reserved or another's" consumer ${recipe} NAME
            ${name})
endforeach()
refuses("there is no target 'nobody'" nobody ${recipe})
refuses("the recipe is missing" consumer NAME ao)
refuses("what is 'FORMATS.header'" consumer ${recipe} FORMATS header)
refuses("nothing follows NAME" consumer ${recipe} NAME)
refuses("FORMAT is 'hlsl', and may be: header, spirv, spirv-asm, glsl" consumer ${recipe} FORMAT hlsl)
refuses("TARGET is 'cg', and may be: hlsl, msl, glsl-es, glsl, wgsl, spirv" consumer ${recipe} TARGET cg)
refuses("TARGET wgsl needs node, and naga-wasm .* run `npm install naga-wasm@" consumer ${recipe} TARGET wgsl)
refuses("TARGET and FORMAT exclude each other" consumer ${recipe} TARGET hlsl FORMAT glsl)
refuses("STAGE is 'vertex', and may be: compute, fragment" consumer ${recipe} STAGE vertex)
refuses("OPTIMISE is 'much', and may be: speed, size" consumer ${recipe} OPTIMISE much)
refuses("TARGET_ENV is '1.1', and may be: vulkan1.0" consumer ${recipe} TARGET_ENV 1.1)
