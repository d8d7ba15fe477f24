#pragma once
// The values that glibra supplies to shaders (language, 6), for one draw.

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <span>

#include "glsl/types/builtins.h"

namespace glibra::render {

struct DrawFacts {
    glm::dmat4 modelView{1.0};
    glm::dmat4 view{1.0};   ///< of the camera
    glm::dmat4 model{1.0};  ///< modelView = view * model
    glm::dmat4 projection{1.0};
    double timer = 0;  ///< 0..1
    glm::dvec4 color{1.0};
    double pointSize = 1;
    glm::dmat4 texture{1.0};  ///< gl_TextureMatrix[0]
};

/// Up to eight matrices, stored in place, because values are made for every uniform of every draw.
class SuppliedNumbers {
  public:
    static constexpr std::size_t kMost = 128;
    SuppliedNumbers() = default;
    SuppliedNumbers(std::initializer_list<double> numbers) {
        for (const double each : numbers) add(each);
    }
    /// Numbers beyond kMost are ignored.
    void add(double number) {
        if (count_ < kMost) numbers_.at(count_++) = number;
    }
    [[nodiscard]] std::span<const double> span() const { return {numbers_.data(), count_}; }

  private:
    std::array<double, kMost> numbers_;
    std::size_t count_ = 0;
};

/// The value of a built-in, column by column. Arrays of matrices (the texture matrices) have `elements`
/// matrices, at most 8.
SuppliedNumbers suppliedValue(glsl::Builtin builtin, const DrawFacts& facts, int elements);

}  // namespace glibra::render
