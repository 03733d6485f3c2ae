# SPDX-License-Identifier: MIT
# Doxygen's filter of a part's header: what the members of every part are is said here once.
s|^( *)static constexpr part description|\1/// What the part says of itself.\n&|
s|^( *)static constexpr number |\1/// The numbers that it takes: name, least, most, fallback, meaning.\n&|
s|^( *)static constexpr setting |\1/// The settings that it reads: name, fallback, least, most, meaning.\n&|
s|^( *)static constexpr void shape[_a-z]*\(|\1/// Sets the shape of its resources by its numbers and by the other parts.\n&|
s|^( *)static constexpr void fill\(|\1/// Fills its constant image.\n&|
s|^( *)static constexpr resource |\1/// Images and buffers that it reads or fills.\n&|
s|^( *)static constexpr step |\1/// Passes of its own.\n&|
s|^( *)static constexpr files_where |\1/// GLSL that stands before its own where more is needed of it.\n&|
s|^( *)static constexpr step_constant |\1/// Constants of its steps.\n&|
s|^( *)static constexpr std::string_view |\1/// Names of resources that a step fills.\n&|
s|^( *)static constexpr role |\1/// The roles of which it requires a part.\n&|
s|^( *)static constexpr const glsl_file\*|\1/// Its GLSL.\n&|
s|^( *)static constexpr int numbers|\1/// The template arguments, in the order of the part's `description.numbers`.\n&|
s|^( *)using needs |\1/// What other parts must offer.\n&|
s|^struct ([a-z_0-9]+)_part |/// What \1 is, whatever its numbers.\n&|
s|^( *)using parts |\1/// Its parts, in any order.\n&|
s|^( *)static constexpr preset_description |\1/// What the preset says of itself.\n&|
