// Loops note that the driver has ended them (ProgramRequest::recordsLoops). A shader cannot see it in the
// values of its variables: after a loop the compiler takes the condition for false. So the condition also
// goes into an array whose subscript the compiler does not know.

#include <algorithm>
#include <string>
#include <vector>

#include "glsl/facts/facts.h"
#include "glsl/parse/statements.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// Adds the places of the loops that compilers unroll. Their rounds do not count.
void addUnrolled(const std::vector<CountedLoop>& loops, std::vector<Place>& to) {
    for (const CountedLoop& each : loops) {
        if (isUnrolled(each)) to.push_back(each.place);
        addUnrolled(each.inside, to);
    }
}

class LoopRecorder {
  public:
    LoopRecorder(Unit& unit, std::vector<Place>& sites) : unit_(unit), statements_(unit), sites_(sites) {
        addUnrolled(loopsOf(unit).loops, unrolled_);
    }

    /// False: the stage has no loop.
    bool run() {
        const std::size_t before = sites_.size();
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::function) visit(each.body);
        return sites_.size() > before;
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return unit_.bodies.matches[at]; }
    [[nodiscard]] std::uint32_t raw(std::uint32_t at) const { return unit_.view[at].raw; }

    /// The index after the loop at `at`.
    [[nodiscard]] std::uint32_t endOf(std::uint32_t at, std::uint32_t end) const {
        return std::min(text(at) == "do" ? statements_.afterDo(at, end) + 1 : statements_.end(at, end), end);
    }

    void visit(Range range) {
        for (std::uint32_t at = range.first; at < range.end; ++at) {
            if (!statements_.isLoop(at)) continue;
            const std::uint32_t end = endOf(at, range.end);
            visit(statements_.body(at, range.end));  // inner brackets come first
            record(at, end, range.end);
            at = end - 1;
        }
    }

    void record(std::uint32_t at, std::uint32_t end, std::uint32_t limit) {
        const Place place = unit_.place(at);
        const Range head = headOf(at, limit);
        if (head.empty() || head.end > end || std::ranges::find(unrolled_, place) != unrolled_.end()) return;
        const std::string site = std::to_string(sites_.size());
        const std::string inLoop = "glibra_inLoop[" + site + " + glibra_NoLoop]";
        sites_.push_back(place);
        markBreaks(statements_.body(at, limit), inLoop);
        markCondition(conditionOf(at, head), site);
        unit_.edits.before(raw(at), "{ ");
        unit_.edits.after(raw(end - 1), " if (" + inLoop + " != 0) glibra_cutLoops[" + site + "] = 1; }");
    }

    /// The brackets of the loop's condition.
    [[nodiscard]] Range headOf(std::uint32_t at, std::uint32_t limit) const {
        const std::uint32_t open = text(at) == "do" ? statements_.body(at, limit).end + 1 : at + 1;
        if (text(open) != "(" || match(open) >= limit) return {};
        return {open, match(open) + 1};
    }

    /// From the token before the condition to the token after it.
    [[nodiscard]] Range conditionOf(std::uint32_t at, Range head) const {
        if (text(at) != "for") return head;
        std::uint32_t first = head.first + 1;
        while (first < head.end && text(first) != ";") ++first;
        std::uint32_t last = first + 1;
        while (last < head.end && text(last) != ";") ++last;
        return {first, std::min(last + 1, head.end)};
    }

    void markCondition(Range condition, const std::string& site) {
        std::uint32_t before = condition.first;
        const bool isEmpty = condition.end - condition.first <= 2;
        // while (bool goesOn = f()), or with const before it
        for (std::uint32_t name = before + 2; name < std::min(before + 4, condition.end - 1); ++name)
            if (unit_.bodies.roles[name] == WordRole::localDeclaration) {
                before = name + 1;
                break;
            }
        unit_.edits.after(raw(before), isEmpty ? " glibra_goes(true" : " glibra_goes(");
        unit_.edits.before(raw(condition.end - 1), ", " + site + ")");
    }

    void markBreaks(Range body, const std::string& inLoop) {
        for (std::uint32_t at = body.first; at < body.end; ++at) {
            if (statements_.isLoop(at)) {
                at = endOf(at, body.end) - 1;
            } else if (text(at) == "switch" && text(at + 1) == "(") {
                at = statements_.end(at, body.end) - 1;
            } else if (text(at) == "break" && text(at + 1) == ";") {
                unit_.edits.before(raw(at), "{ " + inLoop + " = 0; ");
                unit_.edits.after(raw(at + 1), " }");
            }
        }
    }

    Unit& unit_;
    Statements statements_;
    std::vector<Place>& sites_;
    std::vector<Place> unrolled_;
};

}  // namespace

void recordCutLoops(ProgramUnits& program) {
    if (!program.request->recordsLoops || program.request->target.version < 430) return;
    std::vector<Place>& sites = program.result->loopSites;
    std::vector<Unit*> recorded;
    for (Unit& unit : program.units)
        if (LoopRecorder(unit, sites).run()) recorded.push_back(&unit);
    for (Unit* unit : recorded) {
        unit->declare("layout(std430) buffer glibra_CutLoops { int glibra_cutLoops[]; };");
        unit->declare("uniform int glibra_NoLoop;");  // it is 0
        unit->declare("int glibra_inLoop[" + std::to_string(sites.size()) + "];");
        unit->declare(
            "bool glibra_goes(bool on, int site) { glibra_inLoop[site + glibra_NoLoop] = int(on); return on; "
            "}");
        const bool isQuiet =
            std::ranges::none_of(program.units, [](const Unit& each) { return writesMemory(each); });
        // Hidden fragments stay out, as they do where nothing is recorded.
        if (unit->stage == Stage::fragment && isQuiet && !unit->isUsed("gl_FragDepth"))
            unit->declare("layout(early_fragment_tests) in;");
    }
}

}  // namespace glibra::glsl
