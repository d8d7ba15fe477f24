#include "glsl/translate.h"

#include <algorithm>

#include "glsl/emit/emit.h"
#include "glsl/facts/facts.h"
#include "glsl/parse/lexical.h"
#include "glsl/parse/tree.h"
#include "glsl/parse/unit.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"
#include "glsl/read/source.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// Reports a compute stage that cannot be translated; false if there is one.
bool acceptsCompute(const ProgramRequest& request, Report& report) {
    const bool hasCompute = std::ranges::any_of(
        request.stages, [](const StageSource& each) { return each.stage == Stage::compute; });
    if (!hasCompute) return true;
    if (request.stages.size() > 1)
        report.report("glsl-E13", "a program has a compute stage or stages that draw, not both",
                      request.place);
    const int version = request.target.version;
    if (version < kFirstWithCompute)
        report.report("glsl-E12",
                      "compute shaders need OpenGL 4.3; this driver has " + std::to_string(version / 100) +
                          "." + std::to_string(version / 10 % 10),
                      request.place);
    return !report.failed();
}

void read(const ProgramRequest& request, ProgramUnits& program) {
    std::vector<const StageSource*> ordered;
    for (int stage = 0; stage < kStageCount; ++stage)
        for (const StageSource& each : request.stages)
            if (each.stage == static_cast<Stage>(stage)) ordered.push_back(&each);
    program.units.reserve(ordered.size());
    for (const StageSource* each : ordered) {
        if (each->text.empty()) {
            program.report.report("file-E02", "'" + fileName(each->path) + "' is empty", {each->path, 1, 1});
            continue;
        }
        if (!isSourceText(each->path, each->text, program.report)) continue;
        Unit& unit = program.units.emplace_back();
        unit.request = &request;
        const std::size_t begin = std::min(each->text.find_first_not_of("\r\n"), each->text.size());
        unit.firstLine =
            1 + static_cast<int>(std::count(each->text.begin(),
                                            each->text.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
        readSource(*each, unit, program.report);
    }
}

/// Reports constants of the scene that no stage names.
void checkConstants(ProgramUnits& program) {
    const ProgramRequest& request = *program.request;
    for (std::size_t i = 0; i < request.constants.size(); ++i) {
        const std::string& name = request.constants[i].name;
        const bool isNamed = std::ranges::any_of(
            program.units, [&](const Unit& each) { return each.namedConstants.contains(name); });
        if (!request.shim)
            program.report.report(
                "glsl-W33", "--no-shim leaves shaders as they are, so 'const " + name + "' has no effect",
                request.constantPlaces[i]);
        else if (!isNamed && !program.report.failed())
            program.report.report("glsl-W33",
                                  "no shader of Program '" + request.name + "' has the name '" + name +
                                      "', so 'const " + name + "' has no effect",
                                  request.constantPlaces[i]);
    }
}

void parse(Unit& unit) {
    if (unit.request->shim) {
        replaceExtensionWords(unit);
        dropIdleOperands(unit);
        markNames(unit);
    }
    const auto parseText = [&] {
        unit.syntax = parseSyntax(unit.view);
        unit.bodies = parseBodies(unit.view, unit.syntax);
    };
    parseText();
    if (unit.request->shim && renameOwnOverloads(unit)) parseText();
    unit.variables = collectVariables(unit);
    findUsage(unit);
}

/// Gives the fragment stage the vertex stage that covers the target, if the program wants one: where there is
/// no other stage, or only vertex and geometry stages that were meant for other shapes.
void supplyVertexStage(ProgramUnits& program) {
    if (!program.request->suppliesFullScreenVertex || program.units.empty() ||
        program.units.back().stage != Stage::fragment)
        return;
    const auto end = program.units.end() - 1;
    if (!std::all_of(program.units.begin(), end, [&](const Unit& each) {
            const bool isReplaced = each.stage == Stage::vertex || each.stage == Stage::geometry;
            return isReplaced && lacksPlace(each, program.units.back());
        }))
        return;
    program.units.erase(program.units.begin(), end);
    program.result->suppliesVertexStage = true;
    Unit vertex;
    vertex.request = program.request;
    readSource({Stage::vertex, "full_screen.vert", fullScreenVertex(program.units.front())}, vertex,
               program.report);
    parse(vertex);
    program.units.insert(program.units.begin(), std::move(vertex));
}

/// Adds the stage that a program with one end of the pipeline lacks, if it wants one.
void supplyMissingStage(ProgramUnits& program) {
    if (program.units.empty()) return;
    Unit supplied;
    supplied.request = program.request;
    if (program.request->suppliesFragment && program.units.back().stage != Stage::fragment &&
        program.units.front().stage == Stage::vertex) {
        readSource({Stage::fragment, "default.frag", defaultFragment(program.units.back())}, supplied,
                   program.report);
        parse(supplied);
        supplied.isSupplied = true;
        program.result->suppliedColor = suppliedColor(program.units.back());
        program.units.push_back(std::move(supplied));
    } else if (program.request->suppliesFixedVertex && program.units.size() == 1 &&
               program.units.front().stage == Stage::fragment) {
        readSource({Stage::vertex, "default.vert", fixedVertex(program.units.front())}, supplied,
                   program.report);
        parse(supplied);
        program.units.insert(program.units.begin(), std::move(supplied));
    }
}

/// Records the emitted names that differ from the user's, for messages and tags.
void recordUserNames(const Unit& unit, TranslatedProgram& result) {
    for (const auto& [user, emitted] : unit.renames)
        if (emitted.starts_with("glibra_")) result.userNames[emitted] = user;
    for (const auto& [name, at] : unit.declared)
        if (name.starts_with(kOwnOverload)) result.userNames[name] = name.substr(kOwnOverload.size());
}

void applyRules(ProgramUnits& program) {
    std::vector<TokenWalk> walks;
    walks.reserve(program.units.size());
    for (const Unit& unit : program.units) walks.emplace_back(unit);
    Report& report = program.report;

    modernizeQualifiers(program);
    renameTakenWords(program);
    refuse(program);
    resolveSubroutines(program);
    retypeSamplers(program);
    for (std::size_t i = 0; i < walks.size(); ++i) modernizeFunctions(program.units[i], walks[i]);
    supplyBuiltins(program);
    for (Unit& unit : program.units) supplyFixedState(unit, report);
    placeInTile(program);
    runInPieces(program);
    connectBuiltinVaryings(program, walks);
    placeFragmentOutputs(program);
    for (std::size_t i = 0; i < walks.size(); ++i) modernizeGeometry(program.units[i], walks[i], report);
    checkTessellation(program);
    numberPrimitives(program);
    completeGeometryLayout(program);
    collectDeclarations(program);
    collectMemory(program);
    connectStages(program);
    checkUniformTypes(program);
    for (std::size_t i = 0; i < walks.size(); ++i)
        repairDeclarations(program.units[i], walks[i], program.result->geometryInput, report);
    for (std::size_t i = 0; i < walks.size(); ++i) {
        Unit& unit = program.units[i];
        giveInitialValues(unit, report);
        widenScalars(unit, report);
        chooseOverloads(unit, report);
        adaptToTarget(unit);
        renderVariables(unit);
        limitSharedSubscripts(unit, *program.result, report);
        applyRenames(unit, walks[i]);
        if (program.request->checksUndefined) recordUndefined(unit, program.result->undefinedSites);
        recordUserNames(unit, *program.result);
    }
    recordCutLoops(program);
    findPlacement(program);
    makePositionsInvariant(program);
    program.result->isOpaque = findOpacity(program);
    for (const Unit& unit : program.units)
        if (unit.stage == Stage::compute) program.result->wholeWrites = wholeWritesOf(unit);
}

std::vector<TypeMismatch> mismatchesOf(const Unit& unit) {
    constexpr std::size_t kMost = 256;  // drivers stop earlier
    std::vector<TypeMismatch> all;
    for (const OperandMismatch& each : unit.bodies.mismatches) {
        if (all.size() == kMost) break;
        all.push_back({unit.place(each.op),
                       wordOf(each.left) + " " + std::string(unit.text(each.op)) + " " + wordOf(each.right)});
    }
    for (const ReturnValue& each : unit.bodies.returns)
        if (all.size() < 2 * kMost && each.type.numeric() && each.wanted.numeric() &&
            (each.type.columns != each.wanted.columns || each.type.rows != each.wanted.rows))
            all.push_back(
                {unit.place(each.expression.first),
                 "the value is a " + wordOf(each.type) + ", the function returns a " + wordOf(each.wanted)});
    return all;
}

void deliver(ProgramUnits& program) {
    TranslatedProgram& result = *program.result;
    if (!program.find(Stage::fragment)) result.fragmentOutputs = 0;
    result.mayReadTangents = mayReadTangents(program);
    result.levelUniforms = findLevelUniforms(program);
    collectReaches(program);
    if (!program.request->shim)
        for (const Unit& unit : program.units) reportUnassigned(unit, program.report);
    for (Unit& unit : program.units) {
        TranslatedStage& stage =
            result.stages.emplace_back(program.request->shim ? emit(unit) : emitAsIs(unit));
        stage.firstLine = unit.firstLine;
        LoopFacts loops = loopsOf(unit);
        stage.loops = std::move(loops.loops);
        stage.uncounted = std::move(loops.uncounted);
        stage.emits = loops.emits;
        if (program.request->acceptsStorage || unit.stage == Stage::compute)
            stage.subscripts = subscriptsOf(unit);
        stage.facts = factsOf(unit);
        stage.mismatches = mismatchesOf(unit);
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
    if (acceptsCompute(request, program.report)) read(request, program);
    if (!program.report.failed()) {
        for (Unit& unit : program.units) parse(unit);
        checkConstants(program);
        supplyVertexStage(program);
        supplyMissingStage(program);
        if (request.shim) {
            applyRules(program);
        } else {
            checkTessellation(program);
            readFactsAsIs(program);
            collectDeclarations(program);
            collectMemory(program);
        }
    }
    if (!program.report.failed()) deliver(program);
    result.diagnostics = program.report.take();
    return result;
}

}  // namespace glibra::glsl
