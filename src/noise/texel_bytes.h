#pragma once
// Memory for texels without initial values. Setting megabytes to zero takes longer than computing the texels
// that overwrite them.

#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace glibra::noise {

template <class T>
struct Unset : std::allocator<T> {
    template <class Other>
    struct rebind {  // NOLINT(readability-identifier-naming): the standard's name
        using other = Unset<Other>;
    };
    template <class Other>
    void construct(Other* at) noexcept {
        ::new (static_cast<void*>(at)) Other;
    }
    template <class Other, class... From>
    void construct(Other* at, From&&... from) {
        ::new (static_cast<void*>(at)) Other(std::forward<From>(from)...);
    }
};

/// A vector whose constructor and resize leave new bytes unset.
using TexelBytes = std::vector<std::uint8_t, Unset<std::uint8_t>>;
using TexelShorts = std::vector<std::uint16_t, Unset<std::uint16_t>>;

}  // namespace glibra::noise
