#pragma once
// Computes one component of one texel in double precision: the reference for every faster method.

#include <cstdint>

#include "noise/axis_places.h"
#include "noise/tables.h"

namespace glibra::noise {

/// floor(255 * value) of an octave at a texel's places along x, y and z.
std::uint8_t exactByte(const tables::Octave3& table, const AxisPlace& x, const AxisPlace& y,
                       const AxisPlace& z);
std::uint8_t exactByte(const tables::Octave2& table, const AxisPlace& x, const AxisPlace& y);

}  // namespace glibra::noise
