#include "gpu/format/raster_names.h"

#include <array>
#include <cstddef>

namespace glibra::gpu {

GLenum glFunction(base::Comparison comparison) {
    constexpr std::array<GLenum, 8> kFunctions{GL_NEVER,  GL_LESS,    GL_LEQUAL,   GL_EQUAL,
                                               GL_GEQUAL, GL_GREATER, GL_NOTEQUAL, GL_ALWAYS};
    return kFunctions.at(static_cast<std::size_t>(comparison));
}

GLenum glFactor(base::BlendFactor factor) {
    constexpr std::array<GLenum, base::kBlendFactorCount> kFactors{GL_ZERO,
                                                                   GL_ONE,
                                                                   GL_SRC_COLOR,
                                                                   GL_ONE_MINUS_SRC_COLOR,
                                                                   GL_DST_COLOR,
                                                                   GL_ONE_MINUS_DST_COLOR,
                                                                   GL_SRC_ALPHA,
                                                                   GL_ONE_MINUS_SRC_ALPHA,
                                                                   GL_DST_ALPHA,
                                                                   GL_ONE_MINUS_DST_ALPHA,
                                                                   GL_CONSTANT_COLOR,
                                                                   GL_ONE_MINUS_CONSTANT_COLOR,
                                                                   GL_CONSTANT_ALPHA,
                                                                   GL_ONE_MINUS_CONSTANT_ALPHA,
                                                                   GL_SRC_ALPHA_SATURATE};
    return kFactors.at(static_cast<std::size_t>(factor));
}

GLenum glEquation(base::BlendEquation equation) {
    constexpr std::array<GLenum, base::kBlendEquationCount> kEquations{
        GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    return kEquations.at(static_cast<std::size_t>(equation));
}

GLenum glAction(base::StencilAction action) {
    constexpr std::array<GLenum, 8> kActions{GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                             GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
    return kActions.at(static_cast<std::size_t>(action));
}

}  // namespace glibra::gpu
