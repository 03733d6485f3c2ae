# SPDX-License-Identifier: MIT
# The headers of crease from the tree that this port lies in; ../../README.md says how it is used.
set(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../..")
set(VCPKG_BUILD_TYPE release) # there is nothing to debug in headers

vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS -DCREASE_SPIRV=OFF -DCREASE_VULKAN=OFF -DCREASE_EMIT=OFF -DCREASE_TOOLS=OFF -DCREASE_C=OFF -DCREASE_EXAMPLES=OFF
            -DCREASE_TESTS=OFF -DCREASE_DOCS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/crease)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
