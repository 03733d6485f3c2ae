/* SPDX-License-Identifier: MIT */
#ifndef CREASE_C_H
#define CREASE_C_H

/// @file
/// crease for C, and for all languages that call C: a recipe goes in as text, an effect comes out as data.
///
/// - No function keeps state beside what it is given, and none throws: any thread may call any of them.
/// - Text is UTF-8, ends with a NUL and belongs to the library. A sentence that says what is wrong is NULL
/// where
///   nothing is.
/// - NULL for what a function must have is an error like others, which a sentence says.
/// - Structs that the library gives by pointer grow at their end alone, and enumerations and functions are
/// only added:
///   a program made for an older version runs with a newer one of the same major number (while that is 0, of
///   the same minor one). So read them through the pointers, and never keep them in an array of your own.
///   crease_extent, crease_features and crease_view never change.

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(CREASE_C_BUILD)
#define CREASE_C_API __declspec(dllexport)
#elif defined(_WIN32) && !defined(CREASE_C_STATIC)
#define CREASE_C_API __declspec(dllimport)
#elif defined(__GNUC__)
#define CREASE_C_API __attribute__((visibility("default")))
#else
/// What a function of the library is declared with.
#define CREASE_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// What a pass runs as.
typedef enum crease_stage {
    CREASE_STAGE_COMPUTE,   ///< compute invocations
    CREASE_STAGE_FRAGMENT,  ///< one triangle that covers the output
    CREASE_STAGE_FUNCTIONS, ///< no `main`: functions that a shader of the host calls
    CREASE_STAGE_GEOMETRY   ///< no `main`: functions that the fragment shader of the host's geometry calls
} crease_stage;

/// Which GLSL a pass is written in.
typedef enum crease_dialect {
    CREASE_DIALECT_VULKAN,  ///< GLSL 450 for Vulkan 1.1 and up
    CREASE_DIALECT_OPENGL,  ///< GLSL 430 for OpenGL 4.3 and up
    CREASE_DIALECT_GLSL_ES, ///< GLSL ES 3.00 for WebGL 2 and OpenGL ES 3.0, or 3.10 for OpenGL ES 3.1 and up
    CREASE_DIALECT_WEBGPU   ///< GLSL 450 of which naga makes WGSL
} crease_dialect;

/// How a compute pass covers its output.
typedef enum crease_dispatch {
    CREASE_DISPATCH_TEXELS, ///< one invocation for each texel
    CREASE_DISPATCH_ROWS,   ///< a workgroup as wide as the image: (1, height / group height, 1)
    CREASE_DISPATCH_COLUMNS ///< a workgroup as high as the image: (width / group width, 1, 1)
} crease_dispatch;

/// How a pass touches a resource.
typedef enum crease_access {
    CREASE_ACCESS_UNIFORM,    ///< a std140 block
    CREASE_ACCESS_SAMPLE,     ///< a sampled image, nearest filter, clamped to the edge
    CREASE_ACCESS_LOAD,       ///< a storage image or buffer that is read
    CREASE_ACCESS_STORE,      ///< a storage image or buffer that is written
    CREASE_ACCESS_MODIFY,     ///< a storage image or buffer that is read and written, or changed by atomic
                              ///< operations
    CREASE_ACCESS_ATTACHMENT, ///< an attachment; has no binding, its location is `slot`
    CREASE_ACCESS_RESULT      ///< the return value of a function; has no binding
} crease_access;

/// What a resource is made of.
typedef enum crease_resource_kind {
    CREASE_RESOURCE_IMAGE,  ///< an image
    CREASE_RESOURCE_BUFFER, ///< a storage buffer: an array of `element`
    CREASE_RESOURCE_BLOCK   ///< the uniform block, `parameters`
} crease_resource_kind;

/// Who fills a resource, and how long its content lives.
typedef enum crease_lifetime {
    CREASE_LIFETIME_INPUT,     ///< filled by the host before the first pass
    CREASE_LIFETIME_CONSTANT,  ///< filled once, with `texels`
    CREASE_LIFETIME_TRANSIENT, ///< written by a pass, read by later passes of the same frame
    CREASE_LIFETIME_HANDED_ON, ///< of no resource of an effect
    CREASE_LIFETIME_HISTORY, ///< one of two: a pass writes one and reads the other, swapped after each frame
    CREASE_LIFETIME_REPORT,  ///< written by a pass, for the host to read back: counters
    CREASE_LIFETIME_OUTPUT   ///< written by the last pass, for the host
} crease_lifetime;

