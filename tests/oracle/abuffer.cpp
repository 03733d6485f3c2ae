// SPDX-License-Identifier: MIT
#include "abuffer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>

namespace oracle {

namespace {

constexpr crease::piece vertex[] = {{"vertex", R"glsl(#version 450
layout(push_constant) uniform transforms { mat4 clip_from_view; };
layout(location = 0) in vec3 position;
void main() { gl_Position = clip_from_view * vec4(position, 1.0); }
)glsl"}};
constexpr crease::piece fragment_text[] = {{"fragment", R"glsl(
void main() { crease_capture(vec3(0.0)); }
)glsl"}};

constexpr std::uint32_t no_key = ~0u;

// With the surface of a triangle: its normal, and its colour in turn.
struct surface_constants {
    glm::mat4 clip_from_view;
    color_table colors;
};

constexpr crease::piece surface_vertex[] = {{"vertex", R"glsl(#version 450
layout(push_constant) uniform transforms { mat4 clip_from_view; uint colors[16]; };
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) flat out vec3 facing;
layout(location = 1) flat out uint triangle;
void main() {
    gl_Position = clip_from_view * vec4(position, 1.0);
    facing = normal;
    triangle = uint(gl_VertexIndex) / 3u;
}
)glsl"}};
constexpr crease::piece surface_text[] = {{"fragment", R"glsl(
layout(push_constant) uniform transforms { mat4 clip_from_view; uint colors[16]; };
layout(location = 0) flat in vec3 facing;
layout(location = 1) flat in uint triangle;
void main() { crease_capture(vec3(0.0), facing, unpackUnorm4x8(colors[triangle % 16u])); }
)glsl"}};

bool captures_surfaces(const crease::effect_view& effect) {
    return std::ranges::any_of(effect.passes, &crease::pass::takes_surfaces);
}

/// As `crease_unpack_surface_normal`, by the octahedron that it is on.
glm::dvec3 normal_of(std::uint32_t word) {
    const double x = (static_cast<double>(word & 4095u) - 2048) / 2047,
                 y = (static_cast<double>(word >> 12 & 4095u) - 2048) / 2047;
    const double z = 1 - std::abs(x) - std::abs(y);
    if (z >= 0)
        return glm::normalize(glm::dvec3(x, y, z));
    return glm::normalize(
        glm::dvec3(std::copysign(1 - std::abs(y), x), std::copysign(1 - std::abs(x), y), z));
}

/// Of which side of the edge from a to b a point lies, texels; positive: to the left, with y up.
double side_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 point) {
    const glm::dvec2 edge = b - a, to_point = point - a;
    return (edge.x * to_point.y - edge.y * to_point.x) / glm::length(edge);
}

bool is_nearer(const fragment& a, const fragment& b) {
    return a.depth < b.depth || (a.depth == b.depth && !a.back && b.back);
}

}

color_table every_color() {
    color_table all{};
    for (std::uint32_t i = 0; i < 16; ++i) {
        const std::uint32_t opacity = i == 3 ? 0 : i == 7 ? 255 : 17 + 13 * i;
        all[i] = (40 + 11 * i) | (200 - 9 * i) << 8 | (7 * i) << 16 | opacity << 24;
    }
    return all;
}

fragment_lists rasterise(const triangles& scene, lens seen_by, int width, int height) {
    picture p;
    p.width = width;
    p.height = height;
    p.projection = make_projection(seen_by, static_cast<double>(width) / height);
    p.reversed = seen_by == lens::reversed || seen_by == lens::infinite;
    const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    fragment_lists lists{.of = std::vector<std::vector<fragment>>(texels),
                         .doubtful = std::vector<bool>(texels)};
    for (std::size_t t = 0; t + 2 < scene.size(); t += 3) {
        const glm::dvec3 a = scene[t], b = scene[t + 1], c = scene[t + 2];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const glm::dvec2 on_a = p.project(a), on_b = p.project(b), on_c = p.project(c);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const glm::dvec2 centre(x + 0.5, y + 0.5);
                const double sides[] = {side_of(on_a, on_b, centre), side_of(on_b, on_c, centre),
                                        side_of(on_c, on_a, centre)};
                const auto [least, most] = std::minmax({sides[0], sides[1], sides[2]});
                const std::size_t at = p.index(x, y);
                if (std::abs(least) < 0.004 || std::abs(most) < 0.004)
                    lists.doubtful[at] = true;
                if (least < 0 && most > 0)
                    continue;
                glm::dvec3 origin, direction;
                p.ray(centre, origin, direction);
                const double towards = glm::dot(direction, normal);
                const glm::dvec3 hit = origin + direction * (glm::dot(a - origin, normal) / towards);
                lists.of[at].push_back({-hit.z, towards > 0, t / 3});
            }
    }
    for (std::vector<fragment>& list : lists.of)
        std::ranges::sort(list, is_nearer);
    return lists;
}

triangles soup(unsigned count, std::uint32_t seed) {
    const auto random = [&seed] {
        seed = seed * 1664525u + 1013904223u;
        return static_cast<float>(seed >> 8) / 16777216.0f;
    };
    triangles all;
    for (unsigned i = 0; i < count; ++i) {
        const float depth = 1.5f + 4 * random();
        const glm::vec3 middle((random() - 0.5f) * depth, (random() - 0.5f) * depth, -depth);
        for (int corner = 0; corner < 3; ++corner)
            all.push_back(middle + glm::vec3((random() - 0.5f) * 1.6f * depth,
                                             (random() - 0.5f) * 1.6f * depth, random() - 0.5f));
    }
    return all;
}

triangles turned(const triangles& scene) {
    triangles other = scene;
    for (std::size_t t = 0; t + 2 < other.size(); t += 3)
        std::swap(other[t + 1], other[t + 2]);
    return other;
}

std::vector<named_triangles> fragment_scenes() {
    triangles coplanar = soup(5, 7);
    const triangles same = coplanar, other = turned(coplanar);
    coplanar.insert(coplanar.end(), same.begin(), same.end());
    coplanar.insert(coplanar.end(), other.begin(), other.end());
    return {{"nothing but a far corner", {{9, 9, -10}, {9.1f, 9, -10}, {9, 9.1f, -10}}},
            {"few", soup(6, 1)},
            {"coplanar", coplanar},
            {"one through another", soup(60, 2)},
            {"up to 64 and more", soup(400, 3)}};
}

fragment_capture::fragment_capture(const std::string& recipe, unsigned width, unsigned height, lens seen_by,
                                   std::string_view last, std::optional<unsigned> free_nodes,
                                   std::optional<std::uint32_t> rubbish, std::string_view normals)
    : width_(width), height_(height),
      projection_(clip_from_view(seen_by, static_cast<double>(width) / height)),
      composed_(
          compose(recipe + "/linear_depth/" + std::string(normals) +
                  (seen_by == lens::orthographic || seen_by == lens::anamorphic ? "/orthographic" : ""))),
      how_(composed_->view().defaults), host_{.vertex = vertex,
                                              .fragment = fragment_text,
                                              .push_constant_bytes = sizeof(glm::mat4)} {
    crease::effect_view effect = composed_->view();
    if (captures_surfaces(effect))
        host_ = {.vertex = surface_vertex,
                 .fragment = surface_text,
                 .push_constant_bytes = sizeof(surface_constants)};
    resources_.assign(effect.resources.begin(), effect.resources.end());
    const bool are_linked = has("node_count");
    for (crease::resource& each : resources_) {
        if (free_nodes && each.name == "node_count") {
            const auto pool = std::ranges::find(resources_, "list_nodes", &crease::resource::name);
            each.clear = width * height * pool->layers - *free_nodes;
        }
        if (free_nodes && each.name == "list_nodes" && !are_linked) {
            // With surfaces the nearest of each texel has a node too.
            const unsigned own = captures_surfaces(effect) ? width * height : 0;
            each.size = {.fixed_width = own + *free_nodes, .fixed_height = 1};
            each.layers = 1;
        }
        if (rubbish && each.life == crease::lifetime::transient && !each.cleared) {
            each.cleared = true;
            each.clear = *rubbish;
        }
    }
    effect.resources = resources_;
    std::size_t passes = 1;
    while (effect.passes[passes - 1].name != last)
        REQUIRE(++passes <= effect.passes.size());
    effect.passes = {effect.passes.data(), passes};
    runner_ = std::make_unique<crease::vulkan::runner>(device(), effect, width, height);
    float matrix[16];
    std::memcpy(matrix, &projection_, sizeof matrix);
    REQUIRE(crease::set_projection(how_.view, matrix, width, height));
    if (std::ranges::find(resources_, "depth", &crease::resource::name) != resources_.end())
        runner_->upload("depth", std::vector<float>(std::size_t{width} * height, 0.01f));
}

void fragment_capture::set(std::string_view name, float value) {
    if (name == "radius")
        how_.radius = value;
    else
        oracle::set(how_, *composed_, name, value);
}

void fragment_capture::draw(const triangles& first, const triangles& others, const color_table& colors) {
    const auto mesh_of = [](const triangles& scene) {
        std::vector<float> numbers;
        for (std::size_t i = 0; i < scene.size(); ++i) {
            const glm::vec3 &p = scene[i], *corners = &scene[i - i % 3];
            const glm::vec3 n = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
            numbers.insert(numbers.end(), {p.x, p.y, p.z, n.x, n.y, n.z});
        }
        return std::make_unique<crease::vulkan::mesh>(device(), numbers);
    };
    const auto first_mesh = mesh_of(first), other_mesh = mesh_of(others);
    const surface_constants constants{projection_, colors};
    const std::span<const std::byte> pushed =
        std::as_bytes(std::span(&constants, 1)).first(host_.push_constant_bytes);
    const auto passes = composed_->view().passes;
    for (const crease::pass& each : passes)
        if (each.stage == crease::stage_kind::geometry) {
            const bool is_first = &each == passes.data() || each.name == "capture_static_surfaces";
            runner_->set_geometry(each.name, host_, is_first ? *first_mesh : *other_mesh, pushed);
        }
    runner_->run(how_);
}

bool fragment_capture::has(std::string_view resource) const {
    return std::ranges::find(resources_, resource, &crease::resource::name) != resources_.end();
}

std::vector<std::uint32_t> fragment_capture::words_in(std::string_view buffer) const {
    const std::vector<std::byte> bytes = runner_->download_buffer(buffer);
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

std::uint32_t fragment_capture::count_in(std::string_view buffer) const {
    const std::vector<std::uint32_t> words = words_in(buffer);
    REQUIRE(words.size() == 1);
    return words[0];
}

std::vector<std::vector<fragment>> fragment_capture::packed(std::size_t layers) const {
    const std::vector<float> all = runner_->download("packed_layers");
    const std::size_t texels = std::size_t{width_} * height_, each = std::min<std::size_t>(layers, 4);
    const std::size_t components = each == 3 ? 4 : each;
    std::vector<std::vector<fragment>> lists(texels);
    for (std::size_t at = 0; at < texels; ++at)
        for (std::size_t i = 0; i < layers; ++i) {
            const float depth = all[((i / components) * texels + at) * components + i % components];
            if (!(depth < 1e9f))
                break;
            lists[at].push_back({std::abs(depth), depth < 0});
        }
    return lists;
}

namespace {

/// The words of an image of whole numbers, which only those of one component give.
std::vector<std::uint32_t> words_of(crease::vulkan::runner& runner, std::string_view image) {
    const std::vector<std::byte> bytes = crease::vulkan::download_bytes(device(), runner.image_of(image));
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

}

std::vector<std::vector<surface_fragment>> fragment_capture::surfaces() const {
    const std::vector<std::uint32_t> words = words_of(*runner_, "layer_surfaces");
    const std::size_t texels = std::size_t{width_} * height_, layers = words.size() / 4 / texels;
    std::vector<std::vector<surface_fragment>> lists(texels);
    for (std::size_t at = 0; at < texels; ++at)
        for (std::size_t i = 0; i < layers; ++i) {
            const std::uint32_t* own = &words[4 * (i * texels + at)];
            const float depth = std::bit_cast<float>(own[0]);
            if (!(std::abs(depth) < 1e9f))
                break;
            lists[at].push_back({std::abs(depth), depth < 0, own[1], normal_of(own[2])});
        }
    return lists;
}

std::vector<std::vector<surface_fragment>> fragment_capture::nodes() const {
    const std::vector<std::uint32_t> words = words_of(*runner_, "compressed_layers"),
                                     more = words_of(*runner_, "compressed_normals");
    const std::size_t texels = std::size_t{width_} * height_, groups = words.size() / 4 / texels;
    std::vector<std::vector<surface_fragment>> lists(texels);
    for (std::size_t at = 0; at < texels; ++at)
        for (std::size_t i = 0; i < 4 * groups; ++i) {
            const std::uint32_t* own = &words[4 * (i / 4 * texels + at)];
            const auto half = static_cast<std::uint16_t>(own[i % 4 / 2] >> (16 * (i % 2)));
            const float depth = crease::vulkan::detail::float_of_half(half) * how_.radius;
            if (!std::isfinite(depth))
                break;
            std::uint8_t bytes[12]; // of the normals, three each
            const std::uint32_t rest[] = {own[3], more[(i / 4 * 2) * texels + at],
                                          more[(i / 4 * 2 + 1) * texels + at]};
            std::memcpy(bytes, rest, sizeof bytes);
            const std::uint8_t* normal = &bytes[3 * (i % 4)];
            lists[at].push_back({std::abs(depth), depth < 0, own[2] >> (8 * (i % 4)) << 24,
                                 normal_of(normal[0] | static_cast<std::uint32_t>(normal[1]) << 8 |
                                           static_cast<std::uint32_t>(normal[2]) << 16)});
        }
    return lists;
}

std::vector<std::vector<std::uint32_t>> fragment_capture::opacities() const {
    const std::vector<std::uint32_t> words = runner_->download_uint("packed_opacities");
    const std::vector<std::vector<surface_fragment>> all = surfaces();
    std::vector<std::vector<std::uint32_t>> lists(all.size());
    for (std::size_t at = 0; at < all.size(); ++at)
        for (std::size_t i = 0; i < all[at].size(); ++i)
            lists[at].push_back(words[i / 4 * all.size() + at] >> (8 * (i % 4)) & 255u);
    return lists;
}

fragment_capture::keys_of_texels fragment_capture::linked() const {
    const std::vector<std::uint32_t> heads = runner_->download_uint("list_heads"),
                                     nodes = words_in("list_nodes");
    const std::size_t texels = heads.size() / 2;
    keys_of_texels keys(texels);
    for (std::size_t at = 0; at < texels; ++at) {
        keys[at].push_back(heads[at]);
        for (std::uint32_t node = heads[texels + at]; node != no_key; node = nodes[2 * node + 1]) {
            REQUIRE(2 * std::size_t{node} + 1 < nodes.size());
            REQUIRE(keys[at].size() < 1000);
            keys[at].push_back(nodes[2 * node]);
        }
    }
    return keys;
}

fragment_capture::keys_of_texels fragment_capture::linear() const {
    const std::vector<std::uint32_t> nearest = runner_->download_uint("nearest_fragments"),
                                     places = runner_->download_uint("list_places"),
                                     starts = words_in("column_starts"), nodes = words_in("list_nodes");
    const std::size_t texels = nearest.size();
    REQUIRE(starts.size() == width_);
    keys_of_texels keys(texels);
    std::size_t first = 0; // lists stand one behind another down the columns, with no gap
    for (std::size_t x = 0; x < width_; ++x) {
        CHECK(starts[x] == first);
        for (std::size_t at = x; at < texels; at += width_) {
            keys[at].push_back(nearest[at]);
            const std::size_t end = starts[x] + places[at], stored = first + places[texels + at];
            CHECK(stored == end);
            for (std::size_t node = first; node < std::min({stored, end, nodes.size()}); ++node)
                keys[at].push_back(nodes[node]);
            first = end;
        }
    }
    return keys;
}

std::vector<std::vector<fragment>> fragment_capture::listed() const {
    keys_of_texels keys = has("node_count") ? linked() : linear();
    std::vector<std::vector<fragment>> lists(keys.size());
    for (std::size_t at = 0; at < keys.size(); ++at) {
        CHECK(std::ranges::min(keys[at]) == keys[at][0]);
        std::ranges::sort(keys[at]);
        for (std::uint32_t key : keys[at])
            if (key != no_key)
                lists[at].push_back({std::bit_cast<float>(key >> 1), (key & 1) != 0});
    }
    return lists;
}

std::vector<float> visibility_of(const std::string& recipe, const triangles& first, const triangles& others,
                                 std::optional<float> thickness) {
    constexpr unsigned width = 40, height = 24;
    triangles all = first;
    all.insert(all.end(), others.begin(), others.end());
    fragment_capture front("directions:1x1/layer_array:1/hbao", width, height);
    front.draw(all);
    std::vector<float> depth;
    for (const std::vector<fragment>& list : front.packed(1))
        depth.push_back(list.empty() ? 0 : static_cast<float>(list[0].depth));
    fragment_capture whole(recipe + "/r32f", width, height, lens::standard, "visibility");
    whole.runner().upload("depth", depth);
    whole.set("radius", 3);
    if (thickness)
        whole.set("thickness", *thickness);
    whole.draw(first, others);
    return whole.runner().download("visibility");
}

}
