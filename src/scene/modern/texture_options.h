#pragma once
// Private to this room: the keys of textures and samplers (language, 12.4).

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/run/state.h"

namespace glibra::scene {

/// What stands after a texture or sampler, as far as it is given.
struct TextureOptions {
    std::optional<base::Filter> filter;
    glib::Position filterPosition;
    std::vector<base::Wrap> wraps;
    std::optional<std::array<double, 4>> border;
    std::optional<double> anisotropy;
    std::optional<base::Comparison> compare;
    glib::Position comparePosition;
    std::optional<int> samples, levels;
    const KeyedValues *flip = nullptr, *srgb = nullptr, *generate = nullptr, *history = nullptr;
    const KeyedValues *samplesKey = nullptr, *levelsKey = nullptr;
};

/// `axes`: those that have a wrap mode. Nothing with the reason reported.
std::optional<TextureOptions> readOptions(Interpreter&, const Command& command, std::size_t axes);

/// The wrap mode of that word; nothing for other keys.
std::optional<base::Wrap> wrapNamed(std::string_view word);

/// The state with what the options say.
base::SamplerState stateOf(const TextureOptions& options, base::SamplerState state);

}  // namespace glibra::scene