/// Texel formats, named as in Vulkan.
typedef enum crease_format {
    CREASE_FORMAT_NONE,
    CREASE_FORMAT_R8_UNORM,
    CREASE_FORMAT_RGBA8_UNORM,
    CREASE_FORMAT_R32_UINT,
    CREASE_FORMAT_RG32_UINT,
    CREASE_FORMAT_RGBA32_UINT,
    CREASE_FORMAT_R32_FLOAT,
    CREASE_FORMAT_RG32_FLOAT,
    CREASE_FORMAT_RGBA16_FLOAT,
    CREASE_FORMAT_RGBA32_FLOAT,
    CREASE_FORMAT_D32_FLOAT
} crease_format;

/// How a host writes matrices and stores rows, or-ed together; 0 is Vulkan's way with column-major matrices.
typedef enum crease_convention {
    CREASE_CONVENTION_DEPTH_FROM_MINUS_ONE = 1, ///< NDC depth in [-1, 1] (OpenGL), else in [0, 1]
    CREASE_CONVENTION_Y_UP = 2,        ///< NDC y = -1 is the last row of the image (Direct3D), else row 0
    CREASE_CONVENTION_LEFT_HANDED = 4, ///< view space looks along +Z (Direct3D), else along -Z
    CREASE_CONVENTION_ROW_MAJOR = 8    ///< rows one after the other, for column vectors; else columns
} crease_convention;

/// `level` of a binding of a whole image.
#define CREASE_ALL_LEVELS 0xffffffffu

/// How large an image is; see crease_width_of.
typedef struct crease_extent {
    uint32_t divisor;      ///< of the picture's sides, > 0; the quotient is rounded up
    uint32_t guarded;      ///< whether it has the guard band, on each side
    uint32_t fixed_width;  ///< texels; 0: follows the picture
    uint32_t fixed_height; ///< likewise
    uint32_t level;        ///< how often it is halved, rounded down, to one texel at the least
} crease_extent;

/// One resource that a pass uses, and where it is bound.
typedef struct crease_binding {
    const char* name;     ///< "parameters", "input", "output" or the resource's; in GLSL crease_<name>
    uint32_t resource;    ///< index into the effect's resources
    crease_access access; ///< what the pass does with it
    uint32_t set;         ///< Vulkan descriptor set; 0 in OpenGL
    uint32_t slot;        ///< Vulkan binding; in OpenGL the unit, counted for each kind
    uint32_t level;       ///< mip level that is bound, or CREASE_ALL_LEVELS
} crease_binding;

/// A number of a part: a specialization constant in Vulkan GLSL, a `const int` in other GLSL.
typedef struct crease_constant {
    const char* part;   ///< e.g. "directions"
    const char* number; ///< e.g. "steps"; in GLSL crease_directions_steps
    uint32_t id;        ///< constant_id
    int32_t value;      ///< the default
} crease_constant;

/// One shader run of an effect.
typedef struct crease_pass {
    const char* name;                      ///< e.g. "visibility", "bilateral_x"
    crease_stage stage;                    ///< what it runs as
    crease_dialect dialect;                ///< which GLSL it is
    const char* text;                      ///< its GLSL
    const char* vertex_text;               ///< the vertex shader of a fragment pass; else NULL
    const crease_binding* const* bindings; ///< the block of parameters first, where it is used; outputs last
    const crease_constant* const*
        constants;            ///< of a compute pass the first two are the workgroup's width and height
    uint32_t binding_count;   ///< of `bindings`
    uint32_t constant_count;  ///< of `constants`
    crease_extent size;       ///< of the outputs
    crease_dispatch dispatch; ///< of a compute pass, which workgroups run
    uint32_t group_width;     ///< of a compute pass's workgroup, invocations; else 0
    uint32_t group_height;    ///< likewise
    uint32_t view;            ///< index of the camera whose picture it makes
} crease_pass;

/// An image, a buffer or the uniform block that passes read or write.
typedef struct crease_resource {
    const char* name;          ///< e.g. "depth"; in GLSL `crease_depth`
    crease_resource_kind kind; ///< what it is made of
    crease_format format;      ///< of an image; for an input what crease recommends
    const char* element;       ///< of a buffer: the GLSL type of its elements, 4, 8 or 16 bytes; else ""
    crease_lifetime lifetime;  ///< who fills it, and for how long
    crease_extent size;        ///< of an image; of a buffer so many elements, times `layers`
    const char* meaning;       ///< of a counter: what it counts, and what to do where that is not 0; else ""
    uint32_t layers;           ///< of an array image; of a buffer elements for each texel
    uint32_t levels;           ///< of an image: mip levels, fewer where its size has no more
    uint32_t samples;          ///< of a multisampled image
    uint32_t arrayed;          ///< whether it is an array image, also of one layer
    uint32_t centred;          ///< whether all samples of a texel lie at its centre
    const char* previous_of;   ///< of a history that is read: the resource that passes write; else ""
    uint32_t cleared;          ///< whether it holds `clear` before the first pass of each frame
    uint32_t clear;            ///< bits of each component
    const uint32_t* texels; ///< of a constant: its texels, one 32-bit number each, row after row; else NULL
    uint32_t texel_count;   ///< of `texels`
    const char* content;    ///< of an input: what the host gives, such as "device_depth"; else ""
} crease_resource;

