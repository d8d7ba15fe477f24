#include "suite/results/results.h"

#include <algorithm>
#include <iterator>

namespace glibra::suite {
namespace {

struct VerdictRow {
    const char* word;
    Verdict verdict;
    bool failure;
};

constexpr VerdictRow kVerdicts[] = {
    {"passed", Verdict::passed, false},   {"failed", Verdict::failed, true},
    {"missing", Verdict::missing, true},  {"unstable", Verdict::unstable, true},
    {"updated", Verdict::updated, false}, {"refused", Verdict::refused, true},
    {"crashed", Verdict::crashed, true},  {"timed-out", Verdict::timedOut, true},
    {"skipped", Verdict::skipped, false},
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
