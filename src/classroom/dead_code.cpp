#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "classroom/constant_value.h"
#include "classroom/normal_form.h"
#include "glsl/parse/usage.h"
#include "glsl/read/token.h"

namespace glibra::classroom {
namespace {

// Constant conditions inside of each other need a round each. A long text has fewer rounds.
constexpr std::size_t kLeastRounds = 8, kMostTokensRead = 1'000'000;

bool isAssignment(std::string_view text) {
    return glsl::isAssignment(text) || glsl::isStep(text);
}

/// The bodies of functions, statement by statement. Tokens are marked and removed at the end of a round.
class DeadCode {
  public:
    DeadCode(std::vector<CodeToken> tokens, const OwnFunctions& own)
        : tokens_(std::move(tokens)), own_(own) {}

    std::vector<CodeToken> run() {
        std::size_t read = 0;
        for (std::size_t round = 0; round < kLeastRounds || read < kMostTokensRead; ++round) {
            read += tokens_.size();
            dead_.assign(tokens_.size(), false);
            known_ = knownValues(tokens_);
            brackets_.emplace(tokens_);
            outer_.clear();
            findBodies();
            killUnreadGlobals();
            if (std::ranges::find(dead_, true) == dead_.end()) break;
            std::size_t kept = 0;
            for (std::size_t i = 0; i < tokens_.size(); ++i)
                if (!dead_[i]) tokens_[kept++] = tokens_[i];
            tokens_.resize(kept);
        }
        return std::move(tokens_);
    }

  private:
    struct Statement {
        std::size_t begin = 0, end = 0;  ///< with its ";"
    };

    [[nodiscard]] std::string_view text(std::size_t i) const {
        return i < tokens_.size() ? tokens_[i].text : std::string_view{};
    }

    void kill(std::size_t begin, std::size_t end) {
        std::fill(dead_.begin() + static_cast<std::ptrdiff_t>(begin),
                  dead_.begin() + static_cast<std::ptrdiff_t>(end), true);
    }

    [[nodiscard]] std::size_t afterBracket(std::size_t open) const { return brackets_->after(open); }

    void findBodies() {
        for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
            if (tokens_[i].text != ")" || text(i + 1) != "{") continue;
            const std::size_t end = afterBracket(i + 1);
            cleanBody(i + 2, end > 0 ? end - 1 : end);
            i = end - 1;
        }
    }

    /// A statement that ends with ";" and has no block: from `begin`, up to `end` of the body.
    [[nodiscard]] std::optional<Statement> statementAt(std::size_t begin, std::size_t end) const {
        int depth = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const std::string_view each = tokens_[i].text;
            if (each == "{" || each == "}") return std::nullopt;
            if (each == "(" || each == "[") ++depth;
            if (each == ")" || each == "]") --depth;
            if (depth == 0 && each == ";") return Statement{begin, i + 1};
        }
        return std::nullopt;
    }

    void cleanBody(std::size_t begin, std::size_t end) {
        chooseSides(begin, end);
        std::map<std::string_view, std::size_t> occurrences;  // as a name, not as a member
        for (std::size_t i = begin; i < end; ++i)
            if (isVariable(i)) ++occurrences[tokens_[i].text];
        std::map<std::string_view, std::vector<Statement>> writes;
        std::set<std::string_view> locals;
        bool isStart = true;
        for (std::size_t i = begin; i < end;) {
            const std::string_view each = text(i);
            if (each == "{" || each == "}") {
                if (each == "{" && isStart && !isControlled(i, begin)) unwrap(i, end);
                isStart = true;
                ++i;
                continue;
            }
            if (!isStart) {
                isStart = each == ";";
                ++i;
                continue;
            }
            if (each == "if" || each == "while" || each == "for" || each == "switch") {
                const std::size_t after = std::min(afterBracket(i + 1), end);
                if (const std::size_t next = decided(i, after, begin, end); next > i) {
                    i = next;
                    continue;
                }
                // The one statement of "if (a) b;" has to stay, or the next one would take its place.
                i = after;
                isStart = text(after) == "{" || each == "switch";
                continue;
            }
            if (each == "case" || each == "default") {
                while (i < end && text(i) != ":") ++i;
                ++i;
                continue;
            }
            if (each == "else" || each == "do") {
                ++i;
                isStart = text(i) == "{" || text(i) == "if";
                continue;
            }
            const std::optional<Statement> found = statementAt(i, end);
            if (!found) {
                isStart = false;
                ++i;
                continue;
            }
            if (each == "return" || each == "discard" || each == "break" || each == "continue") {
                std::size_t close = found->end;  // what follows, up to the end of the block
                int depth = 0;
                bool simple = true;
                for (; close < end; ++close) {
                    depth += text(close) == "{" ? 1 : text(close) == "}" ? -1 : 0;
                    if (depth < 0) break;
                    simple = simple && text(close) != "case" && text(close) != "default";
                }
                if (simple) kill(found->end, close);
                i = close;
                continue;
            }
            take(*found, locals, writes);
            i = found->end;
        }
        killUnread(occurrences, locals, writes);
        for (auto& [name, statements] : writes)
            if (!locals.contains(name))
                outer_[name].insert(outer_[name].end(), statements.begin(), statements.end());
    }

