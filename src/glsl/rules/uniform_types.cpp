// A uniform or block that several stages declare must have the same type in each of them (GLSL 4.50, 4.3.5
// and 4.3.9). Some drivers compare only what the stages use, so the comparison is made here (language, 7.9).

#include <fmt/format.h>

#include "glsl/parse/usage.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// A type with its sizes, as far as the text shows them: "float[4]", "struct { vec3 a; }".
class TypeText {
  public:
    explicit TypeText(const Unit& unit) : unit_(unit) {}

    [[nodiscard]] std::string of(const Declaration& declaration, const Declarator& name,
                                 std::string_view type, int depth = 0) const {
        std::string text = declaration.type.isStruct ? members(declaration, depth) : named(type, depth);
        for (const auto* dimensions : {&name.dimensions, &declaration.type.dimensions})
            for (const Range& each : *dimensions) text += "[" + sizeText(unit_, each) + "]";
        return text;
    }
    [[nodiscard]] std::string members(const Declaration& declaration, int depth) const {
        std::string text = "{ ";
        for (const Declaration& member : declaration.members)
            for (const Declarator& each : member.declarators)
                text += of(member, each, member.type.name, depth + 1) + " " +
                        std::string(unit_.text(each.name)) + "; ";
        return text + "}";
    }

  private:
    static constexpr int kDeepest = 8;

    [[nodiscard]] std::string named(std::string_view type, int depth) const {
        std::string text(type);
        if (depth > kDeepest) return text;
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.type.isStruct && each.type.name == type) return text + " " + members(each, depth);
        return text;
    }

    const Unit& unit_;
};

/// What a stage declares.
struct Declared {
    std::string type;
    const Unit* unit;
    std::uint32_t at;
};

class Comparison {
  public:
    explicit Comparison(ProgramUnits& program) : program_(program) {}

    void run() {
        for (const Unit& unit : program_.units) {
            for (const Variable& each : unit.variables) {
                if (each.storage != Storage::uniform || each.removed) continue;
                const Declaration& declaration = unit.syntax.declarations[each.declaration];
                compare(variables_, each.name, unit, each.nameToken,
                        TypeText(unit).of(declaration, declaration.declarators[each.declarator], each.type));
            }
            for (const Declaration& each : unit.syntax.declarations) {
                const Storage storage = each.qualifiers.storage;
                if (each.kind == DeclarationKind::block &&
                    (storage == Storage::uniform || storage == Storage::buffer))
                    compare(storage == Storage::uniform ? uniformBlocks_ : storageBlocks_,
                            std::string(unit.text(each.name)), unit, each.name,
                            TypeText(unit).members(each, 0));
            }
        }
    }

  private:
    using Table = std::map<std::string, Declared>;

    /// Sizes that are not plain numbers, or are left out, are compared by the linker.
    static bool mayBeEqual(std::string_view a, std::string_view b) {
        if (a == b) return true;
        const auto isOpen = [](std::string_view text) {
            for (std::size_t open = text.find('['); open != std::string_view::npos;
                 open = text.find('[', open + 1)) {
                const std::size_t close = text.find(']', open);
                const std::string_view size = text.substr(open + 1, close - open - 1);
                if (size.empty() || size.find_first_not_of("0123456789") != std::string_view::npos)
                    return true;
            }
            return false;
        };
        if (!isOpen(a) && !isOpen(b)) return false;
        return a.substr(0, a.find('[')) == b.substr(0, b.find('['));
    }

    void compare(Table& table, const std::string& name, const Unit& unit, std::uint32_t at,
                 const std::string& type) {
        const auto [found, isNew] = table.emplace(name, Declared{type, &unit, at});
        const Declared& first = found->second;
        if (isNew || first.unit == &unit || mayBeEqual(first.type, type)) return;
        // A stage lists the members of a structure only for the comparison.
        const auto shown = [](const std::string& text) {
            if (text.starts_with("{")) return text;
            const std::size_t brace = text.find(" {");
            const std::size_t end = text.rfind('}');
            return brace == std::string::npos ? text : text.substr(0, brace) + text.substr(end + 1);
        };
        const bool isSame = shown(first.type) == shown(type);
        program_.report.report("glsl-E02",
                               "'" + name + "' is " + (isSame ? first.type : shown(first.type)) + " in " +
                                   shortPlace(first.unit->place(first.at)) + " and " +
                                   (isSame ? type : shown(type)) + " in " + shortPlace(unit.place(at)),
                               unit.place(at));
    }

    ProgramUnits& program_;
    Table variables_, uniformBlocks_, storageBlocks_;
};

}  // namespace

void checkUniformTypes(ProgramUnits& program) {
    if (program.units.size() > 1) Comparison(program).run();
}

// Uniforms of type int or float that are passed to a texture function as its sampler (language, 7.9).

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
