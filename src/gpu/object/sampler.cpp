#include "gpu/object/sampler.h"

#include <algorithm>
#include <array>

#include "base/number.h"
#include "gpu/state/raster_tracker.h"

namespace glibra::gpu {
namespace {

GLint glWrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return GL_REPEAT;
        case Wrap::clampToEdge:
            return GL_CLAMP_TO_EDGE;
        case Wrap::clampToBorder:
            return GL_CLAMP_TO_BORDER;
        case Wrap::mirroredRepeat:
            break;
    }
    return GL_MIRRORED_REPEAT;
}

GLint glFilter(base::Filter filter) {
    switch (filter) {
        case base::Filter::nearest:
            return GL_NEAREST;
        case base::Filter::linear:
            return GL_LINEAR;
        case base::Filter::nearestMipmapNearest:
            return GL_NEAREST_MIPMAP_NEAREST;
        case base::Filter::linearMipmapNearest:
            return GL_LINEAR_MIPMAP_NEAREST;
        case base::Filter::nearestMipmapLinear:
            return GL_NEAREST_MIPMAP_LINEAR;
        case base::Filter::linearMipmapLinear:
            break;
    }
    return GL_LINEAR_MIPMAP_LINEAR;
}

bool isNearest(base::Filter filter) {
    return filter == base::Filter::nearest || filter == base::Filter::nearestMipmapNearest ||
           filter == base::Filter::nearestMipmapLinear;
}

}  // namespace

Sampler::Sampler(const SamplerState& state, std::optional<base::Comparison> compare) {
    GLuint name = 0;
    glGenSamplers(1, &name);
    name_ = Name<deleteSampler>(name);
    constexpr std::array<GLenum, 3> kAxes{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    for (std::size_t i = 0; i < kAxes.size(); ++i) glSamplerParameteri(name, kAxes[i], glWrap(state.wrap[i]));
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, glFilter(state.filter));
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, isNearest(state.filter) ? GL_NEAREST : GL_LINEAR);
    if (state.anisotropy > 1)
        glSamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(state.anisotropy));
    if (state.border != std::array<double, 4>{}) {
        std::array<float, 4> border{};
        std::transform(state.border.begin(), state.border.end(), border.begin(), base::toFloat);
        glSamplerParameterfv(name, GL_TEXTURE_BORDER_COLOR, border.data());
    }
    if (!compare) return;
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_FUNC, static_cast<GLint>(glFunction(*compare)));
}

}  // namespace glibra::gpu