    /// Assignments to variables outside of functions that nothing reads. Outputs are not declared here
    /// (comparedCode).
    void killUnreadGlobals() {
        if (outer_.empty()) return;
        std::map<std::string_view, std::size_t> occurrences;
        for (std::size_t i = 0; i < tokens_.size(); ++i)
            if (isVariable(i)) ++occurrences[tokens_[i].text];
        for (const CodeItem& item : itemsOf(tokens_))
            for (const std::string_view name : item.names) {
                const auto own = outer_.find(name);
                if (item.parameters.data() != nullptr || own == outer_.end()) continue;
                std::size_t inside = 1;  // the declaration
                for (const Statement& each : own->second)
                    for (std::size_t i = each.begin; i < each.end; ++i)
                        if (isVariable(i) && tokens_[i].text == name) ++inside;
                if (occurrences[name] != inside) continue;
                for (const Statement& each : own->second) kill(each.begin, each.end);
            }
    }

    /// True for a word that is no member.
    [[nodiscard]] bool isVariable(std::size_t i) const {
        return tokens_[i].isWord && (i == 0 || tokens_[i - 1].text != ".");
    }

    /// What a statement declares and assigns; one without effect is dead.
    void take(const Statement& statement, std::set<std::string_view>& locals,
              std::map<std::string_view, std::vector<Statement>>& writes) {
        const auto [begin, end] = statement;
        std::size_t assigned = end, count = 0;
        bool calls = false;
        for (std::size_t i = begin; i < end; ++i) {
            if (isAssignment(tokens_[i].text)) {
                if (count++ == 0) assigned = i;
            }
            if (!tokens_[i].isWord || text(i + 1) != "(") continue;
            const auto own = own_.find(tokens_[i].text);
            calls = calls || (own == own_.end() ? hasEffect(tokens_[i].text) : own->second);
        }
        if (end - begin == 1) return kill(begin, end);
        if (calls || count > 1) return;
        // float a = ...;   const vec3 a;
        std::size_t first = begin;
        if (text(first) == "const") ++first;
        const bool declares = tokens_[first].isWord && first + 1 < end && tokens_[first + 1].isWord &&
                              (text(first + 2) == "=" || text(first + 2) == ";");
        if (declares) {
            // A list "a = 1., b" declares several; those stay.
            int depth = 0;
            for (std::size_t i = first; i < end; ++i) {
                const std::string_view each = tokens_[i].text;
                depth += each == "(" || each == "[" ? 1 : each == ")" || each == "]" ? -1 : 0;
                if (depth == 0 && each == ",") return;
            }
            locals.insert(tokens_[first + 1].text);
            writes[tokens_[first + 1].text].push_back(statement);
            return;
        }
        if (count == 0) {
            const bool isExpression =
                !(tokens_[begin].isWord && begin + 1 < end && tokens_[begin + 1].isWord) &&
                text(begin) != "break" && text(begin) != "continue";
            if (isExpression) kill(begin, end);
            return;
        }
        if (!tokens_[begin].isWord) return;
        // a = a;
        if (text(assigned) == "=" && assigned - begin == end - 1 - (assigned + 1) &&
            std::equal(tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
                       tokens_.begin() + static_cast<std::ptrdiff_t>(assigned),
                       tokens_.begin() + static_cast<std::ptrdiff_t>(assigned) + 1,
                       [](const CodeToken& a, const CodeToken& b) { return a.text == b.text; }))
            return kill(begin, end);
        // a = ...;   a.x = ...;   a += ...;
        const bool isWhole = assigned == begin + 1 || (assigned == begin + 3 && text(begin + 1) == ".");
        if (isWhole) writes[tokens_[begin].text].push_back(statement);
    }

    /// Local variables that occur nowhere but in their own assignments, "a = a + 1.", and in those of others
    /// of this kind.
    void killUnread(std::map<std::string_view, std::size_t> occurrences,
                    const std::set<std::string_view>& locals,
                    const std::map<std::string_view, std::vector<Statement>>& writes) {
        const auto visit = [&](std::string_view name, const auto& use) {
            for (const Statement& each : writes.at(name))
                for (std::size_t i = each.begin; i < each.end; ++i)
                    if (isVariable(i)) use(tokens_[i].text);
        };
        std::vector<std::string_view> open;
        const auto readLess = [&](std::string_view name) {
            const auto all = occurrences.find(name);
            if (all != occurrences.end() && --all->second == 0 && locals.contains(name)) open.push_back(name);
        };
        for (const std::string_view name : locals) {
            ++occurrences[name];  // it counts as read until all its own occurrences are taken away
            visit(name, [&](std::string_view each) {
                if (each == name) readLess(each);
            });
        }
        for (const std::string_view name : locals) readLess(name);
        while (!open.empty()) {
            const std::string_view name = open.back();
            open.pop_back();
            visit(name, [&](std::string_view each) {
                if (each != name) readLess(each);
            });
            for (const Statement& each : writes.at(name)) kill(each.begin, each.end);
        }
    }

