#include "glsl/translate.h"

#include "glsl/emit/emit.h"
#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"
#include "glsl/read/source.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

void read(const ProgramRequest& request, ProgramUnits& program) {
    std::vector<const StageSource*> ordered;
    for (int stage = 0; stage < kStageCount; ++stage)
        for (const StageSource& each : request.stages)
            if (each.stage == static_cast<Stage>(stage)) ordered.push_back(&each);
    program.units.reserve(ordered.size());  // tokens point into the text of a unit, which must not move
    for (const StageSource* each : ordered) {
        if (each->text.empty()) {
            const std::size_t slash = each->path.find_last_of("/\\");
            program.report.report(
                "file-E02",
                "'" + (slash == std::string::npos ? each->path : each->path.substr(slash + 1)) + "' is empty",
                {each->path, 1, 1});
            continue;
        }
        Unit& unit = program.units.emplace_back();
        unit.request = &request;
        readSource(*each, unit, program.report);
    }
}

void parse(Unit& unit) {
    unit.syntax = parseSyntax(unit.view);
    unit.bodies = walkBodies(unit.view, unit.syntax);
    unit.variables = collectVariables(unit);
    findUsage(unit);
}

/// Records the emitted names that differ from the user's, for messages and tags.
void recordUserNames(const Unit& unit, TranslatedProgram& result) {
    for (const auto& [user, emitted] : unit.renames)
        if (emitted.starts_with("glibra_")) result.userNames[emitted] = user;
}

void applyRules(ProgramUnits& program) {
    std::vector<TokenWalk> walks;
    walks.reserve(program.units.size());
    for (const Unit& unit : program.units) walks.emplace_back(unit);
    Report& report = program.report;

    modernizeQualifiers(program);
    renameTakenWords(program);
    refuse(program);
    for (Unit& unit : program.units) resolveSubroutines(unit, report);
    retypeSamplers(program);
    for (std::size_t i = 0; i < walks.size(); ++i) modernizeFunctions(program.units[i], walks[i]);
    supplyBuiltins(program);
    for (Unit& unit : program.units) supplyFixedState(unit, report);
    placeInTile(program);
    connectBuiltinVaryings(program, walks);
    placeFragmentOutputs(program);
    for (std::size_t i = 0; i < walks.size(); ++i) modernizeGeometry(program.units[i], walks[i], report);
    checkTessellation(program);
    countPatchesInWhole(program);
    completeGeometryLayout(program);
    collectDeclarations(program);
    connectStages(program);
    for (std::size_t i = 0; i < walks.size(); ++i)
        repairDeclarations(program.units[i], walks[i], program.result->geometryInput, report);
    for (std::size_t i = 0; i < walks.size(); ++i) {
        Unit& unit = program.units[i];
        widenScalars(unit, report);
        adaptToTarget(unit);
        renderVariables(unit);
        applyRenames(unit, walks[i]);
        recordUserNames(unit, *program.result);
    }
    program.result->placement = findPlacement(program);
    program.result->isOpaque = findOpacity(program);
}

void deliver(ProgramUnits& program) {
    TranslatedProgram& result = *program.result;
    result.mayReadTangents = mayReadTangents(program);
    result.levelUniforms = findLevelUniforms(program);
    for (Unit& unit : program.units) {
        TranslatedStage& stage =
            result.stages.emplace_back(program.request->shim ? emit(unit) : emitAsIs(unit));
        stage.loops = loopsOf(unit);
        stage.facts = factsOf(unit);
    }
}

}  // namespace

TranslatedProgram translate(const ProgramRequest& request) {
    TranslatedProgram result;
    result.name = request.name;
    result.place = request.place;
    ProgramUnits program;
    program.request = &request;
    program.result = &result;
    read(request, program);
    if (!program.report.failed()) {
        for (Unit& unit : program.units) parse(unit);
        if (request.shim) {
            applyRules(program);
        } else {
            checkTessellation(program);
            readFactsAsIs(program);
            collectDeclarations(program);
        }
    }
    if (!program.report.failed()) deliver(program);
    result.diagnostics = program.report.take();
    return result;
}

}  // namespace glibra::glsl
