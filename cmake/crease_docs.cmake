# SPDX-License-Identifier: MIT
# crease_docs: the API reference, by Doxygen of the comments and of the pages, in docs/html of the build directory.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
    message(STATUS "crease: Doxygen was not found, so there is no target crease_docs")
    return()
endif()

set(pages README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md docs)
set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/docs)
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE docs/README.md)
set(DOXYGEN_FILE_PATTERNS *.h *.hpp *.md)
set(DOXYGEN_FILTER_PATTERNS */docs/*.md=docs/doxygen/page */README.md=docs/doxygen/page
                            "\"*/parts/*=sed -E -f docs/doxygen/part.sed\"")
set(DOXYGEN_IMAGE_PATH docs)
set(DOXYGEN_STRIP_FROM_INC_PATH include)
set(DOXYGEN_INCLUDE_PATH include templates)
set(DOXYGEN_GENERATE_TREEVIEW YES)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_MAX_INITIALIZER_LINES 100) # of a part's description
set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO) # a parameter that its name explains needs no words
set(DOXYGEN_QUIET YES)
# What composing, compiling and running are made of, which no host names.
set(DOXYGEN_EXCLUDE_SYMBOLS *::detail crease::composing crease::joining crease::rules crease::areas *_glsl)
set(DOXYGEN_DISTRIBUTE_GROUP_DOC YES)
foreach(machine assertions core_files described interface_text joining linker plan program refusal rules symbols)
    list(APPEND DOXYGEN_EXCLUDE include/crease/compose/${machine}.hpp)
endforeach()
doxygen_add_docs(crease_docs include ${pages} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
                 COMMENT "crease: API reference")
