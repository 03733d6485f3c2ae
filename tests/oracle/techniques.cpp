// SPDX-License-Identifier: MIT
#include "techniques.hpp"

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
    };
    return all;
}

}
