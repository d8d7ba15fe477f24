#include "glsl/facts/assignment.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "glsl/facts/assigned_parts.h"
#include "glsl/facts/formula.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/zero.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepest = 200;                 // statements and brackets in each other
constexpr std::size_t kMostVariables = 4096;  // of a function

enum class Direction { in, out, inOut };

/// What a call of a function does to the outputs of the stage.
struct CallEffect {
    std::vector<std::uint32_t> assigns;  ///< by output
    std::set<std::size_t> reads;         ///< outputs that it reads, or lets leave the stage
};

/// The names of the members of a structure or block.
std::vector<std::string_view> membersOf(const Unit& unit, const Declaration& declaration) {
    std::vector<std::string_view> members;
    for (const Declaration& member : declaration.members)
        for (const Declarator& each : member.declarators) members.push_back(unit.text(each.name));
    return members;
}

class AssignmentWalk {
  public:
    explicit AssignmentWalk(const Unit& unit) : unit_(unit), search_(unit) {}

    Assignments find() {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (each.type.isStruct && each.name != kNone) structures_[text(each.name)] = &each;
            if (each.kind == DeclarationKind::function || each.kind == DeclarationKind::prototype)
                functions_[text(each.name)].push_back(&each);
        }
        outputs();
        outputCount_ = variables_.size();
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::function && !each.body.empty()) function(each);
        for (std::size_t i = 0; i < outputCount_; ++i) deliver(variables_[i]);
        return std::move(found_);
    }

  private:
    using Shape = AssignedVariable::Shape;

    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return search_.match(at); }
    [[nodiscard]] bool isWord(std::uint32_t at) const { return at < unit_.view.size() && search_.isWord(at); }
    [[nodiscard]] WordRole role(std::uint32_t at) const { return unit_.bodies.roles[at]; }

    // ---- Variables

    [[nodiscard]] std::vector<std::string_view> membersOfType(const std::string& type) const {
        const auto found = structures_.find(type);
        return found == structures_.end() ? std::vector<std::string_view>()
                                          : membersOf(unit_, *found->second);
    }

    void output(const std::string& name, const std::string& type, std::vector<std::string> sizes) {
        if (!unit_.isWritten(name) || outputs_.contains(name)) return;
        AssignedVariable variable;
        variable.is = {Unassigned::Kind::output, name, type, std::move(sizes), 0, kNone};
        shapeOf(variable, static_cast<int>(variable.is.sizes.size()), membersOfType(type));
        outputs_[name] = variables_.size();
        variables_.push_back(std::move(variable));
    }

    /// The outputs of the stage that some statement writes. Those of a control stage belong to several
    /// invocations.
    void outputs() {
        const bool isFragment = unit_.stage == Stage::fragment;
        if (unit_.stage == Stage::compute || unit_.stage == Stage::tessControl) return;
        if (isFragment) {
            output("gl_FragColor", "vec4", {});
            output("gl_FragDepth", "float", {});
            fragData();
        } else {
            output("gl_Position", "vec4", {});
        }
        for (const Variable& each : unit_.variables) {
            if (each.storage != Storage::output || each.removed || each.name.starts_with("gl_")) continue;
            const Declaration& declaration = unit_.syntax.declarations[each.declaration];
            output(each.name, each.type,
                   sizeTexts(unit_, declaration.declarators[each.declarator].dimensions,
                             declaration.type.dimensions));
        }
        for (const Declaration& each : unit_.syntax.declarations) {
            const bool isBlock = each.kind == DeclarationKind::block &&
                                 each.qualifiers.storage == Storage::output &&
                                 !text(each.name).starts_with("gl_");
            if (isBlock && each.declarators.empty())
                for (const Declaration& member : each.members)
                    for (const Declarator& name : member.declarators)
                        output(std::string(text(name.name)), std::string(member.type.name),
                               sizeTexts(unit_, name.dimensions, member.type.dimensions));
            if (isBlock && each.declarators.size() == 1 && each.declarators.front().dimensions.empty())
                block(each);
        }
    }

    /// A block with the name of an instance counts as a structure.
    void block(const Declaration& declaration) {
        const std::string name(text(declaration.declarators.front().name));
        output(name, "", {});
        if (const auto known = outputs_.find(name); known != outputs_.end()) {
            shapeOf(variables_[known->second], 0, membersOf(unit_, declaration));
            blocks_[known->second] = &declaration;
        }
    }

    void fragData() {
        const auto writes = unit_.writes.find("gl_FragData");
        if (writes == unit_.writes.end()) return;
        int count = 0;
        for (const std::uint32_t at : writes->second) {
            const int index = constantIndex(unit_, at + 1);
            count = std::max(count, index < 0 ? kMostData + 1 : index + 1);
        }
        if (count <= kMostData) output("gl_FragData", "vec4", {std::to_string(count)});
    }

    /// The variable that the word at `at` names; nothing if it is not followed.
    [[nodiscard]] std::optional<std::size_t> variableAt(std::uint32_t at) const {
        const WordRole is = role(at);
        if (is == WordRole::local) {
            for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
                if (const auto found = scope->find(text(at)); found != scope->end()) return found->second;
        } else if (is == WordRole::global) {
            if (const auto found = outputs_.find(text(at)); found != outputs_.end()) return found->second;
        }
        return std::nullopt;
    }

    std::size_t add(AssignedVariable variable) {
        variables_.push_back(std::move(variable));
        state_.sure.resize(variables_.size());
        state_.maybe.resize(variables_.size());
        state_.sure.back() = state_.maybe.back() = 0;  // anew in each round of a loop
        return variables_.size() - 1;
    }

    void declareLocal(const Declaration& declaration, const Declarator& name) {
        AssignedVariable variable;
        variable.is = {Unassigned::Kind::local,
                       std::string(text(name.name)),
                       std::string(declaration.type.name),
                       sizeTexts(unit_, name.dimensions, declaration.type.dimensions),
                       name.dimensionTokens.end > name.name + 1 ? name.dimensionTokens.end - 1 : name.name,
                       kNone};
        shapeOf(variable, static_cast<int>(variable.is.sizes.size()), membersOfType(variable.is.type));
        const std::uint32_t last = declaration.tokens.end - 1;
        if (text(last) == ";" && declaration.declarators.size() == 1) variable.is.statementEnd = last;
        scopes_.back()[text(name.name)] = add(std::move(variable));
    }

    void read(std::size_t index, const AssignedPart& part, std::uint32_t at) {
        AssignedVariable& variable = variables_[index];
        if (state_.isDead || (state_.sure[index] & part.bits) == part.bits) return;
        const bool isOutput = index < outputCount_;
        if (isOutput && !isMain_)
            effect_.reads.insert(index);
        else
            variable.lacks = true;
        std::uint32_t missing = part.bits & ~state_.maybe[index];
        // A part of an array or of a structure that is copied as a whole may never be looked at.
        const bool mayBeUnused = variable.shape == Shape::structure || variable.shape == Shape::indexed;
        if (mayBeUnused && part.bits == variable.all() && state_.maybe[index] != 0) missing = 0;
        const auto later = foreseen_.find(index);
        if (later != foreseen_.end() && branches_ + conditional_ >= later->second) missing = 0;
        if (isOutput || variable.isReported || missing == 0 || at == kNone) return;
        variable.isReported = true;
        found_.reads.push_back({nameOfPart(variable, missing), at});
    }

    void assign(std::size_t index, const AssignedPart& part) {
        if (state_.isDead) return;
        state_.maybe[index] |= part.bits;
        if (part.isExact && conditional_ == 0) state_.sure[index] |= part.bits;
    }

    void deliver(const AssignedVariable& variable) {
        if (!variable.lacks) return;
        const bool isData = variable.is.name == "gl_FragData";
        const auto index = static_cast<std::size_t>(&variable - variables_.data());
        const auto block = blocks_.find(index);
        if (variable.is.kind != Unassigned::Kind::output || (!isData && block == blocks_.end())) {
            found_.variables.push_back(variable.is);
            return;
        }
        Unassigned each = variable.is;
        if (isData) {
            each.sizes.clear();
            for (int i = 0; i < variable.count; ++i) {
                each.name = variable.is.name + "[" + std::to_string(i) + "]";
                found_.variables.push_back(each);
            }
            return;
        }
        for (const Declaration& member : block->second->members)
            for (const Declarator& name : member.declarators) {
                each.name = variable.is.name + "." + std::string(text(name.name));
                each.type = member.type.name;
                each.sizes = sizeTexts(unit_, name.dimensions, member.type.dimensions);
                found_.variables.push_back(each);
            }
    }

    // ---- Functions

    void function(const Declaration& declaration) {
        isMain_ = text(declaration.name) == "main";
        state_ = {};
        state_.sure.assign(variables_.size(), 0);
        state_.maybe.assign(variables_.size(), 0);
        scopes_.assign(1, {});
        exit_ = AssignedState{{}, {}, true};
        effect_ = {};
        foreseen_.clear();
        conditional_ = depth_ = branches_ = 0;
        gaveUp_ = false;
        const std::size_t first = variables_.size();
        const std::uint32_t open = declaration.body.first;
        for (const Parameter& each : declaration.parameters) {
            if (each.name == kNone) continue;
            if (each.qualifiers.storage != Storage::output) {
                scopes_.back()[text(each.name)] = std::nullopt;
                continue;
            }
            AssignedVariable variable;
            variable.is = {Unassigned::Kind::outParameter,
                           std::string(text(each.name)),
                           std::string(each.type.name),
                           sizeTexts(unit_, each.dimensions, each.type.dimensions),
                           open,
                           kNone};
            shapeOf(variable, static_cast<int>(variable.is.sizes.size()), membersOfType(variable.is.type));
            scopes_.back()[text(each.name)] = add(std::move(variable));
        }
        hasReturn_ = false;
        statements({open + 1, declaration.body.end - 1});
        const bool reachesEnd = !state_.isDead;
        if (reachesEnd) exit_.join(state_);
        if (reachesEnd && hasReturn_ && !gaveUp_ && declaration.type.name != "void")
            found_.withoutReturn.push_back(&declaration);
        leave(declaration, first);
    }

    /// What lacks its value where the function ends.
    void leave(const Declaration& declaration, std::size_t first) {
        state_ = exit_;
        state_.sure.resize(variables_.size());
        state_.maybe.resize(variables_.size());
        if (gaveUp_) state_ = {std::vector<std::uint32_t>(variables_.size()), state_.maybe, false};
        if ((isMain_ && unit_.stage != Stage::geometry) || gaveUp_)
            for (std::size_t i = 0; i < outputCount_; ++i) read(i, {variables_[i].all(), false}, kNone);
        for (std::size_t i = first; i < variables_.size(); ++i) {
            AssignedVariable& each = variables_[i];
            if (each.is.kind == Unassigned::Kind::outParameter || gaveUp_)
                read(i, {each.all(), false}, kNone);
            deliver(each);
        }
        if (isMain_)
            for (std::size_t i = 0; i < outputCount_; ++i) variables_[i].is.at = declaration.body.first;
        variables_.resize(first);
        if (isMain_) return;
        effect_.assigns.assign(state_.sure.begin(),
                               state_.sure.begin() + static_cast<std::ptrdiff_t>(outputCount_));
        if (exit_.isDead) std::fill(effect_.assigns.begin(), effect_.assigns.end(), 0U);
        const auto [known, isNew] = effects_.try_emplace(text(declaration.name), effect_);
        if (isNew) return;
        for (std::size_t i = 0; i < outputCount_; ++i) known->second.assigns[i] &= effect_.assigns[i];
        known->second.reads.merge(effect_.reads);
    }

    // ---- Statements

    [[nodiscard]] bool isTooMuch() {
        if (depth_ > kDeepest || variables_.size() > kMostVariables || !search_.spend(1)) gaveUp_ = true;
        return gaveUp_;
    }

    void statements(Range range) {
        for (std::uint32_t at = range.first; at < range.end;) at = statement(at, range.end);
    }

    /// The index of the ';' that ends a statement, or of the '}' that ends its block.
    [[nodiscard]] std::uint32_t expressionEnd(std::uint32_t at, std::uint32_t end) const {
        while (at < end && text(at) != ";" && text(at) != "}")
            at = search_.opens(at) && match(at) < end ? match(at) + 1 : at + 1;
        return at;
    }

    std::uint32_t statement(std::uint32_t at, std::uint32_t end) {
        if (isTooMuch()) return end;
        ++depth_;
        const std::uint32_t next = std::max(afterStatement(at, end), at + 1);
        --depth_;
        return next;
    }

    std::uint32_t afterStatement(std::uint32_t at, std::uint32_t end) {
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

    [[nodiscard]] bool isDeclaration(std::uint32_t at, std::uint32_t end) const {
        for (std::uint32_t i = at; i < end && isWord(i); ++i) {
            if (role(i) == WordRole::localDeclaration) return i > at;
            if (text(i) == "struct") return true;
            if (role(i) != WordRole::other) return false;
            while ((text(i + 1) == "[" || (text(i) == "layout" && text(i + 1) == "(")) && match(i + 1) < end)
                i = match(i + 1);
        }
        return false;
    }

    std::uint32_t declaration(std::uint32_t at, std::uint32_t end) {
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

    /// The parts between the ';' of a header, each a declaration or an expression.
    void header(Range range) {
        if (isDeclaration(range.first, range.end))
            declaration(range.first, range.end);
        else
            expression(range);
    }

    std::uint32_t branch(std::uint32_t at, std::uint32_t end) {
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

    /// Notes what the body of a loop assigns: a read on a condition may be one of a later round. The body
    /// itself counts as one more condition if it may have no round.
    void foresee(Range body, bool mayBeEmpty) {
        const int inBody = branches_ + (mayBeEmpty ? 1 : 0);
        int level = inBody + 1;
        for (std::uint32_t i = body.first; i < body.end; ++i)
            if (text(i) == "continue" || text(i) == "break" || text(i) == "return") level = inBody;
        for (std::uint32_t i = body.first; i < body.end && search_.spend(1); ++i) {
            const std::optional<std::size_t> index = isWord(i) ? variableAt(i) : std::nullopt;
            if (!index) continue;
            const std::string_view next = text(afterSuffixes(unit_, i));
            if (next != "=" && next != "," && next != ")") continue;
            int& known = foreseen_.try_emplace(*index, level).first->second;
            known = std::min(known, level);
        }
    }

    [[nodiscard]] bool isAlwaysTrue(Range condition) const {
        return condition.empty() || (condition.end == condition.first + 1 && text(condition.first) == "true");
    }

    [[nodiscard]] bool hasLogic(Range condition) const {
        for (std::uint32_t i = condition.first; i < condition.end; ++i)
            if (text(i) == "&&" || text(i) == "||") return true;
        return false;
    }

    /// The body of a loop whose condition has been evaluated. Gives the state after the loop; a `break`
    /// leaves it, too.
    std::uint32_t loop(std::uint32_t body, std::uint32_t end, Range condition, Range step, bool mayBeEmpty) {
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

    std::uint32_t forLoop(std::uint32_t at, std::uint32_t end) {
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

    /// About the end of the statement at `at`, without a walk through it.
    [[nodiscard]] std::uint32_t bodyEnd(std::uint32_t at, std::uint32_t end) const {
        while (at < end && text(at) != "{" && text(at) != ";")
            at = search_.opens(at) && match(at) < end ? match(at) + 1 : at + 1;
        return at < end && text(at) == "{" ? std::min(match(at), end) : at;
    }

    std::uint32_t whileLoop(std::uint32_t at, std::uint32_t end) {
        const std::uint32_t close = match(at + 1);
        scopes_.emplace_back();
        const bool mayBeEmpty = !isAlwaysTrue({at + 2, close});
        foresee({at + 2, bodyEnd(close + 1, end)}, mayBeEmpty);
        header({at + 2, close});
        const std::uint32_t next = loop(close + 1, end, {at + 2, close}, {}, mayBeEmpty);
        scopes_.pop_back();
        return next;
    }

    std::uint32_t doLoop(std::uint32_t at, std::uint32_t end) {
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

    /// `for (int i = 0; i < n; ++i) a[i] = ...;` gives an array of up to n elements its values.
    void fill(const std::vector<Range>& parts, Range body) {
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
        for (std::uint32_t i = body.first; i < body.end; ++i)
            if (text(i) == "break" || text(i) == "continue" || text(i) == "return" ||
                search_.isChange(counter, i))
                return;
        const Range limit{condition.first + 2, condition.end};
        int depth = 0;
        for (std::uint32_t i = body.first; i < body.end; ++i) {
            if (text(i) == "{") ++depth;
            if (text(i) == "}") --depth;
            const std::string_view before = text(i - 1);
            const bool begins = i == body.first || before == "{" || before == "}" || before == ";";
            if (!begins || depth > 1 || !isWord(i)) continue;
            const std::optional<std::size_t> index = variableAt(i);
            const bool isElement = index && text(i + 1) == "[" && text(i + 2) == counter &&
                                   text(i + 3) == "]" && text(i + 4) == "=";
            if (!isElement || variables_[*index].is.sizes.size() != 1) continue;
            long long rounds = 0;
            const bool isOwnLength = limit.end == limit.first + 5 && text(limit.first) == text(i) &&
                                     text(limit.first + 2) == "length";
            const bool coversAll = globalIntegerValue(unit_, limit, rounds) &&
                                   variables_[*index].elements > 0 && rounds >= variables_[*index].elements;
            if (isOwnLength || coversAll) assign(*index, {variables_[*index].all(), true});
        }
    }

    std::uint32_t switchOver(std::uint32_t at, std::uint32_t end) {
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

    std::uint32_t label(std::uint32_t at, std::uint32_t end) {
        hasDefault_ = hasDefault_ || text(at) == "default";
        while (at < end && text(at) != ":" && text(at) != ";" && text(at) != "}") ++at;
        state_.join(switch_);
        return at + 1;
    }

    std::uint32_t jump(std::uint32_t at, std::uint32_t end) {
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

    // ---- Expressions

    void expression(Range range) {
        if (isTooMuch()) return;
        ++depth_;
        const int outer = conditional_;
        for (std::uint32_t at = range.first; at < range.end && search_.spend(1);) {
            const std::string_view each = text(at);
            if (each == "&&" || each == "||" || each == "?") {
                ++conditional_;
                ++at;
            } else if (isWord(at) && text(at + 1) == "(" && match(at + 1) < range.end) {
                at = call(at);
            } else if (search_.opens(at) && match(at) < range.end) {
                expression({at + 1, match(at)});
                at = match(at) + 1;
            } else if (const auto index = isWord(at) ? variableAt(at) : std::nullopt) {
                at = use(*index, at, range.end);
            } else {
                ++at;
            }
        }
        conditional_ = outer;
        --depth_;
    }

    /// Reads the subscripts after a name.
    void subscripts(Range suffix) {
        for (std::uint32_t i = suffix.first; i < suffix.end; ++i) {
            if (text(i) != "[" || match(i) >= suffix.end) continue;
            expression({i + 1, match(i)});
            i = match(i);
        }
    }

    std::uint32_t use(std::size_t index, std::uint32_t at, std::uint32_t end) {
        const auto isStep = [](std::string_view each) { return each == "++" || each == "--"; };
        const std::uint32_t after = std::min(afterSuffixes(unit_, at), end);
        const Range suffix{at + 1, after};
        subscripts(suffix);
        const bool isLength = after > at + 2 && text(after - 1) == "length" && text(after) == "(";
        if (isLength) return after;
        const AssignedPart part = partOf(unit_, variables_[index], suffix);
        const std::string_view next = after < end ? text(after) : std::string_view();
        if (next == "=") {
            std::uint32_t stop = after + 1;
            while (stop < end && text(stop) != ",")
                stop = search_.opens(stop) && match(stop) < end ? match(stop) + 1 : stop + 1;
            expression({after + 1, stop});
            assign(index, part);
            return stop;
        }
        const bool isChange = isAssignment(next) || isStep(next) || isStep(text(at - 1));
        // `(name) = value` is written where it seems to be read.
        const bool isOtherWrite = !isChange && isWrittenAt(unit_, at);
        read(index, part, isOtherWrite ? kNone : at);
        if (isOtherWrite) state_.maybe[index] |= part.bits;
        return after;
    }

    [[nodiscard]] Direction directionOf(std::string_view function, std::size_t argument,
                                        std::size_t count) const {
        const auto known = functions_.find(function);
        if (known == functions_.end())
            return (builtinOutputs(function) >> argument & 1U) != 0 ? Direction::out : Direction::in;
        bool allOut = true, anyOut = false;
        for (const Declaration* each : known->second) {
            if (each->parameters.size() != count) continue;
            const Storage storage = each->parameters[argument].qualifiers.storage;
            allOut = allOut && storage == Storage::output;
            anyOut = anyOut || storage == Storage::output || storage == Storage::inputOutput;
        }
        return !anyOut ? Direction::in : allOut ? Direction::out : Direction::inOut;
    }

    std::uint32_t call(std::uint32_t at) {
        const std::string_view function = text(at);
        const std::uint32_t close = match(at + 1);
        const std::vector<Range> arguments =
            close > at + 2 ? search_.parts({at + 2, close}, ",") : std::vector<Range>();
        search_.spend(close - at);
        std::vector<std::pair<std::size_t, AssignedPart>> results;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const Range& each = arguments[i];
            const Direction direction = role(at) == WordRole::global && i < 31
                                            ? directionOf(function, i, arguments.size())
                                            : Direction::in;
            const std::optional<std::size_t> index =
                isWord(each.first) && direction != Direction::in ? variableAt(each.first) : std::nullopt;
            if (!index || afterSuffixes(unit_, each.first) != each.end) {
                expression(each);
                continue;
            }
            const Range suffix{each.first + 1, each.end};
            const AssignedPart part = partOf(unit_, variables_[*index], suffix);
            subscripts(suffix);
            // Which overload is called is not known, so an `inout` may be an `out`.
            if (direction == Direction::inOut) read(*index, part, kNone);
            results.emplace_back(*index, part);
        }
        for (const auto& [index, part] : results) assign(index, part);
        if (role(at) == WordRole::global) effectsOf(function);
        return close + 1;
    }

    void effectsOf(std::string_view function) {
        if (function == "EmitVertex" || function == "EmitStreamVertex")
            for (std::size_t i = 0; i < outputCount_; ++i) read(i, {variables_[i].all(), false}, kNone);
        if (!functions_.contains(function)) return;
        const auto known = effects_.find(function);
        for (std::size_t i = 0; i < outputCount_; ++i) {
            // A function that is defined later may do anything.
            if (known == effects_.end() || known->second.reads.contains(i))
                read(i, {variables_[i].all(), false}, kNone);
            if (known != effects_.end()) assign(i, {known->second.assigns[i], true});
        }
    }

    static constexpr int kMostData = 8;

    const Unit& unit_;
    TokenSearch search_;
    Assignments found_;
    std::unordered_map<std::string_view, const Declaration*> structures_;
    std::unordered_map<std::string_view, std::vector<const Declaration*>> functions_;
    std::map<std::string, std::size_t, std::less<>> outputs_;  ///< the first of `variables_`
    std::map<std::size_t, const Declaration*> blocks_;         ///< outputs that are blocks
    std::map<std::string_view, CallEffect> effects_;
    std::size_t outputCount_ = 0;
    std::vector<AssignedVariable> variables_;

    // Of the function that is being walked
    std::vector<std::unordered_map<std::string_view, std::optional<std::size_t>>> scopes_;
    AssignedState state_, exit_, breaks_, continues_, switch_;
    CallEffect effect_;
    std::map<std::size_t, int> foreseen_;  ///< variables that a loop assigns: the branches of a guarded read
    int branches_ = 0;                     ///< `if` and `switch` around the statement
    int conditional_ = 0;                  ///< operands around that may not be evaluated
    int depth_ = 0;
    bool isMain_ = false, hasReturn_ = false, hasDefault_ = false;
    bool gaveUp_ = false;  ///< the function is too large: all its variables may lack their values
};

}  // namespace

Assignments findUnassigned(const Unit& unit) {
    return AssignmentWalk(unit).find();
}

}  // namespace glibra::glsl
