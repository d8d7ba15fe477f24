#include "scene/texture_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "base/suggest.h"
#include "base/text.h"
#include "scene/texture_parts.h"

namespace glibra::scene {
namespace {

/// Takes ".word" or ".word(number)" from the front; false if there is none.
bool takePart(std::string_view& text, std::string_view& word, std::optional<int>& number) {
    if (!text.starts_with('.')) return false;
    const std::size_t end = std::min(text.find_first_of(".(", 1), text.size());
    word = text.substr(1, end - 1);
    number.reset();
    text.remove_prefix(end);
    if (!text.starts_with('(')) return true;
    const std::size_t close = text.find(')');
    if (close == std::string_view::npos) return false;
    text.remove_prefix(1);
    number = word == "face" ? faceNamed(text.substr(0, close - 1)) : std::nullopt;
    if (number) {
        text.remove_prefix(close);
        return true;
    }
    int value = 0;
    const auto [last, problem] = std::from_chars(text.data(), text.data() + close - 1, value);
    if (problem != std::errc() || last != text.data() + close - 1 || value < 0) return false;
    number = value;
    text.remove_prefix(close);
    return true;
}

Diagnostic badName(std::string_view text, const std::string& why) {
    return withoutId(Severity::error, fmt::format("'{}': {}", text, why));
}

std::vector<std::string_view> namesOfTextures(const Scene& scene) {
    std::vector<std::string_view> names;
    for (const TextureIndex each : scene.textures.indices())
        if (!scene.textures[each].name.empty()) names.push_back(scene.textures[each].name);
    return names;
}

}  // namespace

Result<TextureView> textureNamed(const Scene& scene, std::string_view text) {
    const auto bad = [&](const std::string& why) { return badName(text, why); };
    std::string_view rest = text;
    const std::string_view name = rest.substr(0, rest.find('.'));
    rest.remove_prefix(name.size());
    TextureView view;
    for (const TextureIndex each : scene.textures.indices())
        if (!name.empty() && scene.textures[each].name == name) view.texture = each;
    if (!view.texture)
        return bad(fmt::format("the scene has no texture of that name{}",
                               base::suggestion(name, namesOfTextures(scene))));
    const Texture& texture = scene.textures[view.texture];
    std::optional<int> layer, face;
    while (!rest.empty()) {
        std::string_view word;
        std::optional<int> number;
        const bool isPart = takePart(rest, word, number);
        if (isPart && word == "level" && number)
            view.level = number;
        else if (isPart && word == "layer" && number)
            layer = number;
        else if (isPart && word == "face" && number)
            face = number;
        else if (isPart && word == "prev" && !number)
            view.isPrevious = true;
        else
            return bad("expected .level(n), .layer(n), .face(n) or .prev after the name");
    }
    view.layer = face ? face : layer;
    if (texture.target == TextureTarget::cubeArray && view.layer) {
        const int cubes = layersOf(texture, 0).value_or(0) / 6;
        if (!layer || !face || *layer >= cubes || *face > 5)
            return bad(fmt::format("'{0}' has {1}; write {0}.layer(0).face(0), with a face from 0 to 5", name,
                                   base::counted(cubes, "layer")));
        view.layer = 6 * *layer + *face;
    }
    const auto levels = levelsOf(texture);
    if (view.level && levels && *view.level >= *levels)
        return bad(fmt::format("'{}' has {}", name, base::counted(*levels, "level")));
    if (view.isPrevious && !texture.hasHistory)
        return bad(fmt::format("'{}' is declared without history", name));
    return view;
}

Result<ObjectView> objectNamed(const Scene& scene, std::string_view text) {
    const std::string_view name = text.substr(0, text.find('.'));
    const std::string_view part = text.substr(name.size());
    std::vector<std::string_view> names = namesOfTextures(scene);
    const bool isTexture = std::ranges::find(names, name) != names.end();
    for (const BufferIndex each : scene.buffers.indices()) {
        const Buffer& buffer = scene.buffers[each];
        if (buffer.name == text) return ObjectView(BufferView{each});  // of a mesh: "teapot.position"
        names.push_back(buffer.name);
        if (isTexture || name.empty() || buffer.name != name) continue;
        if (part.empty()) return ObjectView(BufferView{each});
        if (part != ".prev") return badName(text, "after the name of a buffer only .prev may stand");
        if (!buffer.hasHistory) return badName(text, fmt::format("'{}' is declared without history", name));
        return ObjectView(BufferView{each, true});
    }
    if (!isTexture)
        return badName(text, fmt::format("the scene has no texture or buffer of that name{}",
                                         base::suggestion(name, names)));
    Result<TextureView> view = textureNamed(scene, text);
    if (!view) return std::move(view.diagnostics);
    return ObjectView(*view);
}

}  // namespace glibra::scene
