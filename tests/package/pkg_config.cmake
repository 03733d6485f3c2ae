# SPDX-License-Identifier: MIT
# Builds a consumer with make and what pkg-config says of the package in PREFIX.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${BUILD})
file(MAKE_DIRECTORY ${BUILD})
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/share/pkgconfig)
run(${MAKE} -f ${CMAKE_CURRENT_LIST_DIR}/pkg_config/Makefile -C ${BUILD} CXX=${COMPILER}
    SOURCE=${CMAKE_CURRENT_LIST_DIR}/consumer.cpp)
require_shader(${BUILD}/consumer)
