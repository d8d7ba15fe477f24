// Stages between those of vertices and of fragments.

// Geometry shaders of EXT_geometry_shader4, and the layouts of geometry stages (language, 7.7).

#include <algorithm>
#include <array>

#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

class OldNames {
  public:
    OldNames(Unit& unit, const TokenWalk& walk, Report& report) : unit_(unit), walk_(walk), report_(report) {}

    void run() {
        for (std::uint32_t i = 0; i < unit_.tokens.size(); ++i) {
            if (unit_.tokens[i].kind != TokenKind::word) continue;
            const std::string_view text = unit_.tokens[i].text;
            if (!text.starts_with("gl_")) continue;
            if (text == "gl_PositionIn") arrayIn(i, "gl_Position", true);
            if (text == "gl_PointSizeIn") arrayIn(i, "gl_PointSize", false);
            if (text == "gl_ClipDistanceIn") arrayIn(i, "gl_ClipDistance", false);
            if (text == "gl_VerticesIn") unit_.edits.replace(i, "gl_in.length()");
            if (text == "gl_PrimitiveIDIn") primitive(i);
        }
    }

  private:
    void arrayIn(std::uint32_t at, const std::string& member, bool length) {
        const std::uint32_t next = walk_.next(at);
        const std::string name(walk_.text(at));
        if (walk_.text(next) == "[" && walk_.match(next) != kNone) {
            unit_.edits.replace(at, "gl_in");
            unit_.edits.after(walk_.match(next), "." + member);
        } else if (length && walk_.text(next) == "." && walk_.text(walk_.next(next)) == "length") {
            unit_.edits.replace(at, "gl_in");
        } else {
            report_.report("glsl-E03",
                           name + " without a subscript cannot be emulated; write " + name + "[i]",
                           unit_.placeOfToken(at));
        }
    }

    void primitive(std::uint32_t at) {
        const std::uint32_t open = walk_.next(at);
        if (walk_.text(open) != "[" || walk_.match(open) == kNone) return;
        const std::uint32_t close = walk_.match(open);
        for (std::uint32_t i = open; i != kNone; i = walk_.next(i)) {
            unit_.edits.remove(i);
            if (i == close) break;
        }
    }

    Unit& unit_;
    const TokenWalk& walk_;
    Report& report_;
};

constexpr std::array<std::string_view, 5> kGeometryInputs = {"points", "lines", "lines_adjacency",
                                                             "triangles", "triangles_adjacency"};
constexpr std::array<std::string_view, 3> kGeometryOutputs = {"points", "line_strip", "triangle_strip"};

/// The content of the layout statements of the stage.
struct Layout {
    std::string input, output;
    const LayoutItem* vertices = nullptr;
    std::uint32_t inputAt = kNone, outputAt = kNone;
};

Layout geometryLayoutOf(const Unit& unit) {
    Layout layout;
    const auto has = [](const auto& list, const std::string& name) {
        return std::ranges::find(list, name) != list.end();
    };
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::layoutOnly) continue;
        for (const LayoutItem& item : each.qualifiers.layout) {
            if (each.qualifiers.storage == Storage::input && has(kGeometryInputs, item.name) &&
                layout.input.empty()) {
                layout.input = item.name;
                layout.inputAt = item.tokens.first;
            }
            if (each.qualifiers.storage != Storage::output) continue;
            if (has(kGeometryOutputs, item.name) && layout.output.empty()) {
                layout.output = item.name;
                layout.outputAt = item.tokens.first;
            }
            if (item.name == "max_vertices") layout.vertices = &item;
        }
    }
    return layout;
}

class Completion {
  public:
    Completion(ProgramUnits& program, Unit& unit)
        : program_(program), unit_(unit), layout_(geometryLayoutOf(unit)) {}

