#include "render/draw/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "gpu/object/uniform.h"
#include "plan/uniform_names.h"
#include "render/draw/patch_split.h"
#include "render/draw/sight.h"
#include "render/load/gl_names.h"

namespace glibra::render {
namespace {

/// The colour of draws whose program failed.
constexpr glm::dvec4 kMagenta{1, 0, 1, 1};

std::array<float, 4> asFloats(const glm::dvec4& color) {
    return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b),
            static_cast<float>(color.a)};
}

bool writesImages(const plan::PlannedDraw& planned) {
    return std::any_of(planned.textures.begin(), planned.textures.end(),
                       [](const plan::TextureUse& use) { return use.isImage; });
}

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
            if (!draw || !plan_.passOf(pass).targets.empty()) continue;
            const BuiltProgram* own = ownProgramOf(*draw);
            if (own == nullptr || !own->interface.facts.isOpaque || !reported.insert(draw->program).second)
                continue;
            const glsl::TranslatedProgram& facts = own->interface.facts;
            stats_.skip("blending", fmt::format("'{}': always writes 1 for alpha", facts.name), facts.place);
        }
}

bool FrameDrawer::texturesComeFirst() const {
    bool windowSeen = false;
    for (const plan::PlannedPass& pass : plan_.passes) {
        if (plan_.passOf(pass).targets.empty())
            windowSeen = true;
        else if (windowSeen)
            return false;
    }
    return true;
}

Diagnostics FrameDrawer::draw(const gpu::Target& window, const Frame& frame) {
    frame_ = &frame;
    forgetState();
    Diagnostics diagnostics = drawPasses(window, frame);
    // Others that draw with this context expect the state in which a pass begins.
    raster_.limitTo({});
    raster_.apply({});
    raster_.limitTo(limit_);
    return diagnostics;
}

void FrameDrawer::forgetState() {
    raster_.forget();
    clipDistances_.reset();
    patchVertices_.reset();
}

Diagnostics FrameDrawer::drawPasses(const gpu::Target& window, const Frame& frame) {
    Diagnostics diagnostics;
    std::size_t drawsBefore = 0;  // in the passes before this one
    std::size_t texturePass = 0;
    for (const plan::PlannedPass& pass : plan_.passes) {
        std::size_t drawIndex = drawsBefore;
        drawsBefore += static_cast<std::size_t>(
            std::count_if(pass.steps.begin(), pass.steps.end(),
                          [](const auto& step) { return std::holds_alternative<plan::PlannedDraw>(step); }));
        const bool isWindow = plan_.passOf(pass).targets.empty();
        if (!isWindow && !frame.texturePasses) continue;
        const gpu::Target* target = &window;
        if (!isWindow) {
            Result<const gpu::Target*> made = device_.target(plan_.passOf(pass));
            append(diagnostics, std::move(made.diagnostics));
            if (!made) return diagnostics;
            target = *made;
            texture_ = {0, 0, target->width(), target->height()};
            textureShift_ = texturePass < textureShifts_.size() ? textureShifts_[texturePass] : glm::dvec2(0);
            ++texturePass;
        }
        beginPass(pass, *target);
        for (const auto& step : pass.steps) {
            if (drawIndex >= drawLimit_) break;
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step)) {
                append(diagnostics, drawOne(*draw, *target, isWindow));
                ++drawIndex;
            } else {
                clear(*target, plan_.clearOf(std::get<plan::PlannedClear>(step)), isWindow);
            }
        }
        stats_.add("passes", 1);
    }
    return diagnostics;
}

void FrameDrawer::beginPass(const plan::PlannedPass& pass, const gpu::Target& target) {
    context_.debugLog().setPlace(plan_.passOf(pass).place);
    target.bind();
    raster_.targetBound(target.width(), target.height());
    raster_.openForClears();
    for (std::size_t i = 0; i < plan_.passOf(pass).clearColors.size(); ++i)
        if (const auto& color = plan_.passOf(pass).clearColors[i])
            target.clearColor(static_cast<int>(i),
                              asFloats(clearColor(*color, plan_.passOf(pass).targets.empty())));
    if (plan_.passOf(pass).clearDepth) target.clearDepth();
}

