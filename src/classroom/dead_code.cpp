#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "classroom/normal_form.h"
#include "glsl/parse/usage.h"
#include "glsl/read/preprocessor.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

// The value of an expression of numbers, so that `if (2 < 1)` hides as little as `if (false)`.

/// Variables that always have the value of their declaration.
using KnownValues = std::map<std::string_view, double>;

using Value = std::optional<double>;

/// A value that every type has exactly, so that nothing rounds or overflows it; nothing for others.
Value exact(double value) {
    constexpr double kMost = 1 << 24;
    const bool isTiny = value != 0 && std::abs(value) < std::numeric_limits<float>::min();
    if (!(std::abs(value) <= kMost) || isTiny || static_cast<double>(static_cast<float>(value)) != value)
        return std::nullopt;
    return value;
}

Value numberOf(std::string_view text) {
    const Value value = glsl::numberValue(text);
    const bool isDouble = text.find_first_of("lL") != std::string_view::npos;
    return value ? exact(isDouble ? *value : static_cast<double>(static_cast<float>(*value))) : value;
}

Value applied(std::string_view op, const Value& a, const Value& b) {
    const auto is = [](const Value& one, bool truth) { return one && (*one != 0) == truth; };
    if (op == "&&" && (is(a, false) || is(b, false))) return 0;
    if (op == "||" && (is(a, true) || is(b, true))) return 1;
    if (!a || !b) return std::nullopt;
    if (op == "&&" || op == "||") return is(a, true) && is(b, true) ? 1 : 0;
    if (op == "^^") return is(a, true) != is(b, true) ? 1 : 0;
    if (op == "==") return *a == *b ? 1 : 0;
    if (op == "!=") return *a != *b ? 1 : 0;
    if (op == "<") return *a < *b ? 1 : 0;
    if (op == ">") return *a > *b ? 1 : 0;
    if (op == "<=") return *a <= *b ? 1 : 0;
    if (op == ">=") return *a >= *b ? 1 : 0;
    if (op == "+") return exact(*a + *b);
    if (op == "-" && *a >= *b) return exact(*a - *b);  // without a sign, others are large
    if (op == "*") return exact(*a * *b);
    // Whole numbers are divided in another way; the text does not show which these are.
    return std::nullopt;
}

bool changes(std::string_view text) {
    return glsl::isAssignment(text) || glsl::isStep(text) || text == "[" || text == ".";
}

/// The value of an expression, where true is 1; nothing if it depends on anything else. `false && a` and
/// `true || a` have a value whatever `a` is, and so have `a && false` and `a || true` unless `a` has an
/// effect.
Value constantValue(const CodeTree& tree, std::uint32_t expression, const KnownValues& known,
                    const OwnFunctions& own) {
    using enum glsl::NodeKind;
    const glsl::Node& it = tree.node(expression);
    const std::string_view text = it.kind == number || it.kind == name ? tree.text(expression) : "";
    if (it.kind == number) return numberOf(text);
    if (it.kind == group) return constantValue(tree, it.child, known, own);
    if (it.kind == name) {
        if (text == "true" || text == "false") return text == "true" ? 1 : 0;
        const auto found = known.find(text);
        return found == known.end() ? std::nullopt : Value(found->second);
    }
    if (it.kind == prefix) {
        Value value = constantValue(tree, it.child, known, own);
        const std::span<const CodeToken> signs =
            tree.code(expression).first(tree.node(it.child).first - it.first);
        const bool isSigned =
            tree.is(it.child, number) && tree.text(it.child).find_first_of("uU") == std::string_view::npos;
        for (const CodeToken& each : signs | std::views::reverse) {
            if (!value || (each.text != "!" && each.text != "-" && each.text != "+")) return std::nullopt;
            if (each.text == "!") value = *value == 0 ? 1 : 0;
            if (each.text == "-" && !isSigned) return std::nullopt;
            if (each.text == "-") value = -*value;
        }
        return value;
    }
    if (it.kind != chain) return std::nullopt;
    Value value = constantValue(tree, it.child, known, own);
    for (std::uint32_t each = tree.node(it.child).next; each != glsl::kNone; each = tree.node(each).next) {
        const bool isOpen = !value;
        value = applied(tree.before(each), value, constantValue(tree, each, known, own));
        if (isOpen && value && hasEffect(tree.code(expression).first(tree.node(each).first - it.first), own))
            return std::nullopt;
    }
    return value;
}

