#include "glsl/facts/assignment.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"

namespace glibra::glsl {
namespace {

constexpr int kMostData = 8;
constexpr int kDeepestWalk = 200;             // statements and brackets in each other
constexpr std::size_t kMostVariables = 4096;  // of a function

/// What a call of a function does to the outputs of the stage.
struct CallEffect {
    std::vector<std::uint32_t> assigns;  ///< by output
    std::set<std::size_t> reads;         ///< outputs that it reads, or lets leave the stage
};

/// Walks through the functions of a stage in the order of the text.
class AssignmentWalk {
  public:
    explicit AssignmentWalk(const Unit& unit) : unit_(unit), bodies_(unit.bodies) {}

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
    enum class Direction { in, out, inOut };

    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] const Node& node(std::uint32_t id) const { return bodies_.nodes[id]; }

    // ---- Variables

    std::vector<std::string_view> membersOfType(const std::string& type) const {
        const auto found = structures_.find(type);
        return found == structures_.end() ? std::vector<std::string_view>()
                                          : membersOf(unit_, *found->second);
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
    void output(const std::string& name, const std::string& type, std::vector<std::string> sizes) {
        if (!unit_.isWritten(name) || outputs_.contains(name)) return;
        AssignedVariable variable;
        variable.is = {Unassigned::Kind::output, name, type, std::move(sizes), 0, kNone};
        shapeOf(variable, static_cast<int>(variable.is.sizes.size()), membersOfType(type));
        outputs_[name] = variables_.size();
        variables_.push_back(std::move(variable));
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
    std::optional<std::size_t> variableAt(std::uint32_t at) const {
        if (bodies_.roles[at] == WordRole::local) {
            const auto found = locals_.find(bodies_.meanings[at]);
            return found == locals_.end() ? std::nullopt : std::optional(found->second);
        }
        const auto found = bodies_.roles[at] == WordRole::global ? outputs_.find(text(at)) : outputs_.end();
        return found == outputs_.end() ? std::nullopt : std::optional(found->second);
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
        locals_[name.name] = add(std::move(variable));
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
        locals_.clear();
        exit_ = AssignedState{{}, {}, true};
        effect_ = {};
        foreseen_.clear();
        conditional_ = depth_ = branches_ = 0;
        gaveUp_ = false;
        const std::size_t first = variables_.size();
        const std::uint32_t open = declaration.body.first;
        for (const Parameter& each : declaration.parameters) {
            if (each.name == kNone || each.qualifiers.storage != Storage::output) continue;
            AssignedVariable variable;
            variable.is = {Unassigned::Kind::outParameter,
                           std::string(text(each.name)),
                           std::string(each.type.name),
                           sizeTexts(unit_, each.dimensions, each.type.dimensions),
                           open,
                           kNone};
            shapeOf(variable, static_cast<int>(variable.is.sizes.size()), membersOfType(variable.is.type));
            locals_[each.name] = add(std::move(variable));
        }
        hasReturn_ = false;
        statements(declaration.code);
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
            const AssignedVariable& each = variables_[i];
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
        if (exit_.isDead) std::ranges::fill(effect_.assigns, 0U);
        const auto [known, isNew] = effects_.try_emplace(text(declaration.name), effect_);
        if (isNew) return;
        for (std::size_t i = 0; i < outputCount_; ++i) known->second.assigns[i] &= effect_.assigns[i];
        known->second.reads.merge(effect_.reads);
    }

    // ---- Statements

    [[nodiscard]] bool isTooMuch() {
        gaveUp_ = gaveUp_ || depth_ > kDeepestWalk || variables_.size() > kMostVariables;
        return gaveUp_;
    }

    void statements(std::uint32_t block) {
        for (const std::uint32_t each : bodies_.children(block)) statement(each);
    }

    void statement(std::uint32_t id) {
        if (isTooMuch()) return;
        ++depth_;
        const Node& it = node(id);
        switch (it.kind) {
            case NodeKind::block:
                statements(id);
                break;
            case NodeKind::branch:
                branch(id);
                break;
            case NodeKind::forLoop:
                forLoop(id);
                break;
            case NodeKind::whileLoop:
                whileLoop(id);
                break;
            case NodeKind::doLoop:
                doLoop(id);
                break;
            case NodeKind::choice:
                choice(id);
                break;
            case NodeKind::label:
                hasDefault_ = hasDefault_ || text(it.token) == "default";
                state_.join(switch_);
                break;
            case NodeKind::jump:
                jump(id);
                break;
            default:
                expression(id);
        }
        --depth_;
    }

    void declaration(std::uint32_t id) {
        const Declaration& parsed = bodies_.declarations[node(id).token];
        for (const Declarator& each : parsed.declarators) {
            if (each.value != kNone) expression(each.value);
            const bool isFollowed = each.initializer.empty() && parsed.qualifiers.storage == Storage::none &&
                                    !parsed.type.name.empty();
            if (isFollowed) declareLocal(parsed, each);
        }
    }

    void branch(std::uint32_t id) {
        expression(bodies_.child(id, 0));
        const AssignedState before = state_;
        ++branches_;
        statement(bodies_.child(id, 1));
        if (const std::uint32_t otherwise = bodies_.child(id, 2); otherwise != kNone) {
            const AssignedState then = std::exchange(state_, before);
            statement(otherwise);
            state_.join(then);
        } else {
            state_.join(before);
        }
        --branches_;
    }

    /// Notes what a loop assigns from the token `first` on: a read on a condition may be one of a later
    /// round. The body itself counts as one more condition if it may have no round.
    void foresee(std::uint32_t first, std::uint32_t body, bool mayBeEmpty) {
        const Range range{first, node(body).end};
        const int inBody = branches_ + (mayBeEmpty ? 1 : 0);
        const int level = unit_.hasAny(range, {"continue", "break", "return"}) ? inBody : inBody + 1;
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            const std::optional<std::size_t> index =
                unit_.view[i].kind == TokenKind::word ? variableAt(i) : std::nullopt;
            if (!index) continue;
            const std::string_view next = text(afterSuffixes(unit_, i));
            if (next != "=" && next != "," && next != ")") continue;
            int& known = foreseen_.try_emplace(*index, level).first->second;
            known = std::min(known, level);
        }
    }

    [[nodiscard]] bool isAlwaysTrue(std::uint32_t condition) const {
        const Node& it = node(condition);
        return it.kind == NodeKind::empty || (it.kind == NodeKind::name && text(it.token) == "true");
    }

    /// The body of a loop whose condition has been evaluated, and what is assigned after it; a `break` leaves
    /// it, too.
    void loop(std::uint32_t body, std::uint32_t condition, std::uint32_t step, bool mayBeEmpty) {
        const AssignedState before = state_;
        const auto outer = std::exchange(breaks_, AssignedState{{}, {}, true});
        branches_ += mayBeEmpty ? 1 : 0;
        statement(body);
        branches_ -= mayBeEmpty ? 1 : 0;
        state_.isDead = false;
        state_.join(before);  // after `continue`
        if (step != kNone) expression(step);
        const AssignedState leaving = std::exchange(breaks_, outer);
        const std::vector<std::uint32_t> maybe = state_.maybe;
        state_ = before;
        for (std::size_t i = 0; i < state_.maybe.size() && i < maybe.size(); ++i) state_.maybe[i] |= maybe[i];
        if (isAlwaysTrue(condition)) state_.isDead = true;
        state_.join(leaving);
    }

    void forLoop(std::uint32_t id) {
        if (bodies_.childCount(id) != 4) gaveUp_ = true;
        if (gaveUp_) return;
        const std::uint32_t first = node(id).child, condition = node(first).next;
        const std::uint32_t step = node(condition).next, body = node(step).next;
        expression(first);
        // A counter that the loop itself sets and compares has a round as a rule.
        const bool hasLogic = unit_.hasAny(node(condition).range(), {"&&", "||"});
        const bool mayBeEmpty = !isAlwaysTrue(condition) && (node(first).kind == NodeKind::empty || hasLogic);
        foresee(node(condition).first, body, mayBeEmpty);
        expression(condition);
        loop(body, condition, step, mayBeEmpty);
        fill(first, condition, step, body);
    }

    void whileLoop(std::uint32_t id) {
        const std::uint32_t condition = node(id).child, body = node(id).lastChild;
        const bool mayBeEmpty = !isAlwaysTrue(condition);
        foresee(node(id).first + 2, body, mayBeEmpty);
        expression(condition);
        loop(body, condition, kNone, mayBeEmpty);
    }

    void doLoop(std::uint32_t id) {
        const std::uint32_t body = node(id).child, condition = node(body).next;
        foresee(node(body).first, body, false);
        const auto outer = std::exchange(breaks_, AssignedState{{}, {}, true});
        const auto outerContinues = std::exchange(continues_, AssignedState{{}, {}, true});
        statement(body);
        state_.join(std::exchange(continues_, outerContinues));
        const AssignedState leaving = std::exchange(breaks_, outer);
        if (condition != kNone) {
            expression(condition);
            if (isAlwaysTrue(condition)) state_.isDead = true;
        }
        state_.join(leaving);
    }

    /// `for (int i = 0; i < n; ++i) a[i] = ...;` gives an array of up to n elements its values.
    void fill(std::uint32_t first, std::uint32_t condition, std::uint32_t step, std::uint32_t body) {
        const auto is = [&](std::uint32_t id, NodeKind kind) { return id != kNone && node(id).kind == kind; };
        const auto named = [&](std::uint32_t id) {
            return is(id, NodeKind::name) ? text(node(id).token) : "";
        };
        const std::uint32_t start = node(first).child;
        if (!is(first, NodeKind::declaration) || start == kNone || start != node(first).lastChild ||
            state_.isDead)
            return;
        const std::string_view counter = text(node(start).token);
        const Node& limit = node(is(condition, NodeKind::chain) ? node(condition).lastChild : condition);
        const bool isFromZero = is(node(start).child, NodeKind::number) &&
                                (text(node(start).end - 1) == "0" || text(node(start).end - 1) == "0u");
        const bool isStep = (is(step, NodeKind::step) || is(step, NodeKind::prefix)) &&
                            node(step).end == node(step).first + 2 && named(node(step).child) == counter &&
                            text(node(step).token) == "++";
        const bool isCounted = isFromZero && isStep && is(condition, NodeKind::chain) &&
                               text(limit.first - 1) == "<" && named(node(condition).child) == counter &&
                               bodies_.childCount(condition) == 2;
        const Range range = node(body).range();
        if (!isCounted || unit_.hasAny(range, {"break", "continue", "return"})) return;
        for (std::uint32_t i = range.first; i < range.end; ++i)
            if (text(i) == counter && bodies_.roles[i] != WordRole::member && isWrittenAt(unit_, i)) return;
        const auto visit = [&](std::uint32_t each) {
            const std::uint32_t value = is(each, NodeKind::evaluation) ? node(each).child : kNone;
            const std::uint32_t target = is(value, NodeKind::assignment) ? node(value).child : kNone;
            if (!is(target, NodeKind::subscript) || text(node(value).token) != "=" ||
                !is(node(target).child, NodeKind::name) || named(node(target).lastChild) != counter)
                return;
            const std::uint32_t name = node(target).first;
            const std::optional<std::size_t> index = variableAt(name);
            if (!index || variables_[*index].is.sizes.size() != 1) return;
            long long rounds = 0;
            const bool isOwnLength = limit.kind == NodeKind::method && text(limit.token) == "length" &&
                                     named(limit.child) == text(name);
            const bool coversAll = globalIntegerValue(unit_, limit.range(), rounds) &&
                                   variables_[*index].elements > 0 && rounds >= variables_[*index].elements;
            if (isOwnLength || coversAll) assign(*index, {variables_[*index].all(), true});
        };
        if (is(body, NodeKind::block))
            for (const std::uint32_t each : bodies_.children(body)) visit(each);
        else
            visit(body);
    }

    void choice(std::uint32_t id) {
        expression(node(id).child);
        const auto outer = std::exchange(breaks_, AssignedState{{}, {}, true});
        const auto outerSwitch = std::exchange(switch_, state_);
        const bool outerDefault = std::exchange(hasDefault_, false);
        state_.isDead = true;
        ++branches_;
        statement(node(id).lastChild);
        --branches_;
        state_.join(std::exchange(breaks_, outer));
        const AssignedState before = std::exchange(switch_, outerSwitch);
        if (!std::exchange(hasDefault_, outerDefault)) state_.join(before);
    }

    void jump(std::uint32_t id) {
        if (node(id).child != kNone) expression(node(id).child);
        const std::string_view word = text(node(id).token);
        if (word == "return") {
            hasReturn_ = true;
            exit_.join(state_);
        } else if (word == "break") {
            breaks_.join(state_);
        } else if (word == "continue") {
            continues_.join(state_);
        }
        state_.isDead = true;
    }

    // ---- Expressions

    void expression(std::uint32_t id) {
        if (isTooMuch()) return;
        const Node& it = node(id);
        const bool isDeeper =
            it.kind == NodeKind::group || it.kind == NodeKind::subscript || it.kind == NodeKind::list;
        depth_ += isDeeper ? 1 : 0;
        switch (it.kind) {
            case NodeKind::declaration:
                declaration(id);
                break;
            case NodeKind::call:
                call(id);
                break;
            case NodeKind::assignment:
                assignment(id);
                break;
            case NodeKind::selection:
                expression(it.child);
                ++conditional_;
                expression(node(it.child).next);
                expression(it.lastChild);
                --conditional_;
                break;
            case NodeKind::name:
            case NodeKind::member:
            case NodeKind::subscript:
            case NodeKind::method:
                if (!use(id)) operands(id);
                break;
            case NodeKind::unknown:
                tokens(it.range());
                break;
            default:
                operands(id);
        }
        depth_ -= isDeeper ? 1 : 0;
    }

    /// What the parser could not read.
    void tokens(Range range) {
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            const std::optional<std::size_t> index = variableAt(i);
            if (!index) continue;
            const std::uint32_t after = afterSuffixes(unit_, i);
            const AssignedPart part = partOf(unit_, variables_[*index], {i + 1, after});
            if (text(after) == "=")
                assign(*index, part);
            else
                read(*index, part, i);
        }
    }

