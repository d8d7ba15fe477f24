#include "render/draw/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "gpu/object/compute.h"
#include "gpu/object/uniform.h"
#include "plan/accesses.h"
#include "plan/uniform_names.h"
#include "render/draw/patch_split.h"
#include "render/draw/sight.h"
#include "render/load/gl_names.h"

namespace glibra::render {
namespace {

/// The colour of draws whose program failed.
constexpr glm::dvec4 kMagenta{1, 0, 1, 1};

std::array<double, 4> asArray(const glm::dvec4& color) {
    return {color.r, color.g, color.b, color.a};
}

/// The draw with the matrices of the camera instead of the clip space.
scene::Draw seenBy(const scene::ClipSpace& space, scene::Draw draw) {
    draw.modelView = space.view;
    draw.model = glm::dmat4(1);
    std::visit([&](const auto& projection) { draw.projection = projection; }, space.projection);
    return draw;
}

constexpr std::array<float, 6> kOneLevel{1, 1, 1, 1, 1, 1};

}  // namespace

double timerAt(double time, double period) {
    // fmod is exact for any time. The largest float below 1 keeps the quotient from rounding up to 1.
    const double rest = std::fmod(time, period);
    return std::min((rest < 0 ? rest + period : rest) / period, 1 - 0x1p-24);
}

FrameDrawer::FrameDrawer(const gpu::Context& context, const plan::FramePlan& plan,
                         const ProgramLibrary& programs, DeviceScene& device, Stats& stats)
    : context_(context),
      plan_(plan),
      programs_(programs),
      device_(device),
      stats_(stats),
      states_(plan.programs.size()),
      raster_(context.capabilities()) {}

void FrameDrawer::skipOpaqueBlending() {
    blendsOpaque_ = false;
    std::set<plan::PlannedProgramIndex> reported;
    for (const plan::PlannedPass& pass : plan_.passes)
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<plan::PlannedDraw>(&step);
            if (!draw || !plan_.passOf(pass).isWindow) continue;
            const BuiltProgram* own = ownProgramOf(*draw);
            if (own == nullptr || !own->interface.facts.isOpaque || !reported.insert(draw->program).second)
                continue;
            const glsl::TranslatedProgram& facts = own->interface.facts;
            stats_.skip("blending", fmt::format("'{}': always writes 1 for alpha", facts.name), facts.place);
        }
}

bool FrameDrawer::texturesComeFirst() const {
    bool windowSeen = false;
    for (const scene::NodeIndex& node : plan_.order) {
        if (node.kind == scene::NodeIndex::Kind::pass && plan_.passOf(plan_.passes[node.index]).isWindow)
            windowSeen = true;
        else if (windowSeen)
            return false;
    }
    return true;
}

Diagnostics FrameDrawer::draw(const gpu::Target& window, const Frame& frame) {
    Diagnostics diagnostics;
    const auto begin = [&](const std::vector<scene::ObjectView>& objects) {
        for (const scene::ObjectView& each : objects) {
            const plan::Object object = plan::objectOf(each);
            const bool isKept = frame.still != nullptr && frame.still->contents.contains(object);
            if (!isKept && device_.isChanged(object)) append(diagnostics, device_.reset(each));
        }
    };
    if (frame.texturePasses) {
        begin(plan_.resets);
        begin(plan_.reads);
    }
    append(diagnostics, execute(&window, frame));
    return diagnostics;
}

Diagnostics FrameDrawer::run(const Frame& frame) {
    return execute(nullptr, frame);
}

Diagnostics FrameDrawer::execute(const gpu::Target* window, const Frame& frame) {
    frame_ = &frame;
    forgetState();
    if (plan_.passes.empty()) return drawNodes(window, frame);  // dispatches do not set raster state
    Diagnostics diagnostics = drawNodes(window, frame);
    encodeSrgb(false);
    // Others that draw with this context expect the state in which a pass begins.
    raster_.limitTo({});
    raster_.apply({});
    raster_.limitTo(limit_);
    setTessellationLevels(kOneLevel);
    return diagnostics;
}

