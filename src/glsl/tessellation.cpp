// Language 7.8, and what the runtime has to know about the stages.

#include <algorithm>
#include <cstdlib>

#include "glsl/rules.h"
#include "glsl/usage.h"

namespace glibra::glsl {
namespace {

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

}  // namespace

void checkTessellation(ProgramUnits& program) {
    const Unit* control = program.find(Stage::tessControl);
    const Unit* evaluation = program.find(Stage::tessEvaluation);
    if (control && !evaluation)
        program.report.error("glsl-E06", "TessControl without TessEvaluation", program.request->place);
    if (control) readControl(*control, *program.result);
    if (evaluation) readEvaluation(*evaluation, *program.result);
    if (const Unit* vertex = program.find(Stage::vertex); vertex && !vertex->isWritten("gl_Position")) {
        const std::size_t slash = vertex->path.find_last_of("/\\");
        const std::string name = slash == std::string::npos ? vertex->path : vertex->path.substr(slash + 1);
        program.report.warning("glsl-W14", name + " never writes gl_Position", vertex->start());
    }
    Unit* last = program.lastBeforeRaster();
    if (!last) return;
    program.result->writesPointSize = last->isWritten("gl_PointSize");
    const auto clip = last->writes.find("gl_ClipDistance");
    if (clip == last->writes.end()) return;
    // A redeclaration with a size says how many there are; else the largest constant index does.
    long long declared = 0;
    if (const Variable* own = last->variable("gl_ClipDistance"); own && !own->nameSizes.empty())
        declared = std::strtoll(own->nameSizes.front().c_str(), nullptr, 10);
    int count = static_cast<int>(std::clamp<long long>(declared, 0, 8));
    for (const std::uint32_t at : clip->second) {
        if (declared > 0) break;
        const int index = constantIndex(*last, at + 1);
        count = std::max(count, index < 0 ? 8 : std::min(index + 1, 8));
    }
    program.result->clipDistances = count;
}

}  // namespace glibra::glsl