/// Finds variables of the types bool, int, uint and float whose declaration gives them a constant value and
/// that nothing changes afterwards. Names that are declared several times are left out.
KnownValues knownValues(const CodeTree& tree, std::span<const CodeToken> code, const OwnFunctions& own) {
    static const std::set<std::string_view> kTypes{"bool", "int", "uint", "float"};
    const auto text = [&](std::size_t i) { return i < code.size() ? code[i].text : std::string_view{}; };
    std::set<std::string_view> declared, repeated, constant, changed;
    for (std::size_t i = 1; i < code.size(); ++i) {
        if (!code[i].isWord) continue;
        const std::string_view name = code[i].text;
        std::size_t first = i, last = i;  // with the parentheses around it: (a) = b
        while (first > 1 && text(first - 1) == "(" && text(last + 1) == ")" && !code[first - 2].isWord) {
            --first;
            ++last;
        }
        const std::string_view before = text(first - 1), after = text(last + 1);
        if (code[i - 1].isWord && before != "return" && before != "else") {
            if (!declared.insert(name).second) repeated.insert(name);
            if (i > 1 && text(i - 2) == "const") constant.insert(name);
            continue;
        }
        // A function may change its argument.
        const bool isArgument = before == "," || (before == "(" && first > 1 && code[first - 2].isWord &&
                                                  text(first - 2) != "if" && text(first - 2) != "while" &&
                                                  text(first - 2) != "for" && text(first - 2) != "return");
        if (isArgument || changes(after) || before == "++" || before == "--") changed.insert(name);
    }
    KnownValues known;
    for (const auto& [at, expression] : tree.initializers()) {
        const std::string_view name = code[at].text;
        if (!kTypes.contains(text(at - 1)) || text(at + 1) != "=" || repeated.contains(name) ||
            (changed.contains(name) && !constant.contains(name)))
            continue;
        if (const Value value = constantValue(tree, expression, known, own)) known[name] = *value;
    }
    return known;
}