void FrameDrawer::encodeSrgb(bool on) {
    if (std::exchange(encodesSrgb_, on) == on) return;
    on ? glEnable(GL_FRAMEBUFFER_SRGB) : glDisable(GL_FRAMEBUFFER_SRGB);
}

void FrameDrawer::forgetState() {
    raster_.forget();
    clipDistances_.reset();
    patchVertices_.reset();
}

bool FrameDrawer::drawsPlainly() const {
    return !hook_ && !limit_ && !wireframe_ && drawLimit_ == std::numeric_limits<std::size_t>::max() &&
           shift_ == glm::dvec2(0.0) && textureShifts_.empty();
}

bool FrameDrawer::isStill(std::size_t node) {
    if (frame_->still == nullptr || frame_->still->nodes.empty() || !frame_->still->nodes[node]) return false;
    const bool isPass = plan_.order[node].kind == scene::NodeIndex::Kind::pass;
    stats_.add(isPass ? kStillPasses : kStillDispatches, 1);
    return true;
}

void FrameDrawer::noteWrites(std::size_t node) {
    if (!device_.isModern()) return;
    if (writes_.empty()) {
        writes_.resize(plan_.order.size());
        for (std::size_t i = 0; i < plan_.order.size(); ++i)
            for (const plan::ObjectUse& each : plan::usesOf(plan_, i))
                if (each.writes) writes_[i].insert(plan::objectOf(each.object));
    }
    for (const plan::Object& each : writes_[node]) device_.noteWritten(each);
}

Diagnostics FrameDrawer::exchangeCopies(std::size_t node) {
    Diagnostics diagnostics;
    if (node >= plan_.exchanges.size()) return diagnostics;
    for (const plan::PlannedExchange& each : plan_.exchanges[node]) {
        if (const auto* buffer = std::get_if<scene::BufferIndex>(&each.object)) {
            device_.buffers().exchange(*buffer, each.keepsContent);
            continue;
        }
        const scene::TextureIndex texture = std::get<scene::TextureIndex>(each.object);
        device_.exchange(texture);
        if (each.keepsContent) append(diagnostics, device_.copyFromPrevious(texture));
    }
    return diagnostics;
}

Diagnostics FrameDrawer::drawNodes(const gpu::Target* window, const Frame& frame) {
    Diagnostics diagnostics;
    std::size_t draws = 0;  // in the passes before the next one
    std::size_t texturePass = 0;
    for (std::size_t index = 0; index < plan_.order.size() && !hasError(diagnostics); ++index) {
        const scene::NodeIndex& node = plan_.order[index];
        if (node.kind != scene::NodeIndex::Kind::pass) {
            if (!frame.texturePasses || isStill(index)) continue;
            if (nodeHook_) nodeHook_(index, true);
            append(diagnostics, exchangeCopies(index));
            noteWrites(index);
            if (node.kind == scene::NodeIndex::Kind::dispatch)
                append(diagnostics, dispatch(plan_.dispatches[node.index]));
            else
                clearObject(plan_.clearOf(plan_.clears[node.index]));
            if (nodeHook_) nodeHook_(index, false);
            continue;
        }
        const plan::PlannedPass& pass = plan_.passes[node.index];
        const std::size_t begin = draws;
        draws += static_cast<std::size_t>(
            std::count_if(pass.steps.begin(), pass.steps.end(),
                          [](const auto& step) { return std::holds_alternative<plan::PlannedDraw>(step); }));
        const bool isWindow = plan_.passOf(pass).isWindow;
        if (isWindow ? window == nullptr : !frame.texturePasses) continue;
        if (isStill(index)) {
            ++texturePass;
            continue;
        }
        if (nodeHook_) nodeHook_(index, true);
        append(diagnostics, exchangeCopies(index));
        noteWrites(index);
        const gpu::Target* target = window;
        if (!isWindow) {
            Result<const gpu::Target*> made = device_.target(plan_.passOf(pass));
            append(diagnostics, std::move(made.diagnostics));
            if (!made) {
                if (nodeHook_) nodeHook_(index, false);
                return diagnostics;
            }
            target = *made;
            texture_ = {0, 0, target->width(), target->height()};
            textureShift_ = texturePass < textureShifts_.size() ? textureShifts_[texturePass] : glm::dvec2(0);
            ++texturePass;
        }
        append(diagnostics, drawPass(pass, *target, begin));
        if (nodeHook_) nodeHook_(index, false);
    }
    return diagnostics;
}

