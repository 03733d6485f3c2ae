// SPDX-License-Identifier: MIT
#pragma once

namespace crease {

/// How a pass touches a resource.
enum class access : unsigned char {
    uniform,    ///< a std140 block
    sample,     ///< a sampled image, nearest filter, clamped to the edge
    load,       ///< a storage image or buffer that is read
    store,      ///< a storage image or buffer that is written
    modify,     ///< a storage image or buffer that is read and written, or changed by atomic operations
    attachment, ///< an attachment; has no binding, its location is `slot`
    result      ///< the return value of a function; has no binding
};

/// Whether a pass that touches a resource so writes it.
constexpr bool writes(access how) {
    return how != access::uniform && how != access::sample && how != access::load;
}

/// Whether a resource that is touched so has a descriptor.
constexpr bool has_descriptor(access how) {
    return how != access::attachment && how != access::result;
}

}
