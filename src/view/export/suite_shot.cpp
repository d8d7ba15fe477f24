#include "view/export/suite_shot.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <system_error>

#include "image/file.h"
#include "suite/file/shot_name.h"
#include "suite/file/suite_file.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// A basic string of TOML.
std::string tomlText(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            result += {'\\', c};
        else if (byte < 0x20 || byte == 0x7F)
            result += fmt::format("\\u{:04X}", byte);
        else
            result += c;
    }
    return result + "\"";
}

std::string tomlText(const fs::path& file, const fs::path& folder) {
    std::error_code failure;
    const fs::path whole = fs::weakly_canonical(file, failure);
    const fs::path relative = whole.lexically_relative(fs::weakly_canonical(folder, failure));
    return tomlText((relative.empty() ? whole : relative).generic_string());
}

std::string list(const auto& values) {
    std::string text;
    for (const double each : values) text += fmt::format("{}{}", text.empty() ? "" : ", ", each);
    return "[" + text + "]";
}

/// A key that needs no quotes is written without them.
std::string keyText(std::string_view key) {
    const bool isBare = std::all_of(key.begin(), key.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
    return isBare ? std::string(key) : tomlText(key);
}

/// "uKd=.25" as "uKd = .25"; what is no plain number or word stays a text as for --set.
std::string setText(const std::vector<std::string>& set) {
    std::string text;
    for (const std::string& each : set) {
        const std::size_t equals = each.find('=');
        const std::string value = each.substr(equals + 1);
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", keyText(each.substr(0, equals)),
                            value == "true" || value == "false" ? value : tomlText(value));
    }
    return text;
}

std::string viewText(const ViewState& view) {
    std::string text;
    const auto matrix = [&](const char* key, const Matrix& value) {
        if (value != kIdentity) text += fmt::format("{} = {}\n", key, list(value));
    };
    matrix("scene-transform", view.scene);
    matrix("eye-transform", view.eye);
    matrix("texture-transform", view.texture);
    std::string objects;
    for (const ViewState::Object& each : view.objects)
        objects += fmt::format("{}{} = {}", objects.empty() ? "" : ", ", each.line, list(each.matrix));
    if (!objects.empty()) text += "object-transform = { " + objects + " }\n";
    if (view.projection == ProjectionMode::perspective) text += "projection = \"perspective\"\n";
    if (view.projection == ProjectionMode::orthographic) text += "projection = \"orthographic\"\n";
    if (view.background) text += fmt::format("background = {}\n", list(*view.background));
    return text;
}

std::string contentOf(const fs::path& file) {
    const auto bytes = image::readFile(file, {file.string(), {}});
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : std::string();
}

}  // namespace

std::string shotText(const Session& session, const std::string& name, const fs::path& folder) {
    const RenderOptions options = session.renderOptions();
    std::string text = fmt::format("[[shot]]\nname = {}\nscript = {}\nsize = [{}, {}]\n", tomlText(name),
                                   tomlText(session.path(), folder), options.width, options.height);
    if (const std::string without = session.onlyOnScreen(); !without.empty())
        text += fmt::format("# The picture as glibra render draws it, without {}.\n", without);
    if (options.time != 0 && session.live().isAnimated()) text += fmt::format("time = {}\n", options.time);
    if (!options.set.empty()) text += "set = { " + setText(options.set) + " }\n";
    if (options.view == ViewPolicy::glman) text += "view = \"glman\"\n";
    text += viewText(options.viewState);
    if (options.axes) text += "axes = true\n";
    if (!options.shim) text += "shim = false\n";
    if (!options.libraryRoots.empty()) {
        std::string roots;
        for (const fs::path& each : options.libraryRoots)
            roots += (roots.empty() ? "" : ", ") + tomlText(each, folder);
        text += "library = [" + roots + "]\n";
    }
    return text;
}

Diagnostics appendShot(const fs::path& suite, const std::string& name, const Session& session) {
    std::string text = contentOf(suite);
    if (!text.empty()) text += text.ends_with('\n') ? "\n" : "\n\n";
    const fs::path folder = suite.parent_path().empty() ? fs::path(".") : suite.parent_path();
    text += shotText(session, name, folder);
    const Result<suite::Suite> read = suite::readSuiteText(text, suite);
    if (!read) return read.diagnostics;
    return image::writeFileAtomically(suite, std::as_bytes(std::span(text)));
}

std::string freeShotName(const fs::path& suite, const Session& session) {
    std::string name = suite::nameOfScene(session.path().filename().string());
    const Result<suite::Suite> read = suite::readSuiteText(contentOf(suite), suite);
    const auto isTaken = [&](const std::string& wanted) {
        return read && std::any_of(read->shots.begin(), read->shots.end(),
                                   [&](const suite::Shot& each) { return each.name == wanted; });
    };
    if (!isTaken(name)) return name;
    for (int number = 2;; ++number) {
        std::string numbered = fmt::format("{}-{}", name, number);
        if (!isTaken(numbered)) return numbered;
    }
}

}  // namespace glibra::view
