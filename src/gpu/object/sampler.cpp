#include "gpu/object/sampler.h"

#include <algorithm>
#include <array>

#include "base/number.h"
#include "gpu/context/es_functions.h"
#include "gpu/format/raster_names.h"

namespace glibra::gpu {
namespace {

GLint glWrap(Wrap wrap) {
    constexpr std::array<GLint, 4> kWraps{GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT,
                                          GL_CLAMP_TO_BORDER};
    return kWraps.at(static_cast<std::size_t>(wrap));
}

GLint glFilter(base::Filter filter) {
    constexpr std::array<GLint, 6> kFilters{GL_NEAREST,
                                            GL_LINEAR,
                                            GL_NEAREST_MIPMAP_NEAREST,
                                            GL_LINEAR_MIPMAP_NEAREST,
                                            GL_NEAREST_MIPMAP_LINEAR,
                                            GL_LINEAR_MIPMAP_LINEAR};
    return kFilters.at(static_cast<std::size_t>(filter));
}

}  // namespace

bool isNearest(base::Filter filter) {
    return filter == base::Filter::nearest || filter == base::Filter::nearestMipmapNearest ||
           filter == base::Filter::nearestMipmapLinear;
}

Sampler::Sampler(const SamplerState& state, std::optional<base::Comparison> compare) {
    const GLuint name = id();
    constexpr std::array<GLenum, 3> kAxes{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        // ES has no borders; shaders read them (glsl/es/borders.h).
        const bool isEdge = isEs() && state.wrap[i] == Wrap::clampToBorder;
        glSamplerParameteri(name, kAxes[i], isEdge ? GL_CLAMP_TO_EDGE : glWrap(state.wrap[i]));
    }
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, glFilter(state.filter));
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, isNearest(state.filter) ? GL_NEAREST : GL_LINEAR);
    if (state.anisotropy > 1)
        glSamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(state.anisotropy));
    if (state.border != std::array<double, 4>{}) {
        std::array<float, 4> border{};
        std::ranges::transform(state.border, border.begin(), base::toFloat);
        glSamplerParameterfv(name, GL_TEXTURE_BORDER_COLOR, border.data());
    }
    if (!compare) return;
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_FUNC, static_cast<GLint>(glFunction(*compare)));
}

}  // namespace glibra::gpu
