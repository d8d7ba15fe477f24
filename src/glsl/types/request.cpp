#include "glsl/types/request.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

namespace glibra::glsl {
namespace {

enum class Base { floating, integer, unsignedInteger, boolean };

struct Shape {
    Base base = Base::floating;
    std::size_t components = 1;
    bool isScalar = true;
};

std::optional<Shape> shapeOf(std::string_view type) {
    if (type == "float") return Shape{Base::floating};
    if (type == "int") return Shape{Base::integer};
    if (type == "uint") return Shape{Base::unsignedInteger};
    if (type == "bool") return Shape{Base::boolean};
    if (type.empty() || type.back() < '2' || type.back() > '4') return std::nullopt;
    const auto size = static_cast<std::size_t>(type.back() - '0');
    type.remove_suffix(1);
    if (type == "vec") return Shape{Base::floating, size, false};
    if (type == "ivec") return Shape{Base::integer, size, false};
    if (type == "uvec") return Shape{Base::unsignedInteger, size, false};
    if (type == "bvec") return Shape{Base::boolean, size, false};
    if (type == "mat") return Shape{Base::floating, size * size, false};
    return std::nullopt;
}

bool isWhole(double value) {
    return std::trunc(value) == value && std::abs(value) <= std::numeric_limits<int>::max();
}

std::optional<std::string> numberText(double value, Base base) {
    switch (base) {
        case Base::boolean:
            return value != 0 ? "true" : "false";
        case Base::integer:
            if (!isWhole(value)) return std::nullopt;
            return fmt::format("{}", static_cast<int>(value));
        case Base::unsignedInteger:
            if (std::trunc(value) != value || value < 0 || value > std::numeric_limits<unsigned>::max())
                return std::nullopt;
            return fmt::format("{}u", static_cast<unsigned>(value));
        case Base::floating:
            break;
    }
    if (std::abs(value) > std::numeric_limits<float>::max()) return std::nullopt;
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

}  // namespace

std::optional<std::string> textOf(const Constant& constant, std::string_view type) {
    const std::vector<double>& numbers = constant.components;
    std::string own(type);
    if (own.empty()) {
        constexpr std::size_t kMatrix3 = 9, kMatrix4 = 16, kMostOfVectors = 4;
        if (numbers.size() == kMatrix3 || numbers.size() == kMatrix4)
            own = numbers.size() == kMatrix3 ? "mat3" : "mat4";
        else if (numbers.size() > 1 && numbers.size() <= kMostOfVectors)
            own = fmt::format("{}vec{}", constant.isBoolean ? "b" : "", numbers.size());
        else
            own = constant.isBoolean ? "bool" : !numbers.empty() && isWhole(numbers[0]) ? "int" : "float";
    }
    const auto shape = shapeOf(own);
    if (!shape || shape->components != numbers.size()) return std::nullopt;
    std::vector<std::string> texts;
    for (const double each : numbers) {
        auto text = numberText(each, shape->base);
        if (!text) return std::nullopt;
        texts.push_back(std::move(*text));
    }
    if (!shape->isScalar) return fmt::format("{}({})", own, fmt::join(texts, ", "));
    return texts[0].starts_with('-') ? "(" + texts[0] + ")" : texts[0];
}

std::string valueText(const Constant& constant) {
    if (constant.isBoolean && constant.components.size() == 1)
        return constant.components[0] != 0 ? "true" : "false";
    return constant.components.size() == 1 ? fmt::format("{}", constant.components[0])
                                           : fmt::format("({})", fmt::join(constant.components, ", "));
}

}  // namespace glibra::glsl
