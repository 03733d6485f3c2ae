// SPDX-License-Identifier: MIT
#include <crease/crease.hpp>

#include <iostream>
#include <string_view>
#include <type_traits>

/// What the engine knows of the devices that it ships on.
struct desktop {
    static constexpr std::string_view name = "desktop";
    static constexpr crease::device_features features{.extended_storage_formats = true};
    static constexpr int taps = 48; // a pixel, that the frame has time for
};

struct handheld {
    static constexpr std::string_view name = "handheld";
    static constexpr crease::device_features features{.extended_storage_formats = true};
    static constexpr int taps = 12;
};

struct old_phone {
    static constexpr std::string_view name = "old phone";
    static constexpr crease::device_features features{};
    static constexpr int taps = 4;
};

/// Horizons where there are taps to find them with, else the cheaper estimate at half the resolution.
template <class Device, class Stage>
using variant_in =
    std::conditional_t<Device::taps >= 12,
                       crease::effect<crease::directions<Device::taps / 6, 6>, crease::single_layer,
                                      crease::hbao, crease::bilateral<>, Stage>,
                       crease::effect<crease::poisson_disk<Device::taps * 4>, crease::single_layer,
                                      crease::hbao_plus, crease::upsample<2>, Stage>>;

/// In compute where the device can run it, else as fragments, which ask for less.
template <class Device>
using variant =
    std::conditional_t<Device::features.cover(variant_in<Device, crease::compute<8, 8>>::features),
                       variant_in<Device, crease::compute<8, 8>>, variant_in<Device, crease::fragment>>;

static_assert(std::is_same_v<variant<desktop>,
                             crease::effect<crease::directions<8, 6>, crease::single_layer, crease::hbao,
                                            crease::bilateral<>, crease::compute<8, 8>>>);
static_assert(variant<handheld>::passes[0].stage == crease::stage_kind::compute);
static_assert(variant<old_phone>::passes[0].stage == crease::stage_kind::fragment);

template <class Device>
void print() {
    // A device that the chosen variant cannot run on stops the build here.
    static_assert(Device::features.cover(variant<Device>::features));
    std::cout << Device::name << ":\n";
    for (const crease::pass& pass : variant<Device>::passes) {
        std::cout << "  " << pass.name
                  << (pass.stage == crease::stage_kind::compute ? ", compute" : ", fragment") << ", 1/"
                  << pass.size.divisor << " of the resolution";
        for (const crease::constant& number : pass.constants)
            std::cout << ", " << number.part << ' ' << number.number << ' ' << number.value;
        std::cout << '\n';
    }
}

int main() {
    print<desktop>();
    print<handheld>();
    print<old_phone>();
}
