#include "cli/suite_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "base/contained_call.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "suite/file/selection.h"
#include "suite/file/shot_name.h"
#include "suite/file/suite_file.h"

namespace glibra::cli {

void addSelectionOptions(CommandLine& command, SuiteArguments& to) {
    command.repeated("--only", to.only,
                     "only shots with this name, as 'oval*', or with this tag, as tag:slow; may be repeated");
    command.option("--shard", to.shard,
                   "only the I-th of N parts of the shots; the parts are the same on every machine");
    command.flag("--resume", to.resume, "continue a run that was stopped or killed");
}

base::WorkerOptions inputWorkers(const SuiteArguments& arguments, std::size_t shots,
                                 const system::Sandbox* sandbox, std::function<bool()> stop) {
    const int jobs = suite::readingJobs(arguments.run.jobs);
    return {.workers = jobs,
            .timeout = arguments.run.timeout.value_or(suite::Shot().timeout),
            .memory = arguments.run.memory.value_or(base::memoryShare(jobs, shots)),
            .stop = std::move(stop),
            .sandbox = sandbox};
}

std::optional<Selection> readSelection(const SuiteArguments& arguments, int& status) {
    const auto refuse = [&](const Diagnostics& diagnostics, int with) {
        print(diagnostics);
        status = with;
        return std::nullopt;
    };
    suite::Shard shard;
    if (!arguments.shard.empty()) {
        const Result<suite::Shard> parsed = suite::parseShard(arguments.shard);
        if (!parsed) return refuse(parsed.diagnostics, kWrongUsage);
        shard = *parsed;
    }
    Selection selection;
    Diagnostics problems;
    std::map<std::string, std::string> files;
    for (const std::string& each : arguments.suites) {
        Result<suite::Suite> read = suite::readSuite(each);
        append(problems, std::move(read.diagnostics));
        if (!read) continue;
        const auto [known, isNew] = files.emplace(suite::nameOnAnyDisk(read->name), each);
        if (!isNew)
            problems.push_back(
                diagnose("suite-E18",
                         fmt::format("'{}' and '{}' are both named '{}'; results and goldens need "
                                     "names of their own",
                                     known->second, each, read->name),
                         {each, 1, 1}));
        selection.suites.push_back(std::move(*read));
    }
    if (hasError(problems)) return refuse(problems, kSceneIsWrong);
    print(problems);
    if (const Diagnostics wrong = suite::unmatchedPatterns(selection.suites, arguments.only); hasError(wrong))
        return refuse(wrong, kWrongUsage);

    const std::vector<std::filesystem::path> roots = libraryRoots();
    for (std::size_t i = 0; i < selection.suites.size(); ++i) {
        for (suite::Shot& shot : selection.suites[i].shots)
            shot.options.libraryRoots.insert(shot.options.libraryRoots.end(), roots.begin(), roots.end());
        for (const std::size_t shot :
             suite::select(selection.suites[i], arguments.only, shard, arguments.withNamed))
            selection.shots.push_back({i, shot});
        for (const std::size_t shot :
             suite::select(selection.suites[i], arguments.only, {}, arguments.withNamed))
            selection.undivided.push_back({i, shot});
    }
    return selection;
}

int listShots(const SuiteArguments& arguments) {
    int status = kDone;
    const std::optional<Selection> selection = readSelection(arguments, status);
    if (!selection) return status;
    std::string text;
    for (const suite::ShotReference& each : selection->shots) {
        const suite::Suite& suite = selection->suites[each.suite];
        text += fmt::format("{}/{}\n", suite.name, suite.shots[each.shot].name);
    }
    std::fwrite(text.data(), 1, text.size(), stdout);
    return status;
}

}  // namespace glibra::cli
