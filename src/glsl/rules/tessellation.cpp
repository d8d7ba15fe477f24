// Checks of the tessellation stages (language, 7.8), and what the runtime has to know about the stages.

#include <algorithm>
#include <cstdlib>

#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
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
