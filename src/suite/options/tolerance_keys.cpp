#include "suite/options/tolerance_keys.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace glibra::suite {
namespace {

using image::Tolerance;

constexpr double kNoLimit = std::numeric_limits<double>::max();

constexpr std::array<ToleranceKey, 9> kKeys{{
    {"max", 255, [](const Tolerance& of) { return std::optional(of.largest); },
     [](Tolerance& to, double v) { to.largest = v; }},
    {"fraction", 1, [](const Tolerance& of) { return std::optional(of.fraction); },
     [](Tolerance& to, double v) { to.fraction = v; }},
    {"cluster", 1e9, [](const Tolerance& of) { return std::optional<double>(of.cluster); },
     [](Tolerance& to, double v) { to.cluster = static_cast<int>(v); }, true},
    {"line", 1e9, [](const Tolerance& of) { return std::optional<double>(of.line); },
     [](Tolerance& to, double v) { to.line = static_cast<int>(v); }, true},
    {"bias", 255, [](const Tolerance& of) { return std::optional(of.bias); },
     [](Tolerance& to, double v) { to.bias = v; }},
    {"flip", 1, [](const Tolerance& of) { return of.flip; }, [](Tolerance& to, double v) { to.flip = v; }},
    {"structure", 1, [](const Tolerance& of) { return of.structure; },
     [](Tolerance& to, double v) { to.structure = v; }},
    {"relative", kNoLimit, [](const Tolerance& of) { return std::optional(of.relative); },
     [](Tolerance& to, double v) { to.relative = v; }},
    {"absolute", kNoLimit, [](const Tolerance& of) { return std::optional(of.absolute); },
     [](Tolerance& to, double v) { to.absolute = v; }},
}};

}  // namespace

std::span<const ToleranceKey> toleranceKeys() {
    return kKeys;
}

std::string toleranceLine(const Tolerance& tolerance, bool isStated, bool isFloat) {
    const Tolerance usual;
    std::string line;
    for (const ToleranceKey& each : kKeys) {
        const std::optional<double> value = each.get(tolerance);
        const bool isOfFloats = each.key == "relative" || each.key == "absolute";
        const bool isOfBytes = each.key == "max" || each.key == "bias";
        const bool isNeeded = value != each.get(usual) || (isStated && !(isFloat ? isOfBytes : isOfFloats));
        if (value && isNeeded) line += fmt::format("{}{} = {}", line.empty() ? "" : ", ", each.key, *value);
    }
    return fmt::format("tolerance = {{ {} }}", line);
}

}  // namespace glibra::suite
