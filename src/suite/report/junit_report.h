#pragma once
// JUnit XML, which the test reports of Jenkins, GitLab and GitHub show.

#include <string>

#include "suite/results/results.h"

namespace glibra::suite {

/// Returns one <testsuite> per suite and one <testcase> per shot. A shot without a picture (crashed,
/// timed-out) is an <error>. Other failures are a <failure> whose text has the figures, the paths of the
/// pictures and the commands. Diagnostics of the scene are in <system-out>. If planned shots have no verdict,
/// one more test case is an <error>. The text is UTF-8 and valid XML 1.0 for all strings. Schema:
/// junit-10.xsd of the xUnit plugin of Jenkins.
std::string toJunit(const RunResult& run);

}  // namespace glibra::suite
