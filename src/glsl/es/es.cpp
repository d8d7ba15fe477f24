#include "glsl/es/es.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "glsl/emit/emit.h"
#include "glsl/es/additions.h"
#include "glsl/es/parts.h"
#include "glsl/es/stage.h"
#include "glsl/parse/tree.h"
#include "glsl/parse/unit.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"
#include "glsl/read/source.h"

namespace glibra::glsl {
namespace {

// GLSL ES 3.00 has no stages but that of vertices and that of fragments: those between them become parts of
// the first.

/// The stages before the fragment stage as one vertex stage, where there are more than that.
class MergedStages {
  public:
    MergedStages(std::vector<Unit>& units, std::vector<EsStage>& stages, const TranslatedProgram& program,
                 const DrawForms& draws);

    /// Of what the stages become.
    [[nodiscard]] ExpandedGeometry expansion() const;
    /// In place of the stages of `program`.
    void join(std::vector<TranslatedStage>& stages) const;

  private:
    EsStage& of(const Unit& unit) { return stages_[static_cast<std::size_t>(&unit - first_)]; }

    /// The fragment stage discards what lies behind a plane: pixels whose centres are cut away have a
    /// negative distance (OpenGL 4.6 Core, 13.7.1).
    void clip(Unit* fragment, int count);
    /// The fragment stage gets the number of its primitive from the vertices.
    void numberPrimitives(Unit& fragment);
    [[nodiscard]] bool isFetched() const;
    /// Reports that the stage is needed, if `problem` or the forms of the draws keep it from becoming a part.
    void lacks(const Unit& unit, const char* what, std::string problem);
    void tessellate(const TranslatedProgram& program);
    void build(Unit* fragment, const TranslatedProgram& program);
    /// The main function of the merged stage, and the functions that it calls.
    [[nodiscard]] std::string ending() const;

    std::vector<EsStage>& stages_;
    const DrawForms& draws_;
    Unit *vertex_, *control_, *evaluation_, *geometry_;  ///< null: there is none
    Unit* last_;                                         ///< before the fragment stage
    const Unit* first_;
    static constexpr const char* kPrimitive = "glibra_PrimitiveID";
    static constexpr const char* kDistances = "glibra_ClipDistance";
    int corners_ = 0;  ///< of a primitive of the mesh
    bool numbersPrimitives_ = false;
    std::optional<TessellationInVertex> tessellation_;
    std::optional<CornerStage> own_;  ///< the vertex stage before a geometry stage
    std::optional<GeometryInVertex> built_;
};

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

constexpr int kEsVersion = 300;

/// The text with empty lines in place of #extension and #line, so that its lines keep their numbers.
std::string withoutDirectives(std::string_view source) {
    std::string text;
    for (const std::string_view line : textLines(source)) {
        if (!isLineNumber(line) && !line.starts_with("#extension ")) text += line;
        text += '\n';
    }
    return text;
}

/// Guards the loops of all stages. Returns their places.
std::vector<Place> guardLoops(const std::vector<Unit>& units, std::vector<EsStage>& stages) {
    std::vector<Place> sites;
    bool haveVertexLoops = false;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (stages[i].guardLoops(sites))
            haveVertexLoops = haveVertexLoops || units[i].stage != Stage::fragment;
    for (std::size_t i = 0; i < units.size() && !sites.empty(); ++i) {
        if (units[i].stage == Stage::vertex && haveVertexLoops) stages[i].beginUncut();
        if (units[i].stage == Stage::fragment) stages[i].showCutLoop(haveVertexLoops);
    }
    return sites;
}

}  // namespace

EsProgram toEs(const TranslatedProgram& program, const EsOptions& options) {
    EsProgram result;
    Report report, ignored;  // the core text has been reported already
    ProgramRequest core, es;
    core.target.version = 450;
    es.target.version = kEsVersion;
    es.target.isEs = true;
    std::vector<Unit> units;
    units.reserve(program.stages.size() + 1);
    std::vector<EsStage> stages;
    for (const TranslatedStage& each : program.stages) {
        if (each.stage == Stage::compute) {
            report.reportOnce("compute", "web-E01", "WebGL 2 has no compute stage",
                              {each.path, each.firstLine, 1});
            continue;
        }
        Unit& unit = units.emplace_back();
        unit.request = &core;
        readSource({each.stage, each.path, withoutDirectives(each.source)}, unit, ignored);
        unit.syntax = parseSyntax(unit.view);
        unit.bodies = parseBodies(unit.view, unit.syntax);
        unit.variables = collectVariables(unit);
        findUsage(unit);
        unit.request = &es;
        stages.emplace_back(each, unit, report, options);
    }
    const MergedStages merged(units, stages, program, options.draws);
    result.loopSites = guardLoops(units, stages);
    for (EsStage& each : stages) each.adapt(result.initialValues);
    for (const Unit& unit : units)
        for (const auto& [name, written] : unit.renames) {
            const auto known = program.userNames.find(name);
            result.userNames[written] = known == program.userNames.end() ? name : known->second;
        }
    for (EsStage& each : stages) result.stages.push_back(each.take());
    merged.join(result.stages);
    result.expanded = merged.expansion();
    // Only the core profile links a vertex stage alone.
    if (!result.stages.empty() && result.stages.back().stage == Stage::vertex) {
        TranslatedStage& empty = result.stages.emplace_back();
        empty.stage = Stage::fragment;
        empty.source = "#version 300 es\nvoid main() {}\n";
        empty.lineMap.lines.resize(2);
        empty.lineMap.columns.resize(2);
    }
    if (options.draws.haveWideLines) result.wideLines = widenLines(result.stages, result.expanded);
    result.diagnostics = report.take();
    return result;
}

}  // namespace glibra::glsl