Diagnostics FrameDrawer::drawPass(const plan::PlannedPass& pass, const gpu::Target& target,
                                  std::size_t begin) {
    Diagnostics diagnostics;
    const bool isWindow = plan_.passOf(pass).isWindow;
    completeReads(pass);
    beginPass(pass, target);
    std::size_t drawIndex = begin;
    for (const auto& step : pass.steps) {
        if (drawIndex >= drawLimit_) break;
        if (const auto* draw = std::get_if<plan::PlannedDraw>(&step)) {
            append(diagnostics, drawOne(*draw, target, isWindow));
            ++drawIndex;
        } else {
            clear(target, plan_.clearOf(std::get<plan::PlannedClear>(step)), isWindow);
        }
    }
    const scene::Pass& drawn = plan_.passOf(pass);
    for (const scene::TextureIndex each : drawn.targets) device_.wasWritten(each);
    stats_.add("passes", 1);
    return diagnostics;
}

void FrameDrawer::completeReads(const plan::PlannedPass& pass) {
    for (const auto& step : pass.steps)
        if (const auto* draw = std::get_if<plan::PlannedDraw>(&step)) completeReads(draw->textures);
}

void FrameDrawer::completeReads(const std::vector<plan::TextureUse>& textures) {
    bool isScissorOff = false;
    for (const plan::TextureUse& use : textures) {
        if (use.isImage || !device_.isIncomplete(use)) continue;
        if (!std::exchange(isScissorOff, true)) {  // it would cut what resolving the samples writes
            raster_.limitTo({});
            raster_.openForClears();
        }
        device_.complete(use);
    }
    if (isScissorOff) raster_.limitTo(limit_);
}

void FrameDrawer::beginPass(const plan::PlannedPass& pass, const gpu::Target& target) {
    const scene::Pass& begun = plan_.passOf(pass);
    context_.debugLog().setPlace(begun.place);
    isAsWindow_ = isMoved(*plan_.nodes, begun);
    if (!isAsWindow_) {
        passView_ = frame_->view.unmoved();
    } else if (begun.shift != glm::dmat4(1)) {
        isAsWindow_ = false;
        passView_ = frame_->view.shifted(begun.shift);
    }
    target.bind();
    encodeSrgb(target.hasSrgb());
    raster_.targetBound(target.width(), target.height());
    raster_.openForClears();
    for (std::size_t i = 0; i < begun.clearColors.size(); ++i)
        if (const auto& color = begun.clearColors[i])
            target.clearColorOfAnyFormat(static_cast<int>(i), asArray(clearColor(*color, begun.isWindow)));
    if (begun.clearDepth) target.clearDepth(static_cast<float>(begun.depthValue));
    if (begun.clearStencil) target.clearStencil(*begun.clearStencil);
}

void FrameDrawer::clear(const gpu::Target& target, const scene::Clear& clear, bool isWindow) {
    raster_.openForClears();
    const int colors = clear.color ? target.readable().colorCount() : 0;
    for (int i = 0; i < colors; ++i)
        target.clearColorOfAnyFormat(i, asArray(clearColor(*clear.color, isWindow)));
    if (clear.depth) target.clearDepth();
    if (clear.stencil) target.clearStencil();
}

glm::dvec4 FrameDrawer::clearColor(const glm::dvec4& color, bool isWindow) const {
    const auto& chosen = frame_->view.state().background;
    if (!isWindow || !chosen) return color;
    return {(*chosen)[0], (*chosen)[1], (*chosen)[2], (*chosen)[3]};
}

