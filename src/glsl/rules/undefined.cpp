// What GLSL leaves open gets a definition.

// Variables without a value are zero on every driver (language, 7.13). GLSL leaves their values open, and
// drivers differ. Drivers remove the stores that nothing reads.

#include <optional>
#include <set>
#include <string>

#include "glsl/facts/assignment.h"
#include "glsl/parse/variables.h"
#include "glsl/read/words.h"
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

// Limits the subscripts of `shared` variables to their sizes, because a store outside one ends the process on
// some drivers. `a[i]` becomes `a[glibra_within(i, a.length())]`, and `s[i].m[j]` becomes
// `s[glibra_within(i, s.length())].m[glibra_within(j, s[0].m.length())]`: sizes are constant expressions, and
// every subscript is evaluated once. Constant subscripts stay, because compilers check them.

namespace {

class SharedArrays {
  public:
    SharedArrays(Unit& unit, TranslatedProgram& result, Report& report)
        : unit_(unit), result_(result), report_(report) {}

    void run() {
        for (const Variable& each : unit_.variables) {
            if (each.storage != Storage::shared || each.removed) continue;
            const auto uses = unit_.uses.find(each.name);
            if (uses == unit_.uses.end()) continue;
            for (const std::uint32_t at : uses->second) use(at);
        }
        if (limited_.empty()) return;
        // So that a message about a subscript of another type reads "no function 'subscript(float, int)'".
        result_.userNames["glibra_within"] = "subscript";
        unit_.declare("int glibra_within(int i, int size) { return clamp(i, 0, size - 1); }");
        unit_.declare("uint glibra_within(uint i, int size) { return min(i, uint(size - 1)); }");
    }

  private:
    /// Limits the subscripts after the name at `at`.
    void use(std::uint32_t at) {
        std::string path = spelled(unit_, std::string(unit_.text(at)));
        std::uint32_t first = at++;
        while (at < unit_.view.size()) {
            const std::string_view text = unit_.text(at);
            if (text == "[") {
                const std::uint32_t close = unit_.bodies.matches[at];
                if (close >= unit_.view.size()) return;
                subscript(at, close, path);
                path += "[0]";
                at = close + 1;
            } else if (text == "." && unit_.text(at + 2) != "(") {
                path += "." + member(unit_.text(at + 1));
                at += 2;
            } else if (text == ")" && first > 0 && unit_.text(first - 1) == "(" && !isCall(first - 1)) {
                --first;
                ++at;
            } else {
                return;
            }
        }
    }

    [[nodiscard]] bool isCall(std::uint32_t open) const {
        if (open == 0) return false;
        const ViewToken& before = unit_.view[open - 1];
        return before.text == "]" || (before.kind == TokenKind::word && !isStatementWord(before.text));
    }
    /// `renames` do not count after a '.'.
    [[nodiscard]] std::string member(std::string_view word) const {
        const auto found = unit_.wordRenames.find(word);
        return found == unit_.wordRenames.end() ? std::string(word) : found->second;
    }

    /// True for literals, constants at file scope, and what is computed from them.
    [[nodiscard]] bool isConstant(Range range) {
        for (std::uint32_t at = range.first; at < range.end; ++at) {
            const ViewToken& token = unit_.view[at];
            if (token.kind != TokenKind::word) continue;
            const Variable* variable =
                unit_.bodies.roles[at] == WordRole::global ? unit_.variable(token.text) : nullptr;
            if (!variable || variable->storage != Storage::constant || variable->isArray()) return false;
        }
        return true;
    }

    void subscript(std::uint32_t open, std::uint32_t close, const std::string& size) {
        const Range inside{open + 1, close};
        if (inside.empty() || isConstant(inside)) return;
        if (unit_.text(close) != "]") {
            report_.reportOnce(unit_.path + std::to_string(unit_.view[open].raw), "glsl-E03",
                               "this subscript of a shared array cannot be limited to the size of the array; "
                               "write '[' and ']' with what is before them in one place",
                               unit_.place(open));
            return;
        }
        if (!limited_.insert(open).second) return;
        // Brackets around a subscript with a comma, `a[i, j]`, keep it one argument.
        const bool hasComma = unit_.hasAny(inside, {","});
        unit_.edits.after(unit_.view[open].raw, hasComma ? "glibra_within((" : "glibra_within(");
        unit_.edits.before(unit_.view[close].raw, std::string(hasComma ? "), " : ", ") + size + ".length())");
    }

    Unit& unit_;
    TranslatedProgram& result_;
    Report& report_;
    std::set<std::uint32_t> limited_;  ///< the opening brackets
};

}  // namespace

void limitSharedSubscripts(Unit& unit, TranslatedProgram& result, Report& report) {
    if (unit.stage == Stage::compute) SharedArrays(unit, result, report).run();
}

}  // namespace glibra::glsl
