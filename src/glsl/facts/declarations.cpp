// What the stages declare: uniforms, texture bindings, vertex inputs and the names of all interfaces.

#include <fmt/format.h>

#include <algorithm>

#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

/// DeclaredUniform::arraySize.
int declaredElements(const Unit& unit, const Declaration& declaration, const Declarator& declarator) {
    if (declaration.type.dimensions.size() + declarator.dimensions.size() != 1) return 0;
    const auto& dimension =
        declarator.dimensions.empty() ? declaration.type.dimensions.front() : declarator.dimensions.front();
    long long elements = 0;
    if (!globalIntegerValue(unit, dimension, elements) || elements < 1) return 0;
    return static_cast<int>(std::min(elements, 1LL << 20));
}

void variableFacts(const Unit& unit, const Variable& variable, TranslatedProgram& result) {
    if (variable.removed || variable.storage == Storage::none || variable.storage == Storage::constant)
        return;
    const Declaration& declaration = unit.syntax.declarations[variable.declaration];
    const Place place = unit.place(variable.nameToken);
    result.interfaceNames[variable.name].push_back(place);
    if (variable.storage == Storage::input && unit.stage == Stage::vertex)
        result.vertexInputs.emplace(variable.name, place);
    if (variable.storage != Storage::uniform) return;
    const bool initialised =
        !declaration.declarators[variable.declarator].initializer.empty() && !variable.dropInitializer;
    DeclaredUniform& uniform =
        result.uniforms.emplace(variable.name, DeclaredUniform{place, initialised}).first->second;
    uniform.hasInitializer = uniform.hasInitializer || initialised;
    uniform.arraySize = std::max(
        uniform.arraySize, declaredElements(unit, declaration, declaration.declarators[variable.declarator]));
    const LayoutItem* binding =
        isOpaqueTypeWord(variable.type) ? declaration.qualifiers.item("binding") : nullptr;
    long long textureUnit = 0;
    if (binding && integerValue(unit, binding->value, textureUnit) && textureUnit >= 0 && textureUnit < 1024)
        result.textureBindings[variable.name] = static_cast<int>(textureUnit);
}

void blockFacts(const Unit& unit, const Declaration& block, TranslatedProgram& result) {
    const std::string name(unit.text(block.name));
    result.interfaceNames[name].push_back(unit.place(block.name));
    if (block.qualifiers.storage != Storage::uniform) return;
    for (const Declaration& member : block.members)
        for (const Declarator& each : member.declarators) {
            const DeclaredUniform uniform{unit.place(each.name), false};
            const std::string own(unit.text(each.name));
            result.uniforms.emplace(own, uniform);
            result.uniforms.emplace(fmt::format("{}.{}", name, own), uniform);
        }
}

}  // namespace

void collectDeclarations(ProgramUnits& program) {
    for (const Unit& unit : program.units) {
        for (const Variable& each : unit.variables) variableFacts(unit, each, *program.result);
        for (const Declaration& each : unit.syntax.declarations)
            if (each.kind == DeclarationKind::block) blockFacts(unit, each, *program.result);
    }
}

}  // namespace glibra::glsl
