// SPDX-License-Identifier: MIT
#include "noise/void_and_cluster.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace crease::tools {

namespace {

/// Which texels are filled, and how crowded each is: a Gaussian around every filled one. Whole numbers, so
/// that ties are ties on every machine.
class pattern {
public:
    explicit pattern(unsigned side)
        : side_(side), filled_(side * side), crowding_(side * side), bump_(side * side) {
        const double deviation = 1.9;
        for (unsigned y = 0; y < side; ++y)
            for (unsigned x = 0; x < side; ++x) {
                const double dx = std::min(x, side - x), dy = std::min(y, side - y);
                bump_[y * side + x] =
                    std::lround((1 << 24) * std::exp(-(dx * dx + dy * dy) / (2 * deviation * deviation)));
            }
    }

    bool is_filled(unsigned at) const { return filled_[at]; }

    void flip(unsigned at) {
        filled_[at] = !filled_[at];
        const long sign = filled_[at] ? 1 : -1;
        for (unsigned y = 0; y < side_; ++y)
            for (unsigned x = 0; x < side_; ++x) {
                const unsigned dx = (x + side_ - at % side_) % side_, dy = (y + side_ - at / side_) % side_;
                crowding_[y * side_ + x] += sign * bump_[dy * side_ + dx];
            }
    }

    /// The filled texel that is most crowded.
    unsigned tightest_cluster() const {
        return best([this](unsigned a, unsigned b) {
            return !filled_[b] || (filled_[a] && crowding_[a] > crowding_[b]);
        });
    }
    /// The empty texel that is least crowded.
    unsigned largest_void() const {
        return best([this](unsigned a, unsigned b) {
            return filled_[b] || (!filled_[a] && crowding_[a] < crowding_[b]);
        });
    }

private:
    template <class Better>
    unsigned best(Better better) const {
        unsigned found = 0;
        for (unsigned at = 1; at < side_ * side_; ++at)
            if (better(at, found))
                found = at;
        return found;
    }

    unsigned side_;
    std::vector<bool> filled_;
    std::vector<long> crowding_, bump_;
};

/// A tenth of the texels, as evenly spread as moves from clusters to voids make them.
pattern spread_out(unsigned side) {
    pattern spread(side);
    std::mt19937 random(1);
    for (unsigned left = std::max(side * side / 10, 1u); left > 0;) {
        const unsigned at = static_cast<unsigned>(random() % (side * side));
        if (spread.is_filled(at))
            continue;
        spread.flip(at);
        --left;
    }
    for (;;) {
        const unsigned from = spread.tightest_cluster();
        spread.flip(from);
        const unsigned to = spread.largest_void();
        spread.flip(to);
        if (to == from)
            return spread;
    }
}

}

std::vector<std::uint16_t> void_and_cluster(unsigned side) {
    const pattern first = spread_out(side);
    std::vector<std::uint16_t> ranks(side * side);
    unsigned filled = 0;
    for (unsigned at = 0; at < side * side; ++at)
        filled += first.is_filled(at);
    pattern emptied = first;
    for (unsigned rank = filled; rank-- > 0;) {
        const unsigned at = emptied.tightest_cluster();
        emptied.flip(at);
        ranks[at] = static_cast<std::uint16_t>(rank);
    }
    // The tightest cluster of empty texels, which counts from one half on, is the largest void too.
    pattern growing = first;
    for (unsigned rank = filled; rank < side * side; ++rank) {
        const unsigned at = growing.largest_void();
        growing.flip(at);
        ranks[at] = static_cast<std::uint16_t>(rank);
    }
    return ranks;
}

}
