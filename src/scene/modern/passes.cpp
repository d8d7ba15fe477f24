// Passes into the window and into textures (language, 12.5).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/text.h"
#include "glib/limits.h"
#include "glib/statement_table.h"
#include "scene/classic/classic.h"
#include "scene/modern/modern.h"
#include "scene/run/camera_use.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/scope.h"
#include "scene/run/statements.h"
#include "scene/run/uniforms.h"
#include "scene/textures.h"

namespace glibra::scene {
namespace {

// ---- Targets.

/// A list of targets that fit together.
struct Targets {
    std::vector<TextureView> colors;
    std::optional<TextureView> depth;
    bool isWindow = false;
    int width = 0, height = 0;  ///< of textures
    int samples = 1, layers = 1;
};

class TargetReader {
  public:
    TargetReader(Interpreter& in, const Command& command) : in_(in), command_(command) {}

    std::optional<Targets> read(std::span<const Value> values) {
        Targets targets;
        for (const Value& each : values) {
            if (isWindow(each)) {
                if (values.size() > 1) return refuse(each, "the window is the only target of its pass");
                if (in_.around.block != nullptr)
                    return refuse(each, fmt::format("{} cannot draw into the window, which every picture "
                                                    "begins anew; draw into a texture",
                                                    in_.around.block->word));
                targets.isWindow = true;
                return targets;
            }
            const auto view = textureNamed(in_, each);
            if (!view || !add(each, *view, targets)) return std::nullopt;
        }
        return targets;
    }

  private:
    std::nullopt_t refuse(const Value& value, const std::string& text) {
        return in_.reportAt(value, "glib-E11", fmt::format("{}: {}", command_.word, text));
    }

    bool add(const Value& value, const TextureView& view, Targets& targets) {
        const Texture& texture = in_.scene.textures[view.texture];
        const auto* source = std::get_if<EmptySource>(&texture.source);
        if (source == nullptr)
            return refuse(value,
                          fmt::format("'{}' is a picture; a target has a size and a format", texture.name)),
                   false;
        if (view.isPrevious)
            return refuse(value, fmt::format("'{}' is only read; draw into '{}'", value.text, texture.name)),
                   false;
        if (view.sampler)
            return refuse(value, fmt::format("'{}': a target is not sampled", value.text)), false;
        if (texture.target == TextureTarget::texture1D)
            return refuse(value, fmt::format("'{}' is a 1D texture; a target has a width and a height",
                                             texture.name)),
                   false;
        const auto isSame = [&](const TextureView& other) {
            return other.texture == view.texture && other.level.value_or(0) == view.level.value_or(0) &&
                   (!other.layer || !view.layer || other.layer == view.layer);
        };
        if (std::ranges::any_of(targets.colors, isSame))
            return refuse(value, fmt::format("'{}' is named twice", value.text)), false;
        if (!fits(value, view, texture, targets)) return false;
        if (!base::hasDepth(source->format)) {
            targets.colors.push_back(view);
            if (targets.colors.size() <= glib::kMostTargets) return true;
            return refuse(value, fmt::format("a pass has at most {} colours", glib::kMostTargets)), false;
        }
        if (targets.depth)
            return refuse(value, fmt::format("'{}' is the second depth texture; a pass has one", value.text)),
                   false;
        targets.depth = view;
        return true;
    }

