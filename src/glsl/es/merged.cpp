#include "glsl/es/merged.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "glsl/es/text_lines.h"
#include "glsl/es/wide_lines.h"

namespace glibra::glsl {
namespace {

/// Outputs of the vertex stage and inputs of the fragment stage: matched by name, interpolated alike.
void connect(Unit& vertex, Unit& fragment) {
    for (Variable& input : fragment.variables) {
        if (input.storage != Storage::input || input.removed) continue;
        const std::string* const location = input.layoutValue("location");
        for (Variable& output : vertex.variables) {
            if (output.storage != Storage::output || output.removed) continue;
            const std::string* const own = output.layoutValue("location");
            const bool isMatch = location && own ? *location == *own : input.name == output.name;
            if (!isMatch) continue;
            if (input.name != output.name)
                fragment.renames[input.name] = vertex.renames[output.name] = "glibra_Location_" + *location;
            output.interpolation = input.interpolation;
            output.centroid = input.centroid;
            output.changed = true;
        }
        input.removeLayout("location");
    }
    for (Variable& output : vertex.variables) {
        if (output.storage != Storage::output) continue;
        output.removeLayout("location");
        if (!typeOfWord(output.type).integral() || !output.interpolation.empty()) continue;
        output.interpolation = "flat";
        output.changed = true;
    }
}

/// Stages as one text: what they declare alike before the user's text stands once.
TranslatedStage joined(TranslatedStage first, const TranslatedStage& second, const std::string& ending) {
    const auto files = static_cast<int>(first.lineMap.files.size());
    const auto macros = static_cast<int>(first.lineMap.macros.size());
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(first.lineMap.files, second.lineMap.files);
    append(first.lineMap.macros, second.lineMap.macros);
    append(first.loops, second.loops);
    append(first.uncounted, second.uncounted);
    const std::string firstText = first.source;
    std::set<std::string_view> known;  // written by the translation
    for (std::size_t i = 0; const std::string_view line : textLines(firstText))
        if (first.lineMap.lines[i++].file < 0 && (line.ends_with(';') || line.starts_with('#')) &&
            !isLineNumber(line))
            known.insert(line);
    std::size_t i = 0;
    for (const std::string_view line : textLines(second.source)) {
        LineOrigin origin = second.lineMap.lines[i];
        std::vector<ColumnShift> columns = second.lineMap.columns[i++];
        if (origin.file < 0 && known.contains(line)) continue;
        first.source += isLineNumber(line) ? withSource(line, files) : std::string(line);
        first.source += '\n';
        if (origin.file >= 0) origin.file += files;
        for (ColumnShift& each : columns) {
            if (each.line.file >= 0) each.line.file += files;
            if (each.macro >= 0) each.macro += macros;
        }
        first.lineMap.lines.push_back(origin);
        first.lineMap.columns.push_back(std::move(columns));
    }
    first.source += ending;
    first.isMerged = true;
    const auto count = static_cast<std::size_t>(std::ranges::count(first.source, '\n'));
    first.lineMap.lines.resize(count);
    first.lineMap.columns.resize(count);
    return first;
}

Unit* stageIn(std::vector<Unit>& units, Stage stage) {
    const auto found = std::ranges::find(units, stage, &Unit::stage);
    return found == units.end() ? nullptr : &*found;
}

}  // namespace

MergedStages::MergedStages(std::vector<Unit>& units, std::vector<EsStage>& stages,
                           const TranslatedProgram& program, const DrawForms& draws)
    : stages_(stages),
      draws_(draws),
      vertex_(stageIn(units, Stage::vertex)),
      control_(stageIn(units, Stage::tessControl)),
      evaluation_(stageIn(units, Stage::tessEvaluation)),
      geometry_(stageIn(units, Stage::geometry)),
      last_(geometry_     ? geometry_
            : evaluation_ ? evaluation_
                          : vertex_),
      first_(units.data()) {
    Unit* const fragment = stageIn(units, Stage::fragment);
    if (last_ && fragment) connect(*last_, *fragment);
    if (vertex_ && fragment && !geometry_ && fragment->isUsed("gl_PrimitiveID")) numberPrimitives(*fragment);
    if (vertex_ && program.clipDistances > 0) clip(fragment, program.clipDistances);
    if (vertex_ && draws.haveWideLines && !evaluation_ && !geometry_) vertex_->renames["main"] = kVertexMain;
    if (!vertex_ || (!evaluation_ && !geometry_)) return;
    corners_ = evaluation_ ? draws.patchVertices : cornersOfInput(program.geometryInput);
    if (evaluation_) tessellate(program);
    if (geometry_) build(fragment, program);
    if (built_ && program.clipDistances > 0)
        built_->keep("float", kDistances, "[" + std::to_string(program.clipDistances) + "]");
}

ExpandedGeometry MergedStages::expansion() const {
    ExpandedGeometry all;
    all.numbersPrimitives = numbersPrimitives_ && !tessellation_;
    if (!tessellation_ && !built_) return all;
    if (built_) all = built_->expansion();
    all.corners = corners_;
    all.fetched = (own_ ? *own_ : tessellation_->corners()).fetched();
    if (!tessellation_) return all;
    all.tessellation = tessellation_->layout();
    all.measuresLevels = control_ != nullptr;
    all.areInSequence = tessellation_->areInSequence();
    if (!built_) all.vertices = all.ofPrimitive = cornersOf(tessellation_->layout());
    return all;
}

void MergedStages::join(std::vector<TranslatedStage>& stages) const {
    if (!tessellation_ && !built_) return;
    const auto at = [&](Stage stage) { return std::ranges::find(stages, stage, &TranslatedStage::stage); };
    const Stage last = built_ ? Stage::geometry : Stage::tessEvaluation;
    for (const Stage each : {Stage::tessControl, Stage::tessEvaluation, Stage::geometry}) {
        if (at(each) == stages.end()) continue;
        *at(Stage::vertex) = joined(*at(Stage::vertex), *at(each), each == last ? ending() : "");
        stages.erase(at(each));
    }
}

void MergedStages::clip(Unit* fragment, int count) {
    const std::string size = "[" + std::to_string(count) + "];";
    last_->renames["gl_ClipDistance"] = kDistances;
    last_->declare(std::string("out float ") + kDistances + size);
    if (!fragment) return;
    fragment->renames["gl_ClipDistance"] = kDistances;
    fragment->declare(std::string("in float ") + kDistances + size);
    std::string isBehind;
    for (int i = 0; i < count; ++i)
        isBehind += std::string(i > 0 ? " || " : "") + kDistances + "[" + std::to_string(i) + "] < 0.";
    of(*fragment).beginWith("if (" + isBehind + ") discard;");
}

void MergedStages::numberPrimitives(Unit& fragment) {
    const bool hasInputs = std::ranges::any_of(vertex_->variables, [](const Variable& each) {
        return each.storage == Storage::input && !each.name.starts_with("gl_");
    });
    if (draws_.haveIndexBuffers || draws_.areStrips) return;
    if (!evaluation_ && hasInputs && vertex_->isUsed("gl_VertexID")) return;  // numbers of the mesh
    numbersPrimitives_ = true;
    fragment.renames["gl_PrimitiveID"] = kPrimitive;
    fragment.declare(std::string("flat in int ") + kPrimitive + ";");
    if (evaluation_) return;
    vertex_->declare(std::string("flat out int ") + kPrimitive + ";");
    vertex_->declare("uniform int glibra_PerPrimitive;");
    of(*vertex_).beginWith(std::string(kPrimitive) + " = gl_VertexID / glibra_PerPrimitive;");
}

bool MergedStages::isFetched() const {
    return (own_ && !own_->fetched().empty()) ||
           (tessellation_ && !tessellation_->corners().fetched().empty());
}

void MergedStages::lacks(const Unit& unit, const char* what, std::string problem) {
    if (problem.empty() && draws_.areStrips) problem = "strips, fans and loops";
    if (problem.empty() && draws_.haveIndexBuffers) problem = "indices of a buffer";
    if (problem.empty() && draws_.haveInstanceData) problem = "attributes of instances";
    if (problem.empty() && draws_.haveBufferData && isFetched())
        problem = "more than 16 inputs, some of them from buffers";
    if (problem.empty() && corners_ == 0) problem = "patches of several sizes";
    if (problem.empty()) return;
    of(unit).lacks("web-E01",
                   std::string("WebGL 2 has no ") + what + " stage, and cannot do without: " + problem);
}

void MergedStages::tessellate(const TranslatedProgram& program) {
    TessellationInVertex& tessellation =
        tessellation_.emplace(*vertex_, control_, *evaluation_, corners_, program);
    lacks(*evaluation_, "tessellation",
          tessellation.prepare(geometry_ ? cornersOfInput(program.geometryInput) : 0));
    of(*vertex_).becomePart({.output = [&](bool) { return tessellation.outputOf(Stage::vertex, false); }});
    if (control_)
        of(*control_).becomePart({tessellation.inputOf(Stage::tessControl), [&](bool isOfPatch) {
                                      return tessellation.outputOf(Stage::tessControl, isOfPatch);
                                  }});
    EsStage::Part part{tessellation.inputOf(Stage::tessEvaluation)};
    if (geometry_) part.output = [&](bool) { return tessellation.primitives().output(); };
    of(*evaluation_).becomePart(std::move(part));
}

void MergedStages::build(Unit* fragment, const TranslatedProgram& program) {
    if (!tessellation_) {
        own_.emplace(*vertex_, "glibra_v", "glibra_corners", corners_);
        own_->prepare("glibra_Instance");
        vertex_->declare("uniform int glibra_Instance;");
        own_->spreadInputs();
        of(*vertex_).becomePart({.output = [&](bool) { return own_->output(); }});
    }
    CornerStage& corners = tessellation_ ? tessellation_->primitives() : *own_;
    GeometryInVertex& built = built_.emplace(corners, *geometry_, fragment, program);
    std::string problem =
        built.prepare(tessellation_ ? "glibra_patch" : "gl_InstanceID",
                      // Quads of lines take the place of what is measured.
                      !tessellation_ && !(draws_.haveWideLines && program.geometryOutput == "line_strip"));
    for (const Unit* each : {vertex_, control_, evaluation_})
        if (each) removeTwins(*geometry_, *each);
    // Vertices without data are numbered; those of a mesh have lost their numbers.
    if (own_ && vertex_->isUsed("gl_VertexID") && own_->hasInputs())
        problem = "gl_VertexID and vertex data before it";
    lacks(*geometry_, "geometry", problem);
    of(*geometry_).becomePart({corners.inputOfNext("glibra_c_"), {}, [&](std::string type, std::string name) {
                                   built.keep(std::move(type), std::move(name));
                               }});
}

std::string MergedStages::ending() const {
    std::string functions, text;
    if (tessellation_) functions += tessellation_->functions();
    if (built_) functions += built_->functions();
    if (!last_->isWritten("gl_PointSize")) {
        if (std::ranges::none_of(
                std::array<const Unit*, 4>{vertex_, control_, evaluation_, geometry_},
                [](const Unit* each) { return each && each->isDeclared("glibra_PointSize"); }))
            functions += "uniform float glibra_PointSize;\n";
        text += " gl_PointSize = glibra_PointSize;\n";
    }
    if (numbersPrimitives_) functions += std::string("flat out int ") + kPrimitive + ";\n";
    if (tessellation_) text += tessellation_->statements();
    if (numbersPrimitives_) text += std::string(" ") + kPrimitive + " = glibra_patch;\n";
    if (tessellation_ && built_) {
        const ExpandedGeometry each = built_->expansion();
        text += " int primitive = glibra_at / " + std::to_string(each.vertices) + ";\n";
        for (int corner = 0; corner < each.corners; ++corner)
            text += tessellation_->primitives().run(
                corner, tessellation_->coordinate("primitive * " + std::to_string(each.corners) + " + " +
                                                  std::to_string(corner)));
        text += built_->statements("(glibra_at - primitive * " + std::to_string(each.vertices) + ")");
    } else if (tessellation_) {
        text += tessellation_->coordinate("glibra_at") + " glibra_e_main();\n";
    } else {
        for (int corner = 0; corner < corners_; ++corner)
            text += own_->run(corner, " glibra_vertex = " + std::to_string(corners_) + " * gl_InstanceID + " +
                                          std::to_string(corner) + ";");
        text += built_->statements("gl_VertexID");
    }
    return functions + "void " + (draws_.haveWideLines ? kVertexMain : "main") + "() {\n" + text + "}\n";
}

}  // namespace glibra::glsl