void FrameDrawer::forgetLiterals(plan::PlannedProgramIndex program) {
    ProgramState& state = states_[program];
    state.literalsSet = false;
    state.blocks.clear();
}

void FrameDrawer::resetUniforms(plan::PlannedProgramIndex program, const BuiltProgram& built) {
    if (built.initialValues.empty()) return;
    std::set<std::pair<plan::UniformIndex, int>> given;
    for (const plan::UniformBinding& each : plan_.programs[program].values)
        given.emplace(each.uniform, each.firstElement);
    for (const InitialValue& each : built.initialValues)
        if (!given.contains({each.uniform, each.element}))
            gpu::setUniform(*built.program, at(built.interface.uniforms, each.uniform), each.values,
                            each.element);
}

void FrameDrawer::setLiterals(plan::PlannedProgramIndex program, const BuiltProgram& built) {
    ProgramState& state = states_[program];
    if (state.literalsSet && built.literalsOf == &state) return;
    state.literalsSet = true;
    built.literalsOf = &state;
    resetUniforms(program, built);
    state.blocks.clear();
    std::vector<std::vector<std::byte>> blocks;
    for (const base::UniformBlock& each : built.interface.blocks)
        blocks.emplace_back(static_cast<std::size_t>(each.bytes));
    for (const plan::UniformBinding& binding : plan_.programs[program].values) {
        const auto* literal = std::get_if<plan::Literal>(&binding.value);
        if (!literal) continue;
        const base::ActiveUniform& uniform = at(built.interface.uniforms, binding.uniform);
        if (uniform.block >= 0)
            gpu::writeBlockMember(blocks[static_cast<std::size_t>(uniform.block)], uniform, literal->values,
                                  binding.firstElement);
        else
            gpu::setUniform(*built.program, uniform, literal->values, binding.firstElement);
    }
    for (const plan::BlockUse& each : plan_.programs[program].blocks)
        if (each.kind == plan::BlockUse::Kind::uniform) blocks.at(each.index).clear();
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        glUniformBlockBinding(built.program->id(), built.interface.blocks[i].index, static_cast<GLuint>(i));
        gpu::Buffer& values = state.blocks.emplace_back();
        if (blocks[i].empty()) continue;
        if (Result<gpu::Buffer> buffer = gpu::Buffer::create(blocks[i])) values = std::move(*buffer);
    }
    for (std::size_t i = 0; i < built.interface.storageBlocks.size(); ++i)
        glShaderStorageBlockBinding(built.program->id(), built.interface.storageBlocks[i].index,
                                    static_cast<GLuint>(i));
}

DrawFacts FrameDrawer::factsOf(const scene::Draw& draw, double aspect) const {
    DrawFacts facts;
    const ViewMatrices& view = isAsWindow_ ? frame_->view : passView_;
    facts.projection = view.projection(draw.projection, aspect);
    facts.modelView = view.modelView(draw);
    facts.texture = frame_->view.texture();
    facts.timer = timerAt(frame_->time, draw.timerPeriod);
    facts.color = draw.color;
    facts.pointSize = draw.raster.pointSize;
    return facts;
}

void FrameDrawer::setBuiltins(const BuiltProgram& built, const DrawFacts& facts) {
    for (std::size_t i = 0; i < built.interface.uniforms.size(); ++i)
        if (const glsl::BuiltinUniform* row = plan::suppliedBy(built.interface.uniforms[i]))
            gpu::setUniform(*built.program, built.interface.uniforms[i],
                            suppliedValue(row->value, facts, built.interface.uniforms[i].arraySize).span());
}

void FrameDrawer::setSupplied(plan::PlannedProgramIndex program, const BuiltProgram& built,
                              const DrawFacts& facts) {
    for (const plan::UniformBinding& binding : plan_.programs[program].values) {
        const auto* supplied = std::get_if<plan::Supplied>(&binding.value);
        if (!supplied) continue;
        const base::ActiveUniform& uniform = at(built.interface.uniforms, binding.uniform);
        gpu::setUniform(*built.program, uniform,
                        suppliedValue(supplied->value, facts, uniform.arraySize).span());
    }
}

