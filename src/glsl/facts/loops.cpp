// The loops of a stage whose rounds follow from constants and uniforms. They are reported where a driver
// would end a loop early without a message (draw-W08).

#include <algorithm>
#include <functional>
#include <iterator>
#include <unordered_map>

#include "glsl/facts/facts.h"
#include "glsl/facts/formula.h"
#include "glsl/parse/statements.h"

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
    explicit LoopSearch(const Unit& unit) : unit_(unit), search_(unit), statements_(unit) {
        for (const Declaration& each : unit.syntax.declarations) {
            if (each.kind != DeclarationKind::function) continue;
            const auto [entry, isNew] = functions_.try_emplace(text(each.name), &each);
            if (!isNew) entry->second = nullptr;
        }
    }

    LoopFacts find() {
        const Declaration* main = function("main");
        if (main == nullptr) return {};
        std::vector<CountedLoop> loops = loopsIn(main->body, 0, true);
        if (!search_.spend(0)) leaveOpen(main->name);
        return {std::move(loops), emitsIn(main->body, 0), std::move(uncounted_)};
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return search_.match(at); }
    [[nodiscard]] WordRole role(std::uint32_t at) const { return unit_.bodies.roles[at]; }

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

    /// `isSure`: the range is executed whenever main is.
    std::vector<CountedLoop> loopsIn(Range range, int depth, bool isSure) {
        std::vector<CountedLoop> loops;
        if (depth > kDeepestLoop) {
            if (!range.empty()) leaveOpen(range.first);
            return loops;
        }
        const auto take = [&loops](std::vector<CountedLoop> more) {
            std::move(more.begin(), more.end(), std::back_inserter(loops));
        };
        std::uint32_t conditional = range.first;  // the end of the last `if` or `switch`
        for (std::uint32_t at = range.first; at < range.end && search_.spend(1); ++at) {
            const bool isSureHere = isSure && at >= conditional;
            if (text(at) == "do" && search_.isWord(at)) {
                take(loopAt(at, range.end, depth, isSureHere));
                at = std::max(at, statements_.afterDo(at, range.end) - 1);
                continue;
            }
            if (!search_.isWord(at) || text(at + 1) != "(" || match(at + 1) >= range.end) continue;
            // What is inside of one that was found ends with it.
            if (at >= conditional && (text(at) == "if" || text(at) == "switch"))
                conditional = statements_.end(at, range.end);
            if (text(at) == "for" || text(at) == "while") {
                take(loopAt(at, range.end, depth, isSureHere));
                at = std::max(at, statements_.body(at, range.end).end - 1);
            } else if (role(at) == WordRole::global) {
                if (const Declaration* called = function(text(at)))
                    take(loopsIn(called->body, depth + 1, isSureHere));
                else if (hasLoops(text(at)))
                    leaveOpen(at);
            }
        }
        return loops;
    }

    /// The loop at `at`, or those in it if it cannot be counted.
    std::vector<CountedLoop> loopAt(std::uint32_t at, std::uint32_t end, int depth, bool isSure) {
        const Range body = statements_.body(at, end);
        std::optional<CountedLoop> loop = text(at) == "for"     ? forAt(at, body)
                                          : text(at) == "while" ? whileAt(at, body)
                                                                : doAt(at, body, end);
        const std::uint32_t head = text(at) == "do" ? body.end : at;
        const std::uint32_t headEnd =
            text(at) == "do" ? statements_.afterDo(at, end) : statements_.afterHead(at, end);
        if (!loop || callsIn({head, headEnd})) leaveOpen(at);
        if (!loop) return loopsIn(body, depth + 1, false);
        loop->inside = loopsIn(body, depth + 1, true);
        loop->emits = emitsIn(body, depth + 1);
        loop->isSure = isSure && !unit_.hasAny(body, {"break", "return", "continue"});
        return {std::move(*loop)};
    }

    /// The EmitVertex() calls of a range outside of conditions and loops, also in the functions that it
    /// calls.
    double emitsIn(Range range, int depth) {
        double emits = 0;
        if (depth > kDeepestLoop) return emits;
        for (std::uint32_t at = range.first; at < range.end && search_.spend(1); ++at) {
            const std::string_view word = text(at);
            if (!search_.isWord(at)) continue;
            if (word == "do") {
                at = std::max(at, statements_.afterDo(at, range.end) - 1);
            } else if (statements_.afterHead(at, range.end) > at) {
                at = std::max(at, statements_.end(at, range.end) - 1);
            } else if (text(at + 1) == "(" && role(at) == WordRole::global) {
                if (word == "EmitVertex" || word == "EmitStreamVertex") ++emits;
                if (const Declaration* called = function(word)) emits += emitsIn(called->body, depth + 1);
            }
        }
        return emits;
    }

    std::optional<CountedLoop> forAt(std::uint32_t at, Range body) {
        const std::vector<Range> head = search_.parts({at + 2, match(at + 1)}, ";");
        if (head.size() != 3) return std::nullopt;
        const auto step = [&](std::string_view name) {
            if (head[2].empty()) return stepInside(name, body);
            return search_.changes(name, body) ? std::nullopt : stepOf(name, head[2]);
        };
        const auto first = [&](std::string_view name) {
            const std::optional<Formula> here = firstOf(name, head[0]);
            return here ? here : firstBefore(name, at);
        };
        const Counter counter{first, step, [&](std::string_view name) {
                                  return !search_.changes(name, body) && !search_.changes(name, head[2]);
                              }};
        return isAlwaysTrue(head[1]) ? loopUntil(at, body, counter) : loopWhile(at, head[1], counter);
    }

    std::optional<CountedLoop> whileAt(std::uint32_t at, Range body) {
        return loopWith(at, body, {at + 2, match(at + 1)});
    }

    std::optional<CountedLoop> doAt(std::uint32_t at, Range body, std::uint32_t end) {
        const std::uint32_t after = statements_.afterDo(at, end);
        if (after <= body.end) return std::nullopt;
        return loopWith(at, body, {body.end + 2, after - 1});
    }

    /// A loop whose counter is set before it and changed in its body.
    std::optional<CountedLoop> loopWith(std::uint32_t at, Range body, Range condition) {
        const Counter counter{[&](std::string_view name) { return firstBefore(name, at); },
                              [&](std::string_view name) { return stepInside(name, body); },
                              [&](std::string_view name) { return !search_.changes(name, body); }};
        return isAlwaysTrue(condition) ? loopUntil(at, body, counter) : loopWhile(at, condition, counter);
    }

    [[nodiscard]] bool isAlwaysTrue(Range condition) const {
        return condition.empty() || (condition.end == condition.first + 1 && text(condition.first) == "true");
    }

    /// A loop without a condition, counted by the first `if (i >= n) break;` of its body that can be counted.
    std::optional<CountedLoop> loopUntil(std::uint32_t at, Range body, const Counter& counter) {
        if (body.empty() || text(body.first) != "{") return std::nullopt;
        for (std::uint32_t here = body.first + 1; here < body.end; here = statements_.end(here, body.end)) {
            if (text(here) != "if" || text(here + 1) != "(" || match(here + 1) >= body.end) continue;
            const std::uint32_t then = match(here + 1) + 1;
            const std::uint32_t leave = text(then) == "{" ? then + 1 : then;
            if (text(leave) != "break" && text(leave) != "return") continue;
            for (const Range& each : search_.parts({here + 2, then - 1}, "||"))
                if (std::optional<CountedLoop> loop = compared(at, each, counter, true)) return loop;
        }
        return std::nullopt;
    }

    /// The loop at `at`, counted by the first of its conditions that can be counted.
    std::optional<CountedLoop> loopWhile(std::uint32_t at, Range condition, const Counter& counter) {
        for (const Range& each : search_.parts(condition, "&&"))
            if (std::optional<CountedLoop> loop = compared(at, each, counter, false)) return loop;
        return std::nullopt;
    }

    /// The loop that goes on while the comparison holds, or `ends` when it does.
    std::optional<CountedLoop> compared(std::uint32_t at, Range comparison, const Counter& counter,
                                        bool ends) {
        const std::string_view equality = ends ? "==" : "!=";
        for (const std::string_view sign : {std::string_view("<="), std::string_view(">="),
                                            std::string_view("<"), std::string_view(">"), equality}) {
            const std::vector<Range> sides = search_.parts(comparison, sign);
            if (sides.size() != 2) continue;
            for (const bool isLeft : {true, false}) {
                std::optional<CountedLoop> loop =
                    counted(sides[isLeft ? 0 : 1], sides[isLeft ? 1 : 0], counter);
                if (!loop) continue;
                loop->place = unit_.place(at);
                loop->untilEqual = sign == equality;
                loop->falling = ((sign.front() == '>') == isLeft) != ends;
                loop->including = !loop->untilEqual && (sign.size() == 2) != ends;
                if (mayWrap(*loop, sides[isLeft ? 0 : 1])) continue;
                return loop;
            }
        }
        return std::nullopt;
    }

    /// True for an unsigned variable that may fall below zero, where it becomes the largest number.
    [[nodiscard]] bool mayWrap(const CountedLoop& loop, Range side) const {
        const LocalVariable* variable = unit_.onlyLocal(text(side.first));
        const auto* step =
            loop.step.steps.size() == 2 ? std::get_if<double>(&loop.step.steps.front()) : nullptr;
        const bool isByOne = (step != nullptr && *step == 1) || loop.step.steps == Formula{{-1.}}.steps;
        return loop.falling && variable != nullptr && variable->typeWord == "uint" &&
               (loop.including || !isByOne);
    }

    /// A loop whose condition compares the variable in `side` with `bound`.
    std::optional<CountedLoop> counted(Range side, Range bound, const Counter& counter) {
        if (side.empty() || !search_.isWord(side.first)) return std::nullopt;
        const std::string_view name = text(side.first);
        std::optional<Formula> step;
        if (side.end == side.first + 1)
            step = counter.step(name);
        else if (side.end == side.first + 2 && counter.isKept(name))
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

    /// The value of `int i = 0;` or `i = 0;` before the statement at `at` in the same block, which therefore
    /// runs each time before that statement does.
    std::optional<Formula> firstBefore(std::string_view name, std::uint32_t at) {
        const auto endsStatement = [](std::string_view word) {
            return word == ";" || word == "{" || word == "}";
        };
        if (at == 0 || !endsStatement(text(at - 1))) return std::nullopt;
        for (std::uint32_t from = at; from-- > 0 && search_.spend(1) && text(from) != "{";) {
            if (const std::string_view here = text(from); here == "}" || here == ")" || here == "]") {
                if (match(from) >= from) return std::nullopt;
                from = match(from);
                continue;
            }
            const bool isDeclared = role(from) == WordRole::localDeclaration;
            if (text(from) != name || text(from + 1) != "=" || (!isDeclared && role(from) != WordRole::local))
                continue;
            if (!isDeclared && !endsStatement(from > 0 ? text(from - 1) : "")) return std::nullopt;
            const Range statement = search_.parts({from + 2, at}, ";").front();
            const std::uint32_t end = search_.parts(statement, ",").front().end;
            return search_.changes(name, {end, at}) ? std::nullopt : search_.formula({from + 2, end});
        }
        return std::nullopt;
    }

    /// What the only statement of the body that changes the variable adds to it, if every round executes it.
    std::optional<Formula> stepInside(std::string_view name, Range body) {
        if (body.empty() || !search_.spend(body.end - body.first)) return std::nullopt;
        int writes = 0;
        for (std::uint32_t at = body.first; at < body.end; ++at) {
            if (text(at) == "continue") return std::nullopt;
            if (search_.isChange(name, at)) ++writes;
        }
        if (writes != 1) return std::nullopt;
        const bool isBlock = text(body.first) == "{";
        const Range inside{isBlock ? body.first + 1 : body.first, body.end - 1};
        for (Range statement : search_.parts(inside, ";")) {
            for (std::uint32_t at = statement.first; at < statement.end; ++at) {
                if (search_.opens(at) && match(at) < statement.end) at = match(at);
                if (text(at) == "}") statement.first = at + 1;  // a block before the statement
            }
            if (std::optional<Formula> step = stepOf(name, statement)) return step;
        }
        return std::nullopt;
    }

    /// The initial value of the variable in `int i = 0, j = 9`.
    std::optional<Formula> firstOf(std::string_view name, Range start) {
        for (const Range& each : search_.parts(start, ","))
            for (std::uint32_t at = each.first; at + 1 < each.end; ++at)
                if (text(at) == name && text(at + 1) == "=") return search_.formula({at + 2, each.end});
        return std::nullopt;
    }

    /// What `++i, j -= 2` adds to the variable.
    std::optional<Formula> stepOf(std::string_view name, Range step) {
        for (const Range& each : search_.parts(step, ",")) {
            const std::uint32_t at = each.first;
            const std::uint32_t count = each.end - each.first;
            if (count == 2 && (text(at) == name || text(at + 1) == name)) {
                const std::string_view sign = text(text(at) == name ? at + 1 : at);
                if (sign == "++") return Formula{{1.}};
                if (sign == "--") return Formula{{-1.}};
            }
            if (count < 3 || text(at) != name) continue;
            if (text(at + 1) == "+=") return search_.formula({at + 2, each.end});
            if (text(at + 1) == "-=") return negated(search_.formula({at + 2, each.end}));
            if (count < 5 || text(at + 1) != "=" || text(at + 2) != name) continue;
            if (text(at + 3) == "+") return search_.formula({at + 4, each.end});
            if (text(at + 3) == "-" && count == 5) return negated(search_.formula({at + 4, each.end}));
        }
        return std::nullopt;
    }

    const Unit& unit_;
    TokenSearch search_;
    Statements statements_;
    std::vector<Place> uncounted_;
    std::unordered_map<std::string_view, const Declaration*> functions_;  ///< null: several of that name
};

}  // namespace

LoopFacts loopsOf(const Unit& unit) {
    return LoopSearch(unit).find();
}

}  // namespace glibra::glsl