    /// The operands of an expression, of which && and || may leave out some.
    void operands(std::uint32_t id) {
        const int outer = conditional_;
        for (const std::uint32_t each : bodies_.children(id)) {
            const std::string_view before = node(id).kind == NodeKind::chain && each != node(id).child
                                                ? text(node(each).first - 1)
                                                : std::string_view();
            if (before == "&&" || before == "||") ++conditional_;
            expression(each);
        }
        conditional_ = outer;
    }

    /// A followed variable with the members and subscripts after its name.
    struct Use {
        std::size_t index;
        AssignedPart part;
    };
    [[nodiscard]] std::optional<Use> useAt(std::uint32_t id) const {
        std::uint32_t base = id;
        while (node(base).kind == NodeKind::member || node(base).kind == NodeKind::subscript)
            base = node(base).child;
        if (node(base).kind != NodeKind::name) return std::nullopt;
        const auto index = variableAt(node(base).token);
        if (!index) return std::nullopt;
        return Use{*index, partOf(unit_, variables_[*index], {node(base).end, node(id).end})};
    }
    void subscripts(std::uint32_t id) {
        if (node(id).kind != NodeKind::member && node(id).kind != NodeKind::subscript) return;
        subscripts(node(id).child);
        if (node(id).kind == NodeKind::subscript) expression(node(id).lastChild);
    }