void FrameDrawer::clear(const gpu::Target& target, const scene::Clear& clear, bool isWindow) {
    raster_.openForClears();
    const int colors = target.readable().colorCount();
    for (int i = 0; i < colors; ++i) target.clearColor(i, asFloats(clearColor(clear.color, isWindow)));
    target.clearDepth();
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

bool FrameDrawer::isCurrent(plan::PlannedProgramIndex program, const BuiltProgram& built) const {
    if (built.initialValues.empty()) return true;
    const auto current = current_.find(&built);
    return current != current_.end() && current->second == program;
}

void FrameDrawer::resetUniforms(plan::PlannedProgramIndex program, const BuiltProgram& built) {
    if (built.initialValues.empty()) return;
    current_[&built] = program;
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
    if (state.literalsSet && isCurrent(program, built)) return;
    state.literalsSet = true;
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
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        glUniformBlockBinding(built.program->id(), built.interface.blocks[i].index, static_cast<GLuint>(i));
        if (Result<gpu::Buffer> buffer = gpu::Buffer::create(blocks[i]))
            state.blocks.push_back(std::move(*buffer));
    }
}

DrawFacts FrameDrawer::factsOf(const scene::Draw& draw, double aspect) const {
    DrawFacts facts;
    facts.projection = frame_->view.projection(draw.projection, aspect);
    facts.modelView = frame_->view.modelView(draw);
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

void FrameDrawer::setSupplied(const plan::PlannedDraw& planned, const BuiltProgram& built,
                              const DrawFacts& facts, bool isWindow) {
    for (const plan::UniformBinding& binding : plan_.programs[planned.program].values) {
        const auto* supplied = std::get_if<plan::Supplied>(&binding.value);
        if (!supplied) continue;
        const base::ActiveUniform& uniform = at(built.interface.uniforms, binding.uniform);
        gpu::setUniform(*built.program, uniform,
                        suppliedValue(supplied->value, facts, uniform.arraySize).span());
    }
    // These names are the translator's; programs that are not made for tiles lack these uniforms.
    const Tile& part = isWindow ? frame_->tile : texture_;
    const glm::dvec2& shift = isWindow ? shift_ : textureShift_;
    const double wholeWidth = isWindow ? frame_->width : part.width,
                 wholeHeight = isWindow ? frame_->height : part.height;
    for (const base::ActiveUniform& uniform : built.interface.uniforms) {
        if (uniform.emittedName == "glibra_Tile") {
            const double width = part.width, height = part.height;
            gpu::setUniform(*built.program, uniform,
                            std::array{wholeWidth / width, wholeHeight / height,
                                       (wholeWidth - 2.0 * (part.x - shift.x) - width) / width,
                                       (wholeHeight - 2.0 * (part.y - shift.y) - height) / height});
        } else if (uniform.emittedName == "glibra_TileOrigin") {
            gpu::setUniform(*built.program, uniform, std::array{part.x - shift.x, part.y - shift.y});
        }
    }
}

void FrameDrawer::setConstantInputs(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                    const glm::dvec4& color) const {
    const DeviceMesh& mesh = *device_.deviceMesh(planned.mesh);
    for (const base::ActiveInput& input : built.interface.inputs) {
        if (input.location < 0) continue;
        std::string_view attribute;
        for (const glsl::BuiltinInput& each : glsl::builtinInputs())
            if (each.name == input.name) attribute = each.attribute;
        const bool fed =
            std::any_of(mesh.attributes.begin(), mesh.attributes.end(),
                        [&](const DeviceMesh::Attribute& each) { return each.name == attribute; });
        if (fed) continue;
        std::array<double, 4> value{0, 0, 0, 1};
        if (attribute == geometry::kColor) value = {color.r, color.g, color.b, color.a};
        gpu::setConstantAttribute(static_cast<GLuint>(input.location), input.type, value);
    }
}

void FrameDrawer::bindTextures(const plan::PlannedDraw& planned, const BuiltProgram& built) {
    for (const plan::TextureUse& use : planned.textures) {
        const gpu::Texture* texture = use.texture ? device_.texture(use.texture) : nullptr;
        if (!texture) texture = &device_.emptyTexture(use.target);
        if (use.isImage) {
            glBindImageTexture(static_cast<GLuint>(use.driverUnit), texture->id(), 0, GL_TRUE, 0,
                               GL_READ_WRITE, gpu::internalFormat(texture->format()));
        } else {
            texture->bind(use.driverUnit);
            device_.sampler(use.clamp).bind(use.driverUnit);
        }
        const std::array<double, 1> unit{static_cast<double>(use.driverUnit)};
        gpu::setUniform(*built.program, at(built.interface.uniforms, use.uniform), unit, use.element);
    }
}

void FrameDrawer::setRaster(const plan::PlannedDraw& planned, const BuiltProgram& built,
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
}

bool FrameDrawer::isOutOfTile(const plan::PlannedDraw& planned, const BuiltProgram& built,
                              const gpu::Target& target, bool isWindow) const {
    const VertexBox* bounds = windowSamples_ > 0 ? device_.knownBounds(plan_.drawOf(planned).shape) : nullptr;
    if (!bounds || writesImages(planned)) return false;
    const Screen window{frame_->width, frame_->height, frame_->tile, windowSamples_,
                        shift_ != glm::dvec2(0.0)};
    const Screen texture{target.width(), target.height(), {0, 0, target.width(), target.height()}, 1, false};
    DrawView drawView = drawViewOf(plan_.drawOf(planned), planned.submission.topology, frame_->view,
                                   isWindow ? window : texture, context_.capabilities());
    if (wireframe_ && drawView.filled) {
        drawView.filled = false;
        drawView.reach = plan_.drawOf(planned).raster.lineWidth / 2 + 1;
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
    const DeviceMesh& mesh = *device_.deviceMesh(planned.mesh);
    const GLenum mode = glMode(planned.submission.topology);
    const auto drawPart = [&](int first, int count) {
        glDrawElements(mode, count, GL_UNSIGNED_INT,
                       // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset into the buffer that is bound
                       reinterpret_cast<const void*>(static_cast<std::size_t>(first) * sizeof(GLuint)));
    };
    if (mode != GL_PATCHES) return drawPart(0, mesh.indexCount);
    drawPatches(context_.capabilities(), programOf(planned)->interface.facts,
                planned.submission.patchVertices, mesh.indexCount, drawPart);
}

Diagnostics FrameDrawer::drawOne(const plan::PlannedDraw& planned, const gpu::Target& target, bool isWindow) {
    Diagnostics diagnostics;
    const DeviceMesh* mesh = device_.deviceMesh(planned.mesh);
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
    DrawFacts facts = factsOf(draw, aspect);
    if (isUsable) {
        setLiterals(planned.program, built);
        setSupplied(planned, built, facts, isWindow);
    } else {
        facts.color = kMagenta;
        setBuiltins(built, facts);
    }
    const std::vector<gpu::Buffer>& blocks = states_[planned.program].blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        blocks[i].bindBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(i));
    setConstantInputs(planned, built, facts.color);
    bindTextures(planned, built);
    setRaster(planned, built, diagnostics);
    device_.vertexArray(planned.mesh, planned.program, built).bind();
    if (hook_) hook_(planned, isWindow, true);
    submit(planned);
    if (hook_) {
        hook_(planned, isWindow, false);
        forgetState();
    }
    if (writesImages(planned)) glMemoryBarrier(GL_ALL_BARRIER_BITS);
    stats_.add("draws", 1);
    stats_.add("vertices drawn", static_cast<std::uint64_t>(mesh->indexCount));
    return diagnostics;
}

}  // namespace glibra::render
