#pragma once

#include <string>

#include "bench/core/report.h"

namespace glibra::bench {

/// A subject for a terminal: its figures, one line per curve with both ends of its sweep, and the findings.
/// Ends with a line feed.
std::string textReport(const SubjectRun& subject);

/// "processor, N cores, system; driver" on one line, without a line feed.
std::string machineLine(const Machine& machine);

}  // namespace glibra::bench
