// Variables without a value are zero on every driver (language, 7.13). GLSL leaves their values open, and
// drivers differ. Drivers remove the stores that nothing reads.

#include <optional>
#include <string>

#include "glsl/facts/assignment.h"
#include "glsl/parse/variables.h"
#include "glsl/parse/zero.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// Longer arrays are filled by a loop, because compilers are slow with long constructors.
constexpr int kMostListed = 64;

class InitialValues {
  public:
    explicit InitialValues(Unit& unit) : unit_(unit) {}

    void run(const Assignments& found) {
        for (const Unassigned& each : found.variables) {
            if (each.kind == Unassigned::Kind::local)
                local(each);
            else
                assignment(each);
        }
        for (const Declaration* each : found.withoutReturn) {
            const auto value = zeroValue(unit_, std::string(each->type.name),
                                         sizeTexts(unit_, {}, each->type.dimensions), kMostListed);
            if (value) unit_.edits.before(unit_.view[each->body.end - 1].raw, "return " + *value + "; ");
        }
        for (Variable& each : unit_.variables) global(each);
    }

  private:
    void local(const Unassigned& variable) {
        if (const auto value = zeroValue(unit_, variable.type, variable.sizes, kMostListed))
            unit_.edits.after(unit_.view[variable.at].raw, " = " + *value);
        else if (variable.statementEnd != kNone)
            unit_.edits.after(unit_.view[variable.statementEnd].raw, filling(variable));
    }

    /// A loop that fills an array.
    [[nodiscard]] std::string filling(const Unassigned& variable) const {
        const auto value = variable.sizes.size() == 1 ? zeroValue(unit_, variable.type, {}) : std::nullopt;
        if (!value) return {};
        const std::string name = spelled(unit_, variable.name);
        return " for (int glibra_i = 0; glibra_i < " + name + ".length(); ++glibra_i) " + name +
               "[glibra_i] = " + *value + ";";
    }

    void assignment(const Unassigned& variable) {
        // The depth that the pixel has without an assignment
        const bool isDepth = variable.kind == Unassigned::Kind::output && variable.name == "gl_FragDepth";
        const auto value = isDepth ? std::optional<std::string>("gl_FragCoord.z")
                                   : zeroValue(unit_, variable.type, variable.sizes, kMostListed);
        const std::size_t end = variable.name.find_first_of(".[");
        const std::string name = spelled(unit_, variable.name.substr(0, end)) +
                                 (end == std::string::npos ? std::string() : variable.name.substr(end));
        const std::string text = value ? " " + name + " = " + *value + ";" : filling(variable);
        unit_.edits.after(unit_.view[variable.at].raw, text);
    }

    void global(Variable& variable) const {
        const Declaration& declaration = unit_.syntax.declarations[variable.declaration];
        const Declarator& declarator = declaration.declarators[variable.declarator];
        if (variable.storage != Storage::none || variable.removed || !variable.initializer.empty() ||
            !declarator.initializer.empty() || variable.name.starts_with("gl_"))
            return;
        if (const auto value = zeroValue(
                unit_, variable.type, sizeTexts(unit_, declarator.dimensions, declaration.type.dimensions)))
            variable.initializer = " = " + *value;
    }

    Unit& unit_;
};

void reportGlobals(const Unit& unit, Report& report) {
    for (const Variable& each : unit.variables) {
        const Declaration& declaration = unit.syntax.declarations[each.declaration];
        const bool isGiven = each.storage != Storage::none || each.removed || !each.initializer.empty() ||
                             !declaration.declarators[each.declarator].initializer.empty();
        if (isGiven || each.name.starts_with("gl_") || !unit.isUsed(each.name) || unit.isWritten(each.name) ||
            !zeroValue(unit, each.type, {}))
            continue;
        report.report("glsl-W28", "'" + each.name + "' is read, but nothing gives it a value; it is 0",
                      unit.place(unit.uses.find(each.name)->second.front()));
    }
}

void report(const Unit& unit, const Assignments& found, Report& report) {
    for (const FirstRead& each : found.reads)
        report.report("glsl-W28",
                      "'" + each.name + "' is read before it has a value; give it one where it is declared",
                      unit.place(each.at));
    for (const Declaration* each : found.withoutReturn)
        report.report(
            "glsl-W28",
            "'" + std::string(unit.text(each->name)) + "' may end without a 'return'; its value is 0 then",
            unit.place(each->name));
    reportGlobals(unit, report);
}

}  // namespace

void giveInitialValues(Unit& unit, Report& log) {
    const Assignments found = findUnassigned(unit);
    report(unit, found, log);
    InitialValues(unit).run(found);
}

void reportUnassigned(const Unit& unit, Report& log) {
    report(unit, findUnassigned(unit), log);
}

}  // namespace glibra::glsl
