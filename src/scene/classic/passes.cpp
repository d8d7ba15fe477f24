// Render targets and clearing (language, 2.3).

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/classic/classic.h"
#include "scene/run/statements.h"

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
std::optional<TargetList> targetList(Interpreter& in, const Command& command) {
    TargetList list;
    list.place = in.place(command);
    const auto refuse = [&](const std::string& text) {
        return in.reportAt(command, "glib-E11", fmt::format("{}: {}", textOf(command), text));
    };
    for (const double number : command.numbers) {
        const int unit = static_cast<int>(number);
        const TextureIndex texture = emptyTextureOn(in, unit);
        if (!texture)
            return refuse(fmt::format(
                "unit {0} holds no empty 2D texture; write 'Texture2D {0} 1024 1024' first", unit));
        if (std::ranges::find(list.units, unit) != list.units.end())
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

Pass beginPass(Interpreter& in, int depthBuffer) {
    Pass pass;
    const TargetList& target = in.state.target;
    pass.targets = target.textures;
    pass.isWindow = target.textures.empty();
    pass.depthBuffer = depthBuffer;
    pass.place = target.place;
    const auto clearOnce = [&](bool isFirst) {
        pass.clearColors.push_back(isFirst ? std::optional(in.state.background) : std::nullopt);
    };
    if (target.textures.empty()) clearOnce(!std::exchange(in.out.cleared.isWindow, true));
    for (const TextureIndex texture : target.textures) clearOnce(isFirstUse(in, texture, {}, 1));
    pass.clearDepth = in.out.cleared.depthBuffers.insert(depthBuffer).second;
    if (pass.clearDepth) pass.clearStencil = 0;
    return pass;
}

/// True if the implicit clear of the pass does the same as Clear would do now.
bool isClearAlready(const Pass& pass, const glm::dvec4& color) {
    return pass.steps.empty() && pass.clearDepth &&
           std::ranges::all_of(pass.clearColors,
                               [&](const std::optional<glm::dvec4>& each) { return each == color; });
}

}  // namespace

int depthBufferOf(Interpreter& in, const std::vector<int>& key, int width, int height) {
    const int next = static_cast<int>(in.made.depthBuffers.size()) + 1;
    return in.made.depthBuffers.try_emplace({key, width, height}, next).first->second;
}

bool checkDepthOrder(Interpreter& in, const Pass& pass, const Place& at) {
    const auto [first, isNew] = in.made.depthOrders.try_emplace(
        {pass.depth ? pass.depth->texture : TextureIndex(), pass.depth ? -1 : pass.depthBuffer},
        pass.isReversed, at);
    const auto& [isReversed, place] = first->second;
    if (isNew || isReversed == pass.isReversed) return true;
    const std::string name = pass.depth      ? "'" + in.scene.textures[pass.depth->texture].name + "'"
                             : pass.isWindow ? "the window"
                                             : "the implicit depth buffer";
    in.report(diagnose("glib-E11",
                       fmt::format("{} is drawn into with {} depth here and with {} depth on line {}; all "
                                   "passes into one depth are reversed, or none is",
                                   name, isReversed ? "the usual" : "reversed",
                                   isReversed ? "reversed" : "the usual", place.line),
                       at));
    return false;
}

bool isFirstUse(Interpreter& in, TextureIndex texture, const TargetPart& part, int layers) {
    constexpr int kAll = -1;
    auto& parts = in.out.cleared.parts;
    const int level = part.level.value_or(0);
    if (parts.contains({texture, level, kAll})) return false;
    if (part.layer) return parts.emplace(texture, level, *part.layer).second;
    bool isCleared = true;  // layer by layer
    for (int layer = 0; layer < layers && isCleared; ++layer)
        isCleared = parts.contains({texture, level, layer});
    parts.emplace(texture, level, kAll);
    return !isCleared;
}

namespace {

/// The pass into the target of RenderToTexture, or into the window. `at`: what needs it.
Pass& implicitPass(Interpreter& in, const Place& at) {
    NodeList& nodes = *in.out.nodes;
    const TargetList& target = in.state.target;
    const int depthBuffer =
        target.units.empty() ? 0 : depthBufferOf(in, target.units, target.width, target.height);
    const bool isLast =
        in.out.implicitPass && nodes.order.back() == NodeIndex{NodeIndex::Kind::pass, *in.out.implicitPass};
    if (isLast) {
        Pass& last = nodes.passes[*in.out.implicitPass];
        if (last.targets == target.textures && last.depthBuffer == depthBuffer) return last;
    }
    in.out.implicitPass = nodes.passes.size();
    Pass& begun = nodes.add(beginPass(in, depthBuffer));
    checkDepthOrder(in, begun, at);
    return begun;
}

}  // namespace

Pass* currentPass(Interpreter& in, const Command& command) {
    if (in.around.pass) return &in.out.nodes->passes[in.around.pass->index];
    if (in.around.block == nullptr) return &implicitPass(in, in.place(command));
    in.reportAt(command, "glib-E25",
                fmt::format("{}: {} draws into textures; write 'Pass NAME' around it", command.word,
                            in.around.block->word));
    return nullptr;
}

namespace {

void doRenderToTexture(Interpreter& in, const Command& command) {
    if (in.around.pass || in.around.block != nullptr) {
        in.reportAt(command, "glib-E23",
                    fmt::format("{} cannot stand inside {}; write 'Pass NAME'", command.word,
                                in.around.pass ? "Pass" : in.around.block->word));
        return;
    }
    if (auto list = targetList(in, command)) in.state.target = std::move(*list);
}

void doClear(Interpreter& in, const Command& command) {
    Pass* pass = currentPass(in, command);
    if (pass != nullptr && !isClearAlready(*pass, in.state.background))
        pass->steps.emplace_back(Clear{in.place(command), in.state.background});
}

}  // namespace

std::span<const CommandAction> passActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::renderToTexture, doRenderToTexture, InList::isWrong},
        {CommandId::clear, doClear},
    };
    return kActions;
}

void finishPasses(Interpreter& in) {
    if (in.out.cleared.isWindow) return;
    in.state.target = {};
    implicitPass(in, {});
}

}  // namespace glibra::scene
