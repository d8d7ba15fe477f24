#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "classroom/code_blocks.h"
#include "classroom/normal_form.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

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
