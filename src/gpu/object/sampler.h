#pragma once
// Samplers: how a texture is read.

#include <glad/gl.h>

#include <optional>

#include "base/raster_state.h"
#include "gpu/object/name.h"

namespace glibra::gpu {

using base::SamplerState;
using base::Wrap;

/// True for filters that read one texel of a level.
bool isNearest(base::Filter filter);

class Sampler {
  public:
    /// `compare`: for sampler2DShadow and its like, which read 1 where (reference compared with texel) holds,
    /// else 0. Anisotropy above 1 needs a driver that supports it.
    explicit Sampler(const SamplerState& state = {}, std::optional<base::Comparison> compare = {});
    /// Linear, with the same wrapping in every direction.
    explicit Sampler(Wrap wrap) : Sampler(SamplerState{.wrap = {wrap, wrap, wrap}, .border = {}}) {}
    void bind(int unit) const { glBindSampler(static_cast<GLuint>(unit), name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }

  private:
    Name<glDeleteSamplers> name_{glGenSamplers};
};

}  // namespace glibra::gpu
