// Checks of the tessellation stages (language, 7.8), and what the runtime has to know about the stages.

#include <algorithm>
#include <cstdlib>

#include "glsl/parse/usage.h"
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

void countPatchesInWhole(ProgramUnits& program) {
    if (!program.find(Stage::tessEvaluation)) return;
    const auto add = [](Unit& unit, const std::string& number, const std::string& first) {
        if (!unit.isUsed(number) || unit.isUserName(number)) return;
        unit.declare("uniform int " + first + ";");
        unit.renames[number] = "(" + number + " + " + first + ")";
    };
    for (Unit& unit : program.units) {
        const bool seesPatches = unit.stage == Stage::tessControl || unit.stage == Stage::tessEvaluation ||
                                 (unit.stage == Stage::fragment && !program.find(Stage::geometry));
        if (seesPatches) add(unit, "gl_PrimitiveID", "glibra_FirstPatch");
        if (unit.stage == Stage::geometry) add(unit, "gl_PrimitiveIDIn", "glibra_FirstPrimitive");
    }
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
    if (vertex && isRead && !vertex->isWritten("gl_Position")) {
        const std::size_t slash = vertex->path.find_last_of("/\\");
        const std::string name = slash == std::string::npos ? vertex->path : vertex->path.substr(slash + 1);
        program.report.report("glsl-W14", name + " never writes gl_Position", vertex->start());
    }
    Unit* last = program.lastBeforeRaster();
    if (!last) return;
    program.result->writesPointSize = last->isWritten("gl_PointSize");
    program.result->writesLayer = last->isWritten("gl_Layer");
    program.result->clipDistances = clipDistances(*last);
}

}  // namespace glibra::glsl
