#pragma once
// Textures with names as samplers and images read them: whether the types fit, and how they are sampled.

#include <glibra/result.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/frame_plan.h"

namespace glibra::plan {

// Finds the texture that each sampler of a draw reads, and the texture image unit of GL that it is bound to
// (language, 2.4 and 7.9).

/// A sampler or image element with the unit of the language that it reads and the unit of GL that it is set
/// to. Both are the same for all draws of a program; only the textures on the units differ.
struct UnitUse {
    SamplerBinding binding;
    int driverUnit = 0;
};

/// Assigns texture image units from 0 on, in the order of the samplers: one per pair of unit and sampler
/// type, since GL forbids samplers of different types on one unit; and one for each bound texture. Image
/// units are assigned likewise. Error draw-E13, without a place, if the driver has too few.
Result<std::vector<UnitUse>> assignUnits(const ProgramInterface& interface,
                                         std::span<const SamplerBinding> samplers, int maxTextureUnits,
                                         int maxImageUnits);

/// The textures that the units hold at a draw or dispatch, and those that are bound by name. A sampler of a
/// type that units cannot hold reads no texture.
std::vector<TextureUse> textureUses(const scene::Scene& scene, scene::SlotTableIndex slots,
                                    const scene::Sampling& sampling, const ProgramInterface& interface,
                                    std::span<const UnitUse> units);

/// The name of a slot in messages: "5 / 3D".
std::string slotText(int unit, scene::TextureTarget target);

/// What a sampler or image of a GLSL type reads.
struct SamplerType {
    /// Nothing for types that no texture of a scene fits, as buffers.
    std::optional<scene::TextureTarget> target{};
    bool isBuffer = false;
    bool isMultisampled = false;
    bool isShadow = false;
    BaseType texels = BaseType::floating;  ///< or integer, unsignedInteger
};
/// The type with that GLSL word: "usampler2DArray".
SamplerType samplerTypeOf(std::string_view word);

/// What a shader reads of a texture: floating, integer or unsignedInteger.
BaseType texelsOf(const scene::Texture& texture);
/// What the GLSL words of such types begin with: "", "i", "u".
std::string_view prefixOf(BaseType texels);

/// The texture as messages name it: "'shadow.layer(2)'".
std::string nameOf(const scene::Scene& scene, const scene::TextureView& view);

/// The format that the shader declares for an image; nothing if it declares none.
std::optional<base::TexelFormat> imageFormatOf(const ProgramInterface& interface,
                                               const ActiveUniform& uniform);

/// The texels that a buffer with elements of that GLSL type has as a texture: the columns of its elements,
/// where three components take the room of four. Nothing for doubles, structures and unknown types.
std::optional<base::TexelFormat> texelsOfType(std::string_view type);

/// Why that sampler or image cannot read the texture or buffer: draw-E09 if the types differ, draw-E10 if the
/// part does not exist.
std::optional<Diagnostic> bindingProblem(const scene::Scene& scene, const ProgramInterface& interface,
                                         const ActiveUniform& uniform, const BoundTexture& bound);

/// Completes the use of a texture by a sampler or image of this type. Integers are read without filters.
/// Where a shader compares depth, samplers read 1 outside of the texture unless the scene sets their
/// wrapping.
void useNamed(const scene::Scene& scene, const scene::TextureView& view, const ValueType& type,
              TextureUse& use);

/// The same for a buffer that it reads as a texture, whose type has texels.
void useBuffer(const scene::Scene& scene, const scene::BufferView& view, TextureUse& use);

/// True if the sampler may read texels of that part of a texture, which is a target of the pass.
bool readsPart(const scene::Scene& scene, const TextureUse& use, const scene::TextureView& target);

}  // namespace glibra::plan
