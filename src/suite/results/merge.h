#pragma once
// Joins the results of several runs, as the shards of one run on several machines.

#include <glibra/result.h>

#include <filesystem>
#include <span>

#include "suite/results/results.h"

namespace glibra::suite {

/// Joins the results in `folders` and writes them, with copies of the pictures in those folders, to the
/// results folder `into` (which may be one of them). A copy is `pictures/HASH.png` or `.exr`, whatever the
/// name of its picture. Pictures elsewhere, as goldens, stay where they are. Links are not followed. Shots
/// are sorted by suite and name, so that the order of the folders does not matter. `seconds` is that of the
/// longest run.
///
/// Of two results for one shot, skipped loses against any other and a failure wins against any other verdict,
/// in the order of kVerdictsByConcern. The warning result-W01 names shots on which the runs differ,
/// result-W02 (at most 20) files that a run names as pictures but that are links, special files or no
/// pictures; they are left out.
///
/// Errors beside a value with what was found: those of readResults for a folder whose results cannot be read
/// (the others are joined); result-E06 runs of different plans or settings, or of which that is not known
/// (RunResult::plan); result-E03 a shard is in none of the folders, or planned shots have no verdict
/// because their run was stopped or killed; result-E04 shards of different counts ("2/8" and "3/4"). The
/// merged run is complete only without errors. Errors without a value: no folder can be read, result-E05 no
/// folder is given, result-E02 another run or merge is writing to `into`, file-E10.
Result<RunResult> mergeResults(std::span<const std::filesystem::path> folders,
                               const std::filesystem::path& into);

}  // namespace glibra::suite
