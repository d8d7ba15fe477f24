#include "view/debug_view/debug_renderer.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "glsl/types/builtins.h"
#include "scene/view.h"
#include "view/debug_view/bound_target.h"
#include "view/scene/window_target.h"

namespace glibra::view {
namespace {

/// Restores the state that FrameDrawer sets once per frame and a debug view changes.
void restoreState() {
    writeOnly(0);
    glEnable(GL_DEPTH_TEST);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

/// The mesh attribute of an input that only debug programs have; empty for other inputs.
std::string_view debugAttribute(std::string_view input) {
    if (input == kDebugPosition) return geometry::kPosition;
    if (input == kDebugNormal) return geometry::kNormal;
    if (input == kDebugCoordinates) return geometry::kTexCoord;
    return {};
}

/// What feeds the input of that name in the scene's program; null if the plan does not say.
const plan::InputSource* sourceOf(const plan::FramePlan& plan, const plan::PlannedDraw& draw,
                                  const render::BuiltProgram* built, const std::string& input) {
    if (!draw.inputs || built == nullptr) return nullptr;
    const std::vector<plan::InputSource>& sources = plan.inputs[draw.inputs].sources;
    for (std::size_t i = 0; i < sources.size() && i < built->interface.inputs.size(); ++i)
        if (built->interface.inputs[i].name == input) return &sources[i];
    return nullptr;
}

/// The mesh attribute that an input reads, also by a name of its own such as `vertPos`.
std::string_view attributeOf(const plan::InputSource* source, std::string_view input) {
    if (source != nullptr)
        if (const auto* name = std::get_if<std::string>(&source->from)) return *name;
    const glsl::BuiltinInput* row = glsl::findBuiltinInput(input);
    return row ? row->attribute : std::string_view();
}

/// True if indices or attributes come from buffers of the scene. Equal meshes may then have others, and the
/// copies of a buffer with history change their places.
bool readsBuffers(const plan::FramePlan& plan, const plan::PlannedDraw& draw) {
    if (plan.drawOf(draw).indices.buffer) return true;
    if (!draw.inputs) return false;
    const std::vector<plan::InputSource>& sources = plan.inputs[draw.inputs].sources;
    return std::any_of(sources.begin(), sources.end(), [](const plan::InputSource& each) {
        return std::holds_alternative<scene::BufferView>(each.from);
    });
}

}  // namespace

void DebugRenderer::connect(const plan::PlannedDraw& draw, Drawn& made) {
    const render::DeviceMesh* device = scene_.deviceMeshOf(draw);
    if (!device) return;
    const geometry::Mesh* mesh = scene_.meshOf(draw);
    if (mesh && mesh->vertexCount() != device->vertexCount) mesh = nullptr;
    const render::BuiltProgram* built = scene_.drawer().programOf(draw);
    std::vector<gpu::AttributeSource> sources;
    made.buffers.clear();
    made.buffers.reserve(made.program->resources.inputs.size());  // `sources` points to them
    for (const base::ActiveInput& input : made.program->resources.inputs) {
        if (input.location < 0) continue;
        const plan::InputSource* fed = sourceOf(scene_.plan(), draw, built, input.name);
        if (fed != nullptr && std::holds_alternative<scene::BufferView>(fed->from)) {
            if (const auto elements = scene_.device().elementsOf(*fed))
                render::DeviceScene::addBufferSources(*elements, fed->isPerInstance, input, sources);
            continue;
        }
        gpu::AttributeSource source;
        source.location = static_cast<GLuint>(input.location);
        const bool isInteger = input.type.base == base::BaseType::integer;
        for (const render::DeviceMesh::Attribute& each : device->attributes) {
            if (each.name != attributeOf(fed, input.name)) continue;
            const bool asIntegers = isInteger && each.integers;
            source.buffer = asIntegers ? &*each.integers : &each.floats;
            if (asIntegers) source.type = gpu::AttributeSource::Type::integer;
            source.components = each.components;
        }
        const std::string_view own = debugAttribute(input.name);
        const geometry::Attribute* attribute = mesh && !own.empty() ? mesh->attribute(own) : nullptr;
        if (attribute) {
            Result<gpu::Buffer> buffer = gpu::Buffer::create(std::as_bytes(std::span(attribute->values)));
            if (!buffer) continue;
            made.buffers.push_back(std::move(*buffer));
            source.buffer = &made.buffers.back();
            source.components = attribute->components;
        }
        if (source.buffer) sources.push_back(source);
    }
    const auto own = scene_.device().indicesOf(scene_.plan().drawOf(draw));
    made.vertices.emplace(sources, own ? own->buffer : device->indices ? &*device->indices : nullptr);
}

const DebugRenderer::Drawn& DebugRenderer::drawn(const plan::PlannedDraw& draw, DebugView kind,
                                                 DebugStages stages) {
    const auto [entry, isNew] = drawn_.try_emplace({kind, stages, draw.program, draw.mesh});
    Drawn& made = entry->second;
    if (!isNew) {
        if (made.program && readsBuffers(scene_.plan(), draw)) connect(draw, made);
        return made;
    }
    const render::BuiltProgram* built = scene_.drawer().programOf(draw);
    const bool isTriangles = draw.submission.topology == geometry::Topology::triangles ||
                             draw.submission.topology == geometry::Topology::patches;
    if (!built || (stages == DebugStages::normalLines && !isTriangles)) return made;
    made.program = makeDebugProgram(context_, *built, kind, stages);
    if (made.program) connect(draw, made);
    if (!made.program && kind != DebugView::normals && told_.emplace(kind, draw.program).second) {
        const char* why = kind == DebugView::coordinates && hasStagesAfterVertices(*built)
                              ? "its stages pass no vST to the fragment stage"
                              : "the driver cannot link its stages with those of the debug view";
        remarks_.push_back(diagnose("view-W01",
                                    fmt::format("{} is left out of the debug view '{}': {}",
                                                scene_.plan().drawOf(draw).word, nameOf(kind), why),
                                    scene_.plan().drawOf(draw).place));
    }
    return made;
}

/// As FrameDrawer sees the pass of the draw.
render::ViewMatrices DebugRenderer::viewOf(const plan::PlannedDraw& draw) const {
    const scene::NodeList& frame = *scene_.plan().nodes;
    const scene::Pass& pass = frame.passes.at(draw.step.pass);
    if (!render::isMoved(frame, pass)) return scene_.view().unmoved();
    return pass.shift == glm::dmat4(1) ? scene_.view() : scene_.view().shifted(pass.shift);
}

void DebugRenderer::bind(const plan::PlannedDraw& draw, const Drawn& with, const Request& request) {
    const DebugProgram& program = *with.program;
    const scene::Draw& drawn = scene_.plan().drawOf(draw);
    const render::BuiltProgram* built = scene_.drawer().programOf(draw);
    const render::ViewMatrices view = viewOf(draw);
    const double aspect = static_cast<double>(width_) / height_;
    const glm::dmat4 projection = view.projection(drawn, aspect);
    const glm::dmat4 modelView = view.modelView(drawn);
    const glm::dmat4 inverse = scene::inverseOrZero(projection);
    // From the depth to z / w.
    const bool fromZero =
        drawn.raster->depthOrder == base::DepthOrder::reversed && context_.capabilities().clipControl;
    const std::array<double, 2> toClip =
        fromZero ? std::array<double, 2>{1, 0} : std::array<double, 2>{2, -1};
    const glm::dmat4 both = projection * modelView;
    const glm::dmat3 normals = scene::normalMatrix(modelView);
    // The length of the projection's second row is the size in clip space of one unit up in the picture, also
    // if the scene transform rotates it.
    const double up = glm::length(glm::dvec3(projection[0][1], projection[1][1], projection[2][1]));
    const double reach = up > 0 ? request.normalLength / up : 0;
    const std::array<double, 2> size{static_cast<double>(width_), static_cast<double>(height_)};
    program.use(*built);
    program.set("glibra_debugProjection", {glm::value_ptr(projection), 16});
    program.set("glibra_debugProjectionInverse", {glm::value_ptr(inverse), 16});
    program.set("glibra_debugToClip", toClip);
    program.set("glibra_debugModelViewProjection", {glm::value_ptr(both), 16});
    program.set("glibra_debugNormalMatrix", {glm::value_ptr(normals), 9});
    program.set("glibra_debugReach", {&reach, 1});
    program.set("glibra_debugSize", size);
    for (const base::ActiveInput& input : program.resources.inputs) {
        if (input.location < 0) continue;
        const auto location = static_cast<GLuint>(input.location);
        const plan::InputSource* fed = sourceOf(scene_.plan(), draw, built, input.name);
        if (!debugAttribute(input.name).empty())
            gpu::setConstantAttribute(location, input.type, {0, 0, 0, 1});
        else if (attributeOf(fed, input.name) == geometry::kColor)
            gpu::setConstantAttribute(location, input.type,
                                      {drawn.color.r, drawn.color.g, drawn.color.b, drawn.color.a});
    }
    with.vertices->bind();
}

void DebugRenderer::beginNumbers(const plan::PlannedDraw& draw, const Request& request, DebugStages stages) {
    const Drawn& with = drawn(draw, request.kind, stages);
    if (!with.program || !with.vertices) return glDrawBuffer(GL_NONE);
    bind(draw, with, request);
    writeOnly(kDebugOutput);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const bool counts = request.kind == DebugView::overdraw || request.kind == DebugView::layers;
    if (counts) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    } else {
        glDisable(GL_BLEND);
    }
    if (request.kind == DebugView::layers) glDisable(GL_DEPTH_TEST);
}

void DebugRenderer::drawNormals(const plan::PlannedDraw& draw, const Request& request, bool begins) {
    const render::BuiltProgram* built = scene_.drawer().programOf(draw);
    if (!built) return;
    if (stageOf(*built, glsl::Stage::geometry) != nullptr) {
        // A geometry stage of ours cannot follow another one. Colours show where the surfaces face.
        return begins ? beginNumbers(draw, request, DebugStages::flatNormals) : restoreState();
    }
    if (begins) return;
    const Drawn& with = drawn(draw, DebugView::normals, DebugStages::normalLines);
    if (!with.program || !with.vertices) return;
    bind(draw, with, request);
    glDisable(GL_BLEND);
    scene_.drawer().submit(draw);
}

Diagnostics DebugRenderer::show(const gpu::Target& picture, DebugView kind) const {
    const std::vector<std::uint8_t> bytes = colorsOf(kind, numbers_);
    if (bytes.empty()) return {};
    const Result<gpu::Texture> colors =
        gpu::Texture::create(context_.capabilities(), gpu::TextureShape::texture2D, gpu::TexelFormat::rgba8,
                             {numbers_.width, numbers_.height, 1}, {std::as_bytes(std::span(bytes)), 4});
    if (!colors) return colors.diagnostics;
    const std::array<gpu::Attachment, 1> attachment{&*colors};
    const Result<gpu::Framebuffer> source = gpu::Framebuffer::create(attachment);
    if (!source) return source.diagnostics;
    picture.bind();
    source->bindForReading();
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return {};
}

Diagnostics DebugRenderer::draw(const gpu::Target& picture, const ViewState& view, const Request& request) {
    width_ = picture.width();
    height_ = picture.height();
    numbers_ = {};
    render::FrameDrawer& drawer = scene_.drawer();
    Diagnostics diagnostics;
    if (request.kind == DebugView::normals) {
        drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool isWindow, bool begins) {
            if (isWindow) drawNormals(draw, request, begins);
        });
        // Normals of objects outside the picture may reach into it.
        scene_.drawOutOfSight(true);
        append(diagnostics, scene_.draw(picture, view, request.time, request.axes));
        scene_.drawOutOfSight(false);
        drawer.setDrawHook({});
        return diagnostics;
    }
    if (Diagnostics problems =
            fit(target_, context_.capabilities(), scene_.scene(), width_, height_, gpu::TexelFormat::rgba32f);
        !target_)
        return problems;
    ViewState onNothing = view;
    onNothing.background = {0, 0, 0, 0};
    drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool isWindow, bool begins) {
        if (!isWindow) return;
        begins ? beginNumbers(draw, request, DebugStages::numbers) : restoreState();
    });
    append(diagnostics, scene_.draw(*target_, onNothing, request.time, false));
    drawer.setDrawHook({});
    append(diagnostics, std::exchange(remarks_, {}));
    numbers_ = colorTexels(*target_);
    append(diagnostics, show(picture, request.kind));
    return diagnostics;
}

