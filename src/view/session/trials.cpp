#include "view/session/trials.h"

#include <algorithm>
#include <variant>

#include "view/edit/source_lines.h"

namespace glibra::view {
namespace {

/// The number that DrawId::file has for the file now; `known` if it draws nothing.
int fileNumber(const scene::Scene& scene, const std::filesystem::path& file, int known) {
    for (const scene::Pass& pass : scene.frame.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<scene::Draw>(&step);
                draw != nullptr && draw->place.file == file)
                return draw->id.file;
    return known;
}

}  // namespace

void Trials::list() {
    states_.clear();
    for (const Trial& each : trials_)
        if (each.now.line > 0) states_.emplace(each.now, each.state);
}

/// From now on draws are followed from where they are now. Those that are gone do not come back.
void Trials::keepTexts(const TextOf& textOf) {
    std::erase_if(trials_, [](const Trial& each) { return each.now.line == 0; });
    texts_.clear();
    for (Trial& each : trials_) {
        each.then = each.now;
        if (!texts_.contains(each.file)) texts_.emplace(each.file, textOf(each.file));
    }
}

void Trials::set(const scene::Draw& draw, const base::RasterState& state, const TextOf& textOf) {
    const auto known = std::ranges::find(trials_, draw.id, &Trial::now);
    // A trial has ended if the scene gives its draw another state than it did.
    const bool isTried = known != trials_.end() && known->state.wanted == *draw.raster;
    const base::RasterState ofScene = isTried ? known->state.ofScene : *draw.raster;
    if (known != trials_.end()) trials_.erase(known);
    if (state != ofScene)
        trials_.push_back({draw.place.file, draw.id, draw.id, render::TriedState{draw.word, ofScene, state}});
    keepTexts(textOf);
    list();
}

void Trials::follow(const scene::Scene& scene, const TextOf& textOf) {
    std::map<std::filesystem::path, std::string> now;
    bool isAnyGone = false;
    for (Trial& each : trials_) {
        if (!now.contains(each.file)) now.emplace(each.file, textOf(each.file));
        each.now = each.then;
        each.now.line = movedLine(texts_[each.file], now[each.file], each.then.line);
        each.now.file = fileNumber(scene, each.file, each.then.file);
        isAnyGone = isAnyGone || each.now.line == 0;
    }
    // While a line is edited, it may not be a statement for a while.
    if (!isAnyGone) {
        texts_ = std::move(now);
        for (Trial& each : trials_) each.then = each.now;
    }
    list();
}

}  // namespace glibra::view
