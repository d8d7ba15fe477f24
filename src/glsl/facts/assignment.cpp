#include "glsl/facts/assignment.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include "glsl/facts/assignment_walk.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/zero.h"

namespace glibra::glsl {
namespace {

/// The names of the members of a structure or block.
std::vector<std::string_view> membersOf(const Unit& unit, const Declaration& declaration) {
    std::vector<std::string_view> members;
    for (const Declaration& member : declaration.members)
        for (const Declarator& each : member.declarators) members.push_back(unit.text(each.name));
    return members;
}

}  // namespace

Assignments AssignmentWalk::find() {
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

std::vector<std::string_view> AssignmentWalk::membersOfType(const std::string& type) const {
    const auto found = structures_.find(type);
    return found == structures_.end() ? std::vector<std::string_view>() : membersOf(unit_, *found->second);
}

void AssignmentWalk::output(const std::string& name, const std::string& type,
                            std::vector<std::string> sizes) {
    if (!unit_.isWritten(name) || outputs_.contains(name)) return;
    AssignedVariable variable;
    variable.is = {Unassigned::Kind::output, name, type, std::move(sizes), 0, kNone};
    shapeOf(variable, static_cast<int>(variable.is.sizes.size()), membersOfType(type));
    outputs_[name] = variables_.size();
    variables_.push_back(std::move(variable));
}

void AssignmentWalk::outputs() {
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

void AssignmentWalk::block(const Declaration& declaration) {
    const std::string name(text(declaration.declarators.front().name));
    output(name, "", {});
    if (const auto known = outputs_.find(name); known != outputs_.end()) {
        shapeOf(variables_[known->second], 0, membersOf(unit_, declaration));
        blocks_[known->second] = &declaration;
    }
}

void AssignmentWalk::fragData() {
    const auto writes = unit_.writes.find("gl_FragData");
    if (writes == unit_.writes.end()) return;
    int count = 0;
    for (const std::uint32_t at : writes->second) {
        const int index = constantIndex(unit_, at + 1);
        count = std::max(count, index < 0 ? kMostData + 1 : index + 1);
    }
    if (count <= kMostData) output("gl_FragData", "vec4", {std::to_string(count)});
}

std::optional<std::size_t> AssignmentWalk::variableAt(std::uint32_t at) const {
    const WordRole is = role(at);
    if (is == WordRole::local) {
        for (const auto& scope : std::ranges::reverse_view(scopes_))
            if (const auto found = scope.find(text(at)); found != scope.end()) return found->second;
    } else if (is == WordRole::global) {
        if (const auto found = outputs_.find(text(at)); found != outputs_.end()) return found->second;
    }
    return std::nullopt;
}

std::size_t AssignmentWalk::add(AssignedVariable variable) {
    variables_.push_back(std::move(variable));
    state_.sure.resize(variables_.size());
    state_.maybe.resize(variables_.size());
    state_.sure.back() = state_.maybe.back() = 0;  // anew in each round of a loop
    return variables_.size() - 1;
}

void AssignmentWalk::declareLocal(const Declaration& declaration, const Declarator& name) {
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

void AssignmentWalk::read(std::size_t index, const AssignedPart& part, std::uint32_t at) {
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

void AssignmentWalk::assign(std::size_t index, const AssignedPart& part) {
    if (state_.isDead) return;
    state_.maybe[index] |= part.bits;
    if (part.isExact && conditional_ == 0) state_.sure[index] |= part.bits;
}

void AssignmentWalk::deliver(const AssignedVariable& variable) {
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

void AssignmentWalk::function(const Declaration& declaration) {
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

void AssignmentWalk::leave(const Declaration& declaration, std::size_t first) {
    state_ = exit_;
    state_.sure.resize(variables_.size());
    state_.maybe.resize(variables_.size());
    if (gaveUp_) state_ = {std::vector<std::uint32_t>(variables_.size()), state_.maybe, false};
    if ((isMain_ && unit_.stage != Stage::geometry) || gaveUp_)
        for (std::size_t i = 0; i < outputCount_; ++i) read(i, {variables_[i].all(), false}, kNone);
    for (std::size_t i = first; i < variables_.size(); ++i) {
        const AssignedVariable& each = variables_[i];
        if (each.is.kind == Unassigned::Kind::outParameter || gaveUp_) read(i, {each.all(), false}, kNone);
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

Assignments findUnassigned(const Unit& unit) {
    return AssignmentWalk(unit).find();
}

}  // namespace glibra::glsl
