#include "view/scene/typed_number.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "expression/expression.h"

namespace glibra::view {
namespace {

class NoNames final : public expression::Names {
  public:
    [[nodiscard]] std::optional<expression::Symbol> find(std::string_view /*path*/) const override {
        return std::nullopt;
    }
    [[nodiscard]] std::vector<std::string> known(std::string_view /*path*/) const override { return {}; }
};

/// The text with points in place of commas that separate no arguments.
std::string withPoints(std::string_view text) {
    std::string result(text);
    int depth = 0;
    for (char& each : result) {
        if (each == '(') ++depth;
        if (each == ')') --depth;
        if (each == ',' && depth == 0) each = '.';
    }
    return result;
}

}  // namespace

std::optional<double> typedNumber(std::string_view text) {
    const expression::Type number = expression::Type::number();
    const auto parsed = expression::parse(withPoints(text), {}, NoNames(), {.types = {&number, 1}});
    const std::optional<expression::Value> value = parsed ? parsed->constant() : std::nullopt;
    if (!value || !(std::abs(value->number()) <= std::numeric_limits<float>::max())) return std::nullopt;
    return value->number();
}

}  // namespace glibra::view
