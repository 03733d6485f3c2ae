# SPDX-License-Identifier: MIT
# Makes the single header and requires it to do without any include directory of crease.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BUILD})
run(${CMAKE_COMMAND} -D ROOT=${ROOT} -D OUTPUT=${BUILD}/crease/crease.hpp -P ${ROOT}/cmake/single_header.cmake)
run(${COMPILER} -std=c++20 -Wall -Wextra -Werror -I${BUILD} ${CMAKE_CURRENT_LIST_DIR}/consumer.cpp -o ${BUILD}/consumer)
require_shader(${BUILD}/consumer)
