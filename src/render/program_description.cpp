#include <algorithm>

#include "render/programs.h"

namespace glibra::render {
namespace {

plan::BaseType baseType(gpu::BaseType base) {
    switch (base) {
        case gpu::BaseType::floating:
            return plan::BaseType::floating;
        case gpu::BaseType::doublePrecision:
            return plan::BaseType::doublePrecision;
        case gpu::BaseType::integer:
            return plan::BaseType::integer;
        case gpu::BaseType::unsignedInteger:
            return plan::BaseType::unsignedInteger;
        case gpu::BaseType::boolean:
            return plan::BaseType::boolean;
        case gpu::BaseType::sampler:
            return plan::BaseType::sampler;
        case gpu::BaseType::image:
            return plan::BaseType::image;
        case gpu::BaseType::atomicCounter:
            break;
    }
    return plan::BaseType::other;
}

std::optional<scene::TextureTarget> textureTarget(GLenum target) {
    switch (target) {
        case GL_TEXTURE_1D:
            return scene::TextureTarget::texture1D;
        case GL_TEXTURE_2D:
            return scene::TextureTarget::texture2D;
        case GL_TEXTURE_3D:
            return scene::TextureTarget::texture3D;
        case GL_TEXTURE_CUBE_MAP:
            return scene::TextureTarget::cube;
        default:
            return std::nullopt;
    }
}

plan::ValueType valueType(const gpu::ValueType& type) {
    plan::ValueType described;
    described.base = baseType(type.base);
    described.columns = type.columns;
    described.rows = type.rows;
    described.word = std::string(type.word);
    if (type.isOpaque()) described.target = textureTarget(type.textureTarget);
    return described;
}

/// The emitted name may be "glibra_x" or "block.glibra_x[2].glibra_y": every part that the translator renamed
/// becomes the user's again.
std::string userName(const std::string& emitted, const glsl::TranslatedProgram& facts) {
    if (const auto whole = facts.userNames.find(emitted); whole != facts.userNames.end())
        return whole->second;
    std::string name;
    for (std::size_t begin = 0; begin < emitted.size();) {
        const std::size_t end = std::min(emitted.find_first_of(".[]", begin), emitted.size());
        const std::string part = emitted.substr(begin, end - begin);
        const auto renamed = facts.userNames.find(part);
        name += renamed == facts.userNames.end() ? part : renamed->second;
        if (end < emitted.size()) name += emitted[end];
        begin = end + 1;
    }
    return name;
}

}  // namespace

plan::ProgramInterface describe(const gpu::ProgramInterface& reflected, glsl::TranslatedProgram facts) {
    plan::ProgramInterface described;
    for (const gpu::UniformBlock& each : reflected.blocks)
        described.blocks.push_back({each.name, each.bytes});
    for (const gpu::ActiveUniform& each : reflected.uniforms) {
        plan::ActiveUniform uniform;
        uniform.name = userName(each.name, facts);
        uniform.type = valueType(each.type);
        uniform.arraySize = each.arraySize;
        uniform.isArray = each.isArray;
        uniform.location = each.location;
        uniform.block = each.block;
        if (each.block >= 0) uniform.blockName = reflected.blocks[static_cast<std::size_t>(each.block)].name;
        uniform.offset = each.offset;
        uniform.arrayStride = each.arrayStride;
        uniform.matrixStride = each.matrixStride;
        uniform.rowMajor = each.rowMajor;
        described.uniforms.push_back(std::move(uniform));
    }
    for (const gpu::ActiveInput& each : reflected.inputs) {
        const bool integer =
            each.type.base == gpu::BaseType::integer || each.type.base == gpu::BaseType::unsignedInteger;
        described.inputs.push_back({each.name, each.location, integer});
    }
    described.facts = std::move(facts);
    return described;
}

}  // namespace glibra::render
