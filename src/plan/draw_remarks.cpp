#include "plan/draw_remarks.h"

#include <fmt/format.h>
#include <algorithm>
#include <glm/geometric.hpp>
#include <string_view>
#include <utility>

#include "base/suggest.h"
#include "plan/accesses.h"
#include "plan/submission.h"
#include "plan/texture_binding.h"
#include "plan/type_table.h"
#include "plan/uniform_names.h"
#include "scene/textures.h"
#include "scene/view.h"

namespace glibra::plan {
namespace {

/// What the texels of a colour target are for a shader. The window's are floating-point numbers.
BaseType texelKindOf(const scene::Scene& scene, const scene::Pass& pass, std::size_t target) {
    if (target >= pass.targets.size()) return BaseType::floating;
    return texelsOf(scene.textures[pass.targets[target]]);
}

std::string_view texelWords(BaseType kind) {
    if (kind == BaseType::integer) return "signed integers";
    return kind == BaseType::unsignedInteger ? "unsigned integers" : "floating-point numbers";
}

/// The GLSL type of that kind with as many components: "uvec3".
std::string glslTypeOf(BaseType kind, int components) {
    if (components > 1) return fmt::format("{}vec{}", prefixOf(kind), components);
    return kind == BaseType::integer ? "int" : kind == BaseType::unsignedInteger ? "uint" : "float";
}

bool isWritten(const scene::Draw& draw, std::size_t target) {
    const base::ColorMask& mask = draw.raster->write.at(target);
    return !draw.raster->discard && (mask.red || mask.green || mask.blue || mask.alpha);
}

}  // namespace

Diagnostics outputProblems(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass,
                           const ProgramInterface& interface) {
    Diagnostics problems;
    const std::size_t count = pass.isWindow ? 1 : pass.targets.size();
    for (const base::ActiveOutput& output : interface.outputs) {
        for (int i = 0; i < output.arraySize; ++i) {
            const int location = output.location + i;
            if (location < 0 || static_cast<std::size_t>(location) >= count) continue;
            const auto target = static_cast<std::size_t>(location);
            const BaseType kind = texelKindOf(scene, pass, target);
            if (kind == output.type.base || !isWritten(draw, target)) continue;
            problems.push_back(diagnose(
                "draw-E11",
                fmt::format("fragment output '{}' is of type {}, but {} holds {}; declare the output as {}",
                            userNameOf(interface, output.name), output.type.word,
                            describeTarget(scene, pass, target), texelWords(kind),
                            glslTypeOf(kind, output.type.components())),
                draw.place));
            break;
        }
    }
    return problems;
}

std::bitset<base::kRasterTargets> targetsWithoutOutput(const scene::Draw& draw, const scene::Pass& pass,
                                                       const ProgramInterface& interface) {
    std::bitset<base::kRasterTargets> missing;
    if (interface.isBuiltin) return missing;
    const std::size_t count = pass.isWindow ? 1 : std::min(pass.targets.size(), base::kRasterTargets);
    for (std::size_t target = 0; target < count; ++target) missing[target] = isWritten(draw, target);
    for (const base::ActiveOutput& output : interface.outputs)
        for (int i = 0; i < std::max(output.arraySize, 1); ++i)
            if (const int location = output.location + i;
                location >= 0 && location < static_cast<int>(base::kRasterTargets))
                missing.reset(static_cast<std::size_t>(location));
    return missing;
}

std::optional<LayeredTarget> layeredTarget(const scene::Scene& scene, const scene::Pass& pass) {
    if (pass.isWindow) return std::nullopt;
    scene::TextureIndex texture{};
    scene::TargetPart part;
    if (!pass.targets.empty()) {
        texture = pass.targets.front();
        if (!pass.parts.empty()) part = pass.parts.front();
    } else if (pass.depth) {
        texture = pass.depth->texture;
        part = {pass.depth->level, pass.depth->layer};
    }
    if (!texture || part.layer) return std::nullopt;
    const scene::Texture& target = scene.textures[texture];
    const int count = layersOf(target, part.level.value_or(0)).value_or(1);
    if (count < 2) return std::nullopt;
    return LayeredTarget{target.name, count, target.target == scene::TextureTarget::cube};
}

std::string describeTarget(const scene::Scene& scene, const scene::Pass& pass, std::size_t target) {
    if (pass.isWindow) return "the window";
    const scene::Texture& texture = scene.textures[pass.targets[target]];
    return texture.name.empty() ? fmt::format("the target of line {}", pass.place.line)
                                : fmt::format("target '{}' (line {})", texture.name, texture.place.line);
}

void DrawRemarks::report(const Diagnostic& diagnostic) {
    if (reported_
            .emplace(diagnostic.id, diagnostic.text, diagnostic.place.file, diagnostic.place.line,
                     diagnostic.place.column)
            .second)
        plan_.diagnostics.push_back(diagnostic);
}

void DrawRemarks::missingStage(const scene::Draw& draw, const ProgramInterface& interface) {
    const std::optional<std::string>& color = interface.facts.suppliedColor;
    const bool isGuess = color && *color != "gl_FrontColor";
    if (!draw.program || !(usesBuiltin(scene_, draw) || isGuess) || !incomplete_.insert(draw.program).second)
        return;
    const scene::Program& program = *programs_.declared(draw.program);
    const bool hasVertex = program.hasStage(glsl::Stage::vertex);
    const bool hasFragment = program.hasStage(glsl::Stage::fragment);
    const char* missing = hasVertex     ? "no fragment stage"
                          : hasFragment ? "no vertex stage"
                                        : "no vertex and no fragment stage";
    const std::string used = !isGuess         ? "a flat colour"
                             : color->empty() ? "the current colour"
                                              : fmt::format("its output '{}'", *color);
    report(diagnose("draw-W01",
                    fmt::format("Program '{}' has {}; {} is used{}", program.name, missing, used,
                                hasVertex || hasFragment || !scene_.hasStages
                                    ? ""
                                    : "; the statements Vertex and Fragment stand before their Program"),
                    draw.place));
}

void DrawRemarks::ofDraw(const scene::Draw& draw, PlannedProgramIndex index, const scene::Program* program,
                         const Submission& submission, const std::vector<TextureUse>& uses) {
    emptySlots(draw.place, index, uses);
    hazards(draw.word, draw.place, index, uses);
    reportUnknownInputs(draw, index);
    reportUnreadAttributes(draw, index);
    reportPrecision(draw, index);
    if (ignoresPointSize(draw, program, *programs_[index].interface, submission))
        reportIgnoredPointSize(draw, index, *program);
}

void DrawRemarks::warnOnce(const Place& place, PlannedProgramIndex index, const char* id,
                           const std::string& text, std::string subject, std::string suggestion) {
    if (remarks_.emplace(programs_[index].variant.program, id, text).second)
        report(about(diagnose(id, text, place), std::move(subject), std::move(suggestion)));
}

void DrawRemarks::hazards(const std::string& word, const Place& place, PlannedProgramIndex index,
                          const std::vector<TextureUse>& uses) {
    for (const Diagnostic& each : readsOfWritten(scene_, programs_[index], uses, word, place)) report(each);
}

void DrawRemarks::emptySlots(const Place& place, PlannedProgramIndex index,
                             const std::vector<TextureUse>& uses) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (uses[i].view.texture || uses[i].buffer.buffer ||
            programs_.state(index).units.at(i).binding.isLost)
            continue;
        const ActiveUniform& sampler = at(programs_[index].interface->uniforms, uses[i].uniform);
        const int unit = programs_.state(index).units.at(i).binding.unit;
        const std::string slot = sampler.type.target ? slotText(unit, *sampler.type.target)
                                                     : fmt::format("{} / {}", unit, sampler.type.word);
        warnOnce(place, index, "draw-W02",
                 fmt::format("{} '{}' reads unit {}, which is empty", uses[i].isImage ? "image" : "sampler",
                             sampler.name, slot),
                 // Known only where the warning may follow from glib-W37, which says "it reads unit 0".
                 !uses[i].isImage && unit == 0 ? sampler.name : std::string());
    }
}

