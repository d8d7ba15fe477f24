// What expressions read and assign.

#include <algorithm>
#include <utility>

#include "glsl/facts/assignment_walk.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"

namespace glibra::glsl {

void AssignmentWalk::expression(Range range) {
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

void AssignmentWalk::subscripts(Range suffix) {
    for (std::uint32_t i = suffix.first; i < suffix.end; ++i) {
        if (text(i) != "[" || match(i) >= suffix.end) continue;
        expression({i + 1, match(i)});
        i = match(i);
    }
}

std::uint32_t AssignmentWalk::use(std::size_t index, std::uint32_t at, std::uint32_t end) {
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

AssignmentWalk::Direction AssignmentWalk::directionOf(std::string_view function, std::size_t argument,
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

std::uint32_t AssignmentWalk::call(std::uint32_t at) {
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

void AssignmentWalk::effectsOf(std::string_view function) {
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

}  // namespace glibra::glsl
