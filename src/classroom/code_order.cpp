#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "classroom/normal_form.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

constexpr int kDeepestNesting = 32, kMostParentheses = 8;

/// What stands between expressions, and is left where it is.
bool separates(const CodeToken& token) {
    static const std::set<std::string_view> kSigns{
        ";",   "{", "}", ",",  "=",  "+=", "-=", "*=", "/=",     "%=",   "&=",   "|=", "^=",   "<<=",
        ">>=", "?", ":", "<",  ">",  "<=", ">=", "==", "!=",     "&&",   "||",   "^^", "!",    "&",
        "|",   "^", "~", "<<", ">>", "%",  "++", "--", "return", "else", "case", "do", "const"};
    return kSigns.contains(token.text);
}

std::optional<double> numberOf(const Code& code) {
    if (code.size() != 1 || !code[0].isNumber) return std::nullopt;
    double value = 0;
    const std::string_view text = code[0].text;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end == text.data()) return std::nullopt;
    return value;
}

class Sorter {
  public:
    explicit Sorter(std::uint32_t number) : number_(number) {}

    /// The tokens of a file or of a bracket.
    Code sorted(std::span<const CodeToken> tokens) {
        if (++depth_ > kDeepestNesting) {
            --depth_;
            return {tokens.begin(), tokens.end()};
        }
        Code made;
        std::size_t statement = 0;
        for (std::size_t i = 0; i < tokens.size();) {
            if (separates(tokens[i])) {
                const std::string_view sign = tokens[i].text;
                if ((sign == "+=" || sign == "-=" || sign == "*=" || sign == "/=") &&
                    made.size() > statement && made.size() - statement <= 8) {
                    i = writeOut(tokens, i,
                                 {made.begin() + static_cast<std::ptrdiff_t>(statement), made.end()}, made);
                    continue;
                }
                made.push_back(tokens[i++]);
                if (sign == ";" || sign == "{" || sign == "}") statement = made.size();
                continue;
            }
            const std::size_t end = endOfExpression(tokens, i);
            const std::span<const CodeToken> expression = tokens.subspan(i, end - i);
            const bool isAlone =
                (i == 0 || standsBefore(tokens[i - 1])) && (end == tokens.size() || standsAfter(tokens[end]));
            append(made, isAlone && isGroup(expression) ? sorted(inside(expression)) : sum(expression));
            i = end;
        }
        --depth_;
        return made;
    }

  private:
    static void append(Code& to, const Code& code) { to.insert(to.end(), code.begin(), code.end()); }

    static std::size_t afterBracket(std::span<const CodeToken> tokens, std::size_t open) {
        int depth = 0;
        for (std::size_t i = open; i < tokens.size(); ++i) {
            const std::string_view each = tokens[i].text;
            if (each == "(" || each == "[") ++depth;
            if (each == ")" || each == "]") --depth;
            if (depth == 0) return i + 1;
        }
        return tokens.size();
    }

    static std::size_t endOfExpression(std::span<const CodeToken> tokens, std::size_t begin) {
        std::size_t i = begin;
        while (i < tokens.size() && !separates(tokens[i]))
            i = tokens[i].text == "(" || tokens[i].text == "[" ? afterBracket(tokens, i) : i + 1;
        return std::max(i, begin + 1);
    }

    /// "a += b" as "a = a + b". Returns the token after b.
    std::size_t writeOut(std::span<const CodeToken> tokens, std::size_t at, const Code& target, Code& made) {
        const std::size_t end = std::min(endOfExpression(tokens, at + 1), tokens.size());
        made.push_back(sign("=", tokens[at].line));
        append(made, sum(assignedBy(target, tokens[at], tokens.subspan(at + 1, end - at - 1))));
        return end;
    }

    struct Operand {
        Code code;
        bool isInverse = false;  ///< subtracted, or divided by
    };

    /// True for what stands before a whole expression, and after one.
    static bool standsBefore(const CodeToken& token) {
        return token.text == "=" || token.text == "," || token.text == "return";
    }
    static bool standsAfter(const CodeToken& token) { return token.text == ";" || token.text == ","; }

