#include "plan/submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>

#include "base/text.h"
#include "geometry/shapes/clouds.h"
#include "geometry/shapes/primitive.h"
#include "glib/statement_table.h"
#include "plan/uniform_names.h"
#include "scene/primitives.h"

namespace glibra::plan {
namespace {

using geometry::Topology;
using glib::CommandId;

constexpr int kObjPatchVertices = 3;

/// The command that draws this model or shape as lines or as triangles; empty if there is none.
std::string_view counterpartOf(CommandId command, Topology wanted) {
    if (const geometry::PrimitiveSpec* spec = glib::primitiveOf(command)) {
        if (spec->twin != nullptr && spec->twin->topology == wanted) return spec->twin->names[0];
        return {};
    }
    const bool isModel =
        command == CommandId::obj || command == CommandId::objAdj || command == CommandId::objPatch;
    if (wanted == Topology::lines && isModel) return glib::nameOf(CommandId::wireObj);
    if (wanted == Topology::triangles && (command == CommandId::wireObj || isModel))
        return command == CommandId::obj ? std::string_view() : glib::nameOf(CommandId::obj);
    return {};
}

/// Returns "; use WireSphere" if there is an obvious command that delivers the wanted kind.
std::string recommendation(CommandId command, std::string_view wanted) {
    if (command == CommandId::vertices)
        return fmt::format("; use {} {}", glib::nameOf(CommandId::vertices), wanted);
    std::string_view other;
    if (wanted == wordOf(Topology::trianglesAdjacency)) other = counterpartOf(command, Topology::triangles);
    if (wanted == wordOf(Topology::linesAdjacency)) other = glib::nameOf(CommandId::linesAdjacency);
    if (wanted == wordOf(Topology::points)) other = geometry::kPointCloudRow.names[0];
    for (const Topology each : {Topology::lines, Topology::triangles})
        if (wanted == wordOf(each)) other = counterpartOf(command, each);
    return other.empty() ? std::string() : fmt::format("; use {}", other);
}

/// Vertices of the patches that a tessellation stage gets of the draw.
int patchVerticesOf(const scene::Shape& shape, const scene::Draw& draw) {
    const Topology topology = topologyOf(shape);
    if (topology != Topology::patches) return geometry::verticesPerPrimitive(topology);
    if (shape.list != nullptr && shape.list->patchVertices > 0) return shape.list->patchVertices;
    return shape.command == CommandId::objPatch ? kObjPatchVertices : draw.patchVertices;
}

/// Returns how a draw with a TessEvaluation stage is submitted, or draw-E03.
Result<Submission> asPatches(const scene::Shape& shape, const scene::Draw& draw,
                             const ProgramInterface& interface) {
    const Topology topology = topologyOf(shape);
    if (topology == Topology::patches) return Submission{topology, patchVerticesOf(shape, draw)};
    const int wanted = geometry::verticesPerPrimitive(topology);
    const bool controlFits = topology == Topology::triangles && interface.facts.patchVertices == wanted;
    if (draw.patchVertices != wanted && !controlFits)
        return diagnose("draw-E03",
                        fmt::format("{} delivers {}, but the patch size is {}; write 'NumPatchVertices {}'",
                                    draw.word, wordOf(topology), draw.patchVertices, wanted),
                        draw.place);
    return Submission{Topology::patches, wanted};
}

/// Returns draw-W17 if the first tessellation stage reads vertices that the patches do not have.
Diagnostics patchProblems(const scene::Shape& shape, const scene::Draw& draw, const scene::Program& program,
                          const ProgramInterface& interface, int patchVertices) {
    const glsl::TranslatedProgram& facts = interface.facts;
    if (facts.patchVerticesRead <= patchVertices) return {};
    const char* stage = program.hasStage(glsl::Stage::tessControl) ? "control stage" : "evaluation stage";
    const bool isOwn = facts.patchRead.ends_with("[gl_InvocationID]");
    const std::string reads =
        isOwn ? fmt::format("{} has {} vertices and reads {}", stage, facts.patchVertices, facts.patchRead)
              : fmt::format("{} reads {}", stage, facts.patchRead);
    const bool isList = shape.list != nullptr;
    const bool isSized = topologyOf(shape) == Topology::patches && !isList;
    return {diagnose(
        "draw-W17",
        fmt::format("{}: a patch has {}, but the {} ({}:{}){}", draw.word,
                    base::counted(patchVertices, "vertex", "vertices"), reads,
                    facts.patchReadPlace.file.substr(facts.patchReadPlace.file.find_last_of("/\\") + 1),
                    facts.patchReadPlace.line,
                    isSized ? fmt::format("; write 'NumPatchVertices {}'", facts.patchVerticesRead)
                            : std::string("; such a vertex has no value")),
        draw.place)};
}

bool isAdjacency(Topology topology) {
    return topology == Topology::trianglesAdjacency || topology == Topology::linesAdjacency;
}

}  // namespace

std::string_view wordOf(Topology topology) {
    constexpr std::array<std::string_view, 6> kWords{
        "points", "lines", "lines_adjacency", "triangles", "triangles_adjacency", "patches"};
    return kWords.at(static_cast<std::size_t>(topology));
}

std::string stageFileName(const scene::Scene& scene, const scene::Program& program, glsl::Stage stage) {
    for (const scene::StageFile& each : program.stages) {
        if (each.stage != stage || !each.file) continue;
        const std::string& name = scene.files[each.file].name;
        return name.substr(name.find_last_of("/\\") + 1);
    }
    return {};
}

Result<Submission> submissionOf(const scene::Scene& scene, const scene::Draw& draw,
                                const scene::Program* program, const ProgramInterface& interface) {
    const scene::Shape& shape = scene.shapes[draw.shape];
    const Topology topology = topologyOf(shape);
    const bool isTessellated =
        program != nullptr && program->hasStage(glsl::Stage::tessEvaluation, draw.isFill);
    const std::string& word = draw.word;

    Submission submission{topology, 0, shape.strip};
    Diagnostics remarks;
    if (shape.strip && isTessellated)
        return diagnose(
            "draw-E03",
            fmt::format("{}: strips, fans and loops cannot be tessellated; write 'Vertices patches'", word),
            draw.place);
    std::string_view delivered = wordOf(topology);
    if (isTessellated) {
        const Result<Submission> patches = asPatches(shape, draw, interface);
        if (!patches) return patches;
        submission = *patches;
        remarks = patchProblems(shape, draw, *program, interface, submission.patchVertices);
        delivered = interface.facts.tessellationOutput;
    } else if (topology == Topology::patches) {
        return diagnose("draw-E04",
                        fmt::format("{} needs a TessEvaluation stage",
                                    shape.command == CommandId::glBegin ? "gl_patches" : word),
                        draw.place);
    }

    const std::string& wanted = interface.facts.geometryInput;
    for (const Topology each : {Topology::trianglesAdjacency, Topology::linesAdjacency})
        if (topology == Topology::triangles && !isTessellated && !shape.bare && wanted == wordOf(each)) {
            submission.topology = each;
            delivered = wanted;
        }
    if (program != nullptr && !wanted.empty() && !delivered.empty() && wanted != delivered) {
        const std::string file = stageFileName(scene, *program, glsl::Stage::geometry);
        return diagnose("draw-E02",
                        fmt::format("{} delivers {}{}, but {} expects {}{}", word, delivered,
                                    isTessellated ? " after tessellation" : "",
                                    file.empty() ? "the geometry stage" : file, wanted,
                                    isTessellated ? "" : recommendation(shape.command, wanted)),
                        draw.place);
    }
    return {submission, std::move(remarks)};
}

std::optional<Topology> addedAdjacency(const scene::Shape& shape, Topology submitted) {
    if (topologyOf(shape) != Topology::triangles || !isAdjacency(submitted)) return std::nullopt;
    return submitted;
}

bool ignoresPointSize(const scene::Draw& draw, const scene::Program* program,
                      const ProgramInterface& interface, const Submission& submission) {
    if (program == nullptr || draw.raster->pointSizeFromShader || !interface.facts.writesPointSize)
        return false;
    const std::string_view points = wordOf(Topology::points);
    if (program->hasStage(glsl::Stage::geometry, draw.isFill))
        return interface.facts.geometryOutput == points;
    if (program->hasStage(glsl::Stage::tessEvaluation, draw.isFill))
        return interface.facts.tessellationOutput == points;
    return submission.topology == Topology::points;
}

glsl::DrawForms drawFormsOf(const scene::Scene& scene, scene::ProgramIndex program, double widestLine) {
    glsl::DrawForms forms;
    std::set<int> sizes;
    const auto look = [&](const scene::NodeList& nodes) {
        nodes.visitDraws([&](const scene::Draw& draw, const auto&) {
            if (draw.program != program) return;
            const scene::Shape& shape = scene.shapes[draw.shape];
            forms.areStrips = forms.areStrips || shape.strip;
            forms.haveIndexBuffers = forms.haveIndexBuffers || draw.indices.buffer;
            forms.haveWideLines = forms.haveWideLines || draw.raster->lineWidth > widestLine;
            if (draw.attributes)
                for (const scene::AttributeBinding& each : scene.attributeSets[draw.attributes].bindings) {
                    forms.haveInstanceData = forms.haveInstanceData || each.isPerInstance;
                    forms.haveBufferData =
                        forms.haveBufferData || std::holds_alternative<scene::BufferView>(each.source);
                }
            sizes.insert(patchVerticesOf(shape, draw));
        });
    };
    look(scene.frame);
    for (const scene::OnceBlock& each : scene.once) look(each.nodes);
    for (const scene::StepBlock& each : scene.steps) look(each.nodes);
    if (!sizes.empty()) forms.patchVertices = sizes.size() > 1 ? 0 : *sizes.begin();
    return forms;
}

// ---- Inputs

namespace {

constexpr std::array<std::string_view, 6> kAttributes{geometry::kPosition, geometry::kNormal,
                                                      geometry::kTexCoord, geometry::kTangent,
                                                      geometry::kColor,    geometry::kFaceIndex};

/// The binding of that name that counts: the last one.
const scene::AttributeBinding* bindingOf(const scene::Scene& scene, scene::AttributeSetIndex attributes,
                                         const std::string& name) {
    if (!attributes) return nullptr;
    const std::vector<scene::AttributeBinding>& bindings = scene.attributeSets[attributes].bindings;
    const auto found = std::find_if(bindings.rbegin(), bindings.rend(),
                                    [&](const scene::AttributeBinding& each) { return each.name == name; });
    return found == bindings.rend() ? nullptr : &*found;
}

InputSource given(const scene::AttributeBinding& binding) {
    InputSource source;
    source.isPerInstance = binding.isPerInstance;
    source.part = binding.part;
    if (const auto* role = std::get_if<std::string>(&binding.source)) {
        source.from = *role;
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&binding.source)) {
        std::array<double, 4> value{0, 0, 0, 1};
        std::copy_n(numbers->begin(), std::min(numbers->size(), value.size()), value.begin());
        source.from = value;
    } else {
        source.from = std::get<scene::BufferView>(binding.source);
    }
    return source;
}

bool isModel(glib::CommandId command) {
    using glib::CommandId;
    return command == CommandId::obj || command == CommandId::wireObj || command == CommandId::objAdj ||
           command == CommandId::objPatch;
}

}  // namespace

