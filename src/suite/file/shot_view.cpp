#include "suite/file/shot_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <system_error>
#include <vector>

#include "glib/text.h"

namespace glibra::suite {
namespace {

constexpr double kLargestNumber = std::numeric_limits<float>::max();

/// Nothing if it is no list of numbers of such a length, which has then been reported.
std::optional<std::vector<double>> numbers(TomlReader& reader, const toml::node& node, std::string_view name,
                                           std::string_view wanted, std::size_t least, std::size_t most) {
    const toml::array* list = node.as_array();
    if (!list || list->size() < least || list->size() > most) {
        reader.wrongType(node, name, wanted);
        return std::nullopt;
    }
    std::vector<double> values;
    for (const toml::node& each : *list)
        if (const auto one = reader.number(each, name, -kLargestNumber, kLargestNumber))
            values.push_back(*one);
    return values.size() == list->size() ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace

void readMatrix(TomlReader& reader, const toml::node& node, std::string_view name, Matrix& matrix) {
    const auto values =
        numbers(reader, node, name, "a list of 16 numbers, column by column,", matrix.size(), matrix.size());
    if (values) std::copy(values->begin(), values->end(), matrix.begin());
}

void readObjectTransforms(TomlReader& reader, const toml::node& node, ViewState& view) {
    const toml::table* table = reader.table(node, "object-transform");
    if (!table) return;
    for (const TomlEntry& entry : reader.entries(*table)) {
        int line = 0;
        const char* const end = entry.key.data() + entry.key.size();
        const auto [stop, failure] = std::from_chars(entry.key.data(), end, line);
        if (failure != std::errc() || stop != end || line < 1) {
            reader.error("suite-E04",
                         fmt::format("object-transform: {} is not the number of a line of the scene",
                                     glib::inQuotes(entry.key)),
                         entry.keyPlace);
            continue;
        }
        const auto same = std::find_if(view.objects.begin(), view.objects.end(),
                                       [&](const ViewState::Object& each) { return each.line == line; });
        ViewState::Object& object = same == view.objects.end()
                                        ? view.objects.emplace_back(ViewState::Object{line, kIdentity})
                                        : *same;
        readMatrix(reader, *entry.value, "object-transform." + entry.key, object.matrix);
    }
}

void readProjection(TomlReader& reader, const toml::node& node, ViewState& view) {
    const auto* text = node.as_string();
    if (text && **text == "scene")
        view.projection = ProjectionMode::scene;
    else if (text && **text == "perspective")
        view.projection = ProjectionMode::perspective;
    else if (text && **text == "orthographic")
        view.projection = ProjectionMode::orthographic;
    else
        reader.wrongType(node, "projection", "\"scene\", \"perspective\" or \"orthographic\"");
}

void readBackground(TomlReader& reader, const toml::node& node, ViewState& view) {
    const auto values = numbers(reader, node, "background", "[R, G, B] or [R, G, B, A]", 3, 4);
    if (values)
        view.background = {(*values)[0], (*values)[1], (*values)[2], values->size() == 4 ? (*values)[3] : 1};
}

}  // namespace glibra::suite
