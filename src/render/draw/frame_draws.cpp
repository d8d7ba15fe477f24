// One draw: its state and its GL calls.

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "base/text.h"
#include "gpu/object/program.h"
#include "gpu/object/uniform.h"
#include "plan/accesses.h"
#include "render/draw/frame.h"
#include "render/draw/sight.h"
#include "render/load/gl_names.h"
#include "scene/nodes.h"

namespace glibra::render {
namespace {

/// The colour of draws whose program failed.
constexpr glm::dvec4 kMagenta{1, 0, 1, 1};

/// The draw with the matrices of the camera instead of the clip space.
scene::Draw seenBy(const scene::ClipSpace& space, scene::Draw draw) {
    draw.modelView = space.view;
    draw.model = glm::dmat4(1);
    std::visit([&](const auto& projection) { draw.projection = projection; }, space.projection);
    return draw;
}

DrawFacts factsOf(const scene::Draw& draw, const PassInProgress& pass) {
    DrawFacts facts;
    facts.projection = pass.view.projection(draw, pass.aspect());
    facts.modelView = pass.view.modelView(draw);
    facts.texture = pass.frame.view.texture();
    facts.timer = timerAt(pass.frame.time, draw.timerPeriod);
    facts.color = draw.color;
    facts.pointSize = draw.raster->pointSize;
    return facts;
}

/// Maps the viewport of a draw to the part of its target that is drawn.
void setTile(const BuiltProgram& built, const base::FractionRectangle& viewport, const PassInProgress& pass) {
    // These names are the translator's; programs that are not made for tiles lack these uniforms.
    const Tile& part = pass.part;
    const glm::dvec2& shift = pass.shift;
    const gpu::PixelRectangle port = gpu::pixelsOf(viewport, pass.width, pass.height);
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

/// Viewport and scissor are fractions of the whole picture. Programs that are made for tiles map the
/// viewport themselves; this leaves the rest to the scissor.
void fitToTile(scene::RasterState& raster, const BuiltProgram& built, const PassInProgress& pass) {
    const base::FractionRectangle all;
    if (raster.viewport == all && !raster.scissor) return;
    const Tile& part = pass.part;
    const bool isTiled = std::ranges::any_of(
        built.interface.uniforms, [](const auto& each) { return each.emittedName == "glibra_Tile"; });
    if (!isTiled) return;
    // setTile() maps the viewport to the tile; what GL would clip at its edges is cut off here.
    const auto shown = [&](const base::FractionRectangle& fraction) {
        const gpu::PixelRectangle pixels = gpu::pixelsOf(fraction, pass.width, pass.height);
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

}  // namespace

/// Of patches without a control stage.
static TessellationLevels levelsOf(const scene::Draw& draw) {
    TessellationLevels levels = kOneLevel;
    if (const auto& given = draw.tessellationLevels)
        std::ranges::transform(*given, levels.begin(), [](double each) { return static_cast<float>(each); });
    return levels;
}

void FrameDrawer::setTessellationLevels(const std::array<float, 6>& levels) {
    if (levels_ == levels) return;
    levels_ = levels;
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels.data());
    glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels.data() + 4);
}

base::RasterState FrameDrawer::setRaster(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                         const PassInProgress& pass, Diagnostics& diagnostics) {
    scene::RasterState raster = *plan_.drawOf(planned).raster;
    if (!blendsOpaque_ && built.interface.facts.isOpaque)
        for (base::Blend& each : raster.blend)
            if (each == base::kBlendOver) each.isOn = false;
    const gpu::Capabilities& capabilities = context_.capabilities();
    const char* lack = capabilities.isEs ? lackOfEs(raster) : nullptr;
    if (capabilities.isEs && lack == nullptr && lacksBorders(planned, built))
        lack = "borders of textures that are not of two dimensions, and of arrays of samplers, are edges";
    if (lack != nullptr && lacks_.insert(lack).second)
        diagnostics.push_back(diagnose("draw-W20", fmt::format("{} in a browser (OpenGL ES)", lack),
                                       plan_.drawOf(planned).place));
    raster.pointSizeFromShader = raster.pointSizeFromShader && built.interface.facts.writesPointSize;
    fitToTile(raster, built, pass);
    if (wireframe_) raster.polygon = base::PolygonMode::line;
    for (std::size_t target = 0; target < planned.unwritten.size(); ++target)
        if (planned.unwritten[target]) raster.write[target] = {false, false, false, false};
    widenLines(planned, built, pass, raster, diagnostics);
    raster_.apply(raster);

    const int distances = built.interface.facts.clipDistances;
    const int before = clipDistances_.value_or(0);
    // Earlier drawing may have left any of them enabled.
    const int after = clipDistances_.value_or(capabilities.maxClipDistances);
    for (int i = before; i < distances; ++i) glEnable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    for (int i = distances; i < after; ++i) glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    clipDistances_ = distances;
    if (planned.submission.topology != geometry::Topology::patches || capabilities.isEs) return raster;
    if (patchVertices_ != planned.submission.patchVertices) {
        patchVertices_ = planned.submission.patchVertices;
        glPatchParameteri(GL_PATCH_VERTICES, planned.submission.patchVertices);
    }
    setTessellationLevels(levelsOf(plan_.drawOf(planned)));
    return raster;
}

const char* FrameDrawer::lackOfEs(const base::RasterState& raster) const {
    if (raster.polygon == base::PolygonMode::line && raster.cull != base::Cull::off)
        return "the edges of triangles are not culled";
    if (raster.polygon == base::PolygonMode::point) return "triangles are filled, not drawn as points";
    if (raster.provoking == base::ProvokingVertex::first) return "flat inputs are those of the last vertex";
    if (raster.sampleShading > 0) return "the fragment stage runs once for each pixel, not for each sample";
    if (raster.depthClamp && !context_.capabilities().hasExtension("GL_EXT_depth_clamp"))
        return "what lies in front of the near plane or behind the far plane is cut off";
    return nullptr;
}

bool FrameDrawer::isOutOfTile(const plan::PlannedDraw& planned, const BuiltProgram& built,
                              const PassInProgress& pass) const {
    const scene::Draw& draw = plan_.drawOf(planned);
    const VertexBox* bounds = windowSamples_ > 0 ? device_.meshes().knownBounds(draw.shape) : nullptr;
    const DeviceMesh* mesh = device_.meshes().onDevice(plan_, planned.mesh);
    // Points reach further than the primitives that the draw view knows.
    if (!bounds || !isPlacedByMatrices(draw) || (mesh != nullptr && mesh->pointCount > 0) ||
        plan::writesMemory(plan_.programs[planned.program], planned.textures))
        return false;
    const bool isWindow = pass.pass.isWindow;
    const Screen screen{pass.width, pass.height, pass.part, isWindow ? windowSamples_ : 1,
                        isWindow && shift_ != glm::dvec2(0.0)};
    DrawView drawView =
        drawViewOf(draw, planned.submission.topology, pass.view, screen, context_.capabilities());
    if (wireframe_ && drawView.filled) {
        drawView.filled = false;
        drawView.reach = draw.raster->lineWidth / 2 + 1;
    }
    return sightOf(placed(*bounds, built.interface.facts.knownPlacement()), drawView) != Sight::possible;
}

const BuiltProgram* FrameDrawer::ownProgramOf(const plan::PlannedDraw& planned) const {
    const BuiltProgram* own = programs_.find(plan_.programs[planned.program].variant);
    return own != nullptr && own->program ? own : nullptr;
}

const BuiltProgram* FrameDrawer::programOf(const plan::PlannedDraw& planned) const {
    if (const BuiltProgram* own = ownProgramOf(planned)) return own;
    return fallback_ != nullptr && fallback_->program ? fallback_ : nullptr;
}

FrameDrawer::Elements FrameDrawer::elementsOf(const plan::PlannedDraw& planned) const {
    const scene::Draw& draw = plan_.drawOf(planned);
    const DeviceMesh& mesh = *device_.meshes().onDevice(plan_, planned.mesh);
    const int instances = std::max(0, draw.instances);
    const bool areIndexed = mesh.indices && !plan_.meshes[planned.mesh].isExpanded;
    if (!draw.indices.buffer) return {areIndexed, 0, mesh.indexCount, mesh.pointCount, instances};
    const auto own = device_.indicesOf(draw).value_or(DeviceScene::Indices{});
    const int wanted = draw.drawsAllIndices ? own.count : std::min(own.count, mesh.indexCount);
    return {true, own.offset, wanted, 0, instances};
}

FrameDrawer::Elements FrameDrawer::submittedBy(const plan::PlannedDraw& planned) const {
    const scene::Draw& draw = plan_.drawOf(planned);
    Elements elements = elementsOf(planned);
    if (draw.verticesFrom) elements.count = static_cast<int>(countIn(draw.verticesFrom));
    if (draw.instancesFrom) elements.instances = static_cast<int>(countIn(draw.instancesFrom));
    return elements;
}

std::uint32_t FrameDrawer::countIn(const scene::CountFrom& from, std::uint64_t after) const {
    std::uint32_t count = 0;
    if (const gpu::Buffer* buffer = device_.buffers().buffer(from.buffer))
        buffer->read((from.word + after) * sizeof count, std::as_writable_bytes(std::span(&count, 1)));
    return count;
}

Diagnostics FrameDrawer::checkCounts(const scene::Draw& draw) const {
    Diagnostics diagnostics;
    const auto check = [&](const scene::CountFrom& from, int most, const char* word, const char* things) {
        const std::uint32_t count = from ? countIn(from) : 0;
        if (count > static_cast<std::uint32_t>(most))
            diagnostics.push_back(
                diagnose("memory-E06",
                         fmt::format("{} from a buffer: {} {}; the limit is {}", word,
                                     base::groupedText(count), things, base::groupedText(most)),
                         draw.place));
        return count;
    };
    const std::uint32_t count = check(draw.verticesFrom, scene::kMostVertices, "Vertices", "vertices");
    check(draw.instancesFrom, scene::kMostInstances, "Instances", "instances");
    // Drivers read beyond the end of a buffer of indices, and may crash there.
    const auto indices = device_.indicesOf(draw);
    if (diagnostics.empty() && indices && count > static_cast<std::uint32_t>(indices->count))
        diagnostics.push_back(
            diagnose("memory-E15",
                     fmt::format("Vertices from a buffer: {} indices are more than the {} elements of '{}'",
                                 base::groupedText(count), base::groupedText(indices->count),
                                 device_.nameOfIndices(draw)),
                     draw.place));
    return diagnostics;
}

void FrameDrawer::submit(const plan::PlannedDraw& planned, bool withPoints) const {
    const scene::Draw& draw = plan_.drawOf(planned);
    if (draw.indices.buffer && !device_.indicesOf(draw)) return;
    const Elements elements = elementsOf(planned);
    const GLenum mode = glMode(planned.submission);
    // GL need not restart patches.
    const bool restarts = draw.indices.buffer && mode != GL_PATCHES;
    if (restarts) {
        glEnable(GL_PRIMITIVE_RESTART);
        glPrimitiveRestartIndex(std::numeric_limits<GLuint>::max());
    }
    Elements part = elements;
    part.count -= elements.points;
    const BuiltProgram& built = *programOf(planned);
    if (built.interface.facts.expanded.corners > 0) return submitExpanded(planned, built, part);
    if (built.interface.facts.expanded.numbersPrimitives) numberPrimitives(planned, built);
    if (part.count > 0 || elements.points == 0) submitPart(planned, part, mode);
    // A geometry stage takes lines or points, not both.
    const std::string& geometryInput = built.interface.facts.geometryInput;
    if (withPoints && elements.points > 0 && mode == GL_LINES && geometryInput.empty()) {
        part.offset += static_cast<std::uint64_t>(part.count) * sizeof(GLuint);
        part.count = elements.points;
        submitPart(planned, part, GL_POINTS);
    }
    if (restarts) glDisable(GL_PRIMITIVE_RESTART);
}

void FrameDrawer::numberPrimitives(const plan::PlannedDraw& planned, const BuiltProgram& built) {
    const GLenum mode = glMode(planned.submission);
    const int corners = mode == GL_POINTS ? 1 : mode == GL_LINES ? 2 : 3;
    setOwnUniform(built, "glibra_PerPrimitive", corners);
}

void FrameDrawer::submitPatches(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                const Elements& elements) const {
    const int patches = elements.count / built.interface.facts.expanded.corners;
    PatchDivider::Work work{&planned,
                            patches,
                            0,
                            elements.instances,
                            levelsOf(plan_.drawOf(planned)),
                            drawsEdges(planned),
                            [&] { bindWorkUnit(planned); },
                            quads()};
    // Patches with vertex data are taken in turn, once for each instance.
    const bool isOneByOne = patches > 1 && !built.interface.inputs.empty();
    if (isOneByOne) work.instances = 1;
    for (; work.first < elements.instances; work.first += work.instances)
        patches_.submit(context_.capabilities(), bindings_, built, work);
}

void FrameDrawer::submitExpanded(const plan::PlannedDraw& planned, const BuiltProgram& built,
                                 const Elements& elements) const {
    if (built.interface.facts.expanded.tessellation) return submitPatches(planned, built, elements);
    const int primitives = elements.count / built.interface.facts.expanded.corners;
    for (int i = 0; i < elements.instances; ++i) {
        setOwnUniform(built, "glibra_Instance", i);
        strips_.draw(built, primitives, drawsEdges(planned), quads());
    }
}

void FrameDrawer::submitPart(const plan::PlannedDraw& planned, const Elements& elements, GLenum mode) const {
    const scene::Draw& draw = plan_.drawOf(planned);
    if (draw.instancesFrom || draw.verticesFrom)
        submitIndirect(draw, elements, mode);
    else if (draw.instances > 0)
        submitDirect(planned, elements, mode);
}

void FrameDrawer::submitDirect(const plan::PlannedDraw& planned, const Elements& elements,
                               GLenum mode) const {
    const int instances = plan_.drawOf(planned).instances;
    const auto own = device_.indicesOf(plan_.drawOf(planned));
    const DeviceMesh& mesh = *device_.meshes().onDevice(plan_, planned.mesh);
    const gpu::Buffer* indices = !elements.areIndexed ? nullptr : own ? own->buffer : &*mesh.indices;
    if (wide_ && mode != GL_POINTS &&
        widener_.draw(*wide_, {indices, elements.offset, elements.count, mode, instances}))
        return;
    if (drawsEdges(planned) && (mode == GL_TRIANGLES || mode == GL_TRIANGLE_STRIP || mode == GL_TRIANGLE_FAN))
        return edges_.draw(indices, elements.offset, elements.count, mode, instances);
    const auto drawPart = [&](int first, int count) {
        // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset into the buffer that is bound
        const auto* at =
            reinterpret_cast<const void*>(elements.offset + static_cast<std::size_t>(first) * sizeof(GLuint));
        if (instances == 1 && elements.areIndexed)
            glDrawElements(mode, count, GL_UNSIGNED_INT, at);
        else if (instances == 1)
            glDrawArrays(mode, first, count);
        else if (elements.areIndexed)
            glDrawElementsInstanced(mode, count, GL_UNSIGNED_INT, at, instances);
        else
            glDrawArraysInstanced(mode, first, count, instances);
    };
    // gl_VertexID and the order of instances are those of one draw.
    const bool isWhole = !elements.areIndexed || instances != 1;
    if (mode != GL_PATCHES || isWhole) return drawPart(0, elements.count);
    drawPatches(context_.capabilities(), programOf(planned)->interface.facts,
                planned.submission.patchVertices, elements.count, drawPart);
}

void FrameDrawer::submitIndirect(const scene::Draw& draw, const Elements& elements, GLenum mode) const {
    // count, instances, first index or vertex, base vertex, base instance (OpenGL 4.6 Core, 10.4)
    const std::array<GLuint, 5> command{static_cast<GLuint>(elements.count),
                                        static_cast<GLuint>(elements.instances),
                                        static_cast<GLuint>(elements.offset / sizeof(GLuint)), 0, 0};
    const std::span<const std::byte> bytes = std::as_bytes(std::span(command));
    if (!command_) {
        Result<gpu::Buffer> made = gpu::Buffer::create(bytes, GL_DYNAMIC_DRAW);
        if (!made) return;
        command_ = std::move(*made);
    }
    command_->update(0, bytes);
    const auto take = [&](const scene::CountFrom& from, std::size_t at) {
        if (const gpu::Buffer* buffer = from ? device_.buffers().buffer(from.buffer) : nullptr)
            command_->copyFrom(*buffer, from.word * sizeof(GLuint), at, sizeof(GLuint));
    };
    take(draw.verticesFrom, 0);
    take(draw.instancesFrom, sizeof(GLuint));
    command_->bind(GL_DRAW_INDIRECT_BUFFER);
    if (elements.areIndexed)
        glDrawElementsIndirect(mode, GL_UNSIGNED_INT, nullptr);
    else
        glDrawArraysIndirect(mode, nullptr);
}

bool FrameDrawer::noteStores(plan::PlannedProgramIndex program,
                             const std::vector<plan::TextureUse>& textures) {
    if (!plan::writesMemory(plan_.programs[program], textures)) return false;
    for (const plan::TextureUse& each : textures)
        if (each.isImage && each.view.texture) device_.textures().wasWritten(each.view.texture);
    return true;
}

Diagnostics FrameDrawer::drawOne(const plan::PlannedDraw& planned, const PassInProgress& pass) {
    Diagnostics diagnostics;
    if (!device_.meshes().onDevice(plan_, planned.mesh)) return diagnostics;
    const scene::Draw& draw = plan_.drawOf(planned);
    const bool isWindow = pass.pass.isWindow;
    const BuiltProgram* drawnWith = programOf(planned);
    if (drawnWith == nullptr) return diagnostics;
    const BuiltProgram& built = *drawnWith;
    const bool isUsable = ownProgramOf(planned) != nullptr;
    if (isUsable && isOutOfTile(planned, built, pass)) {
        stats_.add(kDrawsOutOfTheirTile, 1);
        return diagnostics;
    }
    context_.debugLog().setPlace(draw.place);
    if (Diagnostics refused = checkCounts(draw); !refused.empty()) return refused;
    bindings_.use(*built.program);
    // A supplied vertex stage uses no matrices, so those are free for the fragment stage.
    const auto* covering = built.interface.facts.suppliesVertexStage
                               ? std::get_if<scene::ClipSpace>(&*draw.projection)
                               : nullptr;
    const std::optional<scene::Draw> seen =
        covering != nullptr ? std::optional(seenBy(*covering, draw)) : std::nullopt;
    const scene::Draw& placed = seen ? *seen : draw;
    DrawFacts facts = factsOf(placed, pass);
    if (isUsable) {
        setLiterals(planned.program, built);
        if (!plan_.programs[planned.program].foundByName.empty()) {
            facts.model = pass.view.model(placed);
            facts.view = pass.view.view(placed);
        }
        setSupplied(planned.program, built, facts);
        setTile(built, draw.raster->viewport, pass);
    } else {
        facts.color = kMagenta;
        setBuiltins(built, facts);
    }
    if (isUsable) bindBlocks(planned.program, built);
    if (!built.interface.facts.wideLines.captured.empty()) widener_.prepare(built);
    append(diagnostics, setConstantInputs(planned, built, facts.color));
    bindTextures(planned.textures, built);
    const base::RasterState raster = setRaster(planned, built, pass, diagnostics);
    runPerSample(shadesSamples_ && isWindow && isUsable &&
                 plan::paintedEdges(plan_.programs[planned.program], planned.textures) ==
                     plan::PaintedEdges::shown);
    bindings_.bind(device_.vertexArray(plan_, planned, built));
    if (hook_) hook_(planned, isWindow, true);
    if (isUsable && !built.interface.facts.loopSites.empty()) tryLoops(planned, built, pass, raster);
    if (!recordLoops(planned, built, pass.frame, raster)) submitInShares(planned, built);
    wide_.reset();
    append(diagnostics, patches_.takeProblems());
    append(diagnostics, strips_.takeProblems());
    for (Diagnostic& each : widener_.takeProblems()) {
        each.place = draw.place;
        diagnostics.push_back(std::move(each));
    }
    if (hook_) {
        hook_(planned, isWindow, false);
        forgetState();
    }
    if (noteStores(planned.program, planned.textures)) gpu::finishShaderWrites();
    stats_.add("draws", 1);
    stats_.add("vertices drawn", static_cast<std::uint64_t>(elementsOf(planned).count) *
                                     static_cast<std::uint64_t>(std::max(0, draw.instances)));
    return diagnostics;
}

// Lines that are wider than the driver draws them.

bool FrameDrawer::drawsEdges(const plan::PlannedDraw& planned) const {
    return context_.capabilities().isEs &&
           (wireframe_ || plan_.drawOf(planned).raster->polygon == base::PolygonMode::line);
}

bool FrameDrawer::drawsLines(const plan::PlannedDraw& planned, const BuiltProgram& built) const {
    const glsl::ExpandedGeometry& expanded = built.interface.facts.expanded;
    if (expanded.corners > 0)
        return expanded.ofPrimitive == 2 || (expanded.ofPrimitive == 3 && drawsEdges(planned));
    const GLenum mode = glMode(planned.submission);
    return mode == GL_LINES || mode == GL_LINE_STRIP || mode == GL_LINE_LOOP ||
           (mode != GL_POINTS && drawsEdges(planned));
}

void FrameDrawer::widenLines(const plan::PlannedDraw& planned, const BuiltProgram& built,
                             const PassInProgress& pass, base::RasterState& raster,
                             Diagnostics& diagnostics) {
    wide_.reset();
    const gpu::Capabilities& capabilities = context_.capabilities();
    const scene::Draw& draw = plan_.drawOf(planned);
    const double widest = capabilities.widestLine();
    if (raster.lineWidth <= widest || (capabilities.isEs && !drawsLines(planned, built))) return;
    // A hook may draw with a program of its own.
    if (built.interface.facts.wideLines.captured.empty() || hook_ || raster.discard || draw.verticesFrom ||
        draw.instancesFrom) {
        if (!std::exchange(lineWidthReported_, true))
            diagnostics.push_back(
                diagnose("draw-W04", fmt::format("LineWidth {:g} limited to {:g}", raster.lineWidth, widest),
                         draw.place));
        return;
    }
    const gpu::PixelRectangle port =
        gpu::pixelsOf(raster.viewport, pass.target.width(), pass.target.height());
    auto mode = glsl::WideMode::fromMinusW;
    if (raster.depthOrder == base::DepthOrder::reversed && capabilities.clipControl)
        mode = glsl::WideMode::fromZero;
    if (raster.depthClamp && capabilities.hasExtension("GL_EXT_depth_clamp"))
        mode = glsl::WideMode::depthClamped;
    wide_ = LineWidener::Look{.draw = &planned,
                              .built = &built,
                              .viewportWidth = static_cast<double>(port.width),
                              .viewportHeight = static_cast<double>(port.height),
                              .lineWidth = raster.lineWidth,
                              .hasSamples = pass.target.samples() > 1,
                              .mode = mode,
                              .vertices = &device_.vertexArray(plan_, planned, built),
                              .bindAgain = [this, &planned] { bindWorkUnit(planned); }};
    // Lines are in front, are not culled, and have no offset.
    raster.cull = base::Cull::off;
    raster.front = base::Winding::ccw;
    raster.offsetFactor = raster.offsetUnits = 0;
}

QuadDrawer FrameDrawer::quads() const {
    if (!wide_) return {};
    return [this](GLenum mode, int vertices, int instances) {
        return widener_.draw(*wide_, {.count = vertices, .mode = mode, .instances = instances});
    };
}

void FrameDrawer::bindWorkUnit(const plan::PlannedDraw& planned) const {
    for (const plan::TextureUse& each : planned.textures)
        if (each.driverUnit == gpu::kWorkUnit) device_.bind(each, bindings_);
}

}  // namespace glibra::render
