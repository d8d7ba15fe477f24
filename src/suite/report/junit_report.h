#pragma once
// JUnit XML, which Jenkins, GitLab and GitHub's readers show.

#include <string>

#include "suite/results/results.h"

namespace glibra::suite {

/// One <testsuite> a suite, one <testcase> a shot. What did not draw at all (crashed, timed-out) is an
/// <error>, other failures are a <failure> whose text holds the figures, the pictures' paths and the
/// commands; diagnostics of the scene are in <system-out>. UTF-8, fit for XML 1.0 whatever the strings hold.
/// Form: the schema junit-10.xsd of Jenkins' xUnit plugin.
std::string toJunit(const RunResult& run);

}  // namespace glibra::suite
