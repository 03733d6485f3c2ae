# SPDX-License-Identifier: MIT
# Configures PROJECT with OPTIONS, builds it and requires `consumer` to print a shader.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BUILD})
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${PROJECT} -B ${BUILD} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} ${OPTIONS})
run(${CMAKE_COMMAND} --build ${BUILD})
require_shader(${BUILD}/consumer)