void FrameDrawer::setTile(const BuiltProgram& built, const base::FractionRectangle& viewport, bool isWindow) {
    // These names are the translator's; programs that are not made for tiles lack these uniforms.
    const Tile& part = isWindow ? frame_->tile : texture_;
    const glm::dvec2& shift = isWindow ? shift_ : textureShift_;
    const gpu::PixelRectangle port = gpu::pixelsOf(viewport, isWindow ? frame_->width : part.width,
                                                   isWindow ? frame_->height : part.height);
    for (const base::ActiveUniform& uniform : built.interface.uniforms) {
        if (uniform.emittedName == "glibra_Tile") {
            const double width = part.width, height = part.height;
            gpu::setUniform(*built.program, uniform,
                            std::array{port.width / width, port.height / height,
                                       (port.width - 2.0 * (part.x - port.x - shift.x) - width) / width,
                                       (port.height - 2.0 * (part.y - port.y - shift.y) - height) / height});
        } else if (uniform.emittedName == "glibra_TileOrigin") {
            gpu::setUniform(*built.program, uniform, std::array{part.x - shift.x, part.y - shift.y});
        }
    }
}

void FrameDrawer::setConstantInputs(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                    const glm::dvec4& color) const {
    const DeviceMesh& mesh = *device_.deviceMesh(plan_, planned.mesh);
    const auto isInMesh = [&](const std::string& name) {
        return std::any_of(mesh.attributes.begin(), mesh.attributes.end(),
                           [&](const DeviceMesh::Attribute& each) { return each.name == name; });
    };
    const std::vector<plan::InputSource>& sources = device_.inputSources(plan_, planned.inputs, built);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const base::ActiveInput& input = built.interface.inputs[i];
        if (input.location < 0) continue;
        std::array<double, 4> value{0, 0, 0, 1};
        if (const auto* name = std::get_if<std::string>(&sources[i].from)) {
            if (isInMesh(*name)) continue;
            if (*name == geometry::kColor) value = {color.r, color.g, color.b, color.a};
        } else if (const auto* numbers = std::get_if<std::array<double, 4>>(&sources[i].from)) {
            value = *numbers;
        } else {
            continue;
        }
        gpu::setConstantAttribute(static_cast<GLuint>(input.location), input.type, value);
    }
}

void FrameDrawer::bindTextures(const std::vector<plan::TextureUse>& textures, const BuiltProgram& built) {
    // The units are in rising order. Below GL 4.3 binding a part of a texture may replace what is on unit 0,
    // so that one comes last.
    for (auto each = textures.rbegin(); each != textures.rend(); ++each) {
        const plan::TextureUse& use = *each;
        device_.bind(use);
        const std::array<double, 1> unit{static_cast<double>(use.driverUnit)};
        gpu::setUniform(*built.program, at(built.interface.uniforms, use.uniform), unit, use.element);
    }
}

void FrameDrawer::bindBlocks(plan::PlannedProgramIndex program, const BuiltProgram& built) const {
    const std::vector<gpu::Buffer>& blocks = states_[program].blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (blocks[i].size() > 0) blocks[i].bindBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(i));
    for (const plan::BlockUse& each : plan_.programs[program].blocks) {
        const gpu::Buffer* buffer = device_.buffers().buffer(each.buffer);
        if (!buffer) continue;
        const auto index = static_cast<GLuint>(each.index);
        switch (each.kind) {
            case plan::BlockUse::Kind::uniform:
                buffer->bindBase(GL_UNIFORM_BUFFER, index);
                break;
            case plan::BlockUse::Kind::storage:
                buffer->bindBase(GL_SHADER_STORAGE_BUFFER, index);
                break;
            case plan::BlockUse::Kind::counters:
                buffer->bindBase(GL_ATOMIC_COUNTER_BUFFER,
                                 static_cast<GLuint>(built.interface.counterBuffers.at(each.index).binding));
                break;
        }
    }
}