/// A real number that a host may change each frame.
typedef struct crease_setting {
    const char* part;    ///< that owns it
    const char* name;    ///< e.g. "bias"
    const char* meaning; ///< in a few words, with the unit
    float fallback;      ///< what the part recommends
    float least;         ///< the least value allowed
    float most;          ///< the greatest value allowed
    uint32_t shared;     ///< whether it is one for all parts of an effect that name it
    uint32_t offset;     ///< of an effect's: of its `float` in the uniform block, bytes
} crease_setting;

/// A whole number that a part takes.
typedef struct crease_number {
    const char* name;    ///< e.g. "steps"
    const char* meaning; ///< in a few words
    int32_t least;       ///< the least value allowed
    int32_t most;        ///< the greatest value allowed
    int32_t fallback;    ///< where a recipe gives none
} crease_number;

/// A part, of which recipes are made.
typedef struct crease_part {
    const char* name;                      ///< in recipes, e.g. "hbao"
    const char* role;                      ///< in words, e.g. "depth source"
    const char* summary;                   ///< one line
    const char* source;                    ///< paper, chapter, algorithm; or ""
    const crease_number* const* numbers;   ///< in the order of a recipe, `:NxN...`
    const crease_setting* const* settings; ///< as the part describes them
    uint32_t number_count;                 ///< of `numbers`
    uint32_t setting_count;                ///< of `settings`
} crease_part;

/// Parts that go well together, under a name.
typedef struct crease_preset {
    const char* name;    ///< behind "preset:" in recipes
    const char* summary; ///< one line
    const char* recipe;  ///< of its parts, with all numbers
} crease_preset;

/// A part of an effect.
typedef struct crease_choice {
    const crease_part* part; ///< which
    const int32_t* numbers;  ///< its numbers, `part->number_count` of them
    uint32_t named;          ///< whether the recipe names it; else it is there by default
} crease_choice;

/// Device features that an effect requires beyond Vulkan 1.1 or OpenGL 4.3; each is 0 or 1, or sample counts
/// or-ed together.
typedef struct crease_features {
    uint32_t extended_storage_formats;    ///< Vulkan: shaderStorageImageExtendedFormats
    uint32_t fragment_stores_and_atomics; ///< Vulkan: fragmentStoresAndAtomics
    uint32_t subgroup_arithmetic;         ///< Vulkan: VK_SUBGROUP_FEATURE_ARITHMETIC_BIT in compute shaders
    uint32_t depth_samples;               ///< sample counts of depth images that are drawn to and sampled
    uint32_t centred_depth_samples;       ///< the same, all samples at the centre of the texel
} crease_features;

/// An effect as data: all a renderer needs to run it.
typedef struct crease_effect {
    const char* recipe;                      ///< what it was composed of, with all numbers
    const crease_choice* const* parts;       ///< of which it consists, those by default included
    const crease_pass* const* passes;        ///< in the order of execution, geometry passes among them
    const crease_resource* const* resources; ///< resource 0 is the block of parameters; the outputs come last
    const crease_setting* const* settings;   ///< in the order of the uniform block
    uint32_t part_count;                     ///< of `parts`
    uint32_t pass_count;                     ///< of `passes`
    uint32_t resource_count;                 ///< of `resources`
    uint32_t setting_count;                  ///< of `settings`
    uint32_t view_count; ///< cameras, that of the picture included; camera v is a crease_view at 48 v bytes
    uint32_t block_size; ///< of the uniform block, bytes, a multiple of 16
    uint32_t from_first_offset; ///< of the matrices of the cameras beside the picture's: from its view space
                                ///< to theirs
    uint32_t radius_offset;     ///< of the `float` radius, view-space units
    uint32_t frame_offset;      ///< of the `uint` frame, another of which gives other noise
    crease_features features;   ///< that the device must have
} crease_effect;