    void run() {
        const ProgramRequest& request = *program_.request;
        const int components = componentsPerVertex();
        const int most = mostVertices(components);
        conflict("GeometryInput", request.geometryInput, layout_.input, layout_.inputAt);
        conflict("GeometryOutput", request.geometryOutput, layout_.output, layout_.outputAt);
        std::string synthesised;
        if (layout_.input.empty()) {
            layout_.input = request.geometryInput.empty() ? "triangles" : request.geometryInput;
            synthesised = "layout(" + layout_.input + ") in;";
            unit_.prologue.insert(unit_.prologue.begin(), synthesised);
        }
        std::string output;
        if (layout_.output.empty()) {
            layout_.output = request.geometryOutput.empty() ? "triangle_strip" : request.geometryOutput;
            output = layout_.output;
        }
        vertices(most, components, output);
        if (!output.empty()) unit_.prologue.insert(unit_.prologue.begin(), "layout(" + output + ") out;");
        program_.result->geometryInput = layout_.input;
        program_.result->geometryOutput = layout_.output;
    }

  private:
    void conflict(const std::string& command, const std::string& wanted, const std::string& written,
                  std::uint32_t at) {
        if (!program_.request->reportsGeometryConflicts || wanted.empty() || written.empty() ||
            wanted == written)
            return;
        program_.report.report("glsl-W16",
                               command + " " + wanted + " ignored, the shader's layout says " + written,
                               unit_.place(at));
    }

    [[nodiscard]] int mostVertices(int components) const {
        const Target& target = program_.request->target;
        return std::max(1, std::min(target.maxGeometryOutputVertices,
                                    target.maxGeometryTotalOutputComponents / std::max(1, components)));
    }

    void lowered(long long value, int most, int components, const Place& place) {
        program_.report.report("glsl-W07",
                               "max_vertices " + std::to_string(value) + " lowered to " +
                                   std::to_string(most) + " (" + std::to_string(components) +
                                   " components per vertex)",
                               place);
    }

    void vertices(int most, int components, std::string& output) {
        const int wanted = program_.request->geometryVerticesOut;
        if (!layout_.vertices) {
            if (wanted > most) lowered(wanted, most, components, program_.request->place);
            unit_.mostVertices = wanted > 0 ? std::min(wanted, most) : most;
            output += (output.empty() ? "max_vertices = " : ", max_vertices = ") +
                      std::to_string(unit_.mostVertices);
            return;
        }
        const Range range = layout_.vertices->value;
        long long value = 0;
        if (!integerValue(unit_, range, value)) return;
        unit_.mostVertices = static_cast<int>(std::clamp(value, 0LL, static_cast<long long>(most)));
        if (wanted > 0)
            conflict("GeometryVerticesOut", std::to_string(wanted), std::to_string(value),
                     layout_.vertices->tokens.first);
        if (value <= most) return;
        unit_.remove(range);
        unit_.edits.replace(unit_.view[range.first].raw, std::to_string(most));
        lowered(value, most, components, unit_.place(range.first));
    }

    [[nodiscard]] int arraySize(const std::vector<Range>& dimensions) const {
        long long count = 1;
        for (const Range& each : dimensions) {
            long long size = 1;
            if (integerValue(unit_, each, size))
                count = std::clamp(count * std::clamp(size, 1LL, 4096LL), 1LL, 4096LL);
        }
        return static_cast<int>(count);
    }

    /// The number of components of one emitted vertex, counted over all outputs that the stage writes.
    [[nodiscard]] int componentsPerVertex() const {
        int count = 0;
        if (unit_.isWritten("gl_Position")) count += 4;
        for (const std::string_view each : {"gl_PointSize", "gl_Layer", "gl_ViewportIndex", "gl_PrimitiveID"})
            if (unit_.isWritten(each)) ++count;
        count += program_.result->clipDistances;
        for (const Variable& each : unit_.variables) {
            if (each.storage != Storage::output || each.removed || each.name.starts_with("gl_") ||
                !unit_.isWritten(each.name))
                continue;
            const Declaration& declaration = unit_.syntax.declarations[each.declaration];
            count += typeOfWord(each.type).components() * arraySize(declaration.type.dimensions) *
                     arraySize(declaration.declarators[each.declarator].dimensions);
        }
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::block && each.qualifiers.storage == Storage::output &&
                unit_.text(each.name) != "gl_PerVertex")
                for (const Declaration& member : each.members)
                    for (const Declarator& name : member.declarators)
                        count += typeOfWord(member.type.name).components() *
                                 arraySize(member.type.dimensions) * arraySize(name.dimensions);
        return std::max(1, count + unit_.varyingComponents);
    }

    ProgramUnits& program_;
    Unit& unit_;
    Layout layout_;
};

}  // namespace

