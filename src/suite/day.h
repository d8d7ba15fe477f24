#pragma once
// Days of the calendar, as suites write them: "2026-12-31". Two of them are compared as texts.

#include <string>
#include <string_view>

namespace glibra::suite {

/// True if the text is a day that exists.
bool isDay(std::string_view text);
/// The present day, UTC.
std::string today();

}  // namespace glibra::suite
