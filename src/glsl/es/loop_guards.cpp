#include "glsl/es/loop_guards.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"

namespace glibra::glsl {
namespace {

constexpr double kMostCost = 1e5;

class LoopGuard {
  public:
    LoopGuard(Unit& unit, std::string_view cut, std::size_t before)
        : unit_(unit), cut_(cut), before_(before) {
        addCounted(loopsOf(unit).loops);
    }

    std::vector<std::uint32_t> run() {
        costOfFunction("main");  // finds the functions that it calls
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::function && each.code != kNone &&
                functions_.contains(text(each.name)))
                visit(each.code);
        return std::move(loops_);
    }

  private:
    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t raw(std::uint32_t at) const { return unit_.view[at].raw; }
    [[nodiscard]] bool isLoop(std::uint32_t id) const {
        return node(id).kind >= NodeKind::forLoop && node(id).kind <= NodeKind::doLoop;
    }
    [[nodiscard]] std::uint32_t bodyOf(const Node& loop) const {
        return loop.kind == NodeKind::doLoop ? loop.child : loop.lastChild;
    }

    /// Notes the constant numbers of rounds; 0 for those that compilers unroll, as they count natively.
    void addCounted(const std::vector<CountedLoop>& loops) {
        for (const CountedLoop& each : loops) {
            const double rounds = roundsOf(each, [](std::string_view) { return std::nullopt; });
            if (rounds > 0) rounds_[{each.place.line, each.place.column}] = isUnrolled(each) ? 0 : rounds;
            addCounted(each.inside);
        }
    }

    /// The rounds of the short loops in a statement or expression, and in the functions that it calls.
    double costOf(std::uint32_t id) {
        if (id == kNone) return 0;
        const Node& it = node(id);
        double cost = 0;
        for (const std::uint32_t each : unit_.bodies.children(id)) cost += costOf(each);
        if (it.kind == NodeKind::call && unit_.bodies.roles[it.token] == WordRole::global)
            cost += costOfFunction(text(it.token));
        if (isLoop(id)) cost = roundsOfShort(it, cost).value_or(0);
        return std::min(cost, kMostCost);
    }

    double costOfFunction(std::string_view name) {
        const auto [known, isNew] = functions_.try_emplace(name, 0);
        if (!isNew) return known->second;
        double most = 0;
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::function && text(each.name) == name)
                most = std::max(most, costOf(each.code));
        return functions_[name] = most;
    }

    /// `inside`: of one round. Nothing if the loop is not short.
    [[nodiscard]] std::optional<double> roundsOfShort(const Node& loop, double inside) const {
        const Place place = unit_.place(loop.first);
        const auto known = rounds_.find({place.line, place.column});
        if (known == rounds_.end()) return std::nullopt;
        const double all = known->second * (1 + inside);
        return all <= kShortRounds ? std::optional(all) : std::nullopt;
    }

    void visit(std::uint32_t id) {
        for (const std::uint32_t each : unit_.bodies.children(id)) visit(each);  // inner brackets come first
        if (!isLoop(id)) return;
        const Node& loop = node(id);
        const std::uint32_t body = bodyOf(loop);
        const double inside = costOf(body);
        const bool isDo = loop.kind == NodeKind::doLoop;
        const std::uint32_t open = isDo ? node(body).end + 1 : loop.first + 1;
        if (roundsOfShort(loop, inside) || text(open) != "(" || unit_.bodies.matches[open] >= loop.end)
            return;
        loops_.push_back(loop.first);
        const std::size_t number = std::min<std::size_t>(before_ + loops_.size(), kMostSites);
        guard(conditionOf(unit_, loop, {open, unit_.bodies.matches[open] + 1}),
              fmt::format("((glibra_rounds += {0}) <= {1} || ({2} = {2} == 0 ? {3} : {2}) == -2)",
                          1 + static_cast<int>(inside), kRounds, cut_, number));
    }

    void guard(Range condition, const std::string& goesOn) {
        const std::uint32_t before = beforeValue(unit_, condition);
        const bool isEmpty = condition.end - condition.first <= 2;
        unit_.edits.after(raw(before), isEmpty ? " " + goesOn : " (");
        if (!isEmpty) unit_.edits.before(raw(condition.end - 1), ") && " + goesOn);
    }

    Unit& unit_;
    std::string_view cut_;
    std::size_t before_;
    std::map<std::pair<int, int>, double> rounds_;  ///< by line and column
    std::map<std::string_view, double> functions_;
    std::vector<std::uint32_t> loops_;
};

}  // namespace

std::vector<std::uint32_t> guardLoops(Unit& unit, std::string_view cut, std::size_t before) {
    std::vector<std::uint32_t> loops = LoopGuard(unit, cut, before).run();
    if (loops.empty()) return loops;
    unit.declare("int glibra_rounds = 0;");
    unit.declare(fmt::format("uniform int {};", kRounds));
    return loops;
}

}  // namespace glibra::glsl
