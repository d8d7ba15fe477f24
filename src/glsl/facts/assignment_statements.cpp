// What statements assign.

#include <algorithm>
#include <utility>

#include "glsl/facts/assignment_walk.h"
#include "glsl/parse/usage.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepestStatement = 200;        // statements and brackets in each other
constexpr std::size_t kMostVariables = 4096;  // of a function

}  // namespace

bool AssignmentWalk::isTooMuch() {
    if (depth_ > kDeepestStatement || variables_.size() > kMostVariables || !search_.spend(1)) gaveUp_ = true;
    return gaveUp_;
}

void AssignmentWalk::statements(Range range) {
    for (std::uint32_t at = range.first; at < range.end;) at = statement(at, range.end);
}

std::uint32_t AssignmentWalk::expressionEnd(std::uint32_t at, std::uint32_t end) const {
    while (at < end && text(at) != ";" && text(at) != "}")
        at = search_.opens(at) && match(at) < end ? match(at) + 1 : at + 1;
    return at;
}

std::uint32_t AssignmentWalk::statement(std::uint32_t at, std::uint32_t end) {
    if (isTooMuch()) return end;
    ++depth_;
    const std::uint32_t next = std::max(afterStatement(at, end), at + 1);
    --depth_;
    return next;
}

std::uint32_t AssignmentWalk::afterStatement(std::uint32_t at, std::uint32_t end) {
    const std::string_view first = text(at);
    if (first == "{") {
        const std::uint32_t close = std::min(match(at), end);
        scopes_.emplace_back();
        statements({at + 1, close});
        scopes_.pop_back();
        return close + 1;
    }
    if (first == ";" || first == "}") return at + 1;
    const bool isName = isWord(at) && (role(at) == WordRole::local || role(at) == WordRole::global);
    if (isWord(at) && !isName) {
        const bool isHeaded = text(at + 1) == "(" && match(at + 1) < end;
        if (first == "if" && isHeaded) return branch(at, end);
        if (first == "for" && isHeaded) return forLoop(at, end);
        if (first == "while" && isHeaded) return whileLoop(at, end);
        if (first == "do") return doLoop(at, end);
        if (first == "switch" && isHeaded) return switchOver(at, end);
        if (first == "case" || first == "default") return label(at, end);
        if (first == "return" || first == "discard" || first == "break" || first == "continue")
            return jump(at, end);
    }
    if (isDeclaration(at, end)) return declaration(at, end);
    const std::uint32_t stop = expressionEnd(at, end);
    expression({at, stop});
    return stop + 1;
}

bool AssignmentWalk::isDeclaration(std::uint32_t at, std::uint32_t end) const {
    for (std::uint32_t i = at; i < end && isWord(i); ++i) {
        if (role(i) == WordRole::localDeclaration) return i > at;
        if (text(i) == "struct") return true;
        if (role(i) != WordRole::other) return false;
        while ((text(i + 1) == "[" || (text(i) == "layout" && text(i + 1) == "(")) && match(i + 1) < end)
            i = match(i + 1);
    }
    return false;
}

std::uint32_t AssignmentWalk::declaration(std::uint32_t at, std::uint32_t end) {
    const Declaration parsed = parseVariable(unit_.view, at, end);
    for (const Declarator& each : parsed.declarators) {
        if (!each.initializer.empty()) expression(each.initializer);
        const bool isFollowed = each.initializer.empty() && parsed.qualifiers.storage == Storage::none &&
                                !parsed.type.name.empty();
        if (isFollowed)
            declareLocal(parsed, each);
        else
            scopes_.back()[text(each.name)] = std::nullopt;
    }
    return parsed.tokens.end;
}

void AssignmentWalk::header(Range range) {
    if (isDeclaration(range.first, range.end))
        declaration(range.first, range.end);
    else
        expression(range);
}

std::uint32_t AssignmentWalk::branch(std::uint32_t at, std::uint32_t end) {
    const std::uint32_t close = match(at + 1);
    expression({at + 2, close});
    const AssignedState before = state_;
    ++branches_;
    std::uint32_t next = statement(close + 1, end);
    if (next < end && text(next) == "else") {
        const AssignedState then = std::exchange(state_, before);
        next = statement(next + 1, end);
        state_.join(then);
    } else {
        state_.join(before);
    }
    --branches_;
    return next;
}

