#include "plan/planned_programs.h"

#include <fmt/format.h>

#include <algorithm>

#include "plan/loop_rounds.h"
#include "plan/submission.h"
#include "plan/uniform_names.h"
#include "plan/uniforms.h"

namespace glibra::plan {

bool isInBuffer(const PlannedProgram& program, const ActiveUniform& uniform) {
    return uniform.block >= 0 && std::ranges::any_of(program.blocks, [&](const BlockUse& each) {
               return each.kind == BlockUse::Kind::uniform &&
                      each.index == static_cast<std::size_t>(uniform.block);
           });
}

namespace {

template <class T>
void askFor(const T& what, std::vector<T>& questions) {
    if (std::ranges::find(questions, what) == questions.end()) questions.push_back(what);
}

/// Adds the vertex inputs whose names are in the table of well-known names.
void listNamedInputs(const ProgramInterface& interface, std::vector<std::string>& to) {
    for (const ActiveInput& input : interface.inputs) {
        const std::string_view attribute = glsl::wellKnownAttribute(input.name, input.type.word);
        if (!attribute.empty())
            to.push_back(fmt::format("vertex input '{}' is the attribute {}", input.name, attribute));
    }
}

/// The object whose size is the number of invocations, or null.
const scene::ObjectView* sizeObjectOf(const scene::Dispatch& dispatch) {
    const auto* over = std::get_if<scene::Over>(&dispatch.groups);
    return over != nullptr ? std::get_if<scene::ObjectView>(&over->what) : nullptr;
}

}  // namespace

PlannedProgramIndex PlannedPrograms::of(const ProgramVariant& variant, scene::UniformSetIndex uniforms,
                                        const std::string& file) {
    if (!variant.program) uniforms = {};  // the built-in program reads none of them
    const std::size_t values = uniforms ? uniforms.position() + 1 : 0;
    if (withValues_.size() <= values) withValues_.resize(scene_.uniformSets.size() + 1);
    for (PlannedProgramIndex each = withValues_[values]; each; each = states_[each].other)
        if (plan_.programs[each].variant == variant) return each;
    static const ProgramInterface kUnknown;
    const auto known = answers_.interfaces.find(variant);
    if (known == answers_.interfaces.end()) askFor(variant, questions_.interfaces);
    const ProgramInterface& interface = known == answers_.interfaces.end() ? kUnknown : *known->second;
    PlannedProgram program{variant, &interface, {}, {}, {}};
    State state;
    state.diagnostics = interface.facts.diagnostics;
    if (interface.usable) resolve(program, state, uniforms, file.empty() ? scene_.path : file);
    const Measure measure = measureOf(scene_, program, state.units);
    Diagnostics longLoops = reportLongLoops(program, [this] { return loopLimit(); }, measure);
    program.hasOpenLoops = interface.usable && longLoops.empty() && plan::hasOpenLoops(program, measure);
    append(state.diagnostics, std::move(longLoops));
    append(state.diagnostics, reportLostVertices(program, measure));
    state.other = withValues_[values];
    states_.push_back(std::move(state));
    return withValues_[values] = plan_.programs.add(std::move(program));
}

void PlannedPrograms::resolve(PlannedProgram& program, State& state, scene::UniformSetIndex uniforms,
                              const std::string& file) {
    const ProgramInterface& interface = *program.interface;
    const scene::Program noPairs;
    const scene::Program* own = declared(program.variant.program);
    scene::Program merged;  // values of the draw after those of the Program statement, which they replace
    if (own != nullptr && uniforms) {
        merged.name = own->name;
        merged.place = own->place;
        const std::vector<glib::UniformSpec>& set = scene_.uniformSets[uniforms].values;
        merged.uniforms.reserve(own->uniforms.size() + set.size());
        merged.uniforms = own->uniforms;
        merged.uniforms.insert(merged.uniforms.end(), set.begin(), set.end());
        own = &merged;
    }
    if (own != nullptr) {
        Result<std::vector<BlockUse>> blocks = blockUses(scene_, *own, uniforms, interface);
        append(state.diagnostics, std::move(blocks.diagnostics));
        if (blocks) program.blocks = std::move(*blocks);
    }
    const std::span<const Override> overrides(options_.overrides);
    const DrawValues drawn{scene_.suppliesNames ? &scene_ : nullptr,
                           uniforms ? &scene_.uniformSets[uniforms] : nullptr, plan_.nodes->namedValues,
                           [&](const ActiveUniform& each) { return isInBuffer(program, each); }};
    UniformResolution resolution =
        resolveUniforms(own != nullptr ? *own : noPairs, file, interface,
                        own != nullptr ? overrides : overrides.first(0), plan_.usedOverrides, drawn);
    program.foundByName = std::move(resolution.foundByName);
    program.timed = std::move(resolution.timed);
    if (scene_.suppliesNames && own != nullptr) listNamedInputs(interface, program.foundByName);
    for (const glsl::Constant& each : program.variant.constants)
        program.foundByName.push_back(fmt::format("constant '{}' is {}", each.name, glsl::valueText(each)));
    state.badBindings = std::move(resolution.badBindings);
    state.refused = std::move(resolution.refusedImages);
    program.values = std::move(resolution.values);
    program.controls = std::move(resolution.controls);
    append(state.diagnostics, std::move(resolution.diagnostics));
    auto units =
        assignUnits(interface, resolution.samplers, options_.maxTextureUnits, options_.maxImageUnits);
    if (units) state.units = std::move(*units);
    state.unitProblems = std::move(units.diagnostics);
}

int PlannedPrograms::loopLimit() {
    questions_.loopLimit = questions_.loopLimit || !answers_.loopLimit;
    return answers_.loopLimit.value_or(0);
}

bool PlannedPrograms::mayWrite(const scene::Draw& draw) {
    if (usesBuiltin(scene_, draw)) return false;
    const auto known = answers_.writers.find(draw.program);
    if (known == answers_.writers.end()) askFor(draw.program, questions_.writers);
    return known != answers_.writers.end() && known->second;
}

PlannedInputsIndex PlannedPrograms::inputsOf(const scene::Draw& draw, PlannedProgramIndex program) {
    PlannedInputsIndex& index = inputs_[{(*this)[program].variant, draw.attributes}];
    if (!index)
        index = plan_.inputs.add({inputSources(scene_, draw.attributes, *(*this)[program].interface)});
    return index;
}

void PlannedPrograms::addRefused(PlannedProgramIndex program, std::vector<ObjectUse>& to) {
    for (const scene::ObjectView& each : state(program).refused) to.push_back({each, true, true, true});
}

std::vector<ObjectUse> PlannedPrograms::usesOf(const scene::Draw& draw, const scene::Pass& pass) {
    const PlannedProgramIndex program = of(draw, pass);
    const PlannedInputsIndex inputs = inputsOf(draw, program);
    std::vector<ObjectUse> uses =
        plan::usesOf((*this)[program], texturesOf(draw, program), draw, &plan_.inputs[inputs]);
    addRefused(program, uses);
    return uses;
}

std::vector<ObjectUse> PlannedPrograms::usesOf(const scene::Dispatch& dispatch) {
    if (!options_.lacksCompute.empty()) return {};
    const PlannedProgramIndex program = of(dispatch);
    std::vector<ObjectUse> uses = plan::usesOf((*this)[program], texturesOf(dispatch, program), dispatch);
    addRefused(program, uses);
    if (const scene::ObjectView* size = sizeObjectOf(dispatch))  // its content is not read
        uses.push_back({*size, false, false});
    return uses;
}

}  // namespace glibra::plan