void DrawRemarks::unwritten(const scene::Draw& draw, const scene::Pass& pass, PlannedProgramIndex index,
                            const std::bitset<base::kRasterTargets>& unwritten) {
    const std::string& name = programs_.declared(programs_[index].variant.program)->name;
    if (programs_[index].interface->outputs.empty()) {
        return warnOnce(draw.place, index, "draw-W10",
                        fmt::format("the fragment stage of program '{}' has no output, so the draw leaves "
                                    "the colours as they are; write 'State write none' if that is meant",
                                    name),
                        name);
    }
    for (std::size_t target = 0; target < unwritten.size(); ++target)
        if (unwritten[target])
            warnOnce(draw.place, index, "draw-W10",
                     fmt::format("program '{}' has no output for {}, so the draw leaves it as it is; "
                                 "declare 'layout(location = {}) out vec4 ...' in the fragment stage",
                                 name, describeTarget(scene_, pass, target), target),
                     name);
}

void DrawRemarks::layers(const scene::Draw& draw, const scene::Pass& pass, PlannedProgramIndex index) {
    if (programs_[index].interface->facts.writesLayer) return;
    const std::optional<LayeredTarget> target = layeredTarget(scene_, pass);
    if (!target) return;
    warnOnce(draw.place, index, "draw-W14",
             fmt::format("'{}' has {} {}, but only {} 0 is drawn into: name one, such as '{}.{}(0)', or "
                         "write gl_Layer in a geometry stage",
                         target->name, target->count, target->isCube ? "faces" : "layers",
                         target->isCube ? "face" : "layer", target->name, target->isCube ? "face" : "layer"));
}