    /// True for one pair of parentheses and what is in it.
    static bool isGroup(std::span<const CodeToken> tokens) {
        return tokens.size() > 2 && tokens.front().text == "(" && afterBracket(tokens, 0) == tokens.size() &&
               tokens.back().text == ")";
    }
    static std::span<const CodeToken> inside(std::span<const CodeToken> group) {
        return group.subspan(1, group.size() - 2);
    }

    /// What the parentheses of a group hold together, as far as signs show it.
    enum class Strength { anything, sum, product, operand };
    static Strength strengthOf(std::span<const CodeToken> tokens) {
        Strength found = Strength::operand;
        for (std::size_t i = 0; i < tokens.size();) {
            const std::string_view each = tokens[i].text;
            if (separates(tokens[i])) return Strength::anything;
            if (each == "+" || each == "-") found = Strength::sum;
            if ((each == "*" || each == "/") && found == Strength::operand) found = Strength::product;
            i = each == "(" || each == "[" ? afterBracket(tokens, i) : i + 1;
        }
        return found;
    }

    /// Splits at the signs outside of brackets.
    static std::vector<std::pair<std::span<const CodeToken>, bool>> split(std::span<const CodeToken> tokens,
                                                                          std::string_view plain,
                                                                          std::string_view inverse) {
        std::vector<std::pair<std::span<const CodeToken>, bool>> parts;
        std::size_t begin = 0;
        bool isInverse = false;
        for (std::size_t i = 0; i < tokens.size();) {
            const std::string_view each = tokens[i].text;
            if (each == plain || each == inverse) {
                // A sign at the beginning, or after another operator, belongs to the operand.
                if (i > begin) parts.emplace_back(tokens.subspan(begin, i - begin), isInverse);
                isInverse = (i > begin || !isInverse) ? each == inverse : each != inverse;
                begin = ++i;
                continue;
            }
            i = each == "(" || each == "[" ? afterBracket(tokens, i) : i + 1;
        }
        if (begin < tokens.size()) parts.emplace_back(tokens.subspan(begin), isInverse);
        return parts;
    }

    Code sum(std::span<const CodeToken> tokens) {
        // "a * -b": the minus is no difference. Such terms keep their order.
        for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
            if ((tokens[i].text == "*" || tokens[i].text == "/") &&
                (tokens[i + 1].text == "-" || tokens[i + 1].text == "+"))
                return kept(tokens);
        std::vector<Operand> terms;
        double constant = 0;
        bool hasConstant = false;
        CodeLine line = tokens.front().line;
        for (const auto& [part, isInverse] : flat(tokens, "+", "-", Strength::sum)) {
            Code term = product(part);
            if (const std::optional<double> value = numberOf(term)) {
                constant += isInverse ? -*value : *value;
                hasConstant = true;
                line = term[0].line;
                continue;
            }
            terms.push_back({std::move(term), isInverse});
        }
        if (hasConstant && (constant != 0 || terms.empty()))
            terms.push_back({{number(constant, line)}, terms.empty() ? constant < 0 : false});
        return joined(std::move(terms), "+", "-", tokens.front().line);
    }

    Code product(std::span<const CodeToken> tokens) {
        std::vector<Operand> factors;
        double constant = 1;
        bool hasConstant = false;
        CodeLine line = tokens.front().line;
        for (const auto& [part, isInverse] : flat(tokens, "*", "/", Strength::product)) {
            Code factor = atom(part);
            if (const std::optional<double> value = numberOf(factor); value && (!isInverse || *value != 0)) {
                constant *= isInverse ? 1 / *value : *value;
                hasConstant = true;
                line = factor[0].line;
                continue;
            }
            factors.push_back({std::move(factor), isInverse});
        }
        const bool isAlone = factors.empty() || (factors.size() == 1 && factors[0].isInverse);
        if (hasConstant && (std::abs(constant - 1) > 1e-12 || isAlone))
            factors.push_back({{number(constant, line)}, false});
        return joined(std::move(factors), "*", "/", tokens.front().line);
    }

