#pragma once
// Runs of several machines as one.

#include <glibra/result.h>

#include <filesystem>
#include <span>

#include "suite/results/results.h"

namespace glibra::suite {

/// Joins the results in `folders` and writes them, with copies of the pictures that lie in those folders, to
/// the results folder `into` (which may be one of them). Pictures that lie elsewhere, as goldens do, stay
/// where they are. Shots are sorted by suite and name, so that the order of the folders makes no difference
/// to the verdicts. `seconds` is the longest run's.
///
/// Of two results for one shot, skipped loses against any other and a failure wins against any that is none,
/// in the order of kVerdictsByConcern; the warning result-W01 tells where the verdicts differ.
///
/// Errors, next to a value that holds what is there: those of readResults for a folder whose results cannot
/// be read (the others are joined all the same); result-E03 a shard is in none of the folders; result-E04
/// shards of different counts ("2/8" and "3/4"). Errors without a value: no folder can be read, result-E05
/// none is given, file-E10.
Result<RunResult> mergeResults(std::span<const std::filesystem::path> folders,
                               const std::filesystem::path& into);

}  // namespace glibra::suite
