// Loops note that the driver has ended them (ProgramRequest::recordsLoops). A shader cannot see it in the
// values of its variables: after a loop the compiler takes the condition for false. So the condition also
// goes into an array whose subscript the compiler does not know.

#include <algorithm>
#include <string>
#include <vector>

#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"
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
    LoopRecorder(Unit& unit, std::vector<Place>& sites) : unit_(unit), sites_(sites) {
        addUnrolled(loopsOf(unit).loops, unrolled_);
    }

    /// False: the stage has no loop.
    bool run() {
        const std::size_t before = sites_.size();
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::function && each.code != kNone) visit(each.code);
        return sites_.size() > before;
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return unit_.bodies.matches[at]; }
    [[nodiscard]] std::uint32_t raw(std::uint32_t at) const { return unit_.view[at].raw; }

    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }
    [[nodiscard]] bool isLoop(std::uint32_t id) const {
        const NodeKind kind = node(id).kind;
        return kind == NodeKind::forLoop || kind == NodeKind::whileLoop || kind == NodeKind::doLoop;
    }

    void visit(std::uint32_t id) {
        for (const std::uint32_t each : unit_.bodies.children(id)) visit(each);  // inner brackets come first
        if (isLoop(id)) record(id);
    }

    void record(std::uint32_t id) {
        const Node& loop = node(id);
        const Place place = unit_.place(loop.first);
        const bool isDo = loop.kind == NodeKind::doLoop;
        const std::uint32_t body = isDo ? loop.child : loop.lastChild;
        const std::uint32_t open = isDo ? node(body).end + 1 : loop.first + 1;
        if (text(open) != "(" || match(open) >= loop.end ||
            std::ranges::find(unrolled_, place) != unrolled_.end())
            return;
        const std::string site = std::to_string(sites_.size());
        const std::string inLoop = "glibra_inLoop[" + site + " + glibra_NoLoop]";
        sites_.push_back(place);
        markBreaks(body, inLoop);
        markCondition(conditionOf(unit_, loop, {open, match(open) + 1}), site);
        unit_.edits.before(raw(loop.first), "{ ");
        unit_.edits.after(raw(loop.end - 1),
                          " if (" + inLoop + " != 0) glibra_cutLoops[" + site + "] = 1; }");
    }

    void markCondition(Range condition, const std::string& site) {
        const std::uint32_t before = beforeValue(unit_, condition);
        const bool isEmpty = condition.end - condition.first <= 2;
        unit_.edits.after(raw(before), isEmpty ? " glibra_goes((true" : " glibra_goes((");
        unit_.edits.before(raw(condition.end - 1), "), " + site + ")");
    }

    void markBreaks(std::uint32_t id, const std::string& inLoop) {
        const Node& it = node(id);
        if (isLoop(id) || it.kind == NodeKind::choice) return;
        for (const std::uint32_t each : unit_.bodies.children(id)) markBreaks(each, inLoop);
        if (it.kind != NodeKind::jump || text(it.first) != "break" || text(it.first + 1) != ";") return;
        unit_.edits.before(raw(it.first), "{ " + inLoop + " = 0; ");
        unit_.edits.after(raw(it.first + 1), " }");
    }

    Unit& unit_;
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
