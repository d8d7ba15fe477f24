// Uniforms of type int or float that are passed to a texture function as its sampler (language, 7.9).

#include <fmt/format.h>

#include <algorithm>

#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

std::string_view word(SamplerKind kind) {
    switch (kind) {
        case SamplerKind::sampler1D:
            return "sampler1D";
        case SamplerKind::sampler2D:
            return "sampler2D";
        case SamplerKind::sampler3D:
            return "sampler3D";
        case SamplerKind::samplerCube:
            break;
    }
    return "samplerCube";
}

std::string_view dimension(SamplerKind kind) {
    return kind == SamplerKind::samplerCube ? "cube" : word(kind).substr(7);
}

/// A number that is used as a texture in any stage.
struct Misused {
    std::string named;  ///< the sampler type that a function's name states, or empty
    Place place;
    bool conflicting = false;
};

bool isNumber(const Variable& variable) {
    return variable.storage == Storage::uniform && !variable.removed &&
           (variable.type == "int" || variable.type == "float");
}

void find(Unit& unit, std::map<std::string, Misused>& found) {
    for (const auto& [function, uses] : unit.uses) {
        if (!isTextureFunction(function) || unit.isUserName(function)) continue;
        const std::string named = textureFunction(function).sampler;
        for (const std::uint32_t use : uses) {
            const std::uint32_t argument = use + 2;
            if (unit.text(use + 1) != "(" || argument >= unit.view.size() ||
                unit.bodies.roles[argument] != WordRole::global)
                continue;
            const std::string_view after = unit.text(argument + 1);
            if (after != "," && after != ")" && after != "[") continue;
            const Variable* variable = unit.variable(unit.text(argument));
            if (!variable || !isNumber(*variable)) continue;
            Misused& misused =
                found.emplace(variable->name, Misused{{}, unit.place(argument), false}).first->second;
            if (!named.empty() && !misused.named.empty() && misused.named != named)
                misused.conflicting = true;
            if (!named.empty()) misused.named = named;
        }
    }
}

void retype(ProgramUnits& program, const std::string& name, const std::string& sampler) {
    for (Unit& unit : program.units) {
        Variable* variable = unit.variable(name);
        if (!variable || !isNumber(*variable)) continue;
        program.report.report("glsl-W12",
                              fmt::format("'{}' is {}, used as {}", name, variable->type, sampler),
                              unit.place(variable->nameToken));
        const Declarator& declarator =
            unit.syntax.declarations[variable->declaration].declarators[variable->declarator];
        const Range value = declarator.initializer;
        if (!value.empty()) {
            // The initialiser of a sampler would be its texture unit.
            if (value.end - value.first == 1 && unit.view[value.first].kind == TokenKind::number)
                program.result->textureBindings[name] =
                    std::atoi(std::string(unit.text(value.first)).c_str());
            variable->dropInitializer = true;
        }
        variable->type = sampler;
        variable->precision.clear();
        variable->changed = true;
    }
}

}  // namespace

void retypeSamplers(ProgramUnits& program) {
    std::map<std::string, Misused> found;
    for (Unit& unit : program.units) find(unit, found);
    for (const auto& [name, misused] : found) {
        std::string sampler = misused.named;
        std::vector<SamplerKind> kinds;
        if (sampler.empty() && program.request->samplerKindsOfTag) {
            kinds = program.request->samplerKindsOfTag(name);
            if (kinds.size() == 1) sampler = word(kinds.front());
        }
        if (!sampler.empty() && !misused.conflicting) {
            retype(program, name, sampler);
            continue;
        }
        std::string holds;
        for (const SamplerKind each : kinds)
            holds += (holds.empty() ? "" : " and ") + std::string(dimension(each));
        program.report.report("glsl-E08",
                              "'" + name + "' is a number but used as a texture; " +
                                  (misused.conflicting ? "the functions name several kinds"
                                   : holds.empty()     ? std::string("its unit holds no texture")
                                                       : "its unit holds " + holds) +
                                  ", declare the sampler",
                              misused.place);
    }
}

}  // namespace glibra::glsl
