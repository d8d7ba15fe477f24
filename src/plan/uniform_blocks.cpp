#include "plan/uniform_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace glibra::plan {
namespace {

template <class Number>
Number rounded(double value) {
    using Limits = std::numeric_limits<Number>;
    const double low = static_cast<double>(Limits::min());
    const double high = static_cast<double>(Limits::max());
    return std::isnan(value) ? Number{} : static_cast<Number>(std::clamp(value, low, high));
}

template <class Number>
void put(std::span<std::byte> block, std::size_t offset, Number value) {
    if (offset > block.size() || block.size() - offset < sizeof value) return;
    std::memcpy(block.data() + offset, &value, sizeof value);
}

void putComponent(std::span<std::byte> block, std::size_t offset, BaseType base, double value) {
    switch (base) {
        case BaseType::floating:
            return put(block, offset, static_cast<float>(value));
        case BaseType::doublePrecision:
            return put(block, offset, value);
        case BaseType::integer:
            return put(block, offset, rounded<std::int32_t>(value));
        case BaseType::unsignedInteger:
            return put(block, offset, rounded<std::uint32_t>(value));
        case BaseType::boolean:
            return put(block, offset, std::uint32_t{value != 0 ? 1U : 0U});
        case BaseType::sampler:
        case BaseType::image:
        case BaseType::other:
            return;
    }
}

}  // namespace

void writeMember(const ActiveUniform& member, int firstElement, std::span<const double> values,
                 std::span<std::byte> block) {
    const int components = member.type.components();
    if (components <= 0 || member.offset < 0 || firstElement < 0) return;
    const std::size_t size = member.type.base == BaseType::doublePrecision ? sizeof(double) : sizeof(float);
    const auto unsignedOf = [](int value) { return static_cast<std::size_t>(std::max(value, 0)); };
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t element = unsignedOf(firstElement) + i / unsignedOf(components);
        if (element >= unsignedOf(std::max(member.arraySize, 1))) return;
        const std::size_t component = i % unsignedOf(components);
        const std::size_t column = component / unsignedOf(member.type.rows);
        const std::size_t row = component % unsignedOf(member.type.rows);
        std::size_t offset = unsignedOf(member.offset) + element * unsignedOf(member.arrayStride);
        if (member.type.columns == 1)
            offset += row * size;
        else if (member.rowMajor)
            offset += row * unsignedOf(member.matrixStride) + column * size;
        else
            offset += column * unsignedOf(member.matrixStride) + row * size;
        putComponent(block, offset, member.type.base, values[i]);
    }
}

std::vector<std::byte> blockContent(const ProgramInterface& interface, int block,
                                    std::span<const UniformBinding> bindings) {
    const int size = interface.blocks.at(static_cast<std::size_t>(block)).bytes;
    std::vector<std::byte> bytes(static_cast<std::size_t>(std::max(size, 0)));
    for (const UniformBinding& binding : bindings) {
        const ActiveUniform& member = interface.uniforms.at(static_cast<std::size_t>(binding.uniform));
        const auto* literal = std::get_if<Literal>(&binding.value);
        if (member.block == block && literal != nullptr)
            writeMember(member, binding.firstElement, literal->values, bytes);
    }
    return bytes;
}

}  // namespace glibra::plan
