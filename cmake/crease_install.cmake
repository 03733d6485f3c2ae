# SPDX-License-Identifier: MIT
# An export of its own for each target, so that the package offers what was built and no more.
include(CMakePackageConfigHelpers)

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/crease)

function(crease_install_target target component)
    if(TARGET ${target})
        install(TARGETS ${target} EXPORT crease_${component} ${ARGN})
        install(EXPORT crease_${component} NAMESPACE crease:: DESTINATION ${package_directory})
    endif()
endfunction()

crease_install_target(crease core FILE_SET HEADERS FILE_SET templates)
crease_install_target(crease_spirv spirv FILE_SET HEADERS)
crease_install_target(crease_translate translate FILE_SET HEADERS)
crease_install_target(crease_vulkan vulkan FILE_SET HEADERS)
crease_install_target(crease_c c FILE_SET HEADERS)
if(TARGET crease_emit)
    set_target_properties(crease_emit PROPERTIES EXPORT_NAME emit)
    crease_install_target(crease_emit emit)
endif()
if(CREASE_TOOLS AND TARGET crease_command)
    install(TARGETS crease_command)
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/crease-config.cmake.in crease-config.cmake
                              INSTALL_DESTINATION ${package_directory} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(crease-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/crease-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/crease-config-version.cmake
              ${CMAKE_CURRENT_LIST_DIR}/crease_add_shader.cmake
              ${CMAKE_CURRENT_LIST_DIR}/crease_reserved_names.inc
        DESTINATION ${package_directory})

# Beside what depends on no architecture, where two folders up is the prefix, wherever that is moved.
set(emit_variable "")
if(TARGET crease_emit)
    set(emit_variable "emit=\${prefix}/${CMAKE_INSTALL_BINDIR}/crease_emit\n")
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/crease.pc.in crease.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/crease.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)

# The library has an architecture, and so has the folder of what says how to link it, from which the prefix is found.
if(TARGET crease_c)
    file(RELATIVE_PATH prefix_from_libraries /${CMAKE_INSTALL_LIBDIR} /)
    configure_file(${CMAKE_CURRENT_LIST_DIR}/crease_c.pc.in crease_c.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/crease_c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