int verticesOfPrimitive(std::string_view primitive) {
    if (primitive == "points") return 1;
    if (primitive == "lines") return 2;
    if (primitive == "lines_adjacency") return 4;
    return primitive == "triangles_adjacency" ? 6 : 3;
}

void modernizeGeometry(Unit& unit, const TokenWalk& walk, Report& report) {
    if (unit.stage == Stage::geometry) OldNames(unit, walk, report).run();
}

void readFactsAsIs(ProgramUnits& program) {
    if (const Unit* unit = program.find(Stage::geometry)) {
        Layout layout = geometryLayoutOf(*unit);
        program.result->geometryInput = std::move(layout.input);
        program.result->geometryOutput = std::move(layout.output);
    }
    const Unit* fragment = program.find(Stage::fragment);
    if (!fragment) return;
    const bool old = fragment->isUsed("gl_FragColor") || fragment->isUsed("gl_FragData");
    if (old)
        program.result->fragmentOutputs =
            fragment->isUsed("gl_FragColor") ? program.request->colorTargets : 8;
    else
        placeFragmentOutputs(program);
}

void completeGeometryLayout(ProgramUnits& program) {
    if (Unit* unit = program.find(Stage::geometry)) Completion(program, *unit).run();
}

// Checks of the tessellation stages (language, 7.8), and what the runtime has to know about the stages.

namespace {

constexpr int kMostClipDistances = 8;  // every GL 4 has so many

void readControl(const Unit& unit, TranslatedProgram& result) {
    for (const Declaration& each : unit.syntax.declarations) {
        const LayoutItem* item =
            each.kind == DeclarationKind::layoutOnly && each.qualifiers.storage == Storage::output
                ? each.qualifiers.item("vertices")
                : nullptr;
        long long value = 0;
        if (item && integerValue(unit, item->value, value) && value > 0 && value <= 1024)
            result.patchVertices = static_cast<int>(value);
    }
}

void readEvaluation(const Unit& unit, TranslatedProgram& result) {
    result.tessellationOutput = "triangles";
    bool points = false;
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::layoutOnly || each.qualifiers.storage != Storage::input) continue;
        if (each.qualifiers.item("isolines")) result.tessellationOutput = "lines";
        points = points || each.qualifiers.item("point_mode");
    }
    if (points) result.tessellationOutput = "points";
}

/// The number of gl_ClipDistance elements that the stage writes, by its constant indices or its declared
/// size.
int clipDistances(const Unit& unit) {
    const auto writes = unit.writes.find("gl_ClipDistance");
    if (writes == unit.writes.end()) return 0;
    int declared = kMostClipDistances;
    for (const Variable& each : unit.variables) {
        const Declarator& declarator =
            unit.syntax.declarations[each.declaration].declarators[each.declarator];
        long long size = 0;
        if (each.name == "gl_ClipDistance" && !declarator.dimensions.empty() &&
            integerValue(unit, declarator.dimensions.front(), size) && size > 0 && size < kMostClipDistances)
            declared = static_cast<int>(size);
    }
    int count = 0;
    for (const std::uint32_t at : writes->second) {
        const int index = constantIndex(unit, at + 1);
        count = std::max(count, index < 0 ? declared : std::min(index + 1, declared));
    }
    return count;
}

}  // namespace

