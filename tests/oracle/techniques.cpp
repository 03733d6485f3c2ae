// SPDX-License-Identifier: MIT
#include "techniques.hpp"

#include "slices.hpp"

namespace oracle {

const std::vector<technique>& techniques() {
    static const std::vector<technique> all{
        {"hemisphere_points:12", "ssao",
         [](const picture& p, const receiver& r, const settings& s) {
             return ssao(p, r, s, hemisphere_points(p, r, s, 12));
         }},
        {"directions:6x3", "hbao",
         [](const picture& p, const receiver& r, const settings& s) {
             return hbao(p, r, s, directions(p, r, s, 6, 3));
         }},
        {"directions:6x5", "hbao_plus",
         [](const picture& p, const receiver& r, const settings& s) {
             return hbao_plus(p, r, s, directions(p, r, s, 6, 5));
         }},
        {"poisson_disk:12", "hbao_plus",
         [](const picture& p, const receiver& r, const settings& s) {
             return hbao_plus(p, r, s, poisson_disk(p, r, s, 12));
         }},
        {"slices:3x4", "gtao",
         [](const picture& p, const receiver& r, const settings& s) {
             return gtao(p, r, s, slices(p, r, s, 3, 4));
         }},
        {"half_directions:3x5", "gtao",
         [](const picture& p, const receiver& r, const settings& s) {
             return gtao(p, r, s, half_directions(p, r, s, 3, 5));
         }},
        {"slices:4x3", "visibility_bitmask",
         [](const picture& p, const receiver& r, const settings& s) {
             return visibility_bitmask(p, r, s, slices(p, r, s, 4, 3));
         }},
        {"half_directions:8x4", "cosine_bitmask:0x0",
         [](const picture& p, const receiver& r, const settings& s) {
             return cosine_bitmask(p, r, s, half_directions(p, r, s, 8, 4), false, false);
         }},
        {"half_directions:2x8", "cosine_bitmask:1x1",
         [](const picture& p, const receiver& r, const settings& s) {
             return cosine_bitmask(p, r, s, half_directions(p, r, s, 2, 8), true, true);
         }},
        {"slices:3x6x3", "cosine_bitmask:0x1",
         [](const picture& p, const receiver& r, const settings& s) {
             return cosine_bitmask(p, r, s, slices(p, r, s, 3, 6, 3), false, true);
         }},
        {"axes:8x24", "hbao",
         [](const picture& p, const receiver& r, const settings& s) {
             return hbao(p, r, s, axis_taps(p, r, s, 8, 24));
         }},
        {"axes:3x5", "hbao_plus", // the reach is less than the radius
         [](const picture& p, const receiver& r, const settings& s) {
             return hbao_plus(p, r, s, axis_taps(p, r, s, 3, 5));
         }},
        {"axes:24x12", "hbao_plus", // the radius is less than the steps
         [](const picture& p, const receiver& r, const settings& s) {
             return hbao_plus(p, r, s, axis_taps(p, r, s, 24, 12));
         }},
        {"axes:5x24", "cosine_bitmask:0x1",
         [](const picture& p, const receiver& r, const settings& s) {
             return cosine_bitmask(p, r, s, axis_slices(p, r, s, 5, 24), false, true);
         }},
    };
    return all;
}

}
