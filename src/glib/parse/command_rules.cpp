// Rules about several numbers of one command (language, 3.1 and 3.2).

#include <fmt/format.h>

#include <array>

#include "base/text.h"
#include "glib/number.h"
#include "glib/parse/arguments.h"

namespace glibra::glib {
namespace {

/// Returns the place of number `index`, or the place of the command if the file does not state the number.
Position placeOf(const Command& command, std::span<const Position> places, std::size_t index) {
    return index < places.size() ? places[index] : command.position;
}

void checkPerspective(const Command& command, std::span<const Position> places, MessageLog& log) {
    const double near = command.numbers[1];
    const double far = command.numbers[2];
    if (near <= 0)
        log.report("glib-E05", fmt::format("Perspective: near {} is not above 0", numberText(near)),
                   placeOf(command, places, 1));
    else if (far <= near)
        log.report("glib-E29",
                   fmt::format("Perspective: near {} is not below far {}", numberText(near), numberText(far)),
                   placeOf(command, places, places.size() > 2 ? 2 : 1));
}

void checkOrtho(Command& command, std::span<const Position> places, MessageLog& log) {
    static constexpr std::array<bool, 7> kIncomplete = {false, true, true, true, false, true, false};
    if (kIncomplete.at(command.givenNumbers))
        log.report(
            "glib-W06",
            fmt::format("Ortho: {}, the rest are defaults", base::counted(command.givenNumbers, "number")),
            command.position);
    static constexpr std::array<const char*, 2> kSides = {"left and right", "bottom and top"};
    for (std::size_t axis = 0; axis < kSides.size(); ++axis) {
        double& low = command.numbers[2 * axis];
        double& high = command.numbers[2 * axis + 1];
        if (low != high) continue;
        low = -1;
        high = 1;
        log.report("glib-W29", fmt::format("Ortho: {} are equal, -1 ... 1 used", kSides.at(axis)),
                   placeOf(command, places, 2 * axis));
    }
    if (command.numbers[4] == command.numbers[5])
        log.report("glib-E29", fmt::format("Ortho: near and far are both {}", numberText(command.numbers[4])),
                   placeOf(command, places, places.size() > 5 ? 5 : 4));
}

void checkRotate(const Command& command, std::span<const Position> places, MessageLog& log) {
    if (command.numbers[1] == 0 && command.numbers[2] == 0 && command.numbers[3] == 0)
        log.report("glib-W42", "Rotate: the axis is 0 0 0, no rotation", placeOf(command, places, 1));
}

void checkScale(const Command& command, std::span<const Position> places, MessageLog& log) {
    for (std::size_t i = 0; i < command.numbers.size(); ++i) {
        if (command.numbers[i] != 0) continue;
        log.report("glib-W42", "Scale: factor 0 kept", placeOf(command, places, i));
        return;
    }
}

}  // namespace

void applyCommandRules(Command& command, std::span<const Position> places, MessageLog& log) {
    switch (command.id) {
        case CommandId::perspective:
            return checkPerspective(command, places, log);
        case CommandId::ortho:
            return checkOrtho(command, places, log);
        case CommandId::rotate:
            return checkRotate(command, places, log);
        case CommandId::scale:
            return checkScale(command, places, log);
        default:
            break;
    }
}

}  // namespace glibra::glib
