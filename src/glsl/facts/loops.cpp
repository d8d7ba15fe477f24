// The loops of a stage whose rounds follow from constants and uniforms. They are reported where a driver
// would end a loop early without a message (draw-W08).

#include <algorithm>
#include <functional>
#include <unordered_map>

#include "glsl/facts/facts.h"
#include "glsl/facts/formula.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepestLoop = 24;

std::optional<Formula> negated(std::optional<Formula> formula) {
    if (formula) formula->steps.emplace_back(Operation::negate);
    return formula;
}

/// What is known about a variable that may count the rounds of a loop, by its name.
struct Counter {
    std::function<std::optional<Formula>(std::string_view name)> first;  ///< its value before the first round
    std::function<std::optional<Formula>(std::string_view name)> step;   ///< what each round adds to it
    std::function<bool(std::string_view name)> isKept;  ///< only the condition itself may change it
};

class LoopSearch {
  public:
    explicit LoopSearch(const Unit& unit) : unit_(unit), search_(unit) {
        for (const Declaration& each : unit.syntax.declarations) {
            if (each.kind != DeclarationKind::function) continue;
            const auto [entry, isNew] = functions_.try_emplace(text(each.name), &each);
            if (!isNew) entry->second = nullptr;
        }
    }

    LoopFacts find() {
        const Declaration* main = function("main");
        if (main == nullptr) return {};
        std::vector<CountedLoop> loops;
        loopsIn(main->code, 0, true, loops);
        if (!search_.spend(0)) leaveOpen(main->name);
        return {std::move(loops), emitsIn(main->code, 0), std::move(uncounted_)};
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] WordRole role(std::uint32_t at) const { return unit_.bodies.roles[at]; }
    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }
    [[nodiscard]] Bodies::Children children(std::uint32_t id) const { return unit_.bodies.children(id); }
    [[nodiscard]] bool isName(std::uint32_t id, std::string_view name) const {
        return node(id).kind == NodeKind::name && text(node(id).token) == name;
    }

    /// The definition of that name, if there is only one.
    [[nodiscard]] const Declaration* function(std::string_view name) const {
        const auto found = functions_.find(name);
        return found == functions_.end() ? nullptr : found->second;
    }

    /// True if a function of that name has a loop, or calls a function, in any of its overloads.
    [[nodiscard]] bool hasLoops(std::string_view name) const {
        if (!functions_.contains(name)) return false;
        return std::ranges::any_of(unit_.syntax.declarations, [&](const Declaration& each) {
            return each.kind == DeclarationKind::function && text(each.name) == name &&
                   (unit_.hasAny(each.body, {"for", "while", "do"}) || callsIn(each.body));
        });
    }

    /// Notes that what begins at `at` is, or has, a loop that cannot be counted.
    void leaveOpen(std::uint32_t at) {
        const Place place = unit_.place(at);
        if (std::ranges::find(uncounted_, place) == uncounted_.end()) uncounted_.push_back(place);
    }

    /// True if the range calls a function of the stage.
    [[nodiscard]] bool callsIn(Range range) const {
        for (std::uint32_t at = range.first; at < range.end; ++at)
            if (text(at + 1) == "(" && role(at) == WordRole::global && functions_.contains(text(at)))
                return true;
        return false;
    }

    /// Adds the loops in a statement or expression. `isSure`: it is executed whenever main is.
    void loopsIn(std::uint32_t id, int depth, bool isSure, std::vector<CountedLoop>& to) {
        if (id == kNone || !search_.spend(1)) return;
        const Node& it = node(id);
        if (depth > kDeepestLoop) return leaveOpen(it.first);
        if (it.kind == NodeKind::forLoop || it.kind == NodeKind::whileLoop || it.kind == NodeKind::doLoop)
            return loopAt(id, depth, isSure, to);
        if (it.kind == NodeKind::call && role(it.token) == WordRole::global) {
            if (const Declaration* called = function(text(it.token)))
                loopsIn(called->code, depth + 1, isSure, to);
            else if (hasLoops(text(it.token)))
                leaveOpen(it.token);
        }
        const bool isCondition = it.kind == NodeKind::branch || it.kind == NodeKind::choice;
        for (const std::uint32_t each : children(id)) loopsIn(each, depth, isSure && !isCondition, to);
    }

    /// The loop, or those in it if it cannot be counted.
    void loopAt(std::uint32_t id, int depth, bool isSure, std::vector<CountedLoop>& to) {
        const Node& it = node(id);
        const std::uint32_t body = it.kind == NodeKind::doLoop ? it.child : it.lastChild;
        std::optional<CountedLoop> loop = it.kind == NodeKind::forLoop ? forAt(id, body) : whileAt(id, body);
        const Range head =
            it.kind == NodeKind::doLoop ? Range{node(body).end, it.end} : Range{it.first, node(body).first};
        if (!loop || callsIn(head)) leaveOpen(it.first);
        if (!loop) return loopsIn(body, depth + 1, false, to);
        loopsIn(body, depth + 1, true, loop->inside);
        loop->emits = emitsIn(body, depth + 1);
        loop->isSure = isSure && !unit_.hasAny(node(body).range(), {"break", "return", "continue"});
        to.push_back(std::move(*loop));
    }

    /// The EmitVertex() calls of a statement outside of conditions and loops, also in the functions that it
    /// calls.
    double emitsIn(std::uint32_t id, int depth) {
        if (id == kNone || depth > kDeepestLoop || !search_.spend(1)) return 0;
        const Node& it = node(id);
        if (it.kind >= NodeKind::branch && it.kind <= NodeKind::choice) return 0;
        double emits = 0;
        if (it.kind == NodeKind::call && role(it.token) == WordRole::global) {
            const std::string_view word = text(it.token);
            if (word == "EmitVertex" || word == "EmitStreamVertex") ++emits;
            if (const Declaration* called = function(word)) emits += emitsIn(called->code, depth + 1);
        }
        for (const std::uint32_t each : children(id)) emits += emitsIn(each, depth);
        return emits;
    }

    std::optional<CountedLoop> forAt(std::uint32_t id, std::uint32_t body) {
        if (unit_.bodies.childCount(id) != 4) return std::nullopt;
        const std::uint32_t start = node(id).child, condition = node(start).next, next = node(condition).next;
        const auto step = [&](std::string_view name) {
            if (node(next).kind == NodeKind::empty) return stepInside(name, body);
            return search_.changes(name, node(body).range()) ? std::nullopt : stepOf(name, next);
        };
        const auto first = [&](std::string_view name) {
            const std::optional<Formula> here = firstOf(name, start);
            return here ? here : firstBefore(name, id);
        };
        const Counter counter{first, step, [&](std::string_view name) {
                                  return !search_.changes(name, node(body).range()) &&
                                         !search_.changes(name, node(next).range());
                              }};
        return loopWith(id, body, condition, counter);
    }

    /// A `while` or `do`, whose counter is set before it and changed in its body.
    std::optional<CountedLoop> whileAt(std::uint32_t id, std::uint32_t body) {
        const std::uint32_t condition = node(id).child == body ? node(body).next : node(id).child;
        if (condition == kNone) return std::nullopt;
        const Counter counter{
            [&](std::string_view name) { return firstBefore(name, id); },
            [&](std::string_view name) { return stepInside(name, body); },
            [&](std::string_view name) { return !search_.changes(name, node(body).range()); }};
        return loopWith(id, body, condition, counter);
    }

    /// The loop, counted by the first of its conditions that can be counted; without a condition, by the
    /// first `if (i >= n) break;` of its body.
    std::optional<CountedLoop> loopWith(std::uint32_t id, std::uint32_t body, std::uint32_t condition,
                                        const Counter& counter) {
        if (node(condition).kind != NodeKind::empty && !isName(condition, "true"))
            return comparedIn(id, condition, "&&", counter, false);
        if (node(body).kind != NodeKind::block) return std::nullopt;
        for (const std::uint32_t each : children(body)) {
            if (node(each).kind != NodeKind::branch) continue;
            const std::uint32_t test = node(each).child, then = node(test).next;
            const std::uint32_t leave = node(then).kind == NodeKind::block ? node(then).child : then;
            if (leave == kNone || node(leave).kind != NodeKind::jump ||
                (text(node(leave).token) != "break" && text(node(leave).token) != "return"))
                continue;
            if (std::optional<CountedLoop> loop = comparedIn(id, test, "||", counter, true)) return loop;
        }
        return std::nullopt;
    }

    /// The loop, counted by the first of the comparisons that the operator joins.
    std::optional<CountedLoop> comparedIn(std::uint32_t id, std::uint32_t condition, std::string_view joint,
                                          const Counter& counter, bool ends) {
        const bool areSeveral =
            node(condition).kind == NodeKind::chain && text(node(condition).token) == joint;
        if (!areSeveral) return compared(id, condition, counter, ends);
        for (const std::uint32_t each : children(condition))
            if (std::optional<CountedLoop> loop = compared(id, each, counter, ends)) return loop;
        return std::nullopt;
    }

    /// The loop that goes on while the comparison holds, or `ends` when it does.
    std::optional<CountedLoop> compared(std::uint32_t id, std::uint32_t comparison, const Counter& counter,
                                        bool ends) {
        if (node(comparison).kind != NodeKind::chain || unit_.bodies.childCount(comparison) != 2)
            return std::nullopt;
        const std::uint32_t left = node(comparison).child, right = node(comparison).lastChild;
        const std::string_view sign = text(node(comparison).token);
        const bool isEquality = sign == (ends ? "==" : "!=");
        if (!isEquality && sign != "<" && sign != ">" && sign != "<=" && sign != ">=") return std::nullopt;
        for (const bool isLeft : {true, false}) {
            const std::uint32_t side = isLeft ? left : right;
            std::optional<CountedLoop> loop = counted(side, isLeft ? right : left, counter);
            if (!loop) continue;
            loop->place = unit_.place(node(id).first);
            loop->untilEqual = isEquality;
            loop->falling = ((sign.front() == '>') == isLeft) != ends;
            loop->including = !isEquality && (sign.size() == 2) != ends;
            if (!mayWrap(*loop, text(node(side).first))) return loop;
        }
        return std::nullopt;
    }

    /// True for an unsigned variable that may fall below zero, where it becomes the largest number.
    [[nodiscard]] bool mayWrap(const CountedLoop& loop, std::string_view name) const {
        const LocalVariable* variable = unit_.onlyLocal(name);
        const auto* step =
            loop.step.steps.size() == 2 ? std::get_if<double>(&loop.step.steps.front()) : nullptr;
        const bool isByOne = (step != nullptr && *step == 1) || loop.step.steps == Formula{{-1.}}.steps;
        return loop.falling && variable != nullptr && variable->typeWord == "uint" &&
               (loop.including || !isByOne);
    }

    /// A loop whose condition compares the variable in `side` with `bound`.
    std::optional<CountedLoop> counted(std::uint32_t side, std::uint32_t bound, const Counter& counter) {
        const std::string_view name = text(node(side).first);
        std::optional<Formula> step;
        if (node(side).kind == NodeKind::name)
            step = counter.step(name);
        else if (node(side).kind == NodeKind::step && counter.isKept(name))
            step = stepOf(name, side);  // i++ < n
        if (!step) return std::nullopt;
        std::optional<Formula> first = counter.first(name);
        std::optional<Formula> last = search_.formula(bound);
        if (!first || !last) return std::nullopt;
        CountedLoop loop;
        loop.first = std::move(*first);
        loop.bound = std::move(*last);
        loop.step = std::move(*step);
        return loop;
    }

    /// The value that `int i = 0;` or `i = 0;` gives before the statement in the same block, and which
    /// therefore holds each time that statement begins.
    std::optional<Formula> firstBefore(std::string_view name, std::uint32_t id) {
        const std::uint32_t block = node(id).parent, at = node(id).first;
        if (block == kNone || node(block).kind != NodeKind::block || text(at - 1) == ":") return std::nullopt;
        std::uint32_t value = kNone;
        for (const std::uint32_t each : children(block)) {
            if (each == id || !search_.spend(1)) break;
            if (const std::uint32_t given = valueGiven(name, each); given != kNone) value = given;
        }
        if (value == kNone || search_.changes(name, {node(value).end, at})) return std::nullopt;
        return search_.formula(value);
    }
    /// What a declaration or an assignment gives the variable; kNone if it does not.
    [[nodiscard]] std::uint32_t valueGiven(std::string_view name, std::uint32_t id) const {
        const Node& it = node(id);
        if (it.kind == NodeKind::evaluation) return valueGiven(name, it.child);
        if (it.kind == NodeKind::assignment)
            return text(it.token) == "=" && isName(it.child, name) ? it.lastChild : kNone;
        if (it.kind != NodeKind::declaration) return kNone;
        for (const std::uint32_t each : children(id))
            if (text(node(each).token) == name) return node(each).child;
        return kNone;
    }

    /// What the only statement of the body that changes the variable adds to it, if every round executes it.
    std::optional<Formula> stepInside(std::string_view name, std::uint32_t body) {
        const Range range = node(body).range();
        if (range.empty() || !search_.spend(range.end - range.first)) return std::nullopt;
        int writes = 0;
        for (std::uint32_t at = range.first; at < range.end; ++at) {
            if (text(at) == "continue") return std::nullopt;
            if (search_.isChange(name, at)) ++writes;
        }
        if (writes != 1) return std::nullopt;
        const auto stepIn = [&](std::uint32_t id) {
            return node(id).kind == NodeKind::evaluation ? stepOf(name, node(id).child) : std::nullopt;
        };
        if (node(body).kind != NodeKind::block) return stepIn(body);
        for (const std::uint32_t each : children(body))
            if (std::optional<Formula> step = stepIn(each)) return step;
        return std::nullopt;
    }

    /// The initial value of the variable in `int i = 0, j = 9`.
    std::optional<Formula> firstOf(std::string_view name, std::uint32_t start) {
        std::uint32_t value = valueGiven(name, start);
        if (node(start).kind == NodeKind::sequence)
            for (const std::uint32_t each : children(start))
                if (value == kNone) value = valueGiven(name, each);
        return value == kNone ? std::nullopt : search_.formula(value);
    }

    /// What `++i, j -= 2` adds to the variable.
    std::optional<Formula> stepOf(std::string_view name, std::uint32_t id) {
        const Node& it = node(id);
        if (it.kind == NodeKind::sequence)
            for (const std::uint32_t each : children(id))
                if (std::optional<Formula> step = stepOf(name, each)) return step;
        const bool isStep = (it.kind == NodeKind::step || it.kind == NodeKind::prefix) &&
                            it.end == it.first + 2 && isName(it.child, name);
        if (isStep && text(it.token) == "++") return Formula{{1.}};
        if (isStep && text(it.token) == "--") return Formula{{-1.}};
        if (it.kind != NodeKind::assignment || !isName(it.child, name)) return std::nullopt;
        const std::string_view sign = text(it.token);
        if (sign == "+=") return search_.formula(it.lastChild);
        if (sign == "-=") return negated(search_.formula(it.lastChild));
        const Node& sum = node(it.lastChild);
        if (sign != "=" || sum.kind != NodeKind::chain || !isName(sum.child, name)) return std::nullopt;
        if (text(sum.token) == "+") return search_.formula(it.lastChild, true);
        const bool isDifference = text(sum.token) == "-" && sum.end == sum.first + 3;
        return isDifference ? negated(search_.formula(sum.lastChild)) : std::nullopt;
    }

    const Unit& unit_;
    FormulaSearch search_;
    std::vector<Place> uncounted_;
    std::unordered_map<std::string_view, const Declaration*> functions_;  ///< null: several of that name
};

}  // namespace

LoopFacts loopsOf(const Unit& unit) {
    return LoopSearch(unit).find();
}

}  // namespace glibra::glsl