    using Part = std::pair<std::span<const CodeToken>, bool>;
    static bool isSamePart(const Part& a, const Part& b) {
        return a.first.data() == b.first.data() && a.first.size() == b.first.size();
    }
    /// The operands of a sum or product, also those of groups in it that are one themselves.
    static std::vector<Part> flat(std::span<const CodeToken> tokens, std::string_view plain,
                                  std::string_view inverse, Strength strength) {
        std::vector<Part> parts = split(tokens, plain, inverse);
        for (int round = 0; round < kMostParentheses; ++round) {
            std::vector<Part> made;
            for (const auto& [part, isInverse] : parts) {
                if (!isGroup(part) || strengthOf(inside(part)) < strength) {
                    made.emplace_back(part, isInverse);
                    continue;
                }
                for (const auto& [inner, isInnerInverse] : split(inside(part), plain, inverse))
                    made.emplace_back(inner, isInnerInverse != isInverse);
            }
            if (made.size() == parts.size() &&
                std::equal(made.begin(), made.end(), parts.begin(), isSamePart))
                break;
            parts = std::move(made);
        }
        return parts;
    }

    /// A factor: its brackets are sorted, and those around one operand are left out.
    Code atom(std::span<const CodeToken> tokens) {
        for (int round = 0;
             round < kMostParentheses && isGroup(tokens) && strengthOf(inside(tokens)) == Strength::operand;
             ++round)
            tokens = inside(tokens);
        if (isGroup(tokens)) {
            Code inner = sorted(inside(tokens));
            if (inner.size() == 1) return inner;
            Code made{tokens.front()};
            append(made, inner);
            made.push_back(tokens.back());
            return made;
        }
        return kept(tokens);
    }

    /// The same order, with sorted brackets.
    Code kept(std::span<const CodeToken> tokens) {
        Code made;
        for (std::size_t i = 0; i < tokens.size();) {
            if (tokens[i].text != "(" && tokens[i].text != "[") {
                made.push_back(tokens[i++]);
                continue;
            }
            const std::size_t end = afterBracket(tokens, i);
            made.push_back(tokens[i]);
            const bool isClosed = end > i + 1 && (tokens[end - 1].text == ")" || tokens[end - 1].text == "]");
            append(made, sorted(tokens.subspan(i + 1, end - i - (isClosed ? 2 : 1))));
            if (isClosed) made.push_back(tokens[end - 1]);
            i = end;
        }
        return made;
    }

    [[nodiscard]] CodeToken number(double value, CodeLine line) const {
        // Only its own value counts again: whether it is 0 or 1.
        return {value == 0 ? "0" : value == 1 ? "1" : "2", number_, line, false, true};
    }

    Code joined(std::vector<Operand> operands, std::string_view plain, std::string_view inverse,
                CodeLine line) const {
        std::ranges::stable_sort(operands, [](const Operand& a, const Operand& b) {
            return a.isInverse != b.isInverse ? b.isInverse : isBefore(a.code, b.code);
        });
        Code made;
        for (const Operand& each : operands) {
            const CodeLine at = each.code.empty() ? line : each.code.front().line;
            if (each.isInverse && made.empty() && inverse == "/") made.push_back(number(1, at));
            if (!made.empty() || each.isInverse) made.push_back(sign(each.isInverse ? inverse : plain, at));
            append(made, each.code);
        }
        return made;
    }

    std::uint32_t number_;
    int depth_ = 0;
};

/// What a statement reads and writes.
struct Effects {
    std::vector<std::string_view> mentions;  ///< in their order, each once
    std::set<std::string_view> writes;
    bool isBarrier = false;  ///< nothing passes it
};

Effects effectsOf(std::span<const CodeToken> tokens, const OwnFunctions& own) {
    static const std::set<std::string_view> kLoops{"for", "while", "do", "switch"};
    Effects effects;
    std::set<std::string_view> seen;
    const bool isLoop = !tokens.empty() && kLoops.contains(tokens.front().text);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view text = tokens[i].text;
        if (text == "return" || text == "discard" || text == "case" || text == "default")
            effects.isBarrier = true;
        if ((text == "break" || text == "continue") && !isLoop) effects.isBarrier = true;
        if (glsl::isAssignment(text) || glsl::isStep(text)) effects.writes.insert(targetOf(tokens, 0, i));
        if (isVariableName(tokens, i)) {
            if (seen.insert(text).second) effects.mentions.push_back(text);
            if (isDeclaredName(tokens, i)) effects.writes.insert(text);
        } else if (tokens[i].isWord && i + 1 < tokens.size() && tokens[i + 1].text == "(") {
            const auto function = own.find(text);
            if (function == own.end() ? hasEffect(text) : function->second) effects.isBarrier = true;
        }
    }
    return effects;
}