void FrameDrawer::setTessellationLevels(const std::array<float, 6>& levels) {
    if (levels_ == levels) return;
    levels_ = levels;
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels.data());
    glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels.data() + 4);
}

void FrameDrawer::fitToTile(scene::RasterState& raster, const BuiltProgram& built, bool isWindow) const {
    const base::FractionRectangle all;
    if (raster.viewport == all && !raster.scissor) return;
    const Tile whole{0, 0, isWindow ? frame_->width : texture_.width,
                     isWindow ? frame_->height : texture_.height};
    const Tile& part = isWindow ? frame_->tile : texture_;
    const bool isTiled = std::any_of(built.interface.uniforms.begin(), built.interface.uniforms.end(),
                                     [](const auto& each) { return each.emittedName == "glibra_Tile"; });
    if (!isTiled) return;
    // setSupplied() maps the viewport to the tile; what GL would clip at its edges is cut off here.
    const auto shown = [&](const base::FractionRectangle& fraction) {
        const gpu::PixelRectangle pixels = gpu::pixelsOf(fraction, whole.width, whole.height);
        return base::FractionRectangle{static_cast<double>(pixels.x - part.x) / part.width,
                                       static_cast<double>(pixels.y - part.y) / part.height,
                                       static_cast<double>(pixels.width) / part.width,
                                       static_cast<double>(pixels.height) / part.height};
    };
    if (raster.scissor) raster.scissor = shown(*raster.scissor);
    if (raster.viewport == all) return;
    const base::FractionRectangle port = shown(raster.viewport);
    if (raster.scissor) {
        const double left = std::max(port.x, raster.scissor->x);
        const double bottom = std::max(port.y, raster.scissor->y);
        const double right = std::min(port.x + port.width, raster.scissor->x + raster.scissor->width);
        const double top = std::min(port.y + port.height, raster.scissor->y + raster.scissor->height);
        raster.scissor = {left, bottom, std::max(0., right - left), std::max(0., top - bottom)};
    } else {
        raster.scissor = port;
    }
    raster.viewport = all;
}

void FrameDrawer::setRaster(const plan::PlannedDraw& planned, const BuiltProgram& built, bool isWindow,
                            Diagnostics& diagnostics) {
    scene::RasterState raster = plan_.drawOf(planned).raster;
    if (!blendsOpaque_ && built.interface.facts.isOpaque)
        for (base::Blend& each : raster.blend)
            if (each == base::kBlendOver) each.isOn = false;
    const gpu::Capabilities& capabilities = context_.capabilities();
    const double widest = capabilities.wideLines ? capabilities.maxLineWidth : 1;
    if (raster.lineWidth > widest && !lineWidthReported_) {
        lineWidthReported_ = true;
        diagnostics.push_back(
            diagnose("draw-W04", fmt::format("LineWidth {:g} limited to {:g}", raster.lineWidth, widest),
                     plan_.drawOf(planned).place));
    }
    raster.pointSizeFromShader = raster.pointSizeFromShader && built.interface.facts.writesPointSize;
    fitToTile(raster, built, isWindow);
    if (wireframe_) raster.polygon = base::PolygonMode::line;
    raster_.apply(raster);

    const int distances = built.interface.facts.clipDistances;
    const int before = clipDistances_.value_or(0);
    // Earlier drawing may have left any of them enabled.
    const int after = clipDistances_.value_or(capabilities.maxClipDistances);
    for (int i = before; i < distances; ++i) glEnable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    for (int i = distances; i < after; ++i) glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    clipDistances_ = distances;
    if (planned.submission.topology == geometry::Topology::patches &&
        patchVertices_ != planned.submission.patchVertices) {
        patchVertices_ = planned.submission.patchVertices;
        glPatchParameteri(GL_PATCH_VERTICES, planned.submission.patchVertices);
    }
    if (planned.submission.topology == geometry::Topology::patches) {
        std::array<float, 6> levels = kOneLevel;
        if (const auto& given = plan_.drawOf(planned).tessellationLevels)
            std::transform(given->begin(), given->end(), levels.begin(),
                           [](double each) { return static_cast<float>(each); });
        setTessellationLevels(levels);
    }
}