void AssignmentWalk::foresee(Range body, bool mayBeEmpty) {
    const int inBody = branches_ + (mayBeEmpty ? 1 : 0);
    const int level = unit_.hasAny(body, {"continue", "break", "return"}) ? inBody : inBody + 1;
    for (std::uint32_t i = body.first; i < body.end && search_.spend(1); ++i) {
        const std::optional<std::size_t> index = isWord(i) ? variableAt(i) : std::nullopt;
        if (!index) continue;
        const std::string_view next = text(afterSuffixes(unit_, i));
        if (next != "=" && next != "," && next != ")") continue;
        int& known = foreseen_.try_emplace(*index, level).first->second;
        known = std::min(known, level);
    }
}

bool AssignmentWalk::isAlwaysTrue(Range condition) const {
    return condition.empty() || (condition.end == condition.first + 1 && text(condition.first) == "true");
}

bool AssignmentWalk::hasLogic(Range condition) const {
    return unit_.hasAny(condition, {"&&", "||"});
}

std::uint32_t AssignmentWalk::loop(std::uint32_t body, std::uint32_t end, Range condition, Range step,
                                   bool mayBeEmpty) {
    const AssignedState before = state_;
    const auto outer = std::exchange(breaks_, AssignedState{{}, {}, true});
    branches_ += mayBeEmpty ? 1 : 0;
    const auto next = statement(body, end);
    branches_ -= mayBeEmpty ? 1 : 0;
    state_.isDead = false;
    state_.join(before);  // after `continue`
    if (!step.empty()) expression(step);
    const AssignedState leaving = std::exchange(breaks_, outer);
    const std::vector<std::uint32_t> maybe = state_.maybe;
    state_ = before;
    for (std::size_t i = 0; i < state_.maybe.size() && i < maybe.size(); ++i) state_.maybe[i] |= maybe[i];
    if (isAlwaysTrue(condition)) state_.isDead = true;
    state_.join(leaving);
    return next;
}

std::uint32_t AssignmentWalk::forLoop(std::uint32_t at, std::uint32_t end) {
    const std::uint32_t close = match(at + 1);
    const std::vector<Range> parts = search_.parts({at + 2, close}, ";");
    if (parts.size() != 3) gaveUp_ = true;
    if (gaveUp_) return close + 1;
    scopes_.emplace_back();
    header(parts[0]);
    // A counter that the loop itself sets and compares has a round as a rule.
    const bool mayBeEmpty = !isAlwaysTrue(parts[1]) && (parts[0].empty() || hasLogic(parts[1]));
    foresee({parts[1].first, bodyEnd(close + 1, end)}, mayBeEmpty);
    expression(parts[1]);
    const std::uint32_t next = loop(close + 1, end, parts[1], parts[2], mayBeEmpty);
    fill(parts, {close + 1, next});
    scopes_.pop_back();
    return next;
}

std::uint32_t AssignmentWalk::bodyEnd(std::uint32_t at, std::uint32_t end) const {
    while (at < end && text(at) != "{" && text(at) != ";")
        at = search_.opens(at) && match(at) < end ? match(at) + 1 : at + 1;
    return at < end && text(at) == "{" ? std::min(match(at), end) : at;
}

std::uint32_t AssignmentWalk::whileLoop(std::uint32_t at, std::uint32_t end) {
    const std::uint32_t close = match(at + 1);
    scopes_.emplace_back();
    const bool mayBeEmpty = !isAlwaysTrue({at + 2, close});
    foresee({at + 2, bodyEnd(close + 1, end)}, mayBeEmpty);
    header({at + 2, close});
    const std::uint32_t next = loop(close + 1, end, {at + 2, close}, {}, mayBeEmpty);
    scopes_.pop_back();
    return next;
}