    [[nodiscard]] std::optional<double> valueOf(std::size_t begin, std::size_t end,
                                                const KnownValues& known) const {
        return constantValue(std::span(tokens_).subspan(begin, end - begin), known);
    }

    /// Removes the side of each "a ? b : c" that a constant condition never takes.
    void chooseSides(std::size_t begin, std::size_t end) {
        const auto change = [&](std::size_t i) {
            return text(i) == "(" || text(i) == "[" ? 1 : text(i) == ")" || text(i) == "]" ? -1 : 0;
        };
        static const std::set<std::string_view> kEnds{",", ";", "?", ":", "{", "}", "return"};
        for (std::size_t question = begin + 1; question < end; ++question) {
            if (text(question) != "?") continue;
            std::size_t from = question;
            for (int depth = 0; from > begin; --from) {
                depth -= change(from - 1);
                if (depth < 0 ||
                    (depth == 0 && (kEnds.contains(text(from - 1)) || isAssignment(text(from - 1)))))
                    break;
            }
            const std::optional<double> value = valueOf(from, question, known_);
            if (!value) continue;
            std::size_t colon = end, at = question + 1;
            for (int depth = 0, nested = 0; at < end; ++at) {
                depth += change(at);
                if (depth < 0) break;
                if (depth > 0) continue;
                nested += text(at) == "?" ? 1 : 0;
                if (text(at) == ":" && nested-- == 0 && colon == end)
                    colon = at;
                else if (text(at) == "," || text(at) == ";" || text(at) == "}")
                    break;
            }
            if (colon == end) continue;
            kill(from, *value != 0 ? question + 1 : colon + 1);
            if (*value != 0) kill(colon, at);
            question = at;  // what is inside of it in the next rounds
        }
    }

    /// True if a condition, "else" or "do" before it decides whether a statement runs.
    [[nodiscard]] bool isControlled(std::size_t at, std::size_t begin) const {
        return at > begin && text(at - 1) != ";" && text(at - 1) != "{" && text(at - 1) != "}";
    }

    /// Removes the braces of a block.
    void unwrap(std::size_t open, std::size_t end) {
        const std::size_t close = afterBracket(open);
        if (close > end) return;
        kill(open, open + 1);
        kill(close - 1, close);
    }

    [[nodiscard]] std::size_t afterStatement(std::size_t at, std::size_t end) const {
        return classroom::afterStatement(tokens_, *brackets_, at, end);
    }

    /// Removes what a constant condition keeps from running, and the condition itself. Returns the token to
    /// go on with; `at` if the condition at `at`, up to `after`, decides nothing.
    std::size_t decided(std::size_t at, std::size_t after, std::size_t begin, std::size_t end) {
        const std::string_view word = text(at);
        std::size_t from = at + 2, to = after > 0 ? after - 1 : after;
        KnownValues known = known_;
        if (word == "for") {
            const std::size_t first = from;
            while (from < to && text(from) != ";") ++from;
            // for (int i = 0; i < 0; ++i)
            if (from > first + 3 && text(first + 2) == "=")
                if (const auto value = valueOf(first + 3, from, known_)) known[text(first + 1)] = *value;
            std::size_t second = ++from;
            while (second < to && text(second) != ";") ++second;
            to = second;
        }
        if (word == "switch" || from >= to || to > end) return at;
        const std::optional<double> value = valueOf(from, to, known);
        if (!value || (*value != 0 && word != "if")) return at;
        const std::size_t then = afterStatement(after, end);
        const bool hasElse = word == "if" && text(then) == "else";
        const std::size_t last = hasElse ? afterStatement(then + 1, end) : then;
        if (*value != 0) {
            kill(at, after);
            if (hasElse) kill(then, last);
            return after;
        }
        const bool isElse = at > begin && text(at - 1) == "else";
        // Without it, the statement after it would be what "if (a)" before it controls.
        if (!hasElse && !isElse && isControlled(at, begin)) return at;
        kill(hasElse || !isElse ? at : at - 1, hasElse ? then + 1 : then);
        return hasElse ? then + 1 : then;
    }

    std::vector<CodeToken> tokens_;
    const OwnFunctions& own_;
    std::vector<bool> dead_;
    std::optional<Brackets> brackets_;
    KnownValues known_;
    std::map<std::string_view, std::vector<Statement>> outer_;  ///< of variables that no function declares
};

}  // namespace

std::vector<CodeToken> withoutDeadCode(std::vector<CodeToken> tokens, const OwnFunctions& own) {
    return DeadCode(std::move(tokens), own).run();
}

}  // namespace glibra::classroom
