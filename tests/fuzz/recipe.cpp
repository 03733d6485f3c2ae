// SPDX-License-Identifier: MIT
// The recipe parser: any text either is refused with a sentence or makes an effect that is the same when read
// back.
#include <crease/compose/composition.hpp>

#include <cstdint>
#include <cstdlib>
#include <memory>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const crease::recipe read(std::string_view(reinterpret_cast<const char*>(data), size));
    if (!read) {
        if (read.error().empty())
            std::abort();
        return 0;
    }
    const auto text = read.text();
    const crease::recipe again(text.view());
    if (!again || again.text().view() != text.view())
        std::abort();
    const auto composed = std::make_unique<crease::composition>(again);
    if (!*composed || composed->view().passes.empty())
        std::abort();
    return 0;
}
