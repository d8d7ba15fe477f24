#pragma once
// What a report says about the run that it comes from.

#include <string>

namespace glibra::cli {

/// The command line of this process, or empty if the system does not provide it.
std::string commandLine();

/// "2026-01-31T12:00:00Z"
std::string utcNow();

}  // namespace glibra::cli