bool FrameDrawer::isOutOfTile(const plan::PlannedDraw& planned, const BuiltProgram& built,
                              const gpu::Target& target, bool isWindow) const {
    const scene::Draw& draw = plan_.drawOf(planned);
    const VertexBox* bounds = windowSamples_ > 0 ? device_.knownBounds(draw.shape) : nullptr;
    if (!bounds || !isPlacedByMatrices(draw) ||
        plan::writesMemory(plan_.programs[planned.program], planned.textures))
        return false;
    const Screen window{frame_->width, frame_->height, frame_->tile, windowSamples_,
                        shift_ != glm::dvec2(0.0)};
    const Screen texture{target.width(), target.height(), {0, 0, target.width(), target.height()}, 1, false};
    DrawView drawView = drawViewOf(draw, planned.submission.topology, isAsWindow_ ? frame_->view : passView_,
                                   isWindow ? window : texture, context_.capabilities());
    if (wireframe_ && drawView.filled) {
        drawView.filled = false;
        drawView.reach = draw.raster.lineWidth / 2 + 1;
    }
    return sightOf(placed(*bounds, built.interface.facts.placement), drawView) != Sight::possible;
}

const BuiltProgram* FrameDrawer::ownProgramOf(const plan::PlannedDraw& planned) const {
    const BuiltProgram* own = programs_.find(plan_.programs[planned.program].variant);
    return own != nullptr && own->program ? own : nullptr;
}

const BuiltProgram* FrameDrawer::programOf(const plan::PlannedDraw& planned) const {
    if (const BuiltProgram* own = ownProgramOf(planned)) return own;
    return fallback_ != nullptr && fallback_->program ? fallback_ : nullptr;
}

void FrameDrawer::submit(const plan::PlannedDraw& planned) const {
    const DeviceMesh& mesh = *device_.deviceMesh(plan_, planned.mesh);
    const scene::Draw& draw = plan_.drawOf(planned);
    const GLenum mode = glMode(planned.submission);
    if (draw.instancesFrom.buffer || draw.verticesFrom.buffer) return submitIndirect(planned, mesh, mode);
    if (draw.instances <= 0) return;
    const auto drawPart = [&](int first, int count) {
        // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset into the buffer that is bound
        const auto* at = reinterpret_cast<const void*>(static_cast<std::size_t>(first) * sizeof(GLuint));
        if (draw.instances == 1 && mesh.indices)
            glDrawElements(mode, count, GL_UNSIGNED_INT, at);
        else if (draw.instances == 1)
            glDrawArrays(mode, first, count);
        else if (mesh.indices)
            glDrawElementsInstanced(mode, count, GL_UNSIGNED_INT, at, draw.instances);
        else
            glDrawArraysInstanced(mode, first, count, draw.instances);
    };
    // gl_VertexID and the order of instances are those of one draw.
    const bool isWhole = !mesh.indices || draw.instances != 1;
    if (mode != GL_PATCHES || isWhole) return drawPart(0, mesh.indexCount);
    drawPatches(context_.capabilities(), programOf(planned)->interface.facts,
                planned.submission.patchVertices, mesh.indexCount, drawPart);
}