DrawRemarks::InputHint DrawRemarks::hintForInput(const scene::Draw& draw, const ProgramInterface& interface,
                                                 const ActiveInput& input) const {
    if (!scene_.suppliesNames) {
        if (glsl::wellKnownAttribute(input.name, input.type.word).empty()) return {};
        return {"; scenes with a Camera or another modern statement supply it", {}};
    }
    const std::string name = userNameOf(interface, input.name);
    const auto isFed = [&](std::string_view attribute) {
        return std::ranges::any_of(interface.inputs, [&](const ActiveInput& each) {
            return userNameOf(interface, each.name) == attribute;
        });
    };
    std::vector<std::string_view> names;
    if (draw.attributes)
        for (const scene::AttributeBinding& each : scene_.attributeSets[draw.attributes].bindings)
            if (!isFed(each.name)) names.emplace_back(each.name);
    if (const std::string own = base::nearestName(name, names, 1); !own.empty())
        return {fmt::format("; did you mean the attribute '{}'?", own), own};
    const std::string near = glsl::inputNear(name, input.type.word);
    return {hintOf(near), near};
}

void DrawRemarks::reportUnknownInputs(const scene::Draw& draw, PlannedProgramIndex index) {
    const ProgramInterface& interface = *programs_[index].interface;
    const scene::Shape& shape = scene_.shapes[draw.shape];
    const std::vector<InputSource>& sources = plan_.inputs[programs_.inputsOf(draw, index)].sources;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::string name = userNameOf(interface, interface.inputs[i].name);
        const bool isOfList = shape.list != nullptr && shape.list->attribute(name) != nullptr;
        if (sources[i].isKnown || isOfList || isInternalName(name)) continue;
        const InputHint hint = hintForInput(draw, interface, interface.inputs[i]);
        warnOnce(draw.place, index, "draw-W03",
                 fmt::format("vertex input '{}' is not supplied; it reads 0 0 0 1{}", name, hint.text), name,
                 hint.suggestion);
    }
}

void DrawRemarks::reportUnreadAttributes(const scene::Draw& draw, PlannedProgramIndex index) {
    if (!draw.attributes) return;
    const ProgramInterface& interface = *programs_[index].interface;
    const auto& bindings = scene_.attributeSets[draw.attributes].bindings;
    const std::vector<InputSource>& sources = plan_.inputs[programs_.inputsOf(draw, index)].sources;
    std::vector<std::string> inputs;
    for (const ActiveInput& each : interface.inputs) inputs.push_back(userNameOf(interface, each.name));
    std::vector<std::string_view> free;  // what is not supplied at all is draw-W03
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (sources[i].isKnown &&
            std::ranges::none_of(bindings, [&](const auto& each) { return each.name == inputs[i]; }))
            free.emplace_back(inputs[i]);
    for (const scene::AttributeBinding& each : bindings) {
        if (std::ranges::find(inputs, each.name) != inputs.end()) continue;
        if (const std::string near = base::nearestName(each.name, free); !near.empty())
            warnOnce(each.place, index, "draw-W15",
                     fmt::format("Attribute: program '{}' has no vertex input '{}'; did you mean '{}'?",
                                 programs_.declared(programs_[index].variant.program)->name, each.name, near),
                     each.name, near);
    }
}