/// A camera in the uniform block: what a texel and its depth mean in view space, right-handed and looking
/// down -Z.
typedef struct crease_view {
    float from_texel[4];   ///< scale xy and offset zw: texel to view-space xy at depth 1, or at any
                           ///< (orthographic)
    float depth_unpack[2]; ///< device depth z gives z * [0] + [1]: 1 / depth, or depth (orthographic)
    float far_depth;       ///< view-space units; a depth from there on is background
    float guard;           ///< width of the guard band, texels
    float resolution[2];   ///< of the picture, texels
    float texel_size[2];   ///< 1 / the size of the depth image, guard band included
} crease_view;

/// What came of composing a recipe: an effect, or a sentence that says why there is none.
typedef struct crease_composition crease_composition;

/// The version of the library as one number: 0.2.0 is 200, 1.2.3 is 10203.
CREASE_C_API uint32_t crease_c_version(void);

/// The version of the library as text, "0.2.0".
CREASE_C_API const char* crease_c_version_text(void);

/// How many parts there are.
CREASE_C_API uint32_t crease_part_count(void);

/// A part; those of a role stand together. NULL from crease_part_count() on.
CREASE_C_API const crease_part* crease_part_at(uint32_t index);

/// How many presets there are.
CREASE_C_API uint32_t crease_preset_count(void);

/// A preset, from the least time to the least error. NULL from crease_preset_count() on.
CREASE_C_API const crease_preset* crease_preset_at(uint32_t index);

/// Composes the effect of a recipe, `SAMPLER/DEPTH/ESTIMATOR[/PART...]` or `preset:NAME[/PART...]`.
/// @return to be given to crease_destroy, also where crease_error says why there is no effect; NULL where
/// memory
///         ran out
CREASE_C_API crease_composition* crease_compose(const char* recipe);

/// One sentence that says why there is no effect; NULL where there is one.
CREASE_C_API const char* crease_error(const crease_composition* composition);

/// The effect, which lives as long as the composition; NULL where there is none.
CREASE_C_API const crease_effect* crease_effect_of(const crease_composition* composition);

/// Frees a composition with all that belongs to it. NULL is left alone.
CREASE_C_API void crease_destroy(crease_composition* composition);

/// Whether the parts of a recipe fit, in a small part of the time that composing takes: for menus. What fits
/// and is too large for an effect is refused by crease_compose alone.
/// @param sentence  where to write why not, cut to `capacity` bytes with its NUL; "" where they fit. May be
/// NULL
/// @return the length of the whole sentence, without the NUL; 0 where they fit
CREASE_C_API size_t crease_check(const char* recipe, char* sentence, size_t capacity);

/// Writes the uniform block with the settings as the parts recommend them, the radius 1, the frame 0 and no
/// camera yet.
/// @param block  of at least effect->block_size bytes
/// @return why nothing is written: NULL, or a block too small
CREASE_C_API const char* crease_write_defaults(const crease_effect* effect, void* block, size_t size);

/// Sets each setting that `name` names, "strength" or "hbao.bias", in a uniform block.
/// @param block  that crease_write_defaults wrote
/// @return why nothing is set: NULL, no setting of that name, or a value out of its range
CREASE_C_API const char* crease_set(const crease_effect* effect, void* block, const char* name, float value);

/// Fills a camera from a projection matrix, perspective or orthographic, also off-centre, with standard,
/// reversed or infinite-far depth.
/// @param matrix  16 numbers, view space to clip space
/// @param width,height,guard  texels: of the picture, and the guard band on each of its sides
/// @param convention  crease_convention, or-ed together
/// @return why it is refused, with `view` unchanged: NULL, a matrix that is no projection, is singular, not
/// finite or
///         of another convention, or a size of 0
CREASE_C_API const char* crease_set_projection(crease_view* view, const float* matrix, uint32_t width,
                                               uint32_t height, uint32_t convention, uint32_t guard);

/// Widens the projection of a picture by a guard band, to draw the larger depth image.
/// @param matrix  16 numbers, column-major
/// @return why nothing is done: NULL
CREASE_C_API const char* crease_widen_projection(float* matrix, uint32_t width, uint32_t height,
                                                 uint32_t guard);

/// The sides of an image for a picture of a size, all in texels; 0 of NULL.
/// @{
CREASE_C_API uint32_t crease_width_of(const crease_extent* size, uint32_t picture_width, uint32_t guard);
CREASE_C_API uint32_t crease_height_of(const crease_extent* size, uint32_t picture_height, uint32_t guard);
/// @}

#ifdef __cplusplus
}
#endif

#endif