    bool fits(const Value& value, const TextureView& view, const Texture& texture, Targets& targets) {
        const std::array<int, 3> size =
            sizeOfLevel(texture, view.level.value_or(0)).value_or(std::array{1, 1, 1});
        const int layers = view.layer ? 1 : size[2];
        if (targets.colors.empty() && !targets.depth) {
            first_ = value.text;
            targets.width = size[0];
            targets.height = size[1];
            targets.layers = layers;
            targets.samples = texture.samples;
            return true;
        }
        if (size[0] != targets.width || size[1] != targets.height)
            return refuse(value,
                          fmt::format("'{}' is {} x {}, '{}' is {} x {}; all must have the same size", first_,
                                      targets.width, targets.height, value.text, size[0], size[1])),
                   false;
        if (layers != targets.layers)
            return refuse(value, fmt::format("'{}' has {}, '{}' has {}; all must have as many", first_,
                                             base::counted(targets.layers, "layer"), value.text, layers)),
                   false;
        if (texture.samples != targets.samples)
            return refuse(value,
                          fmt::format("'{}' has {}, '{}' has {}; all must have as many", first_,
                                      base::counted(targets.samples, "sample"), value.text, texture.samples)),
                   false;
        return true;
    }

    Interpreter& in_;
    const Command& command_;
    std::string first_;
};

TargetPart partOf(const TextureView& view) {
    return {view.level, view.layer};
}

/// Equal for equal lists of targets, which share an implicit depth buffer.
std::vector<int> keyOfTargets(const Targets& targets) {
    std::vector<int> key;
    for (const TextureView& each : targets.colors)
        key.insert(key.end(), {-1 - static_cast<int>(each.texture.position()), each.level.value_or(0),
                               each.layer.value_or(-1)});
    return key;
}

// ---- Clearing.

/// What Pass states about the earlier content of its targets.
struct Clearing {
    enum class Kind { first, clear, keep };  ///< `first`: cleared by the first pass
    Kind kind = Kind::first;
    std::vector<glm::dvec4> colors;  ///< none, one for all targets, or one per target
    double depth = 1;
    int stencil = 0;
    bool keepsColor = false, keepsDepth = false, keepsStencil = false;  ///< unless `kind` is `first`

