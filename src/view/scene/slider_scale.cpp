#include "view/scene/slider_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "expression/expression.h"

namespace glibra::view {
namespace {

constexpr double kDecadesOfLogarithm = 3;

int decadeOf(double value) {
    return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// The nearest multiple of 10^exponent, as the shortest decimal number gives it: 0.3, not
/// 0.30000000000000004.
double rounded(double value, int exponent) {
    if (value == 0 || !std::isfinite(value)) return value;
    constexpr int kDigitsOfDouble = 17;
    const int digits = decadeOf(value) - exponent;
    if (digits < -1) return 0;
    if (digits >= kDigitsOfDouble) return value;
    if (digits < 0)
        return std::abs(value) * 2 < std::pow(10, exponent) ? 0
                                                            : std::copysign(std::pow(10, exponent), value);
    std::array<char, 40> text{};
    const auto end = fmt::format_to_n(text.data(), text.size(), "{:.{}e}", value, digits).out;
    double result = value;
    std::from_chars(text.data(), end, result);
    return result + 0.0;  // not -0
}

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

double SliderScale::positionOf(double value) const {
    if (!(value > minimum)) return 0;
    if (value >= maximum) return 1;
    if (isLogarithmic) return std::log(value / minimum) / std::log(maximum / minimum);
    return (value / 2 - minimum / 2) / (maximum / 2 - minimum / 2);
}

double SliderScale::valueAt(double position, bool isFine) const {
    position = std::clamp(position, 0.0, 1.0);
    double value = isLogarithmic ? minimum * std::pow(maximum / minimum, position)
                                 : minimum * (1 - position) + maximum * position;
    if (isInteger) {
        const double low = std::ceil(minimum);
        const double high = std::floor(maximum);
        return low > high ? low : std::clamp(std::round(value), low, high) + 0.0;
    }
    if (position == 0) return minimum;
    if (position == 1) return maximum;
    const int digits = isFine ? 5 : 3;
    const double size = isLogarithmic ? value : (maximum / 2 - minimum / 2) * 2;
    if (std::isfinite(size)) value = rounded(value, decadeOf(size) - digits);
    return std::clamp(value, minimum, maximum);
}

double SliderScale::moved(double value, double positions, bool isFine) const {
    const double next = valueAt(positionOf(value) + positions, isFine);
    if (!isInteger || positions == 0) return next;
    const double least =
        positions > 0 ? std::max(next, std::floor(value) + 1) : std::min(next, std::ceil(value) - 1);
    const double low = std::ceil(minimum);
    return std::clamp(least, low, std::max(low, std::floor(maximum)));
}

SliderScale scaleOf(const render::Knob& knob) {
    SliderScale scale{std::min(knob.minimum, knob.maximum), std::max(knob.minimum, knob.maximum),
                      knob.isInteger()};
    if (scale.minimum == scale.maximum) scale.maximum = scale.minimum + 1;
    scale.isLogarithmic =
        scale.minimum > 0 && std::log10(scale.maximum / scale.minimum) >= kDecadesOfLogarithm - 1e-9;
    return scale;
}

double withoutLeftover(double value, double step) {
    constexpr double kLeftover =
        1e-9;  // of a step; dragging rounds values to four digits, so leftovers are far smaller
    return std::abs(value) < kLeftover * step ? 0 : value;
}

std::optional<double> typedNumber(std::string_view text) {
    const expression::Type number = expression::Type::number();
    const auto parsed = expression::parse(withPoints(text), {}, NoNames(), {.types = {&number, 1}});
    const std::optional<expression::Value> value = parsed ? parsed->constant() : std::nullopt;
    if (!value || !(std::abs(value->number()) <= std::numeric_limits<float>::max())) return std::nullopt;
    return value->number();
}

}  // namespace glibra::view