    /// False: this is no use of a variable that is followed.
    bool use(std::uint32_t id) {
        const bool isMethod = node(id).kind == NodeKind::method;
        const std::uint32_t object = isMethod ? node(id).child : id;
        const std::optional<Use> used = useAt(object);
        if (!used) return false;
        subscripts(object);
        if (isMethod && text(node(id).token) == "length") return true;
        // `(name) = value` is written where it seems to be read.
        const std::uint32_t at = node(object).first;
        const std::uint32_t around = node(id).parent;
        const bool isChange = isStep(text(node(id).end)) || (at > 0 && isStep(text(at - 1))) ||
                              (around != kNone && node(around).kind == NodeKind::assignment);
        const bool isOtherWrite = !isChange && isWrittenAt(unit_, at);
        read(used->index, used->part, isOtherWrite ? kNone : at);
        if (isOtherWrite) state_.maybe[used->index] |= used->part.bits;
        return true;
    }

    void assignment(std::uint32_t id) {
        const std::uint32_t target = node(id).child, value = node(id).lastChild;
        const std::optional<Use> used = text(node(id).token) == "=" ? useAt(target) : std::optional<Use>();
        if (!used) {
            expression(target);
            expression(value);
            return;
        }
        subscripts(target);
        expression(value);
        assign(used->index, used->part);
    }

