#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/core/run.h"
#include "bench/report/comparison.h"
#include "bench/report/csv_report.h"
#include "bench/report/html_report.h"
#include "bench/report/json_report.h"
#include "bench/report/text_report.h"
#include "cli/commands.h"
#include "glib/suggest.h"
#include "image/file.h"

namespace glibra::cli {
namespace {

struct BenchArguments {
    std::vector<std::string> subjects;
    bool list = false;
    bench::BenchOptions options;
    std::string folder, csv, json, html, against;
    bench::ComparisonOptions comparison;
};

void printSubjects() {
    std::size_t width = 0;
    for (const bench::Subject& each : bench::subjects()) width = std::max(width, each.name.size());
    for (const bench::Subject& each : bench::subjects())
        fmt::print("{:<{}}  {}\n", each.name, width, each.title);
}

/// In the order of the table, each once; all if none is named.
Result<std::vector<const bench::Subject*>> choose(const std::vector<std::string>& names) {
    const std::span<const bench::Subject> table = bench::subjects();
    std::vector<std::string_view> known;
    for (const bench::Subject& each : table) known.push_back(each.name);
    Diagnostics problems;
    for (const std::string& each : names) {
        if (std::ranges::find(known, each) != known.end()) continue;
        const std::string near = glib::suggestion(each, known);
        problems.push_back(error("bench-E01", fmt::format("there is no subject '{}'{}", each,
                                                          near.empty() ? "; --list names them" : near)));
    }
    if (!problems.empty()) return problems;
    std::vector<const bench::Subject*> chosen;
    for (const bench::Subject& each : table)
        if (names.empty() || std::ranges::find(names, each.name) != names.end()) chosen.push_back(&each);
    return chosen;
}

Result<bench::Report> readEarlier(const std::string& path) {
    const Result<std::vector<std::byte>> file = image::readFile(path, {path, {}});
    if (!file) return file.diagnostics;
    const std::string_view text(reinterpret_cast<const char*>(file->data()), file->size());
    return bench::readJsonReport(text, path);
}

bench::Report measure(std::span<const bench::Subject* const> chosen, const bench::BenchOptions& options) {
    const bool isTerminal = ::isatty(STDERR_FILENO) == 1;
    bench::Report report =
        bench::run(chosen, options, [&](const bench::Subject& subject, std::size_t index, std::size_t count) {
            fmt::print(stderr, "{}[{}/{}] {}{}", isTerminal ? "\r\033[K" : "", index + 1, count,
                       subject.title, isTerminal ? "" : "\n");
        });
    if (isTerminal) fmt::print(stderr, "\r\033[K");
    report.glibra = GLIBRA_VERSION;
    return report;
}

Diagnostics writeText(const std::filesystem::path& file, const std::string& text) {
    return image::writeFileAtomically(file, std::as_bytes(std::span(text)));
}

/// What --csv, --json and --html name, and the three files of -o.
Diagnostics writeFiles(const BenchArguments& arguments, const bench::Report& report,
                       const bench::Comparison* comparison) {
    Diagnostics problems;
    const std::filesystem::path folder = arguments.folder;
    if (!folder.empty()) {
        std::error_code failure;
        std::filesystem::create_directories(folder, failure);
        if (failure)
            return {error("file-E10", fmt::format("cannot make the folder '{}': {}", folder.string(),
                                                  failure.message()))};
    }
    const auto write = [&](const std::string& named, const char* inFolder, const auto& text) {
        if (named.empty() && folder.empty()) return;
        const std::string content = text();
        if (!named.empty()) append(problems, writeText(named, content));
        if (!folder.empty()) append(problems, writeText(folder / inFolder, content));
    };
    write(arguments.csv, "bench.csv", [&] { return bench::csvReport(report); });
    write(arguments.json, "bench.json", [&] { return bench::jsonReport(report); });
    write(arguments.html, "bench.html", [&] { return bench::htmlReport(report, comparison); });
    return problems;
}

int run(const BenchArguments& arguments) {
    if (arguments.list) {
        printSubjects();
        return kDone;
    }
    const Result<std::vector<const bench::Subject*>> chosen = choose(arguments.subjects);
    if (!chosen) {
        print(chosen.diagnostics);
        return kWrongUsage;
    }
    std::optional<bench::Report> earlier;
    if (!arguments.against.empty()) {
        Result<bench::Report> read = readEarlier(arguments.against);
        print(read.diagnostics);
        if (!read) return kWrongUsage;
        earlier = std::move(*read);
    }

    const bench::Report report = measure(*chosen, arguments.options);
    fmt::print("glibra {} on {}\n", report.glibra, bench::machineLine(report.machine));
    Diagnostics problems;
    for (const bench::SubjectRun& each : report.subjects) {
        fmt::print("\n{}", bench::textReport(each));
        append(problems, each.diagnostics);
    }
    std::optional<bench::Comparison> comparison;
    if (earlier) {
        comparison = bench::compare(*earlier, report, arguments.comparison);
        fmt::print("\nagainst {}\n{}", arguments.against, bench::comparisonText(*comparison));
    }
    std::fflush(stdout);
    append(problems, writeFiles(arguments, report, comparison ? &*comparison : nullptr));
    print(problems);
    if (bench::lacksDriver(report)) return kNoDriver;
    if (hasError(problems)) return kSceneIsWrong;
    return comparison && bench::isWorse(*comparison) ? kDiffers : kDone;
}

}  // namespace

void addBench(CLI::App& app, int& status) {
    auto arguments = std::make_shared<BenchArguments>();
    CLI::App* command = app.add_subcommand("bench", "run time against error, as curves with their fronts");
    BenchArguments& to = *arguments;
    command->add_option("SUBJECT", to.subjects, "what to measure; without a name everything");
    command->add_flag("--list", to.list, "names the subjects");
    command->add_flag("--quick", to.options.quick, "fewer settings and measurements: seconds, for CI");
    command->add_option("-o,--output", to.folder, "folder for bench.csv, bench.json and bench.html");
    command->add_option("--csv", to.csv, "a row for each point");
    command->add_option("--json", to.json, "everything, to compare with later");
    command->add_option("--html", to.html, "one page with all diagrams and tables");
    command->add_option("--against", to.against,
                        "an earlier run's JSON: what changed; status 1 if an error grew");
    command
        ->add_option("--tolerance", to.comparison.errorTolerance,
                     "with --against: the share by which an error may grow")
        ->check(CLI::Range(0., 1e6))
        ->capture_default_str();
    command
        ->add_option("--time-factor", to.comparison.timeFactor,
                     "with --against: status 1 too if a time grew by more, beyond its spread")
        ->check(CLI::Range(1., 1e6));
    command->add_option("--driver", to.options.driver, "which OpenGL: auto, egl, egl-device, osmesa")
        ->transform(CLI::CheckedTransformer(kDriversByWord));
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