std::string userNameOf(const ProgramInterface& interface, const std::string& name) {
    const auto found = interface.facts.userNames.find(name);
    return found != interface.facts.userNames.end() ? found->second : name;
}

std::vector<InputSource> inputSources(const scene::Scene& scene, scene::AttributeSetIndex attributes,
                                      const ProgramInterface& interface) {
    std::vector<InputSource> sources;
    sources.reserve(interface.inputs.size());
    for (const ActiveInput& input : interface.inputs) {
        InputSource source;
        const std::string name = userNameOf(interface, input.name);
        if (const scene::AttributeBinding* binding = bindingOf(scene, attributes, name)) {
            source = given(*binding);
        } else if (const auto attribute = attributeOfInput(input, scene.suppliesNames)) {
            source.from = std::string(*attribute);
        } else {
            source.from = name;
            source.isKnown = false;
        }
        sources.push_back(std::move(source));
    }
    return sources;
}

std::vector<std::string> attributesOf(const scene::Shape& shape) {
    std::vector<std::string> names;
    if (shape.bare) return names;
    for (const std::string_view each : kAttributes) {
        bool isCarried = each != geometry::kColor || isModel(shape.command);
        if (each == geometry::kFaceIndex) {
            const geometry::PrimitiveSpec* spec = glib::primitiveOf(shape.command);
            isCarried = spec != nullptr && spec->hasFaceIndex;
        }
        if (shape.list != nullptr) isCarried = shape.list->attribute(each) != nullptr;
        if (isCarried) names.emplace_back(each);
    }
    if (shape.list != nullptr)
        for (const geometry::Attribute& each : shape.list->attributes)
            if (std::ranges::find(names, each.name) == names.end()) names.push_back(each.name);
    return names;
}

}  // namespace glibra::plan
