#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "classroom/normal_form.h"

namespace glibra::classroom {
namespace {

constexpr int kMostRounds = 8;  // a chain of variables that only each other read needs several

bool isAssignment(std::string_view text) {
    static const std::set<std::string_view> kSigns{
        "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>=", "++", "--"};
    return kSigns.contains(text);
}

/// The bodies of functions, statement by statement. Tokens are marked and removed at the end of a round.
class DeadCode {
  public:
    DeadCode(std::vector<CodeToken> tokens, const std::set<std::string_view>& own)
        : tokens_(std::move(tokens)), own_(own) {}

    std::vector<CodeToken> run() {
        for (int round = 0; round < kMostRounds; ++round) {
            dead_.assign(tokens_.size(), false);
            findBodies();
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

    /// The token after the bracket that closes the one at `open`.
    [[nodiscard]] std::size_t afterBracket(std::size_t open) const {
        int depth = 0;
        for (std::size_t i = open; i < tokens_.size(); ++i) {
            const std::string_view each = tokens_[i].text;
            if (each == "(" || each == "{" || each == "[") ++depth;
            if (each == ")" || each == "}" || each == "]") --depth;
            if (depth == 0) return i + 1;
        }
        return tokens_.size();
    }

    void findBodies() {
        for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
            if (tokens_[i].isDirective || tokens_[i].text != ")" || text(i + 1) != "{") continue;
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
            if (tokens_[i].isDirective || each == "{" || each == "}") return std::nullopt;
            if (each == "(" || each == "[") ++depth;
            if (each == ")" || each == "]") --depth;
            if (depth == 0 && each == ";") return Statement{begin, i + 1};
        }
        return std::nullopt;
    }

    void cleanBody(std::size_t begin, std::size_t end) {
        std::map<std::string_view, std::size_t> occurrences;  // as a name, not as a member
        for (std::size_t i = begin; i < end; ++i)
            if (tokens_[i].isWord && (i == 0 || tokens_[i - 1].text != ".")) ++occurrences[tokens_[i].text];
        std::map<std::string_view, std::vector<Statement>> writes;
        std::set<std::string_view> locals;
        bool isStart = true;
        for (std::size_t i = begin; i < end;) {
            const std::string_view each = text(i);
            if (each == "{" || each == "}") {
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
                const std::size_t after = afterBracket(i + 1);
                if (isFalse(i + 2, after - 1) && each != "for" && text(after) == "{") {
                    const std::size_t close = std::min(afterBracket(after), end);
                    if (text(close) != "else") kill(i, close);
                    i = close;
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
            if (each == "return" || each == "discard") {
                std::size_t close = found->end;  // what follows, up to the end of the block
                int depth = 0;
                bool simple = true;
                for (; close < end; ++close) {
                    depth += text(close) == "{" ? 1 : text(close) == "}" ? -1 : 0;
                    if (depth < 0) break;
                    simple = simple && text(close) != "case" && text(close) != "default" &&
                             !tokens_[close].isDirective;
                }
                if (simple) kill(found->end, close);
                i = close;
                continue;
            }
            take(*found, locals, writes);
            i = found->end;
        }
        killUnread(occurrences, locals, writes);
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
            calls = calls || (tokens_[i].isWord && text(i + 1) == "(" &&
                              (own_.contains(tokens_[i].text) || tokens_[i].text.starts_with("image") ||
                               tokens_[i].text.starts_with("atomic") || tokens_[i].text.starts_with("emit") ||
                               tokens_[i].text.starts_with("Emit") || tokens_[i].text.starts_with("End") ||
                               tokens_[i].text.ends_with("arrier")));
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
                text(begin) != "break" && text(begin) != "continue" &&
                !(tokens_[begin].isWord && text(begin + 1) == "(");  // of any file
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

    /// A local variable that occurs nowhere but as the target of its assignments.
    void killUnread(const std::map<std::string_view, std::size_t>& occurrences,
                    const std::set<std::string_view>& locals,
                    const std::map<std::string_view, std::vector<Statement>>& writes) {
        for (const std::string_view name : locals) {
            const std::vector<Statement>& own = writes.at(name);
            std::size_t inside = 0;  // also "a = a + 1.": only what is dead reads it
            for (const Statement& each : own)
                for (std::size_t i = each.begin; i < each.end; ++i)
                    if (tokens_[i].isWord && tokens_[i].text == name &&
                        (i == 0 || tokens_[i - 1].text != "."))
                        ++inside;
            const auto all = occurrences.find(name);
            if (all == occurrences.end() || all->second != inside) continue;
            for (const Statement& each : own) kill(each.begin, each.end);
        }
    }

    [[nodiscard]] bool isFalse(std::size_t begin, std::size_t end) const {
        return end == begin + 1 && (text(begin) == "false" || text(begin) == "0");
    }

    std::vector<CodeToken> tokens_;
    const std::set<std::string_view>& own_;
    std::vector<bool> dead_;
};

}  // namespace

std::vector<CodeToken> withoutDeadCode(std::vector<CodeToken> tokens, const std::set<std::string_view>& own) {
    return DeadCode(std::move(tokens), own).run();
}

}  // namespace glibra::classroom