using glsl::NodeKind;

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
            tree_.emplace(tokens_);
            known_ = knownValues(*tree_, tokens_, own_);
            outer_.clear();
            for (const std::uint32_t each : tree_->functions()) cleanBody(each);
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

    [[nodiscard]] const glsl::Node& node(std::uint32_t id) const { return tree_->node(id); }
    [[nodiscard]] bool isBlock(std::uint32_t id) const { return tree_->is(id, NodeKind::block); }
    [[nodiscard]] std::optional<double> valueOf(std::uint32_t expression) const {
        return constantValue(*tree_, expression, known_, own_);
    }

    void cleanBody(std::uint32_t body) {
        chooseSides(body);
        std::map<std::string_view, std::size_t> occurrences;  // as a name, not as a member
        for (std::size_t i = node(body).first; i < node(body).end; ++i)
            if (isVariable(i)) ++occurrences[tokens_[i].text];
        locals_.clear();
        writes_.clear();
        statements(node(body).child);
        killUnread(std::move(occurrences));
        for (auto& [name, found] : writes_)
            if (!locals_.contains(name)) outer_[name].insert(outer_[name].end(), found.begin(), found.end());
    }

    /// Removes the side of each "a ? b : c" that a constant condition never takes. What is inside of it
    /// follows in the next rounds.
    void chooseSides(std::uint32_t id) {
        const std::optional<double> value =
            tree_->is(id, NodeKind::selection) ? valueOf(node(id).child) : std::nullopt;
        if (!value) {
            for (const std::uint32_t each : tree_->children(id)) chooseSides(each);
            return;
        }
        const glsl::Node& yes = node(tree_->child(id, 1));
        kill(node(id).first, *value != 0 ? yes.first : node(yes.next).first);
        if (*value != 0) kill(yes.end, node(id).end);
    }

    /// The statements of a block from one on. What nothing reaches behind one that always leaves the block is
    /// removed, up to a label. True: so does the last one.
    bool statements(std::uint32_t each) {
        bool isAfterJump = false;
        for (; each != glsl::kNone; each = node(each).next) {
            isAfterJump = isAfterJump && !tree_->is(each, NodeKind::label);
            if (isAfterJump) kill(node(each).first, node(each).end);
            isAfterJump = isAfterJump || tree_->is(each, NodeKind::jump);
            if (isAfterJump) continue;
            if (isBlock(each)) unwrap(each);
            if (tree_->is(each, NodeKind::declaration) || tree_->is(each, NodeKind::evaluation) ||
                tree_->is(each, NodeKind::empty))
                take({node(each).first, node(each).end});
            else
                isAfterJump = control(each, false, false);
        }
        return isAfterJump;
    }

    /// A block, or a statement that controls others. The one statement of "if (a) b;" has to stay, or the
    /// next one would take its place. True: it always leaves the block around it.
    bool control(std::uint32_t id, bool isControlled, bool isElse) {
        if (isBlock(id)) return statements(node(id).child);
        if (tree_->is(id, NodeKind::jump)) return true;
        if (decided(id, isControlled, isElse) || unwrappedLoop(id, isControlled) ||
            decidedChoice(id, isControlled, isElse))
            return false;  // the next round knows
        const bool isBranch = tree_->is(id, NodeKind::branch);
        int leaving = 0;
        for (const std::uint32_t each : tree_->children(id))
            leaving += control(each, true, isBranch && each == tree_->child(id, 2)) ? 1 : 0;
        return isBranch && leaving == 2;
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
    void take(const Statement& statement) {
        const auto [begin, end] = statement;
        std::size_t assigned = end, count = 0;
        if (text(end - 1) != ";") return;
        for (std::size_t i = begin; i < end; ++i) {
            if (text(i) == "{") return;
            if (isAssignment(tokens_[i].text)) {
                if (count++ == 0) assigned = i;
            }
        }
        if (end - begin == 1) return kill(begin, end);
        if (count > 1 || callsWithEffect(std::span(tokens_).subspan(begin, end - begin), own_)) return;
        // float a = ...;   const vec3 a;
        std::size_t first = begin;
        if (text(first) == "const") ++first;
        const bool declares = tokens_[first].isWord && first + 1 < end && tokens_[first + 1].isWord &&
                              (text(first + 2) == "=" || text(first + 2) == ";");
        if (declares) {
            locals_.insert(tokens_[first + 1].text);
            writes_[tokens_[first + 1].text].push_back(statement);
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
        if (isWhole) writes_[tokens_[begin].text].push_back(statement);
    }

    /// Local variables that occur nowhere but in their own assignments, "a = a + 1.", and in those of others
    /// of this kind.
    void killUnread(std::map<std::string_view, std::size_t> occurrences) {
        const auto visit = [&](std::string_view name, const auto& use) {
            for (const Statement& each : writes_.at(name))
                for (std::size_t i = each.begin; i < each.end; ++i)
                    if (isVariable(i)) use(tokens_[i].text);
        };
        std::vector<std::string_view> open;
        const auto readLess = [&](std::string_view name) {
            const auto all = occurrences.find(name);
            if (all != occurrences.end() && --all->second == 0 && locals_.contains(name))
                open.push_back(name);
        };
        for (const std::string_view name : locals_) {
            ++occurrences[name];  // it counts as read until all its own occurrences are taken away
            visit(name, [&](std::string_view each) {
                if (each == name) readLess(each);
            });
        }
        for (const std::string_view name : locals_) readLess(name);
        while (!open.empty()) {
            const std::string_view name = open.back();
            open.pop_back();
            visit(name, [&](std::string_view each) {
                if (each != name) readLess(each);
            });
            for (const Statement& each : writes_.at(name)) kill(each.begin, each.end);
        }
    }

    /// Removes the braces of a block.
    void unwrap(std::uint32_t block) {
        if (text(node(block).end - 1) != "}") return;
        kill(node(block).first, node(block).first + 1);
        kill(node(block).end - 1, node(block).end);
    }

    /// Removes what a constant condition keeps from running, and the condition itself; false if it decides
    /// nothing.
    bool decided(std::uint32_t id, bool isControlled, bool isElse) {
        const bool isBranch = tree_->is(id, NodeKind::branch), isFor = tree_->is(id, NodeKind::forLoop);
        if (!isBranch && !isFor && !tree_->is(id, NodeKind::whileLoop)) return false;
        const glsl::Node& it = node(id);
        const std::optional<double> value = isFor ? firstCondition(id) : valueOf(it.child);
        if (!value || (*value != 0 && !isBranch)) return false;
        const std::uint32_t then = isBranch ? node(it.child).next : it.lastChild;
        const std::uint32_t otherwise = isBranch ? node(then).next : glsl::kNone;
        const bool hasElse = otherwise != glsl::kNone;
        if (*value != 0) {
            kill(it.first, node(then).first);
            if (hasElse) kill(node(then).end, it.end);
            control(then, true, false);
            return true;
        }
        if (isFor && acts(it.child)) {
            keepStart(id, it.end);
            return true;
        }
        if (!hasElse) return killWhole(id, isControlled, isElse);
        kill(it.first, node(otherwise).first);
        control(otherwise, true, true);
        return true;
    }

    /// False: without it, the statement after it would be what "if (a)" before it controls.
    bool killWhole(std::uint32_t id, bool isControlled, bool isElse) {
        if (isElse || !isControlled) kill(node(id).first - (isElse ? 1 : 0), node(id).end);
        return isElse || !isControlled;
    }

    /// Leaves what a `for` begins with, and what follows `end`.
    void keepStart(std::uint32_t id, std::size_t end) {
        const glsl::Node& start = node(node(id).child);
        kill(node(id).first, start.first);
        kill(start.end + (text(start.end) == ";" ? 1 : 0), end);
    }

    /// True if the code of a node has an effect besides its value.
    [[nodiscard]] bool acts(std::uint32_t id) const { return hasEffect(tree_->code(id), own_); }

    /// The condition of a `for` before its first round, or, where it holds there, after `rounds`: for (int i
    /// = 0; i < 1; ++i).
    std::optional<double> firstCondition(std::uint32_t id, int rounds = 0) {
        const std::uint32_t start = node(id).child, condition = node(start).next;
        if (condition != glsl::kNone && node(condition).first == node(condition).end) return 1;
        const KnownValues known = known_;
        std::string_view counter;
        if (tree_->is(start, NodeKind::declaration) && node(start).child == node(start).lastChild) {
            const std::uint32_t one = node(start).child;
            const auto value = one == glsl::kNone || node(one).child == glsl::kNone
                                   ? std::nullopt
                                   : valueOf(node(one).child);
            if (value) known_[counter = tree_->text(one)] = *value;
        }
        std::optional<double> value = valueOf(condition);
        if (rounds > 0 && value && *value != 0) {
            const auto by = counter.empty() ? std::nullopt : stepOf(tree_->child(id, 2), counter);
            if (by) known_[counter] += *by;
            value = by ? valueOf(condition) : std::nullopt;
        }
        known_ = known;
        return value;
    }

    /// What ++i, i--, i += 2 and i = i + 2 add to i.
    [[nodiscard]] std::optional<double> stepOf(std::uint32_t id, std::string_view counter) const {
        const std::span<const CodeToken> code = tree_->code(id);
        if (code.size() == 2 && (code[0].text == counter || code[1].text == counter)) {
            const std::string_view sign = code[code[0].text == counter ? 1 : 0].text;
            return sign == "++" ? std::optional(1.) : sign == "--" ? std::optional(-1.) : std::nullopt;
        }
        if (!tree_->is(id, NodeKind::assignment) || code[0].text != counter) return std::nullopt;
        const std::optional<double> value = valueOf(node(id).lastChild);
        if (!value || code[1].text == "+=") return value;
        if (code[1].text == "-=") return -*value;
        const auto before = known_.find(counter);
        return code[1].text == "=" && before != known_.end() ? std::optional(*value - before->second)
                                                             : std::nullopt;
    }

    /// True if a `break`, or a `continue`, leaves a statement from within this one.
    [[nodiscard]] bool leaves(std::uint32_t id, bool breaks, bool continues) const {
        if (tree_->is(id, NodeKind::jump)) {
            const std::string_view word = text(node(id).first);
            return (breaks && word == "break") || (continues && word == "continue");
        }
        const bool isChoice = tree_->is(id, NodeKind::choice);
        breaks = breaks && !isChoice;
        if ((!breaks && !continues) || (!isChoice && !isBlock(id) && !tree_->is(id, NodeKind::branch)))
            return false;
        return std::ranges::any_of(tree_->children(id),
                                   [&](std::uint32_t each) { return leaves(each, breaks, continues); });
    }

    /// Removes the words of a loop that runs once: do { } while (false), for (int i = 0; i < 1; ++i), while
    /// (true) { ... break; } or return.
    bool unwrappedLoop(std::uint32_t id, bool isControlled) {
        const bool isFor = tree_->is(id, NodeKind::forLoop), isDo = tree_->is(id, NodeKind::doLoop);
        if (!isFor && !isDo && !tree_->is(id, NodeKind::whileLoop)) return false;
        const glsl::Node& it = node(id);
        const std::uint32_t body = isDo ? it.child : it.lastChild;
        const auto is = [](std::optional<double> value, bool truth) {
            return value && (*value != 0) == truth;
        };
        const std::uint32_t final = isBlock(body) ? node(body).lastChild : glsl::kNone;
        const bool isBroken = tree_->is(final, NodeKind::jump) && text(node(final).first) != "continue";
        const auto runsOnce = [&] {
            if (isDo) return isBroken || (it.lastChild != body && is(valueOf(it.lastChild), false));
            if (isBroken) return is(isFor ? firstCondition(id) : valueOf(it.child), true);
            return isFor && is(firstCondition(id), true) && is(firstCondition(id, 1), false);
        };
        const bool hasStart = isFor && node(it.child).first < node(it.child).end;
        if (body == glsl::kNone || (hasStart && isControlled) || !runsOnce()) return false;
        const bool isLeft = isBlock(body) ? std::ranges::any_of(tree_->children(body),
                                                                [&](std::uint32_t each) {
                                                                    return !(isBroken && each == final) &&
                                                                           leaves(each, true, true);
                                                                })
                                          : leaves(body, true, true);
        if (isLeft) return false;
        if (hasStart)
            keepStart(id, node(body).first);
        else
            kill(it.first, node(body).first);
        if (isBroken && text(node(final).first) == "break") kill(node(final).first, node(final).end);
        kill(node(body).end, it.end);
        control(body, true, false);
        return true;
    }

    /// Removes the parts of a `switch` that its constant value does not choose, and, unless a `break` in
    /// other statements leaves it, the words around the others.
    bool decidedChoice(std::uint32_t id, bool isControlled, bool isElse) {
        if (!tree_->is(id, NodeKind::choice) || !isBlock(node(id).lastChild)) return false;
        const glsl::Node& it = node(id);
        const std::uint32_t body = it.lastChild;
        const std::optional<double> value = valueOf(it.child);
        std::uint32_t chosen = glsl::kNone, fallback = glsl::kNone;
        for (const std::uint32_t each : tree_->children(body)) {
            if (!tree_->is(each, NodeKind::label)) continue;
            const bool isDefault = node(each).child == glsl::kNone;
            const std::optional<double> label = isDefault ? std::nullopt : valueOf(node(each).child);
            if (isDefault)
                fallback = each;
            else if (!value || !label)
                return false;
            else if (*label == *value && chosen == glsl::kNone)
                chosen = each;
        }
        if (chosen == glsl::kNone) chosen = fallback;
        if (acts(it.child)) return false;
        if (chosen == glsl::kNone) return killWhole(id, isControlled, isElse);
        const std::size_t end = node(body).end - (text(node(body).end - 1) == "}" ? 1 : 0);
        bool isLeft = false;
        std::size_t last = end;
        for (std::uint32_t each = node(chosen).next; each != glsl::kNone && last == end;
             each = node(each).next) {
            if (tree_->is(each, NodeKind::label)) kill(node(each).first, node(each).end);
            if (tree_->is(each, NodeKind::jump))
                last = text(node(each).first) == "break" ? node(each).first : node(each).end;
            else
                isLeft = isLeft || leaves(each, true, false);
        }
        kill(last, std::max(last, end));
        kill(isLeft ? node(body).first + 1 : it.first, isLeft ? node(chosen).first : node(body).first);
        if (!isLeft) kill(node(body).first + 1, node(chosen).end);
        statements(node(chosen).next);
        return true;
    }

    std::vector<CodeToken> tokens_;
    const OwnFunctions& own_;
    std::vector<bool> dead_;
    std::optional<CodeTree> tree_;
    KnownValues known_;
    // Of the body that is read
    std::set<std::string_view> locals_;
    std::map<std::string_view, std::vector<Statement>> writes_;  ///< statements that only set a variable
    std::map<std::string_view, std::vector<Statement>> outer_;   ///< of variables that no function declares
};

}  // namespace

std::vector<CodeToken> withoutDeadCode(std::vector<CodeToken> tokens, const OwnFunctions& own) {
    return DeadCode(std::move(tokens), own).run();
}

}  // namespace glibra::classroom
