#include "glsl/facts/assigned_parts.h"

#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"

namespace glibra::glsl {
namespace {

constexpr int kMostParts = 16;

/// The components that a swizzle names; 0 if it is none.
std::uint32_t componentsOf(std::string_view swizzle) {
    std::uint32_t bits = 0;
    for (const char c : swizzle) {
        std::size_t component = std::string_view::npos;
        for (const std::string_view letters : {"xyzw", "rgba", "stpq"})
            component = std::min(component, letters.find(c));
        if (component == std::string_view::npos) return 0;
        bits |= 1U << component;
    }
    return bits;
}

}  // namespace

void shapeOf(AssignedVariable& variable, int arrayDepth, const std::vector<std::string_view>& members) {
    using Shape = AssignedVariable::Shape;
    const Type type = typeOfWord(variable.is.type);
    if (arrayDepth > 0) {
        long long size = 0;
        const std::string& first = variable.is.sizes.front();
        if (first.empty() || first.find_first_not_of("0123456789") != std::string::npos) return;
        size = first.size() < 7 ? std::stoll(first) : 0;
        variable.elements = arrayDepth == 1 ? static_cast<int>(size) : 0;
        if (size < 1 || size > kMostParts) return;
        variable.shape = Shape::indexed;
        variable.count = static_cast<int>(size);
    } else if (!members.empty() && members.size() <= static_cast<std::size_t>(kMostParts)) {
        variable.shape = Shape::structure;
        variable.members = members;
        variable.count = static_cast<int>(members.size());
    } else if (type.matrix()) {
        variable.shape = Shape::indexed;
        variable.count = type.columns;
    } else if (type.vector()) {
        variable.shape = Shape::vector;
        variable.count = type.rows;
    }
}

AssignedPart partOf(const Unit& unit, const AssignedVariable& variable, Range suffix) {
    using Shape = AssignedVariable::Shape;
    const AssignedPart whole{variable.all(), suffix.empty()};
    if (suffix.empty() || variable.shape == Shape::whole) return whole;
    if (unit.text(suffix.first) == "[") {
        const int index = constantIndex(unit, suffix.first);
        if (variable.shape == Shape::structure || index < 0 || index >= variable.count) return whole;
        return {1U << index, unit.bodies.matches[suffix.first] + 1 == suffix.end};
    }
    const std::string_view member = unit.text(suffix.first + 1);
    const bool isAlone = suffix.end == suffix.first + 2;
    if (variable.shape == Shape::structure) {
        const auto found = std::ranges::find(variable.members, member);
        if (found == variable.members.end()) return whole;
        return {1U << (found - variable.members.begin()), isAlone};
    }
    const std::uint32_t bits = variable.shape == Shape::vector ? componentsOf(member) & variable.all() : 0U;
    return bits == 0U ? whole : AssignedPart{bits, isAlone};
}

std::string nameOfPart(const AssignedVariable& variable, std::uint32_t bits) {
    using Shape = AssignedVariable::Shape;
    if (bits == 0 || (bits & variable.all()) == variable.all()) return variable.is.name;
    if (variable.shape == Shape::structure) {
        std::size_t first = 0;
        while ((bits >> first & 1U) == 0) ++first;
        return variable.is.name + "." + std::string(variable.members[first]);
    }
    if (variable.shape != Shape::vector) return variable.is.name;
    std::string name = variable.is.name + ".";
    for (int i = 0; i < variable.count; ++i)
        if ((bits >> i & 1U) != 0) name += "xyzw"[i];
    return name;
}

std::vector<std::string_view> membersOf(const Unit& unit, const Declaration& declaration) {
    std::vector<std::string_view> members;
    for (const Declaration& member : declaration.members)
        for (const Declarator& each : member.declarators) members.push_back(unit.text(each.name));
    return members;
}

}  // namespace glibra::glsl
