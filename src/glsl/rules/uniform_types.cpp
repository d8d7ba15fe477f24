// A uniform or block that several stages declare must have the same type in each of them (GLSL 4.50, 4.3.5
// and 4.3.9). Some drivers compare only what the stages use, so the comparison is made here (language, 7.9).

#include <algorithm>

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

}  // namespace glibra::glsl
