// Options that give a picture the view of a window: its transforms, projection and background.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.h"

namespace glibra::cli {
namespace {

/// Numbers separated by commas; nothing if the text is anything else.
std::optional<std::vector<double>> numbers(std::string_view text) {
    std::vector<double> values;
    for (;;) {
        double value = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (problem != std::errc() || !std::isfinite(value)) return std::nullopt;
        values.push_back(value);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        if (text.empty()) return values;
        if (text.front() != ',') return std::nullopt;
        text.remove_prefix(1);
    }
}

Matrix matrix(const std::string& option, std::string_view text) {
    const auto values = numbers(text);
    Matrix result{};
    if (!values || values->size() != result.size())
        throw CLI::ValidationError(option, "16 numbers separated by commas are wanted, column by column");
    std::copy(values->begin(), values->end(), result.begin());
    return result;
}

/// "12:1,0,0,..."
ViewState::Object object(const std::string& text) {
    const std::size_t colon = text.find(':');
    ViewState::Object result;
    const auto [end, problem] =
        std::from_chars(text.data(), text.data() + std::min(colon, text.size()), result.line);
    if (colon == std::string::npos || problem != std::errc() || end != text.data() + colon || result.line < 1)
        throw CLI::ValidationError("--object-transform",
                                   "LINE:M is wanted, the line of the object in the scene");
    result.matrix = matrix("--object-transform", std::string_view(text).substr(colon + 1));
    return result;
}

std::array<double, 4> background(const std::string& text) {
    const auto values = numbers(text);
    if (!values || (values->size() != 3 && values->size() != 4))
        throw CLI::ValidationError("--background", "R,G,B or R,G,B,A is wanted, as 0,.5,1");
    return {(*values)[0], (*values)[1], (*values)[2], values->size() == 4 ? (*values)[3] : 1};
}

}  // namespace

void addViewOptions(CLI::App& command, ViewState& view) {
    const auto addMatrix = [&](const char* name, Matrix& to, const char* help) {
        command.add_option_function<std::string>(
            name, [name, &to](const std::string& text) { to = matrix(name, text); }, help);
    };
    addMatrix("--scene-transform", view.scene,
              "M: 16 numbers, column by column; Projection becomes Projection * M");
    addMatrix("--eye-transform", view.eye, "M: ModelView becomes M * ModelView");
    addMatrix("--texture-transform", view.texture, "M: gl_TextureMatrix[0]");
    command
        .add_option_function<std::vector<std::string>>(
            "--object-transform",
            [&view](const std::vector<std::string>& all) {
                for (const std::string& each : all) view.objects.push_back(object(each));
            },
            "LINE:M: for the object on that line of the scene ModelView becomes ModelView * M")
        ->allow_extra_args(false);
    command.add_option("--projection", view.projection, "scene, perspective or orthographic")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, ProjectionMode>{{"scene", ProjectionMode::scene},
                                                  {"perspective", ProjectionMode::perspective},
                                                  {"orthographic", ProjectionMode::orthographic}}));
    command.add_option_function<std::string>(
        "--background", [&view](const std::string& text) { view.background = background(text); },
        "R,G,B instead of the scene's clear colour");
}

}  // namespace glibra::cli
