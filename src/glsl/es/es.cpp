#include "glsl/es/es.h"

#include <string_view>
#include <utility>

#include "glsl/es/loop_guards.h"
#include "glsl/es/merged.h"
#include "glsl/es/stage.h"
#include "glsl/es/text_lines.h"
#include "glsl/es/wide_lines.h"
#include "glsl/parse/bodies.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"
#include "glsl/read/source.h"

namespace glibra::glsl {
namespace {

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
