#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "bench/subjects/builtin_precision.h"

namespace glibra::bench {
namespace {

/// 12.3, 4.2e+05, inf: short enough for a column.
std::string brief(double value) {
    if (value == 0) return "0";
    if (value < 1e-2 || value >= 1e5) return fmt::format("{:.1e}", value);
    return fmt::format("{:.{}f}", value, value < 10 ? 2 : 1);
}

std::string verdict(const PrecisionRow& row) {
    const Precision& worse = row.vertex.timesTheBound.value_or(0) > row.fragment.timesTheBound.value_or(0)
                                 ? row.vertex
                                 : row.fragment;
    if (!worse.timesTheBound) return "";
    return *worse.timesTheBound > 1 ? fmt::format("broken, {} times", brief(*worse.timesTheBound)) : "kept";
}

std::string rangeOf(const PrecisionRow& row) {
    return fmt::format("{}, {}", row.function->name, row.sweep->words);
}

}  // namespace

std::string argumentsText(const BuiltinFunction& function, const std::array<float, 8>& arguments) {
    constexpr std::string_view kComponents = "xyzw";
    const std::string_view text = function.expression;
    std::array<bool, 8> isRead{};
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isName =
            (text[i] == 'a' || text[i] == 'b') &&
            (i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0) &&
            (i + 1 == text.size() || std::isalnum(static_cast<unsigned char>(text[i + 1])) == 0);
        if (!isName) continue;
        const std::size_t first = text[i] == 'a' ? 0 : 4;
        const bool isSwizzled = i + 1 < text.size() && text[i + 1] == '.';
        for (std::size_t c = 0; c < 4; ++c) isRead[first + c] = isRead[first + c] || !isSwizzled;
        for (std::size_t k = i + 2; isSwizzled && k < text.size(); ++k) {
            const std::size_t c = kComponents.find(text[k]);
            if (c == std::string_view::npos) break;
            isRead[first + c] = true;
        }
    }
    std::string words;
    for (std::size_t i = 0; i < 8; ++i)
        if (isRead[i]) words += fmt::format("{}{:.9g}", words.empty() ? "" : ", ", arguments[i]);
    return words;
}

std::string toText(const std::vector<PrecisionRow>& rows) {
    std::string text =
        fmt::format("{:<12} {:<36} {:>9} {:>9} {:>9} {:>9}  {:<28} {}\n", "function", "arguments", "vertex",
                    "fragment", "mean", "absolute", "GLSL 4.60 allows", "");
    std::size_t broken = 0, bounded = 0, different = 0;
    for (const PrecisionRow& row : rows) {
        text += fmt::format("{:<12} {:<36} {:>9} {:>9} {:>9} {:>9}  {:<28} {}\n", row.function->name,
                            row.sweep->words, brief(row.vertex.largest), brief(row.fragment.largest),
                            brief(row.fragment.mean), brief(row.fragment.largestAbsolute),
                            row.function->bound, verdict(row));
        if (row.fragment.timesTheBound) ++bounded;
        if (verdict(row).starts_with("broken")) ++broken;
        if (row.vertex.largest != row.fragment.largest) ++different;
    }
    text += fmt::format(
        "Largest errors in the vertex and in the fragment stage and the mean error of the latter, in units "
        "in the "
        "last place of the exact result; largest absolute error.\n"
        "{} of {} bounds are broken; the stages differ in {} of {} lines.\n",
        broken, bounded, different, rows.size());
    for (const PrecisionRow& row : rows) {
        if (!verdict(row).starts_with("broken")) continue;
        const bool inVertex = row.vertex.largest > row.fragment.largest;
        const Precision& worse = inVertex ? row.vertex : row.fragment;
        text += fmt::format("{}: {} ULP at ({}) in the {} stage, allowed: {}\n", rangeOf(row),
                            brief(worse.largest), argumentsText(*row.function, worse.worst),
                            inVertex ? "vertex" : "fragment", row.function->bound);
    }
    return text;
}

}  // namespace glibra::bench
