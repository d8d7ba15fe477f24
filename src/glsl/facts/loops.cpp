#include "glsl/facts/loops.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <iterator>
#include <unordered_map>

#include "glsl/parse/usage.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepest = 24;
constexpr std::size_t kMostTokens = 2'000'000;  // looked at for one stage, functions once a call

bool isCast(std::string_view word) {
    return word == "int" || word == "uint" || word == "float" || word == "double";
}

std::optional<double> numberOf(std::string_view text) {
    const bool isHex = text.starts_with("0x") || text.starts_with("0X");
    while (!text.empty() && (text.back() == 'u' || text.back() == 'U' ||
                             (!isHex && std::string_view("fFlL").find(text.back()) != text.npos)))
        text.remove_suffix(1);
    if (isHex) {
        unsigned long long value = 0;
        const auto [end, problem] = std::from_chars(text.data() + 2, text.data() + text.size(), value, 16);
        if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
        return static_cast<double>(value);
    }
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

class LoopSearch {
  public:
    explicit LoopSearch(const Unit& unit) : unit_(unit) {
        for (const Declaration& each : unit.syntax.declarations) {
            if (each.kind != DeclarationKind::function) continue;
            const auto [entry, isNew] = functions_.try_emplace(text(each.name), &each);
            if (!isNew) entry->second = nullptr;
        }
    }

    std::vector<CountedLoop> find() {
        const Declaration* main = function("main");
        return main == nullptr ? std::vector<CountedLoop>() : loopsIn(main->body, 0);
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return unit_.bodies.matches[at]; }
    [[nodiscard]] static bool opens(std::string_view text) {
        return text == "(" || text == "[" || text == "{";
    }

    /// The definition of that name, if there is one only.
    [[nodiscard]] const Declaration* function(std::string_view name) const {
        const auto found = functions_.find(name);
        return found == functions_.end() ? nullptr : found->second;
    }

    /// True while the search may go on.
    bool spend(std::size_t tokens) {
        spent_ += tokens;
        return spent_ < kMostTokens;
    }

    std::vector<CountedLoop> loopsIn(Range range, int depth) {
        std::vector<CountedLoop> loops;
        if (depth > kDeepest) return loops;
        const auto take = [&loops](std::vector<CountedLoop> more) {
            std::move(more.begin(), more.end(), std::back_inserter(loops));
        };
        for (std::uint32_t at = range.first; at < range.end && spend(1); ++at) {
            if (unit_.view[at].kind != TokenKind::word || text(at + 1) != "(" || match(at + 1) >= range.end)
                continue;
            if (text(at) == "for" || text(at) == "while") {
                const Range body{match(at + 1) + 1, statementEnd(match(at + 1) + 1, range.end)};
                std::optional<CountedLoop> loop = text(at) == "for" ? forAt(at, body) : whileAt(at, body);
                std::vector<CountedLoop> inside = loopsIn(body, depth + 1);
                if (loop) {
                    loop->inside = std::move(inside);
                    loops.push_back(std::move(*loop));
                } else {
                    take(std::move(inside));
                }
                at = std::max(at, body.end - 1);
            } else if (unit_.bodies.roles[at] == WordRole::global) {
                if (const Declaration* called = function(text(at))) take(loopsIn(called->body, depth + 1));
            }
        }
        return loops;
    }

    /// Behind the statement that begins at `at`.
    [[nodiscard]] std::uint32_t statementEnd(std::uint32_t at, std::uint32_t end) const {
        // `for (...) for (...) statement`, `if (...) statement else statement`: heads in front of it.
        while (at < end) {
            const std::string_view word = text(at);
            const bool isHead = word == "for" || word == "while" || word == "if" || word == "switch";
            if (isHead && text(at + 1) == "(" && match(at + 1) < end) {
                at = match(at + 1) + 1;
                continue;
            }
            if (word == "do") {
                ++at;
                continue;
            }
            while (at < end && text(at) != ";" && text(at) != "{")
                at = opens(text(at)) && match(at) < end ? match(at) + 1 : at + 1;
            at = at < end && text(at) == "{" && match(at) < end ? match(at) + 1 : std::min(at + 1, end);
            if (at >= end || text(at) != "else") break;
            ++at;
        }
        return std::min(at, end);
    }

    /// The ranges between the separators in a range, those inside brackets left alone.
    [[nodiscard]] std::vector<Range> parts(Range range, std::string_view separator) const {
        std::vector<Range> result;
        std::uint32_t start = range.first;
        for (std::uint32_t at = range.first; at < range.end; ++at) {
            if (opens(text(at)) && match(at) < range.end) at = match(at);
            if (text(at) != separator) continue;
            result.push_back({start, at});
            start = at + 1;
        }
        result.push_back({start, range.end});
        return result;
    }

    /// What is known of a variable that may count the rounds of a loop, by its name: what it begins with, and
    /// what every round adds to it at the loop's end (step), or nothing (isKept) if the condition counts.
    struct Counter {
        std::function<std::optional<Formula>(std::string_view name)> first, step;
        std::function<bool(std::string_view name)> isKept;
    };

    std::optional<CountedLoop> forAt(std::uint32_t at, Range body) {
        const std::vector<Range> head = parts({at + 2, match(at + 1)}, ";");
        if (head.size() != 3) return std::nullopt;
        return loopWhile(
            at, head[1],
            {[&](std::string_view name) { return firstOf(name, head[0]); },
             [&](std::string_view name) {
                 return changes(name, body) ? std::nullopt : stepOf(name, head[2]);
             },
             [&](std::string_view name) { return !changes(name, body) && !changes(name, head[2]); }});
    }

    std::optional<CountedLoop> whileAt(std::uint32_t at, Range body) {
        return loopWhile(at, {at + 2, match(at + 1)},
                         {[&](std::string_view name) { return firstBefore(name, at); },
                          [&](std::string_view name) { return stepInside(name, body); },
                          [&](std::string_view name) { return !changes(name, body); }});
    }

    std::optional<CountedLoop> loopWhile(std::uint32_t at, Range condition, const Counter& counter) {
        for (const Range& each : parts(condition, "&&")) {
            std::optional<CountedLoop> loop = loopWhile(each, counter);
            if (!loop) continue;
            loop->place = unit_.place(at);
            return loop;
        }
        return std::nullopt;
    }

    std::optional<CountedLoop> loopWhile(Range condition, const Counter& counter) {
        for (const std::string_view comparison : {"<=", ">=", "<", ">"}) {
            const std::vector<Range> sides = parts(condition, comparison);
            if (sides.size() != 2) continue;
            for (const bool isLeft : {true, false}) {
                const Range side = sides[isLeft ? 0 : 1];
                if (side.first == side.end || unit_.view[side.first].kind != TokenKind::word) continue;
                const std::string_view name = text(side.first);
                std::optional<Formula> by;
                if (side.end == side.first + 1)
                    by = counter.step(name);
                else if (side.end == side.first + 2 && counter.isKept(name))
                    by = stepOf(name, side);  // i++ < n
                if (!by) continue;
                std::optional<Formula> first = counter.first(name);
                std::optional<Formula> bound = formula(sides[isLeft ? 1 : 0]);
                if (!first || !bound) continue;
                CountedLoop loop;
                loop.first = std::move(*first);
                loop.bound = std::move(*bound);
                loop.step = std::move(*by);
                loop.falling = (comparison.front() == '>') == isLeft;
                loop.including = comparison.size() == 2;
                return loop;
            }
        }
        return std::nullopt;
    }

    /// `int i = 0;` or `i = 0;` in front of the statement at `at`, in the same block, so that it is done each
    /// time before that one is.
    std::optional<Formula> firstBefore(std::string_view name, std::uint32_t at) {
        const auto endsStatement = [](std::string_view word) {
            return word == ";" || word == "{" || word == "}";
        };
        if (at == 0 || !endsStatement(text(at - 1))) return std::nullopt;
        for (std::uint32_t from = at; from-- > 0 && spend(1) && text(from) != "{";) {
            if (const std::string_view here = text(from); here == "}" || here == ")" || here == "]") {
                if (match(from) >= from) return std::nullopt;
                from = match(from);
                continue;
            }
            const bool isDeclared = unit_.bodies.roles[from] == WordRole::localDeclaration;
            if (text(from) != name || text(from + 1) != "=" ||
                (!isDeclared && unit_.bodies.roles[from] != WordRole::local))
                continue;
            if (!isDeclared && !endsStatement(from > 0 ? text(from - 1) : "")) return std::nullopt;
            const std::uint32_t end = parts(parts({from + 2, at}, ";").front(), ",").front().end;
            return changes(name, {end, at}) ? std::nullopt : formula({from + 2, end});
        }
        return std::nullopt;
    }

    /// What the one statement of the body that changes the name adds to it, if every round comes to it.
    std::optional<Formula> stepInside(std::string_view name, Range body) {
        if (body.first >= body.end || !spend(body.end - body.first)) return std::nullopt;
        int writes = 0;
        for (std::uint32_t at = body.first; at < body.end; ++at) {
            if (text(at) == "continue") return std::nullopt;
            if (isChange(name, at)) ++writes;
        }
        if (writes != 1) return std::nullopt;
        const bool isBlock = text(body.first) == "{";
        const Range inside{isBlock ? body.first + 1 : body.first, body.end - 1};
        for (Range statement : parts(inside, ";")) {
            for (std::uint32_t at = statement.first; at < statement.end; ++at) {
                if (opens(text(at)) && match(at) < statement.end) at = match(at);
                if (text(at) == "}") statement.first = at + 1;  // of a block in front of it
            }
            if (std::optional<Formula> step = stepOf(name, statement)) return step;
        }
        return std::nullopt;
    }

    [[nodiscard]] bool isChange(std::string_view name, std::uint32_t at) const {
        return text(at) == name && unit_.bodies.roles[at] != WordRole::member && isWrittenAt(unit_, at);
    }

    bool changes(std::string_view name, Range body) {
        if (!spend(body.end - body.first)) return true;
        for (std::uint32_t at = body.first; at < body.end; ++at)
            if (isChange(name, at)) return true;
        return false;
    }

    /// `int i = 0, j = 9`: what the name begins with.
    std::optional<Formula> firstOf(std::string_view name, Range start) {
        for (const Range& each : parts(start, ","))
            for (std::uint32_t at = each.first; at + 1 < each.end; ++at)
                if (text(at) == name && text(at + 1) == "=") return formula({at + 2, each.end});
        return std::nullopt;
    }

    /// `++i, j -= 2`: what is added to the name.
    std::optional<Formula> stepOf(std::string_view name, Range step) {
        for (const Range& each : parts(step, ",")) {
            const std::uint32_t at = each.first;
            const std::uint32_t count = each.end - each.first;
            if (count == 2 && (text(at) == name || text(at + 1) == name)) {
                const std::string_view sign = text(text(at) == name ? at + 1 : at);
                if (sign == "++") return Formula{{1.}};
                if (sign == "--") return Formula{{-1.}};
            }
            if (count < 3 || text(at) != name) continue;
            if (text(at + 1) == "+=") return formula({at + 2, each.end});
            if (text(at + 1) == "-=") return negated(formula({at + 2, each.end}));
            if (count < 5 || text(at + 1) != "=" || text(at + 2) != name) continue;
            if (text(at + 3) == "+") return formula({at + 4, each.end});
            if (text(at + 3) == "-" && count == 5) return negated(formula({at + 4, each.end}));
        }
        return std::nullopt;
    }

    static std::optional<Formula> negated(std::optional<Formula> of) {
        if (of) of->steps.emplace_back(Operation::negate);
        return of;
    }

    // Expressions of constants and uniforms.

    std::optional<Formula> formula(Range range) {
        Formula result;
        if (++formulaDepth_ > kDeepest || !spend(range.end - range.first) || !sum(range, result)) {
            --formulaDepth_;
            return std::nullopt;
        }
        --formulaDepth_;
        return result;
    }

    /// Appends the formula of a range to another.
    bool append(Range range, Formula& to) {
        const std::optional<Formula> part = formula(range);
        if (part) to.steps.insert(to.steps.end(), part->steps.begin(), part->steps.end());
        return part.has_value();
    }

    bool sum(Range range, Formula& to) {
        std::uint32_t at = range.first;
        return product(at, range.end, to) &&
               binary(at, range.end, to, "+", Operation::add, "-", Operation::subtract,
                      [this](std::uint32_t& next, std::uint32_t end, Formula& into) {
                          return product(next, end, into);
                      }) &&
               at == range.end;
    }

    bool product(std::uint32_t& at, std::uint32_t end, Formula& to) {
        return operand(at, end, to) && binary(at, end, to, "*", Operation::multiply, "/", Operation::divide,
                                              [this](std::uint32_t& next, std::uint32_t stop, Formula& into) {
                                                  return operand(next, stop, into);
                                              });
    }

    template <class Operand>
    bool binary(std::uint32_t& at, std::uint32_t end, Formula& to, std::string_view one, Operation first,
                std::string_view other, Operation second, const Operand& next) {
        while (at < end && (text(at) == one || text(at) == other)) {
            const Operation operation = text(at) == one ? first : second;
            ++at;
            if (!next(at, end, to)) return false;
            to.steps.emplace_back(operation);
        }
        return true;
    }

    bool operand(std::uint32_t& at, std::uint32_t end, Formula& to) {
        bool isNegative = false;
        while (at < end && (text(at) == "-" || text(at) == "+")) isNegative ^= text(at++) == "-";
        if (at >= end || !primary(at, end, to)) return false;
        if (isNegative) to.steps.emplace_back(Operation::negate);
        return true;
    }

    bool primary(std::uint32_t& at, std::uint32_t end, Formula& to) {
        const std::uint32_t here = at++;
        if (unit_.view[here].kind == TokenKind::number) {
            const std::optional<double> value = numberOf(text(here));
            if (value) to.steps.emplace_back(*value);
            return value.has_value();
        }
        if (text(here) == "(" && match(here) < end) {
            at = match(here) + 1;
            return append({here + 1, match(here)}, to);
        }
        if (unit_.view[here].kind != TokenKind::word) return false;
        if (text(at) == "(" && match(at) < end) {
            const Range inside{at + 1, match(at)};
            at = match(at) + 1;
            return call(text(here), inside, to);
        }
        if (at < end && (text(at) == "[" || text(at) == ".")) return false;
        return name(here, to);
    }

    bool call(std::string_view function, Range inside, Formula& to) {
        if (isCast(function)) {
            if (!append(inside, to)) return false;
            if (function == "int" || function == "uint") to.steps.emplace_back(Operation::truncate);
            return true;
        }
        const std::vector<Range> arguments = parts(inside, ",");
        if ((function != "min" && function != "max") || arguments.size() != 2) return false;
        if (!append(arguments[0], to) || !append(arguments[1], to)) return false;
        to.steps.emplace_back(function == "min" ? Operation::least : Operation::greatest);
        return true;
    }

    /// A uniform, or a variable that keeps what it is declared with.
    bool name(std::uint32_t at, Formula& to) {
        if (!spend(unit_.bodies.locals.size() + unit_.variables.size())) return false;
        if (unit_.bodies.roles[at] == WordRole::local) {
            const LocalVariable* found = nullptr;
            for (const LocalVariable& each : unit_.bodies.locals) {
                if (text(each.name) != text(at)) continue;
                if (found != nullptr) return false;
                found = &each;
            }
            const Range everything{0, static_cast<std::uint32_t>(unit_.view.size())};
            if (found == nullptr || found->isParameter || found->initializer.empty()) return false;
            // Its declaration writes to it as well.
            const bool isKept = !changes(text(at), {everything.first, found->name}) &&
                                !changes(text(at), {found->name + 1, everything.end});
            return isKept && append(found->initializer, to);
        }
        for (const Variable& each : unit_.variables) {
            if (each.name != text(at) || each.isArray() || !isCast(each.type)) continue;
            if (each.storage == Storage::uniform) {
                to.steps.emplace_back(each.name);
                return true;
            }
            const Range initializer =
                unit_.syntax.declarations[each.declaration].declarators[each.declarator].initializer;
            const bool isKept = each.storage == Storage::constant ||
                                (each.storage == Storage::none && !unit_.isWritten(each.name));
            return isKept && !initializer.empty() && append(initializer, to);
        }
        return false;
    }

    const Unit& unit_;
    std::unordered_map<std::string_view, const Declaration*> functions_;  ///< null: several of that name
    std::size_t spent_ = 0;
    int formulaDepth_ = 0;
};

}  // namespace

std::vector<CountedLoop> loopsOf(const Unit& unit) {
    return LoopSearch(unit).find();
}

}  // namespace glibra::glsl