    /// What the statement says about a target.
    [[nodiscard]] std::optional<glm::dvec4> color(std::size_t target) const {
        if (colors.empty()) return std::nullopt;
        return colors[std::min(target, colors.size() - 1)];
    }
    /// True if a part of this kind is cleared. `isFirst`: nothing has cleared it yet.
    [[nodiscard]] bool clears(bool keeps, bool isFirst) const {
        return kind == Kind::first ? isFirst : !keeps;
    }
};

std::optional<glm::dvec4> colorOf(Interpreter& in, const Command& command, const Value& value) {
    const auto numbers = floatsOf(in, {&value, 1});
    if (!numbers) return std::nullopt;
    if (numbers->size() == 1) return glm::dvec4(numbers->front());
    if (numbers->size() != 3 && numbers->size() != 4)
        return in.reportAt(
            value, "glib-E26",
            fmt::format("{}: a colour has 1, 3 or 4 components, not {}", command.word, numbers->size()));
    return glm::dvec4((*numbers)[0], (*numbers)[1], (*numbers)[2], numbers->size() == 4 ? (*numbers)[3] : 1);
}

std::optional<Clearing> readClearing(Interpreter& in, const Command& command, const Targets& targets) {
    Clearing clearing;
    const std::size_t most = targets.isWindow ? 1 : targets.colors.size();
    for (const KeyedValues& key : command.keys) {
        if (key.key == "clear") {
            clearing.kind = Clearing::Kind::clear;
            for (const Value& each : key.values) {
                const auto color = colorOf(in, command, each);
                if (!color) return std::nullopt;
                clearing.colors.push_back(*color);
            }
            if (clearing.colors.size() > 1 && clearing.colors.size() != most)
                return in.reportAt(key.values.front(), "glib-E26",
                                   fmt::format("{}: {} colours for {} targets; write one for all, or one "
                                               "per target with colours",
                                               command.word, clearing.colors.size(), most));
        } else if (key.key == "depth") {
            const auto depth = numberIn(in, key.values.front(), command.word + ": depth", 0, 1);
            if (!depth) return std::nullopt;
            clearing.depth = *depth;
        } else if (key.key == "stencil") {
            const auto stencil = integerIn(in, key.values.front(), command.word + ": stencil", 0, 255);
            if (!stencil) return std::nullopt;
            clearing.stencil = *stencil;
        } else if (key.key == "keep") {
            if (clearing.kind == Clearing::Kind::first) clearing.kind = Clearing::Kind::keep;
            if (key.values.empty()) clearing.keepsColor = clearing.keepsDepth = clearing.keepsStencil = true;
            constexpr std::array<std::string_view, 3> kParts{"color", "depth", "stencil"};
            for (const Value& each : key.values) {
                const auto part = wordOf(in, each, kParts);
                if (!part) return std::nullopt;
                const std::array flags{&clearing.keepsColor, &clearing.keepsDepth, &clearing.keepsStencil};
                *flags[*part] = true;
            }
        }
    }
    return clearing;
}

int layersOfView(const Interpreter& in, const TextureView& view) {
    const auto size = sizeOfLevel(in.scene.textures[view.texture], view.level.value_or(0));
    return size ? (*size)[2] : 1;
}

TexelFormat formatOf(const Interpreter& in, const TextureView& view) {
    return std::get<EmptySource>(in.scene.textures[view.texture].source).format;
}

/// The colour that a target is cleared to. Integers are cleared to zero unless the pass states a colour.
glm::dvec4 clearColorOf(const Interpreter& in, const TextureView& view,
                        const std::optional<glm::dvec4>& stated) {
    if (stated) return *stated;
    return base::isInteger(formatOf(in, view)) ? glm::dvec4(0) : in.state.background;
}

/// Fills in the targets of a pass and what it clears. Without `usesDepth` the pass neither clears nor keeps
/// the depth.
Pass makePass(Interpreter& in, const Command& command, const Targets& targets, const Clearing& clearing,
              bool usesDepth) {
    Pass pass;
    pass.place = in.place(command);
    pass.isWindow = targets.isWindow;
    const auto clearColor = [&](bool isFirst, const glm::dvec4& color) {
        pass.clearColors.push_back(clearing.clears(clearing.keepsColor, isFirst) ? std::optional(color)
                                                                                 : std::nullopt);
    };
    if (targets.isWindow) {
        const bool isFirst = !std::exchange(in.out.cleared.isWindow, true);
        // A picture begins with the background, so there is nothing to keep yet.
        if (isFirst && clearing.kind == Clearing::Kind::keep)
            pass.clearColors.emplace_back(in.state.background);
        else
            clearColor(isFirst, clearing.color(0).value_or(in.state.background));
    }
    bool hasPart = false;
    for (const TextureView& each : targets.colors) {
        pass.targets.push_back(each.texture);
        pass.parts.push_back(partOf(each));
        hasPart = hasPart || each.level || each.layer;
        clearColor(isFirstUse(in, each.texture, partOf(each), layersOfView(in, each)),
                   clearColorOf(in, each, clearing.color(pass.targets.size() - 1)));
    }
    if (!hasPart) pass.parts.clear();
    pass.depth = targets.depth;
    if (!targets.isWindow && !targets.depth)
        pass.depthBuffer = depthBufferOf(in, keyOfTargets(targets), targets.width, targets.height);
    if (!usesDepth) return pass;
    const bool isFirst = targets.depth ? isFirstUse(in, targets.depth->texture, partOf(*targets.depth),
                                                    layersOfView(in, *targets.depth))
                                       : in.out.cleared.depthBuffers.insert(pass.depthBuffer).second;
    // Depth buffers without a name begin every picture anew.
    const bool isAnew = isFirst && !targets.depth;
    pass.clearDepth = isAnew || clearing.clears(clearing.keepsDepth, isFirst);
    pass.depthValue = clearing.depth;
    const bool hasStencil = !targets.depth || base::hasStencil(formatOf(in, *targets.depth));
    if (hasStencil && (isAnew || clearing.clears(clearing.keepsStencil, isFirst)))
        pass.clearStencil = clearing.stencil;
    return pass;
}

void doPass(Interpreter& in, const Command& command) {
    if (!isOutsidePass(in, command)) return;
    const auto targets = TargetReader(in, command).read(command.values);
    if (!targets) return;
    const auto clearing = readClearing(in, command, *targets);
    if (!clearing) return;
    const KeyedValues* from = command.key("from");
    std::optional<SceneCamera> camera;
    if (from != nullptr) {
        camera = cameraNamed(in, from->values.front());
        if (!camera) return;
    }
    const KeyedValues* stencil = command.key("stencil");
    if (stencil != nullptr && targets->depth && !base::hasStencil(formatOf(in, *targets->depth))) {
        in.report(diagnose("glib-E38",
                           fmt::format("{}: '{}' has no stencil; its format must be depth24_stencil8 or "
                                       "depth32f_stencil8",
                                       command.word, in.scene.textures[targets->depth->texture].name),
                           in.script->place(stencil->position)));
        return;
    }
    const KeyedValues* reversed = command.key("reversed");
    if (reversed != nullptr && targets->depth) {
        const TexelFormat format = formatOf(in, *targets->depth);
        if (format != TexelFormat::depth32f && format != TexelFormat::depth32f_stencil8) {
            in.report(diagnose("glib-E11",
                               fmt::format("{}: reversed depth needs floats, but '{}' is {}; its format must "
                                           "be depth32f or depth32f_stencil8",
                                           command.word, in.scene.textures[targets->depth->texture].name,
                                           base::rowOf(format).name),
                               in.script->place(reversed->position)));
            return;
        }
    }
    const std::size_t index = indexOf(in, command);
    Pass pass = makePass(in, command, *targets, *clearing, true);
    pass.isReversed = reversed != nullptr;
    if (!checkDepthOrder(in, pass, pass.place)) return;
    OpenPass open;
    open.place = pass.place;
    open.aspect =
        targets->isWindow ? windowAspect(in) : static_cast<double>(targets->width) / targets->height;
    open.camera = camera ? camera->name : CameraName{"eye", 0};
    open.hasStencil = !targets->depth || base::hasStencil(formatOf(in, *targets->depth));
    if (from != nullptr && camera->name != CameraName{"eye", 0}) pass.camera = textOf(in, camera->name);
    open.index = in.out.nodes->passes.size();
    in.out.nodes->add(std::move(pass));
    in.out.implicitPass.reset();

    const Scope scope(in);
    noteFreshRaster(in, command);
    resetRaster(in);
    in.around.pass = std::move(open);
    const SceneCamera seen = currentCamera(in);
    Pass& made = in.out.nodes->passes.back();
    if (seen.root != CameraName{"eye", 0})
        made.rootCamera = fmt::format("{}[{}]", seen.root.first, seen.root.second);
    made.shift = seen.shift;
    noteAspect(in, seen, in.around.pass->aspect);
    noteCamera(in, seen);
    runBody(in, index + 1, command.partner);
    in.around.pass.reset();
}

void doFill(Interpreter& in, const Command& command) {
    if (!isOutsidePass(in, command)) return;
    const KeyedValues* with = command.key("with");
    const auto targets = TargetReader(in, command).read(command.values);
    if (!targets || with == nullptr) return;
    if (targets->depth) {
        const auto depth = std::ranges::find_if(command.values, [&](const Value& each) {
            const auto view = textureNamed(in, each);
            return view && base::hasDepth(formatOf(in, *view));
        });
        in.report(diagnose("glib-E38",
                           fmt::format("{}: a depth texture has no colours to fill", command.word),
                           in.script->place(depth->position)));
        return;
    }
    const auto program = programNamed(in, with->values.front(), false);
    if (!program) return;
    noteFreshRaster(in, command);
    Pass pass = makePass(in, command, *targets, {}, false);
    Draw made;
    made.place = pass.place;
    made.id = nextDrawId(in, made.place);
    made.word = command.word;
    Shape shape{.command = command.id, .numbers = {3}, .file = {}, .list = nullptr};
    if (in.scene.programs[*program].hasStage(glsl::Stage::vertex, true)) {
        shape.command = glib::findCommand("FullScreen")->id;
        shape.numbers.clear();
    } else {
        shape.bare = geometry::Topology::triangles;
    }
    made.shape = shareShape(in, std::move(shape));
    made.program = *program;
    made.isFill = true;
    made.projection = coveringSpace(
        in, targets->isWindow ? windowAspect(in) : static_cast<double>(targets->width) / targets->height);
    noteFill(in);
    made.color = in.state.color;
    RasterState& raster = made.raster.change();
    raster.depthTest = raster.depthWrite = false;
    made.sampling = in.state.sampling;
    made.slots = currentSlots(in);
    made.uniforms = uniformsOf(in, *program, command.tags);
    made.timerPeriod = in.state.timerPeriod;
    pass.steps.emplace_back(std::move(made));
    in.out.nodes->add(std::move(pass));
    in.out.implicitPass.reset();
}

void doClearParts(Interpreter& in, const Command& command) {
    if (!command.values.front().path.empty()) return doClearObject(in, command);
    Clear clear{in.place(command), std::nullopt, false, false};
    constexpr std::array<std::string_view, 3> kParts{"color", "depth", "stencil"};
    for (const Value& each : command.values) {
        const auto part = wordOf(in, each, kParts);
        if (!part) return;
        if (*part == 0) clear.color = in.state.background;
        if (*part == 1) clear.depth = true;
        if (*part == 2) clear.stencil = true;
    }
    if (clear.stencil && in.around.pass && !in.around.pass->hasStencil) {
        in.reportAt(command, "glib-E38",
                    fmt::format("{}: this pass has no stencil; its depth texture needs the format "
                                "depth24_stencil8",
                                command.word));
        return;
    }
    if (Pass* pass = currentPass(in, command)) pass->steps.emplace_back(clear);
}

std::optional<base::FractionRectangle> areaOf(Interpreter& in, const Command& command, bool mayBeEmpty) {
    const auto numbers = floatsOf(in, command.values, 4, command.word);
    if (!numbers) return std::nullopt;
    const base::FractionRectangle area{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
    constexpr double kFar = 64;  // times the target, so that pixels stay in the range of the driver
    const bool isNear = std::all_of(numbers->begin(), numbers->end(),
                                    [](double each) { return each >= -kFar && each <= kFar; });
    const bool hasArea = area.width > 0 && area.height > 0;
    const bool isNegative = area.width < 0 || area.height < 0;
    if (isNear && (hasArea || (mayBeEmpty && !isNegative))) return area;
    return in.reportAt(command.values.front(), "glib-E05",
                       fmt::format("{} needs x y width height in fractions of the target, the width and "
                                   "height above 0",
                                   command.word));
}

void doViewport(Interpreter& in, const Command& command) {
    noteRasterStatement(in, command, RasterPart::viewport);
    if (const auto area = areaOf(in, command, false)) in.state.raster.viewport = *area;
}

void doScissor(Interpreter& in, const Command& command) {
    noteRasterStatement(in, command, RasterPart::scissor);
    if (const auto area = areaOf(in, command, true)) in.state.raster.scissor = *area;
}

}  // namespace

bool isOutsidePass(Interpreter& in, const Command& command) {
    if (!in.around.pass) return true;
    in.reportAt(command, "glib-E23",
                fmt::format("{} cannot stand inside Pass (line {}); move it out", command.word,
                            in.around.pass->place.line));
    return false;
}

std::span<const CommandAction> targetActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::pass, doPass, InList::isWrong, true},
        {CommandId::endPass, doNothing, InList::isWrong, true},
        {CommandId::fill, doFill, InList::isWrong, true},
        {CommandId::clearParts, doClearParts},
        {CommandId::viewport, doViewport},
        {CommandId::scissor, doScissor},
    };
    return kActions;
}

}  // namespace glibra::scene