std::uint32_t AssignmentWalk::doLoop(std::uint32_t at, std::uint32_t end) {
    foresee({at + 1, bodyEnd(at + 1, end)}, false);
    const AssignedState before = state_;
    const auto outer = std::exchange(breaks_, AssignedState{{}, {}, true});
    const auto outerContinues = std::exchange(continues_, AssignedState{{}, {}, true});
    std::uint32_t next = statement(at + 1, end);
    state_.join(std::exchange(continues_, outerContinues));
    const AssignedState leaving = std::exchange(breaks_, outer);
    if (text(next) == "while" && text(next + 1) == "(" && match(next + 1) < end) {
        const Range condition{next + 2, match(next + 1)};
        expression(condition);
        if (isAlwaysTrue(condition)) state_.isDead = true;
        next = condition.end + 1;
    }
    state_.join(leaving);
    return next;
}

void AssignmentWalk::fill(const std::vector<Range>& parts, Range body) {
    const Range& first = parts[0];
    const Range& condition = parts[1];
    const Range& step = parts[2];
    const bool isCounted = first.end == first.first + 4 && text(first.first + 2) == "=" &&
                           (text(first.first + 3) == "0" || text(first.first + 3) == "0u") &&
                           condition.end > condition.first + 2 && text(condition.first + 1) == "<";
    if (!isCounted || state_.isDead) return;
    const std::string_view counter = text(first.first + 1);
    const bool isStep = step.end == step.first + 2 &&
                        (text(step.first) == "++" || text(step.first + 1) == "++") &&
                        (text(step.first) == counter || text(step.first + 1) == counter);
    if (!isStep || text(condition.first) != counter) return;
    if (unit_.hasAny(body, {"break", "continue", "return"})) return;
    for (std::uint32_t i = body.first; i < body.end; ++i)
        if (search_.isChange(counter, i)) return;
    const Range limit{condition.first + 2, condition.end};
    int depth = 0;
    for (std::uint32_t i = body.first; i < body.end; ++i) {
        if (text(i) == "{") ++depth;
        if (text(i) == "}") --depth;
        const std::string_view before = text(i - 1);
        const bool begins = i == body.first || before == "{" || before == "}" || before == ";";
        if (!begins || depth > 1 || !isWord(i)) continue;
        const std::optional<std::size_t> index = variableAt(i);
        const bool isElement =
            index && text(i + 1) == "[" && text(i + 2) == counter && text(i + 3) == "]" && text(i + 4) == "=";
        if (!isElement || variables_[*index].is.sizes.size() != 1) continue;
        long long rounds = 0;
        const bool isOwnLength =
            limit.end == limit.first + 5 && text(limit.first) == text(i) && text(limit.first + 2) == "length";
        const bool coversAll = globalIntegerValue(unit_, limit, rounds) && variables_[*index].elements > 0 &&
                               rounds >= variables_[*index].elements;
        if (isOwnLength || coversAll) assign(*index, {variables_[*index].all(), true});
    }
}

std::uint32_t AssignmentWalk::switchOver(std::uint32_t at, std::uint32_t end) {
    const std::uint32_t close = match(at + 1);
    expression({at + 2, close});
    const auto outer = std::exchange(breaks_, AssignedState{{}, {}, true});
    const auto outerSwitch = std::exchange(switch_, state_);
    const bool outerDefault = std::exchange(hasDefault_, false);
    state_.isDead = true;
    ++branches_;
    const std::uint32_t next = statement(close + 1, end);
    --branches_;
    state_.join(std::exchange(breaks_, outer));
    const AssignedState before = std::exchange(switch_, outerSwitch);
    if (!std::exchange(hasDefault_, outerDefault)) state_.join(before);
    return next;
}

std::uint32_t AssignmentWalk::label(std::uint32_t at, std::uint32_t end) {
    hasDefault_ = hasDefault_ || text(at) == "default";
    while (at < end && text(at) != ":" && text(at) != ";" && text(at) != "}") ++at;
    state_.join(switch_);
    return at + 1;
}

std::uint32_t AssignmentWalk::jump(std::uint32_t at, std::uint32_t end) {
    const std::uint32_t stop = expressionEnd(at + 1, end);
    if (stop > at + 1) expression({at + 1, stop});
    if (text(at) == "return") {
        hasReturn_ = true;
        exit_.join(state_);
    } else if (text(at) == "break") {
        breaks_.join(state_);
    } else if (text(at) == "continue") {
        continues_.join(state_);
    }
    state_.isDead = true;
    return stop + 1;
}

}  // namespace glibra::glsl
