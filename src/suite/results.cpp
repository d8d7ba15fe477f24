#include "suite/results.h"

#include <algorithm>
#include <iterator>

namespace glibra::suite {
namespace {

struct VerdictRow {
    Verdict verdict;
    const char* word;
    bool failure;
};

constexpr VerdictRow kVerdicts[] = {
    {Verdict::passed, "passed", false},   {Verdict::failed, "failed", true},
    {Verdict::missing, "missing", true},  {Verdict::unstable, "unstable", true},
    {Verdict::updated, "updated", false}, {Verdict::refused, "refused", true},
    {Verdict::crashed, "crashed", true},  {Verdict::timedOut, "timed-out", true},
    {Verdict::skipped, "skipped", false},
};

const VerdictRow& rowOf(Verdict verdict) {
    const auto* row = std::find_if(std::begin(kVerdicts), std::end(kVerdicts),
                                   [&](const VerdictRow& each) { return each.verdict == verdict; });
    return row != std::end(kVerdicts) ? *row : kVerdicts[1];  // what has no row is no pass
}

}  // namespace

const char* name(Verdict verdict) {
    return rowOf(verdict).word;
}

std::optional<Verdict> verdictOf(std::string_view word) {
    for (const VerdictRow& row : kVerdicts)
        if (row.word == word) return row.verdict;
    return std::nullopt;
}

bool isFailure(Verdict verdict) {
    return rowOf(verdict).failure;
}

}  // namespace glibra::suite
