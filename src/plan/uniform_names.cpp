#include "plan/uniform_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "base/suggest.h"

namespace glibra::plan {

bool isTextureMatrix(glsl::Builtin value) {
    return value == glsl::Builtin::textureMatrix || value == glsl::Builtin::textureMatrixInverse ||
           value == glsl::Builtin::textureMatrixTranspose ||
           value == glsl::Builtin::textureMatrixInverseTranspose;
}

UniformNames::UniformNames(const ProgramInterface& interface) {
    for (std::size_t i = 0; i < interface.uniforms.size(); ++i) {
        const ActiveUniform& uniform = interface.uniforms[i];
        const UniformIndex index(i);
        arraySizes_.push_back(uniform.isArray ? std::max(uniform.arraySize, 1) : 0);
        exact_[uniform.name].push_back(index);
        if (uniform.block < 0) continue;
        // GL reports `Block.member` for a block with an instance name, and `member` for one without.
        const std::string prefix = uniform.blockName + ".";
        const bool hasPrefix = uniform.name.starts_with(prefix);
        const std::string member = hasPrefix ? uniform.name.substr(prefix.size()) : uniform.name;
        members_[hasPrefix ? member : prefix + member].push_back(index);
        const std::size_t plain = std::min(uniform.blockName.find('['), uniform.blockName.size());
        const glsl::MemoryBlock* block =
            interface.facts.memory.block(uniform.blockName.substr(0, plain), false);
        if (block != nullptr && !block->instance.empty() && block->instance != block->name)
            members_[block->instance + uniform.blockName.substr(plain) + "." + member].push_back(index);
    }
}

const std::vector<UniformIndex>* UniformNames::indices(std::string_view name) const {
    if (const auto found = exact_.find(name); found != exact_.end()) return &found->second;
    if (const auto found = members_.find(name); found != members_.end()) return &found->second;
    return nullptr;
}

std::vector<NamedUniform> UniformNames::find(std::string_view tag) const {
    std::vector<NamedUniform> found;
    if (const std::vector<UniformIndex>* whole = indices(tag)) {
        for (const UniformIndex each : *whole) found.push_back({each, 0, false});
        return found;
    }
    const std::size_t bracket = tag.rfind('[');
    if (bracket == std::string_view::npos || !tag.ends_with(']')) return found;
    const std::string_view digits = tag.substr(bracket + 1, tag.size() - bracket - 2);
    int element = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), element);
    if (problem != std::errc() || end != digits.data() + digits.size() || element < 0) return found;
    const std::vector<UniformIndex>* arrays = indices(tag.substr(0, bracket));
    if (arrays == nullptr) return found;
    for (const UniformIndex each : *arrays)
        if (element < arraySizes_[each]) found.push_back({each, element, true});
    return found;
}

const glsl::BuiltinUniform* suppliedBy(const ActiveUniform& uniform) {
    const glsl::BuiltinUniform* row = glsl::findBuiltinUniform(uniform.name);
    const bool isSame =
        row != nullptr && row->type == uniform.type.word && uniform.isArray == isTextureMatrix(row->value);
    return isSame ? row : nullptr;
}

std::optional<std::string_view> attributeOfInput(const ActiveInput& input, bool isModern) {
    if (const glsl::BuiltinInput* row = glsl::findBuiltinInput(input.name)) return row->attribute;
    if (!isModern) return std::nullopt;
    const std::string_view attribute = glsl::wellKnownAttribute(input.name, input.type.word);
    return attribute.empty() ? std::nullopt : std::optional(attribute);
}

bool isSuppliedName(std::string_view name) {
    return glsl::findBuiltinUniform(name) != nullptr || glsl::findBuiltinInput(name) != nullptr;
}

bool isInternalName(std::string_view name) {
    return name.starts_with("glibra_") || name.starts_with("gl_");
}

bool namesMemory(const glsl::MemoryFacts& memory, std::string_view name) {
    return memory.counters.contains(std::string(name)) ||
           std::ranges::any_of(memory.blocks, [&](const glsl::MemoryBlock& each) {
               return each.name == name || each.instance == name ||
                      (!each.members.empty() && each.members.back().name == name);
           });
}

std::string nearestUniform(std::string_view tag, std::span<const std::string> names) {
    constexpr std::size_t kPrefix = 1;  // the u at the beginning of most uniform names
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return base::nearestName(tag, candidates, kPrefix);
}

std::string hintOf(std::string_view name) {
    return name.empty() ? std::string() : fmt::format("; did you mean '{}'?", name);
}

std::string suggestionFor(std::string_view tag, std::span<const std::string> names) {
    return hintOf(nearestUniform(tag, names));
}

std::string_view rootName(std::string_view name) {
    return name.substr(0, name.find_first_of(".["));
}

}  // namespace glibra::plan