/// Half of the distance between neighbouring floats of 1.
static constexpr double kFloatError = 0x1p-24;

/// The planes of a perspective projection; zeros for other projections, whose depth is even.
static scene::Lens perspectiveOf(const scene::Projection& projection) {
    if (const auto* lens = std::get_if<scene::Perspective>(&projection)) return {lens->near, lens->far, 1};
    const auto* matrix = std::get_if<glm::dmat4>(&projection);
    const scene::Lens lens = matrix != nullptr ? scene::lensOf(*matrix) : scene::Lens();
    return lens.fieldOfView > 0 ? lens : scene::Lens();
}

void DrawRemarks::reportPrecision(const scene::Draw& draw, PlannedProgramIndex index) {
    const auto warn = [&](const std::string& text, const char* id = "draw-W19") {
        if (remarks_.emplace(scene::ProgramIndex(), id, text).second) report(diagnose(id, text, draw.place));
    };
    const bool isReversed = draw.raster->depthOrder != base::DepthOrder::usual;
    if (isReversed && !clipsFromZero_)
        warn("this driver has no glClipControl (OpenGL 4.5), so reversed depth is no more exact than usual",
             "draw-W21");
    // 24 bits of depth have steps of z * z / near * 2^-24 at the distance z.
    constexpr double kMostRatio = 1e7, kVisible = .01;
    const scene::Lens lens = perspectiveOf(*draw.projection);
    const bool isEven = isReversed && clipsFromZero_;  // relative to the distance, as floats are
    if (draw.raster->depthTest && !isEven && lens.near > 0 && lens.far / lens.near >= kMostRatio)
        warn(
            fmt::format("near {} and far {}: beyond {:.3g} from the eye, surfaces need more than 1% of their "
                        "distance between them for the depth to tell them apart; raise near or lower far",
                        numberText(lens.near), numberText(lens.far), kVisible * lens.near / kFloatError));

    if (lens.near <= 0 || draw.isFill || draw.isSky) return;
    // The runtime multiplies in double precision, shaders in floats. A matrix that a tag gives may be one of
    // them.
    double farthest = 0;  // from the origin
    const auto reads = [&](auto... wanted) {
        return std::ranges::any_of(programs_[index].values, [&](const UniformBinding& each) {
            const auto* supplied = std::get_if<Supplied>(&each.value);
            return supplied != nullptr && ((supplied->value == wanted) || ...);
        });
    };
    using enum glsl::Builtin;
    const glm::dvec3 place(draw.model[3]), seen(draw.modelView[3]);
    if (reads(model) && reads(view, viewProjection) && !reads(modelView, modelViewProjection))
        farthest = glm::length(place);
    for (const UniformBinding& each : programs_[index].values) {
        const auto* literal = std::get_if<Literal>(&each.value);
        if (literal == nullptr || literal->values.size() != 16) continue;
        const std::vector<double>& m = literal->values;
        if (m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1)
            farthest = std::max(farthest, glm::length(glm::dvec3(m[12], m[13], m[14])));
    }
    const double distance = std::max(glm::length(seen), lens.near);
    const double error = farthest * kFloatError;
    constexpr double kPixel = 1e-3;  // of the distance
    if (error <= kPixel * distance) return;
    warn(
        fmt::format("program '{}' multiplies the model and the view matrix itself, in 32-bit floats, whose "
                    "places are off by {:.2g} at {:.3g} from the origin; read their product, as "
                    "modelViewMatrix, or move the scene towards the origin",
                    programs_.declared(programs_[index].variant.program)->name, error, farthest));
}

void DrawRemarks::reportIgnoredPointSize(const scene::Draw& draw, PlannedProgramIndex index,
                                         const scene::Program& program) {
    using glsl::Stage;
    const Stage last = program.hasStage(Stage::geometry)         ? Stage::geometry
                       : program.hasStage(Stage::tessEvaluation) ? Stage::tessEvaluation
                                                                 : Stage::vertex;
    const std::string file = stageFileName(scene_, program, last);
    warnOnce(draw.place, index, "draw-W05",
             fmt::format("{} writes gl_PointSize, but PointSizeMode is 0",
                         file.empty() ? "Program '" + program.name + "'" : file));
}

}  // namespace glibra::plan
