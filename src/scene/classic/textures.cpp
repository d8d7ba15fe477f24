// Textures and the slots that hold them (language, 2.4, 3.4 and 9).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "glib/statement_table.h"
#include "glib/text.h"
#include "scene/classic/classic.h"
#include "scene/run/statements.h"
#include "scene/textures.h"

namespace glibra::scene {
namespace {

constexpr std::uint64_t kAllTextures = std::uint64_t{4} << 30U;  // bytes

/// The noise textures are the first two textures of every scene.
constexpr TextureIndex kNoise2Texture{0};
constexpr TextureIndex kNoise3Texture{1};

/// The formats in the order of glib's table.
constexpr std::array kFormats{TexelFormat::rgba8, TexelFormat::rgba16f, TexelFormat::rgba32f,
                              TexelFormat::r32f};

/// Returns the index of the format with that word, or 0 if there is none.
std::size_t formatIndex(std::string_view word) {
    const auto formats = glib::textureFormats();
    for (std::size_t i = 0; i < formats.size() && i < kFormats.size(); ++i)
        if (glib::sameWord(formats[i].name, word)) return i;
    return 0;
}

TextureTarget targetOfDimensions(std::size_t dimensions) {
    if (dimensions == 1) return TextureTarget::texture1D;
    return dimensions == 2 ? TextureTarget::texture2D : TextureTarget::texture3D;
}

/// Puts the texture into its slot. Slots stay sorted by unit and target.
void store(Interpreter& in, const Command& command, Texture texture) {
    Slot slot{texture.unit, texture.target, {}};
    slot.texture = in.scene.textures.add(std::move(texture));
    in.made.slotTable = {};
    const auto order = [](const Slot& a, const Slot& b) {
        return std::pair(a.unit, a.target) < std::pair(b.unit, b.target);
    };
    const auto at = std::ranges::lower_bound(in.state.slots, slot, order);
    if (at == in.state.slots.end() || order(slot, *at)) {
        in.state.slots.insert(at, slot);
        return;
    }
    if (at->texture == kNoise2Texture || at->texture == kNoise3Texture)
        in.reportAt(command, "glib-W36", fmt::format("the noise texture on unit {} is replaced", slot.unit));
    at->texture = slot.texture;
}

/// Returns an empty texture, or nothing with glib-E15 if all such textures together would be too large.
std::optional<EmptySource> emptySource(Interpreter& in, const Command& command) {
    std::array<int, 3> sizes{1, 1, 1};
    const std::size_t format = formatIndex(command.text());
    auto bytes = static_cast<std::uint64_t>(glib::textureFormats()[format].bytes);
    for (std::size_t i = 0; i < sizes.size() && i + 1 < command.numbers.size(); ++i) {
        sizes[i] = static_cast<int>(command.numbers[i + 1]);
        bytes *= static_cast<std::uint64_t>(sizes[i]);
    }
    if (!chargeTexels(in, command, bytes)) return std::nullopt;
    return EmptySource{sizes[0], sizes[1], sizes[2], kFormats[format]};
}

/// The number of dimensions in the command's name; 0 if it has none.
std::size_t dimensionsOf(CommandId id) {
    switch (id) {
        case CommandId::texture1D:
            return 1;
        case CommandId::texture2D:
            return 2;
        case CommandId::texture3D:
            return 3;
        default:
            break;
    }
    return 0;
}

void setNoiseSize(Interpreter& in, const Command& command, std::size_t index) {
    if (!command.numbers.empty()) in.noise.sizes[index] = static_cast<int>(command.numbers[0]);
    in.noise.areGiven[index] = in.noise.areGiven[index] || command.givenNumbers > 0;
}

}  // namespace

bool chargeTexels(Interpreter& in, const Command& command, std::uint64_t bytes) {
    const std::uint64_t all = in.counts.textureBytes + bytes;
    if (all > kAllTextures) {
        in.reportAt(command, "glib-E15",
                    fmt::format("{}: all textures need {} bytes; the limit is {}", textOf(command),
                                base::groupedText(all), base::groupedText(kAllTextures)));
        return false;
    }
    in.counts.textureBytes = all;
    return true;
}

Texture pictureTexture(Interpreter& in, const std::string& name, const Place& place, std::size_t wanted) {
    Texture texture;
    const FileIndex file = fileOf(in, name, place);
    const base::FileSource source = in.scene.files[file].source();
    const auto noise = source.path.empty() ? noiseNameOf(name) : std::nullopt;
    if (noise && (wanted == 0 || wanted == static_cast<std::size_t>(noise->dimensions))) {
        texture.target = targetOfDimensions(static_cast<std::size_t>(noise->dimensions));
        texture.source = NoiseSource{
            .dimensions = noise->dimensions,
            .size = noise->size,
            .isSizeGiven = true,
            .remarks = {diagnose("file-W09", fmt::format("'{}' not found; the built-in noise is used", name),
                                 place)}};
        return texture;
    }
    texture.target = wanted == 0 ? targetOfFile(source) : targetOfDimensions(wanted);
    texture.source = PictureSource{{file}};
    return texture;
}

void addNoiseTextures(Interpreter& in) {
    const Place place = in.script->place({});
    in.scene.textures.push_back(
        {TextureTarget::texture2D, NoiseSource{.dimensions = 2, .remarks = {}}, place, kNoise2Unit});
    in.scene.textures.push_back(
        {TextureTarget::texture3D, NoiseSource{.dimensions = 3, .remarks = {}}, place, kNoise3Unit});
    in.state.slots = {{kNoise2Unit, TextureTarget::texture2D, kNoise2Texture},
                      {kNoise3Unit, TextureTarget::texture3D, kNoise3Texture}};
}

namespace {

void doTexture(Interpreter& in, const Command& command) {
    if (command.numbers.empty()) return;
    Texture texture;
    if (command.numbers.size() > 1) {
        const auto source = emptySource(in, command);
        if (!source) return;
        texture.source = *source;
        texture.target = targetOfDimensions(command.numbers.size() - 1);
    } else {
        texture = pictureTexture(in, command.text(), in.script->place(command.textPosition()),
                                 dimensionsOf(command.id));
    }
    texture.place = in.place(command);
    texture.unit = static_cast<int>(command.numbers[0]);
    store(in, command, std::move(texture));
}

void doCubeMap(Interpreter& in, const Command& command) {
    if (command.numbers.empty()) return;
    PictureSource source;
    for (const Value& each : command.values)
        source.files.push_back(fileOf(in, each.text, in.script->place(command.textPosition())));
    store(in, command,
          {TextureTarget::cube, std::move(source), in.place(command), static_cast<int>(command.numbers[0])});
}

void doClamp(Interpreter& in, const Command& command) {
    in.state.sampling.clamp = command.numbers.empty() || command.numbers[0] != 0;
}

void doNoise2D(Interpreter& in, const Command& command) {
    setNoiseSize(in, command, 0);
}
void doNoise3D(Interpreter& in, const Command& command) {
    setNoiseSize(in, command, 1);
}

}  // namespace

std::span<const CommandAction> textureActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::texture1D, doTexture}, {CommandId::texture2D, doTexture},
        {CommandId::texture3D, doTexture}, {CommandId::texture, doTexture},
        {CommandId::cubeMap, doCubeMap},   {CommandId::clamp, doClamp},
        {CommandId::noise2D, doNoise2D},   {CommandId::noise3D, doNoise3D},
    };
    return kActions;
}

void finishNoise(Interpreter& in) {
    for (const TextureIndex index : {kNoise2Texture, kNoise3Texture}) {
        Texture& texture = in.scene.textures[index];
        NoiseSource noise;
        noise.dimensions = index == kNoise2Texture ? 2 : 3;
        noise.size = in.noise.sizes[index.position()];
        noise.isSizeGiven = in.noise.areGiven[index.position()];
        FileReference file = noiseFileBeside(in.folders, noise.dimensions, noise.size, texture.place);
        noise.remarks = std::move(file.remarks);
        const std::string key = "\n" + file.path.generic_string();
        if (!file.path.empty()) noise.file = fileNamed(in, key, [&] { return std::move(file); });
        texture.source = std::move(noise);
    }
}

// Render targets and clearing (language, 2.3).

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
