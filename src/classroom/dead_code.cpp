#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "classroom/code_tree.h"
#include "classroom/constant_value.h"
#include "classroom/normal_form.h"
#include "glsl/parse/usage.h"
#include "glsl/read/token.h"

namespace glibra::classroom {
namespace {

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
            known_ = knownValues(*tree_, tokens_);
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
        return constantValue(*tree_, expression, known_);
    }

    void cleanBody(std::uint32_t body) {
        chooseSides(body);
        std::map<std::string_view, std::size_t> occurrences;  // as a name, not as a member
        for (std::size_t i = node(body).first; i < node(body).end; ++i)
            if (isVariable(i)) ++occurrences[tokens_[i].text];
        locals_.clear();
        writes_.clear();
        statements(body);
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

    /// The statements of a block.
    void statements(std::uint32_t block) {
        std::string_view before = "{";
        for (const std::uint32_t each : tree_->children(block)) {
            if (tree_->is(each, NodeKind::jump)) return afterJump(each);
            if (isBlock(each) && before != ":") unwrap(each);
            if (tree_->is(each, NodeKind::declaration) || tree_->is(each, NodeKind::evaluation) ||
                tree_->is(each, NodeKind::empty))
                take({node(each).first, node(each).end});
            else
                control(each, before == ":", false);
            before = text(node(each).end - 1);
        }
    }

    /// Removes what follows a jump in its block, unless a label is there.
    void afterJump(std::uint32_t jump) {
        std::uint32_t last = jump;
        for (std::uint32_t each = jump; each != glsl::kNone; each = node(each).next) {
            if (tree_->is(each, NodeKind::label)) return;
            last = each;
        }
        kill(node(jump).end, node(last).end);
    }

    /// A block, or a statement that controls others. The one statement of "if (a) b;" has to stay, or the
    /// next one would take its place.
    void control(std::uint32_t id, bool isControlled, bool isElse) {
        if (isBlock(id)) return statements(id);
        if (decided(id, isControlled, isElse)) return;
        const bool isBranch = tree_->is(id, NodeKind::branch);
        for (const std::uint32_t each : tree_->children(id))
            control(each, true, isBranch && each == tree_->child(id, 2));
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
        bool calls = false;
        if (text(end - 1) != ";") return;
        for (std::size_t i = begin; i < end; ++i) {
            if (text(i) == "{") return;
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
        const KnownValues known = known_;
        if (isFor) noteCounter(it.child);
        const std::optional<double> value = valueOf(isFor ? node(it.child).next : it.child);
        known_ = known;
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
        // Without it, the statement after it would be what "if (a)" before it controls.
        if (!hasElse && !isElse && isControlled) return false;
        kill(hasElse || !isElse ? it.first : it.first - 1, hasElse ? node(otherwise).first : it.end);
        if (hasElse) control(otherwise, true, true);
        return true;
    }

    /// for (int i = 0; i < 0; ++i)
    void noteCounter(std::uint32_t start) {
        if (!tree_->is(start, NodeKind::declaration) || node(start).child != node(start).lastChild) return;
        const std::uint32_t counter = node(start).child;
        if (counter == glsl::kNone || node(counter).child == glsl::kNone) return;
        if (const auto value = valueOf(node(counter).child)) known_[tree_->text(counter)] = *value;
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