void numberPrimitives(ProgramUnits& program) {
    const auto uses = [](const Unit* unit, std::string_view number) {
        return unit != nullptr && unit->isUsed(number) && !unit->isUserName(number);
    };
    Unit* const evaluation = program.find(Stage::tessEvaluation);
    Unit* const geometry = program.find(Stage::geometry);
    Unit* const fragment = program.find(Stage::fragment);
    const bool isSupplied = geometry != nullptr && uses(fragment, "gl_PrimitiveID") &&
                            !geometry->isWritten("gl_PrimitiveID") && geometry->isUsed("EmitVertex");
    if (evaluation != nullptr) {
        const std::string whole = "(gl_PrimitiveID + glibra_FirstPatch)";
        for (Unit& unit : program.units) {
            const bool seesPatches = unit.stage == Stage::tessControl ||
                                     unit.stage == Stage::tessEvaluation ||
                                     (unit.stage == Stage::fragment && geometry == nullptr);
            if (!seesPatches || !uses(&unit, "gl_PrimitiveID")) continue;
            unit.declare("uniform int glibra_FirstPatch;");
            unit.renames["gl_PrimitiveID"] = whole;
        }
        if (isSupplied || uses(geometry, "gl_PrimitiveIDIn")) {
            const Declaration* const main = evaluation->function("main");
            if (main == nullptr) return;
            evaluation->declare("uniform int glibra_FirstPatch;");
            evaluation->declare("out int glibra_Patch;");
            evaluation->edits.after(evaluation->view[main->body.first].raw, " glibra_Patch = " + whole + ";");
            geometry->declare("in int glibra_Patch[];");
            geometry->renames["gl_PrimitiveIDIn"] = "glibra_Patch[0]";
        }
    }
    if (!isSupplied) return;
    const auto emit = geometry->renames.find("EmitVertex");
    geometry->declare(
        "void glibra_emitNumbered() { gl_PrimitiveID = " + spelled(*geometry, "gl_PrimitiveIDIn") + "; " +
        (emit == geometry->renames.end() ? "EmitVertex" : emit->second) + "(); }");
    geometry->renames["EmitVertex"] = "glibra_emitNumbered";
    program.result->userNames["glibra_emitNumbered"] = "EmitVertex";
    ++geometry->varyingComponents;
}

void checkTessellation(ProgramUnits& program) {
    const Unit* control = program.find(Stage::tessControl);
    const Unit* evaluation = program.find(Stage::tessEvaluation);
    if (control && !evaluation)
        program.report.report("glsl-E06", "TessControl without TessEvaluation", program.request->place);
    if (control) readControl(*control, *program.result);
    if (evaluation) readEvaluation(*evaluation, *program.result);
    // The next stage may make its positions of other outputs, and so may a later one.
    const Unit* next = control ? control : evaluation ? evaluation : program.find(Stage::geometry);
    const auto readsPositions = [](const Unit& unit) {
        return unit.isUsed("gl_in") || unit.isUsed("gl_PositionIn");
    };
    const auto makesPositions = [&](Stage stage) {
        const Unit* unit = program.find(stage);
        return unit != nullptr && unit->isWritten("gl_Position") && !readsPositions(*unit);
    };
    const bool isRead = (!next || readsPositions(*next)) && !makesPositions(Stage::geometry) &&
                        !makesPositions(Stage::tessEvaluation);
    const Unit* vertex = program.find(Stage::vertex);
    if (vertex && isRead && !vertex->isWritten("gl_Position"))
        program.report.report("glsl-W14", fileName(vertex->path) + " never writes gl_Position",
                              vertex->start());
    Unit* last = program.lastBeforeRaster();
    if (!last) return;
    program.result->writesPointSize = last->isWritten("gl_PointSize");
    program.result->writesLayer = last->isWritten("gl_Layer");
    program.result->clipDistances = clipDistances(*last);
}

}  // namespace glibra::glsl
