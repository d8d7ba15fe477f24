#pragma once
// What OpenGL guarantees of numbers that are stored in fewer bits.

#include <gtest/gtest.h>

#include <cmath>

namespace glibra::test {

/// A number that is stored in a normalized format becomes either of the two integers beside it; the nearest
/// one is only preferred (OpenGL 4.6, 2.3.5.2). NVIDIA's driver makes 127 of .5. `exact`: in units of the
/// stored integer; `error`: of what the device computed, in the same unit.
inline bool mayBeStored(double stored, double exact, double error = 1e-4) {
    const double integer = std::round(stored);  // it may have been read as a float
    return integer >= std::floor(exact - error) && integer <= std::ceil(exact + error);
}

/// The same as an assertion that shows the numbers.
inline void expectStored(double stored, double exact, double error = 1e-4) {
    EXPECT_TRUE(mayBeStored(stored, exact, error)) << exact << " became " << stored;
}

}  // namespace glibra::test
