#include <map>
#include <set>
#include <utility>

#include "budget/budget.h"

namespace glibra::budget {
namespace {

using Key = std::pair<glib::CommandId, std::vector<double>>;

/// Returns the shapes that are drawn. A draw whose shape is about to be replaced has none.
std::set<scene::ShapeIndex> drawnShapes(const scene::Scene& scene) {
    std::set<scene::ShapeIndex> drawn;
    scene.frame.visitDraws([&](const scene::Draw& draw, const auto&) {
        if (draw.shape) drawn.insert(draw.shape);
    });
    return drawn;
}

}  // namespace

std::vector<scene::ShapeIndex> apply(const Choice& choice, scene::Scene& scene) {
    std::vector<scene::Draw*> draws;
    std::vector<scene::Shape> wanted;
    for (const ShapeChoice& each : choice.shapes) {
        auto& draw = std::get<scene::Draw>(scene.frame.passes.at(each.pass).steps.at(each.step));
        wanted.push_back({scene.shapes[draw.shape].command, each.numbers, {}, nullptr});
        draws.push_back(&draw);
        draw.shape = {};
    }
    // Shapes that are no longer drawn are replaced by the new ones, so that none is left over.
    const std::set<scene::ShapeIndex> stillDrawn = drawnShapes(scene);
    std::vector<scene::ShapeIndex> vacant, replaced;
    for (const scene::ShapeIndex each : scene.shapes.indices())
        if (!stillDrawn.contains(each)) vacant.push_back(each);
    std::map<Key, scene::ShapeIndex> known;
    for (const scene::ShapeIndex each : stillDrawn)
        if (const scene::Shape& shape = scene.shapes[each]; !shape.list && !shape.file)
            known.emplace(Key{shape.command, shape.numbers}, each);
    for (std::size_t i = 0; i < draws.size(); ++i) {
        scene::ShapeIndex& shape = known[Key{wanted[i].command, wanted[i].numbers}];
        if (!shape && replaced.size() < vacant.size()) {
            shape = vacant[replaced.size()];
            replaced.push_back(shape);
            scene.shapes[shape] = std::move(wanted[i]);
        } else if (!shape) {
            shape = scene.shapes.add(std::move(wanted[i]));
        }
        draws[i]->shape = shape;
    }
    for (const NoiseChoice& each : choice.noise) {
        scene::Texture& texture = scene.textures[each.texture];
        auto& noise = std::get<scene::NoiseSource>(texture.source);
        noise.size = each.format.size;
        noise.texels = each.format.texels;
    }
    return replaced;
}

}  // namespace glibra::budget