/// Statements between two barriers.
class Region {
  public:
    Region(std::vector<Code> statements, const std::vector<Effects>& effects)
        : statements_(std::move(statements)) {
        needed_.resize(statements_.size());
        isNeeded_.assign(statements_.size(), false);
        std::map<std::string_view, std::size_t> written;
        std::map<std::string_view, std::vector<std::size_t>> readers;  // since it was written
        for (std::size_t i = 0; i < statements_.size(); ++i) {
            for (const std::string_view each : effects[i].mentions) {
                if (const auto by = written.find(each); by != written.end()) need(i, by->second);
                if (!effects[i].writes.contains(each)) readers[each].push_back(i);
            }
            for (const std::string_view each : effects[i].writes) {
                for (const std::size_t reader : std::exchange(readers[each], {}))
                    if (reader != i) need(i, reader);
                written[each] = i;
            }
        }
        written_ = std::move(written);
    }

    /// The statements in their order, before a statement that mentions these variables.
    std::vector<Code> ordered(const std::vector<std::string_view>& mentions) {
        for (std::vector<std::size_t>& each : needed_) sort(each);
        std::vector<std::size_t> roots;
        std::vector<bool> isRoot = isNeeded_;
        isRoot.flip();
        for (const std::string_view each : mentions) {
            const auto by = written_.find(each);
            if (by == written_.end() || !isRoot[by->second]) continue;
            roots.push_back(by->second);
            isRoot[by->second] = false;
        }
        for (std::size_t i = 0; i < statements_.size(); ++i)
            if (isRoot[i]) roots.push_back(i);
        sort(roots);
        for (const std::size_t each : roots) visit(each);
        std::vector<Code> made;
        for (const std::size_t each : order_) made.push_back(std::move(statements_[each]));
        return made;
    }

  private:
    void need(std::size_t statement, std::size_t earlier) {
        needed_[statement].push_back(earlier);
        isNeeded_[earlier] = true;
    }

    /// By their code; those of equal code in the order in which they are mentioned.
    void sort(std::vector<std::size_t>& numbers) const {
        std::ranges::stable_sort(
            numbers, [&](std::size_t a, std::size_t b) { return isBefore(statements_[a], statements_[b]); });
    }

    /// Adds a statement after all that it needs.
    void visit(std::size_t root) {
        isDone_.resize(statements_.size());
        std::vector<std::pair<std::size_t, std::size_t>> open{{root, 0}};  // a statement, and its next need
        while (!open.empty()) {
            auto& [statement, next] = open.back();
            if (isDone_[statement]) {
                open.pop_back();
            } else if (next < needed_[statement].size()) {
                const std::size_t earlier = needed_[statement][next++];
                if (!isDone_[earlier]) open.emplace_back(earlier, 0);
            } else {
                isDone_[statement] = true;
                order_.push_back(statement);
                open.pop_back();
            }
        }
    }

    std::vector<Code> statements_;
    std::vector<std::vector<std::size_t>> needed_;
    std::vector<bool> isNeeded_, isDone_;
    std::map<std::string_view, std::size_t> written_;  ///< where a variable was written last
    std::vector<std::size_t> order_;
};

}  // namespace

std::vector<CodeToken> inOrder(const std::vector<CodeToken>& tokens, std::uint32_t number) {
    return Sorter(number).sorted(tokens);
}

std::vector<CodeToken> inStatementOrder(const std::vector<CodeToken>& tokens, const OwnFunctions& own) {
    return withBlocks(tokens, [&](std::vector<Code>& statements) {
        std::vector<Code> made, region;
        std::vector<Effects> effects;
        const auto finish = [&](const std::vector<std::string_view>& mentions) {
            for (Code& each : Region(std::exchange(region, {}), effects).ordered(mentions))
                made.push_back(std::move(each));
            effects.clear();
        };
        for (Code& each : statements) {
            Effects of = effectsOf(each, own);
            if (of.isBarrier) {
                finish(of.mentions);
                made.push_back(std::move(each));
                continue;
            }
            region.push_back(std::move(each));
            effects.push_back(std::move(of));
        }
        finish({});
        statements = std::move(made);
    });
}

}  // namespace glibra::classroom