    Direction directionOf(std::string_view function, std::size_t argument, std::size_t count) const {
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

    void call(std::uint32_t id) {
        const std::string_view function = text(node(id).token);
        const bool isGlobal = bodies_.roles[node(id).token] == WordRole::global;
        const auto count = static_cast<std::size_t>(bodies_.childCount(id));
        std::vector<Use> results;
        std::size_t i = 0;
        for (const std::uint32_t each : bodies_.children(id)) {
            const Direction direction = isGlobal && i < 31 ? directionOf(function, i, count) : Direction::in;
            ++i;
            const std::optional<Use> used = direction != Direction::in ? useAt(each) : std::nullopt;
            if (!used) {
                expression(each);
                continue;
            }
            subscripts(each);
            // Which overload is called is not known, so an `inout` may be an `out`.
            if (direction == Direction::inOut) read(used->index, used->part, kNone);
            results.push_back(*used);
        }
        for (const Use& each : results) assign(each.index, each.part);
        if (isGlobal) effectsOf(function);
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

    const Unit& unit_;
    const Bodies& bodies_;
    Assignments found_;
    std::unordered_map<std::string_view, const Declaration*> structures_;
    std::unordered_map<std::string_view, std::vector<const Declaration*>> functions_;
    std::map<std::string, std::size_t, std::less<>> outputs_;  ///< the first of `variables_`
    std::map<std::size_t, const Declaration*> blocks_;         ///< outputs that are blocks
    std::map<std::string_view, CallEffect> effects_;
    std::size_t outputCount_ = 0;
    std::vector<AssignedVariable> variables_;

    // Of the function that is being walked
    std::unordered_map<std::uint32_t, std::size_t> locals_;  ///< by the name in the declaration
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
