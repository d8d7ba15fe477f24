// Render targets and clearing (language, 2.3).

#include <fmt/format.h>

#include <algorithm>

#include "scene/state.h"

namespace glibra::scene {
namespace {

/// The empty 2D texture on the unit, or none.
TextureIndex emptyTextureOn(const Interpreter& in, int unit) {
    for (const Slot& slot : in.state.slots)
        if (slot.unit == unit && slot.target == TextureTarget::texture2D &&
            std::holds_alternative<EmptySource>(in.scene.textures[slot.texture].source))
            return slot.texture;
    return {};
}

const EmptySource& sourceOf(const Interpreter& in, TextureIndex texture) {
    return std::get<EmptySource>(in.scene.textures[texture].source);
}

/// Returns the target list, or nothing with glib-E11 if these units cannot be targets.
std::optional<TargetList> targetList(Interpreter& in, const glib::Command& command) {
    TargetList list;
    list.place = in.place(command);
    const auto refuse = [&](const std::string& text) {
        in.reportAt(command, "glib-E11", fmt::format("{}: {}", textOf(command), text));
        return std::nullopt;
    };
    for (const double number : command.numbers) {
        const int unit = static_cast<int>(number);
        const TextureIndex texture = emptyTextureOn(in, unit);
        if (!texture)
            return refuse(fmt::format(
                "unit {0} holds no empty 2D texture; write 'Texture2D {0} 1024 1024' first", unit));
        if (std::find(list.units.begin(), list.units.end(), unit) != list.units.end())
            return refuse(fmt::format("unit {} is named twice", unit));
        const EmptySource& source = sourceOf(in, texture);
        if (list.units.empty()) {
            list.width = source.width;
            list.height = source.height;
        } else if (source.width != list.width || source.height != list.height) {
            return refuse(fmt::format("unit {} is {} x {}, unit {} is {} x {}; all must have the same size",
                                      list.units.front(), list.width, list.height, unit, source.width,
                                      source.height));
        }
        list.units.push_back(unit);
        list.textures.push_back(texture);
    }
    return list;
}

/// The number of the current target's depth buffer. 0 is the window's; each combination of units and size
/// has its own.
int depthBufferOf(Interpreter& in, const TargetList& target) {
    if (target.units.empty()) return 0;
    const int next = static_cast<int>(in.depthBuffers.size()) + 1;
    return in.depthBuffers.try_emplace({target.units, target.width, target.height}, next).first->second;
}

Pass beginPass(Interpreter& in, int depthBuffer) {
    Pass pass;
    const TargetList& target = in.state.target;
    pass.targets = target.textures;
    pass.depthBuffer = depthBuffer;
    pass.place = target.place;
    const auto clearOnce = [&](bool isFirst) {
        pass.clearColors.push_back(isFirst ? std::optional(in.state.background) : std::nullopt);
    };
    if (target.textures.empty()) {
        clearOnce(!in.isWindowCleared);
        in.isWindowCleared = true;
    }
    for (const TextureIndex texture : target.textures) clearOnce(in.clearedTextures.insert(texture).second);
    pass.clearDepth = in.clearedDepths.insert(depthBuffer).second;
    return pass;
}

/// True if the implicit clear of the pass does the same as Clear would do now.
bool isClearAlready(const Pass& pass, const glm::dvec4& color) {
    return pass.steps.empty() && pass.clearDepth &&
           std::all_of(pass.clearColors.begin(), pass.clearColors.end(),
                       [&](const std::optional<glm::dvec4>& each) { return each == color; });
}

}  // namespace

Pass& currentPass(Interpreter& in) {
    const int depthBuffer = depthBufferOf(in, in.state.target);
    if (!in.scene.frame.passes.empty()) {
        Pass& last = in.scene.frame.passes.back();
        if (last.targets == in.state.target.textures && last.depthBuffer == depthBuffer) return last;
    }
    return in.scene.frame.passes.emplace_back(beginPass(in, depthBuffer));
}

namespace {

void doRenderToTexture(Interpreter& in, const glib::Command& command) {
    if (auto list = targetList(in, command)) in.state.target = std::move(*list);
}

void doClear(Interpreter& in, const glib::Command& command) {
    Pass& pass = currentPass(in);
    if (!isClearAlready(pass, in.state.background))
        pass.steps.emplace_back(Clear{in.place(command), in.state.background});
}

constexpr CommandAction kActions[] = {
    {glib::CommandId::renderToTexture, doRenderToTexture, InList::isWrong},
    {glib::CommandId::clear, doClear},
};

}  // namespace

std::span<const CommandAction> passActions() {
    return kActions;
}

void finishPasses(Interpreter& in) {
    if (in.isWindowCleared) return;
    in.state.target = {};
    currentPass(in);
}

}  // namespace glibra::scene
