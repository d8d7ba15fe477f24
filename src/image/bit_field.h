#pragma once
// One component of a pixel that is packed into an integer.

#include <bit>
#include <cstdint>
#include <limits>

namespace glibra::image {

/// The component in the bits of `mask`, scaled to the whole range of Value with rounding. A component without
/// a mask is `missing`.
template <class Value>
class BitField {
  public:
    BitField(std::uint32_t mask, Value missing)
        : mask_(mask),
          shift_(mask == 0 ? 0 : static_cast<std::uint32_t>(std::countr_zero(mask))),
          missing_(missing),
          most_(mask >> shift_) {}

    [[nodiscard]] Value of(std::uint32_t pixel) const {
        if (mask_ == 0) return missing_;
        const std::uint64_t value = (pixel & mask_) >> shift_;
        return static_cast<Value>((value * std::numeric_limits<Value>::max() + most_ / 2) / most_);
    }

  private:
    std::uint32_t mask_, shift_;
    Value missing_;
    std::uint64_t most_;
};

}  // namespace glibra::image
