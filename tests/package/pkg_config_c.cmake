# SPDX-License-Identifier: MIT
# Builds a host in C with what pkg-config says of the C library in the folder LIBRARIES, wherever that was moved.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BUILD})
file(MAKE_DIRECTORY ${BUILD})
set(ENV{PKG_CONFIG_PATH} ${LIBRARIES}/pkgconfig)
run(${PKG_CONFIG} --cflags --libs crease_c)
separate_arguments(flags UNIX_COMMAND "${run_output}")
run(${C_COMPILER} -std=c99 -Wall -Wextra -Wpedantic -Werror ${CMAKE_CURRENT_LIST_DIR}/consumer.c -o ${BUILD}/consumer
    ${flags})
set(ENV{LD_LIBRARY_PATH} ${LIBRARIES})
require_shader(${BUILD}/consumer)