void FrameDrawer::submitIndirect(const plan::PlannedDraw& planned, const DeviceMesh& mesh,
                                 GLenum mode) const {
    const scene::Draw& draw = plan_.drawOf(planned);
    // count, instances, first index or vertex, base vertex, base instance (OpenGL 4.6 Core, 10.4)
    const std::array<GLuint, 5> command{static_cast<GLuint>(mesh.indexCount),
                                        static_cast<GLuint>(std::max(0, draw.instances)), 0, 0, 0};
    const std::span<const std::byte> bytes = std::as_bytes(std::span(command));
    if (!command_) {
        Result<gpu::Buffer> made = gpu::Buffer::create(bytes, GL_DYNAMIC_DRAW);
        if (!made) return;
        command_ = std::move(*made);
    }
    command_->update(0, bytes);
    const auto take = [&](const scene::BufferView& from, std::size_t at) {
        if (const gpu::Buffer* buffer = from.buffer ? device_.buffers().buffer(from) : nullptr)
            command_->copyFrom(*buffer, 0, at, sizeof(GLuint));
    };
    take(draw.verticesFrom, 0);
    take(draw.instancesFrom, sizeof(GLuint));
    command_->bind(GL_DRAW_INDIRECT_BUFFER);
    if (mesh.indices)
        glDrawElementsIndirect(mode, GL_UNSIGNED_INT, nullptr);
    else
        glDrawArraysIndirect(mode, nullptr);
}

void FrameDrawer::finishWrites(plan::PlannedProgramIndex program,
                               const std::vector<plan::TextureUse>& textures) {
    if (!plan::writesMemory(plan_.programs[program], textures)) return;
    gpu::finishShaderWrites();
    for (const plan::TextureUse& each : textures)
        if (each.isImage && each.view.texture) device_.wasWritten(each.view.texture);
}

Diagnostics FrameDrawer::drawOne(const plan::PlannedDraw& planned, const gpu::Target& target, bool isWindow) {
    Diagnostics diagnostics;
    const DeviceMesh* mesh = device_.deviceMesh(plan_, planned.mesh);
    if (!mesh) return diagnostics;
    const scene::Draw& draw = plan_.drawOf(planned);
    const BuiltProgram* drawnWith = programOf(planned);
    if (drawnWith == nullptr) return diagnostics;
    const BuiltProgram& built = *drawnWith;
    const bool isUsable = ownProgramOf(planned) != nullptr;
    if (isUsable && isOutOfTile(planned, built, target, isWindow)) {
        stats_.add(kDrawsOutOfTheirTile, 1);
        return diagnostics;
    }
    context_.debugLog().setPlace(draw.place);
    built.program->use();
    const double aspect = isWindow ? static_cast<double>(frame_->width) / frame_->height
                                   : static_cast<double>(target.width()) / target.height();
    // A supplied vertex stage uses no matrices, so those are free for the fragment stage.
    const auto* covering =
        built.interface.facts.suppliesVertexStage ? std::get_if<scene::ClipSpace>(&draw.projection) : nullptr;
    const std::optional<scene::Draw> seen =
        covering != nullptr ? std::optional(seenBy(*covering, draw)) : std::nullopt;
    const scene::Draw& placed = seen ? *seen : draw;
    DrawFacts facts = factsOf(placed, aspect);
    if (isUsable) {
        setLiterals(planned.program, built);
        if (!plan_.programs[planned.program].foundByName.empty()) {
            const ViewMatrices& view = isAsWindow_ ? frame_->view : passView_;
            facts.model = view.model(placed);
            facts.view = view.view(placed);
        }
        setSupplied(planned.program, built, facts);
        setTile(built, draw.raster.viewport, isWindow);
    } else {
        facts.color = kMagenta;
        setBuiltins(built, facts);
    }
    if (isUsable) bindBlocks(planned.program, built);
    setConstantInputs(planned, built, facts.color);
    bindTextures(planned.textures, built);
    setRaster(planned, built, isWindow, diagnostics);
    device_.vertexArray(plan_, planned.mesh, planned.inputs, built).bind();
    if (hook_) hook_(planned, isWindow, true);
    submit(planned);
    if (hook_) {
        hook_(planned, isWindow, false);
        forgetState();
    }
    finishWrites(planned.program, planned.textures);
    stats_.add("draws", 1);
    stats_.add("vertices drawn", static_cast<std::uint64_t>(mesh->indexCount) *
                                     static_cast<std::uint64_t>(std::max(0, draw.instances)));
    return diagnostics;
}

}  // namespace glibra::render
