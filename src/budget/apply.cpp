#include <map>
#include <set>
#include <utility>

#include "budget/budget.h"

namespace glibra::budget {
namespace {

using Key = std::pair<glib::CommandId, std::vector<double>>;

/// Returns the shapes that are drawn. A draw whose shape is about to be replaced has none.
std::set<int> drawnShapes(const scene::Scene& scene) {
    std::set<int> drawn;
    for (const scene::Pass& pass : scene.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<scene::Draw>(&step); draw && draw->shape != scene::kNone)
                drawn.insert(draw->shape);
    return drawn;
}

}  // namespace

std::vector<int> apply(const Choice& choice, scene::Scene& scene) {
    std::vector<scene::Draw*> draws;
    std::vector<scene::Shape> wanted;
    for (const ShapeChoice& each : choice.shapes) {
        auto& draw = std::get<scene::Draw>(scene.passes.at(each.pass).steps.at(each.step));
        wanted.push_back({scene.shapes[static_cast<std::size_t>(draw.shape)].command, each.numbers,
                          scene::kNone, nullptr});
        draws.push_back(&draw);
        draw.shape = scene::kNone;
    }
    // Shapes that are no longer drawn are replaced by the new ones, so that none is left over.
    const std::set<int> stillDrawn = drawnShapes(scene);
    std::vector<int> vacant, replaced;
    for (int i = static_cast<int>(scene.shapes.size()) - 1; i >= 0; --i)
        if (!stillDrawn.contains(i)) vacant.push_back(i);
    std::map<Key, int> known;
    for (const int each : stillDrawn)
        if (const scene::Shape& shape = scene.shapes[static_cast<std::size_t>(each)];
            !shape.list && shape.file == scene::kNone)
            known.emplace(Key{shape.command, shape.numbers}, each);
    for (std::size_t i = 0; i < draws.size(); ++i) {
        const auto [entry, isNew] =
            known.try_emplace(Key{wanted[i].command, wanted[i].numbers}, scene::kNone);
        if (isNew && !vacant.empty()) {
            entry->second = vacant.back();
            vacant.pop_back();
            replaced.push_back(entry->second);
            scene.shapes[static_cast<std::size_t>(entry->second)] = std::move(wanted[i]);
        } else if (isNew) {
            entry->second = static_cast<int>(scene.shapes.size());
            scene.shapes.push_back(std::move(wanted[i]));
        }
        draws[i]->shape = entry->second;
    }
    for (const NoiseChoice& each : choice.noise) {
        scene::Texture& texture = scene.textures.at(static_cast<std::size_t>(each.texture));
        auto& noise = std::get<scene::NoiseSource>(texture.source);
        noise.size = each.format.size;
        noise.texels = each.format.texels;
    }
    return replaced;
}

}  // namespace glibra::budget
