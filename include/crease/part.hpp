// SPDX-License-Identifier: MIT
#pragma once

#include <crease/array_view.hpp>
#include <crease/glsl_file.hpp>
#include <crease/parameters.hpp>
#include <crease/pass.hpp>
#include <crease/resource.hpp>

#include <string_view>

namespace crease {

/// What a part does in an effect.
enum class role : unsigned char {
    sampler,        ///< where to look: proposes taps around the receiver
    depth_source,   ///< what may be there: the layers of depth that a tap finds
    estimator,      ///< what it means: how much a layer occludes the receiver
    projection,     ///< view: between texels, view space and device depth
    depth_encoding, ///< view: what the depth image holds
    normals,        ///< view: where the receiver's normal comes from
    noise,          ///< two numbers per pixel, by which a sampler differs from pixel to pixel
    second_view,    ///< view: a second camera, for what the first sees at a grazing angle
    layer_carrier,  ///< capture: what keeps the layers that the geometry pass draws
    layer_sampling, ///< capture: which samples keep a fragment
    fold,           ///< how the layers of a tap become one contribution
    scan,           ///< how the sums of a line of a table are made, of those of its pieces
    output,         ///< what leaves the effect beside visibility
    filter,         ///< passes over the result: denoising, upsampling
    stage,          ///< what a pass runs as
    dialect         ///< which GLSL it is written in
};

inline constexpr std::size_t role_count = static_cast<std::size_t>(role::dialect) + 1;

constexpr std::string_view name_of(role r) {
    constexpr std::string_view names[] = {"sampler",        "depth source",   "estimator", "projection",
                                          "depth encoding", "normals",        "noise",     "second view",
                                          "layer carrier",  "layer sampling", "fold",      "scan",
                                          "output",         "filter",         "stage",     "dialect"};
    return names[static_cast<unsigned>(r)];
}

/// An integer that a part takes as a template argument; in GLSL crease_<part>_<name>.
struct number {
    std::string_view name;
    int least, most; ///< inclusive
    int fallback;    ///< where a recipe gives none
    std::string_view meaning;
    /// Whether it is a constant of the programs. Effects that differ only in such numbers are written once,
    /// except for numbers of a depth source, a depth encoding or a second view and for a filter's upsampling,
    /// on which passes and resources depend. False: it places bindings and the like.
    bool in_glsl = true;
};

/// A field of `parameters` that a part reads, and the value that it recommends.
struct setting {
    std::string_view name;
    float parameters::*field;
    float fallback;
    float least, most; ///< inclusive
    std::string_view meaning;
};

/// Something that one part needs and another offers: a kind of tap, an attribute of a layer. See
/// CREASE_TRAIT.
struct trait {
    role from;                 ///< who must offer it
    std::string_view sentence; ///< why an effect without it is refused
};

/// How a pass keeps its result in the texels of an image; its GLSL defines crease_encode_<name> and, where a
/// filter can read it, crease_decode_<name>.
struct encoding {
    std::string_view name;
    format texels;
    const glsl_file* glsl;
    const glsl_file* helper = nullptr; ///< GLSL that must stand before `glsl`
};

/// A `const int` of one step; in GLSL crease_<part>_<name>.
struct step_constant {
    std::string_view name;
    int value;
    std::string_view of{}; ///< takes the place of the part's name, where parts share the body
};

/// What the body of a step defines.
enum class step_kind : unsigned char {
    evaluate, ///< `crease_result crease_evaluate(ivec2 pixel)`: a filter's, and the main pass's
    build,    ///< `void crease_build(ivec2 texel)`, that stores to what the step writes: a depth source's
    rows,     ///< `void crease_build_line(int line)`, which the invocations of a workgroup in a row call
              ///< together for a row: a depth source's. The workgroup's height is that many rows, and the
              ///< last lines may lie outside
    columns   ///< the same for a column, of the invocations in a column of the workgroup
};

/// A pass as a part describes it.
struct step {
    std::string_view name; ///< of the pass
    const glsl_file* body = nullptr;
    step_kind kind = step_kind::evaluate;
    array_view<const role> includes{};            ///< roles whose functions the body calls
    array_view<const trait* const> needs{};       ///< of a build: other parts' extras that the body calls
    array_view<const glsl_file* const> helpers{}; ///< GLSL of a build that must stand before the body
    array_view<const step_constant> constants{};
    bool full_size_input = false;               ///< a filter's: whether that must be as large as the picture
    array_view<const std::string_view> reads{}; ///< the part's own resources that the body reads
    array_view<const std::string_view>
        writes{};                            ///< the part's own resources that a build fills, all of one size
    access how = access::store;              ///< how a build fills them; or modify
    int group_width = 16, group_height = 16; ///< a build's workgroup, invocations
    /// Of a body that reads far around its texel: how many workgroups side by side run down the output
    /// together, so that they find in the cache what they share; 0: they run in rows.
    int columns = 0;
    int from = 0; ///< a build's: the part's first number from which on the step is there
};

/// How a geometry pass fills a resource; its body defines `void crease_capture(vec3 anchor)`.
struct capture_step {
    std::string_view name;
    const glsl_file* body = nullptr;
    array_view<const role> includes{};            ///< roles whose functions the body calls
    array_view<const glsl_file* const> helpers{}; ///< what the body calls besides
    std::string_view writes{};                    ///< the part's own resource
    access how = access::attachment;              ///< or modify
};

/// GLSL of a part that is there only where another part, or one of its steps, needs it.
struct extra {
    const trait* on_need; ///< the trait that the part offers by it
    const glsl_file* glsl;
    format texels = format::none; ///< of the images that hold what it makes, where others than they say do
};

/// What a part says of itself. Parts are open: a host describes its own and composes it with those of crease.
struct part {
    role kind;
    std::string_view name;    ///< in recipes and as the stem of its file, e.g. "hbao"
    std::string_view summary; ///< one line
    std::string_view source;  ///< paper, chapter, algorithm
    const glsl_file* glsl = nullptr;
    array_view<const glsl_file* const>
        helpers{}; ///< GLSL that must stand before `glsl`: the tap's struct, the noise
    array_view<const number> numbers{};
    array_view<const setting> settings{};
    array_view<const trait* const> needs{};
    array_view<const trait* const> offers{};
    array_view<const extra> extras{};
    array_view<const role> wants{};             ///< roles, else absent, of which the effect must have a part
    array_view<const resource> resources{};     ///< what its functions read
    array_view<const resource> intermediates{}; ///< what only its steps read and write
    array_view<const step>
        steps{}; ///< a depth encoding's and a depth source's before the main pass, a filter's after it
    const glsl_file* fold = nullptr;   ///< how the layers of a tap become one contribution, where there is
                                       ///< no part of the role; a depth source's comes before an estimator's
    const glsl_file* gather = nullptr; ///< a fold's: what takes the place of core/gather.glsl
    const glsl_file* packs =
        nullptr; ///< a fold's: which layers it asks of the depth source, for that source's steps
    std::string_view extension{};           ///< of GLSL, that its text needs
    device_features features{};             ///< that its text requires
    const glsl_file* main_body = nullptr;   ///< a second view's: what takes the place of core/visibility.glsl
    const capture_step* captures = nullptr; ///< a layer carrier's
    const glsl_file* result = nullptr;      ///< an output's: `struct crease_result` and its arithmetic
    const encoding* between = nullptr;      ///< an output's: how the result is kept between passes
    array_view<const encoding* const> final_images{}; ///< an output's: the images that leave the effect
    int upsampling = -1; ///< a filter's: index of the number by which its output is larger
    stage_kind stage_of = stage_kind::compute;      ///< a stage's
    dialect_kind dialect_of = dialect_kind::vulkan; ///< a dialect's
};

/// The most numbers that a part may take.
inline constexpr std::size_t most_numbers = 4;

/// A part with its numbers: what a template argument of `effect` or a word of a recipe comes down to.
struct choice {
    const part* what = nullptr;
    int numbers[most_numbers]{};
};

/// A type that names a part: it has `description`, `numbers` where the part takes any, and `needs` (a
/// `traits<...>`) where it needs something of another part.
template <class T>
concept a_part = requires {
    static_cast<const part*>(&T::description);
};

/// The choice that a part's type stands for.
template <a_part Part>
constexpr choice choice_of() {
    choice c{&Part::description, {}};
    if constexpr (requires { Part::numbers; }) {
        std::size_t i = 0;
        for (int value : Part::numbers)
            c.numbers[i++] = value;
    }
    return c;
}

/// A list of traits, as a type and as the data in `part::needs` and `part::offers`.
template <class... Traits>
struct traits {
    static constexpr const trait* values[] = {&Traits::value...};
    static constexpr array_view<const trait* const> list{values};
};

constexpr bool has(array_view<const trait* const> list, const trait* wanted) {
    for (const trait* t : list)
        if (t == wanted)
            return true;
    return false;
}

/// Whether the part of type `Part` offers `Trait`.
template <class Part, class Trait>
constexpr bool offers = has(Part::description.offers, &Trait::value);

}

/// Defines a trait. `sentence_` says who needs what and who does not offer it: it is the static assertion and
/// the run-time refusal.
#define CREASE_TRAIT(name_, from_, sentence_)                                                                \
    struct name_ {                                                                                           \
        static constexpr ::crease::trait value{::crease::role::from_, sentence_};                            \
        template <class Needer, class Offerer>                                                               \
        static constexpr bool met() {                                                                        \
            static_assert(::crease::offers<Offerer, name_>, "crease::effect: " sentence_);                   \
            return ::crease::offers<Offerer, name_>;                                                         \
        }                                                                                                    \
    }