std::string DebugRenderer::drawPass(std::size_t pass, int width, int height, const Request& request) {
    numbers_ = {};
    const scene::Pass& shown = scene_.scene().frame.passes.at(pass);
    const gpu::TextureSize size = sizeOf(scene_, shown, width, height);
    const Result<gpu::Target> window = windowTarget(context_.capabilities(), scene_.scene(), width, height);
    if (!window) return "there is no memory for another picture";
    width_ = size.width;
    height_ = size.height;
    const DebugStages stages =
        request.kind == DebugView::normals ? DebugStages::flatNormals : DebugStages::numbers;
    std::optional<BesideTarget> beside;
    std::string problem;
    GLint bound = 0;
    render::FrameDrawer& drawer = scene_.drawer();
    drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
        if (draw.step.pass != pass || !problem.empty()) return;
        if (!begins) {
            glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
            glEnable(GL_DEPTH_TEST);
            return;
        }
        if (!beside) {
            beside = BesideTarget::make(context_.capabilities(), scene_, shown, size, request.layer);
            if (beside)
                beside->clear();
            else
                problem = "the driver cannot draw this view beside the depth of the pass";
        }
        if (!beside) return;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
        beside->bind(kDebugOutput);
        beginNumbers(draw, request, stages);
    });
    drawer.draw(*window, {scene_.view(), width, height, {0, 0, width, height}, request.time});
    drawer.setDrawHook({});
    remarks_.clear();
    if (!beside) return problem.empty() ? "nothing of this pass is drawn" : problem;
    const render::Content content = beside->read(context_.capabilities());
    numbers_ = {content.width, content.height, {content.values.begin(), content.values.end()}};
    return {};
}

}  // namespace glibra::view
