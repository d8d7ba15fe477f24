// Probed values as text.

#include <fmt/format.h>

#include <algorithm>

#include "view/debug_view/pixel_probe.h"

namespace glibra::view {
namespace {

/// "mat4", "mat3x2" (3 columns, 2 rows), and arrays of them; 0: it is no matrix.
std::size_t rowsOfMatrix(std::string_view type) {
    if (type.starts_with('d')) type.remove_prefix(1);
    if (!type.starts_with("mat") || type.size() < 4) return 0;
    const char rows = type.size() > 5 && type[4] == 'x' ? type[5] : type[3];
    return rows >= '2' && rows <= '4' ? static_cast<std::size_t>(rows - '0') : 0;
}

/// The rows as lines, with the numbers of a column below each other; an empty line between matrices.
std::string matrixText(const ProbedValue& value, std::size_t rows) {
    const auto columns = static_cast<std::size_t>(value.type[value.type.front() == 'd' ? 4 : 3] - '0');
    std::vector<std::string> texts;
    std::size_t widest = 0;
    for (const double each : value.numbers) {
        texts.push_back(fmt::format("{:.6g}", each == 0 ? 0 : each));  // no "-0"
        widest = std::max(widest, texts.back().size());
    }
    std::string text;
    for (std::size_t first = 0; first + rows * columns <= texts.size(); first += rows * columns) {
        if (first > 0) text += "\n";
        for (std::size_t row = 0; row < rows; ++row) {
            if (!text.empty()) text += "\n";
            for (std::size_t column = 0; column < columns; ++column)
                text += fmt::format("{}{:>{}}", column > 0 ? "  " : "", texts[first + column * rows + row],
                                    widest);
        }
    }
    return text;
}

}  // namespace

const ProbedValue* ProbedPixel::find(std::string_view name) const {
    for (const std::vector<ProbedValue>* list : {&outputs, &inputs, &uniforms})
        for (const ProbedValue& each : *list)
            if (each.name == name) return &each;
    return nullptr;
}

std::string numbersText(const ProbedValue& value) {
    if (value.numbers.empty()) return value.why;
    std::string text;
    if (value.type == "bool") return value.numbers.front() != 0 ? "true" : "false";
    if (const std::size_t rows = rowsOfMatrix(value.type); rows > 0) return matrixText(value, rows);
    for (const double each : value.numbers) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", each);
    return text;
}

}  // namespace glibra::view
