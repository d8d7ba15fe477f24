// glibra-bench: started by `glibra bench` and `glibra info --precision`.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <system_error>

#include "base/device_lost.h"
#include "base/files.h"
#include "base/suggest.h"
#include "base/text.h"
#include "bench/report/reports.h"
#include "bench/subjects/builtins.h"
#include "bench/subjects/scene_pictures.h"
#include "bench/subjects/subjects.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/info_output.h"
#include "cli/picture_options.h"
#include "image/file.h"
#include "suite/suite.h"
#include "system/terminal.h"

namespace glibra::bench {
namespace {

struct MeasureArguments {
    std::vector<std::string> subjects;  ///< names; empty: all subjects
    bool list = false;                  ///< prints the names of the subjects only
    BenchOptions options;
    std::string scene, sweep;             ///< of --scene and --sweep; empty: subjects are measured
    suite::Shot picture;                  ///< options of its picture
    std::string folder, csv, json, html;  ///< files to write; empty: none
    std::string against;                  ///< bench.json of an earlier run; empty: no comparison
    ComparisonOptions comparison;
};

void printSubjects() {
    std::size_t width = 0;
    for (const Subject& each : subjects()) width = std::max(width, each.name.size());
    for (const Subject& each : subjects()) fmt::print("{:<{}}  {}\n", each.name, width, each.title);
}

/// The named subjects, each once, in the order of the table; all subjects if none is named. bench-E01.
Result<std::vector<const Subject*>> choose(const std::vector<std::string>& names) {
    const std::span<const Subject> table = subjects();
    std::vector<std::string_view> known;
    for (const Subject& each : table) known.push_back(each.name);
    Diagnostics problems;
    for (const std::string& each : names) {
        if (std::ranges::find(known, each) != known.end()) continue;
        const std::string near = base::suggestion(each, known);
        problems.push_back(diagnose("bench-E01", fmt::format("unknown subject '{}'{}", each,
                                                             near.empty() ? "; --list names them" : near)));
    }
    if (!problems.empty()) return problems;
    std::vector<const Subject*> chosen;
    for (const Subject& each : table)
        if (names.empty() || std::ranges::find(names, each.name) != names.end()) chosen.push_back(&each);
    return chosen;
}

Result<Report> readEarlier(const std::string& path) {
    const Result<std::vector<std::byte>> file = image::readFile(path, {path, {}});
    if (!file) return file.diagnostics;
    const std::string_view text(reinterpret_cast<const char*>(file->data()), file->size());
    return readJsonReport(text, path);
}

Diagnostics writeText(const std::filesystem::path& file, const std::string& text, image::NamedBy named) {
    return image::writeFileAtomically(file, std::as_bytes(std::span(text)), named);
}

/// file-E13 for each file that would replace the earlier run which --against names.
Diagnostics overwritten(const MeasureArguments& arguments) {
    cli::ReadFiles read;
    read.add(arguments.against, "--against compares with it");
    Diagnostics problems;
    for (const auto& [file, option] :
         {std::pair(&arguments.csv, "--csv"), std::pair(&arguments.json, "--json"),
          std::pair(&arguments.html, "--html")})
        if (!file->empty()) append(problems, read.overwrittenBy(*file, option));
    if (!arguments.folder.empty())
        for (const char* each : {"bench.csv", "bench.json", "bench.html"})
            append(problems, read.overwrittenBy(std::filesystem::path(arguments.folder) / each, "-o"));
    return problems;
}

/// file-E10 if the folder of -o cannot be made, which is known before anything is measured.
Diagnostics makeFolder(const std::string& folder) {
    std::error_code failure;
    if (!folder.empty()) std::filesystem::create_directories(folder, failure);
    if (!failure) return {};
    return {diagnose("file-E10", fmt::format("cannot make the folder '{}': {}", folder, failure.message()))};
}

/// True if writing the file again would add to what is there, as in a pipe.
bool isStream(const std::string& file) {
    std::error_code failure;
    return std::filesystem::exists(file, failure) && !std::filesystem::is_regular_file(file, failure);
}

/// Writes the files of --csv, --json and --html, and the three files of -o; streams only at the end.
Diagnostics writeFiles(const MeasureArguments& arguments, const Report& report,
                       const RunComparison* comparison, bool isEnd) {
    Diagnostics problems;
    const std::filesystem::path folder = arguments.folder;
    const auto write = [&](std::string named, const char* inFolder, const auto& text) {
        if (!isEnd && isStream(named)) named.clear();
        if (named.empty() && folder.empty()) return;
        const std::string content = text();
        if (!named.empty()) append(problems, writeText(named, content, image::NamedBy::user));
        if (!folder.empty()) append(problems, writeText(folder / inFolder, content, image::NamedBy::program));
    };
    write(arguments.csv, "bench.csv", [&] { return csvReport(report); });
    write(arguments.json, "bench.json", [&] { return jsonReport(report); });
    write(arguments.html, "bench.html", [&] { return htmlReport(report, comparison); });
    return problems;
}

/// Prints the last subject of a report, after a line about the machine if it is the first.
void printLast(const Report& report) {
    if (report.subjects.size() == 1)
        fmt::print("glibra {} on {}\n", GLIBRA_VERSION, machineLine(report.machine));
    fmt::print("\n{}", textReport(report.subjects.back()));
    std::fflush(stdout);
    cli::print(report.subjects.back().diagnostics);
}

/// Measures the subjects, and prints and writes what is known after each of them: minutes of work must not
/// be lost with what comes later.
Report measureAll(std::span<const Subject* const> chosen, const MeasureArguments& arguments) {
    const bool isTerminal = system::isTerminal(system::Standard::error);
    const auto begins = [&](const Subject& subject, std::size_t index, std::size_t count) {
        fmt::print(stderr, "{}[{}/{}] {}{}", isTerminal ? "\r\033[K" : "", index + 1, count, subject.title,
                   isTerminal ? "" : "\n");
    };
    const auto measured = [&](const Report& soFar) {
        if (isTerminal) fmt::print(stderr, "\r\033[K");
        printLast(soFar);
        Report named = soFar;
        named.glibra = GLIBRA_VERSION;
        (void)writeFiles(arguments, named, nullptr, false);  // the last time reports what cannot be written
    };
    Report report = run(chosen, arguments.options, {begins, measured});
    report.glibra = GLIBRA_VERSION;
    return report;
}

/// Reads NAME=[a, b, ...]. bench-E03.
Result<SceneSweep> readSweep(const MeasureArguments& arguments) {
    const auto wrong = [&](const std::string& why) {
        return diagnose("bench-E03", fmt::format("--sweep '{}': {}", arguments.sweep, why));
    };
    SceneSweep sweep{arguments.scene, arguments.picture.options, {}, {}};
    const std::string& text = arguments.sweep;
    const std::size_t equals = text.find('=');
    if (equals == 0 || equals == std::string::npos)
        return wrong("expected a name and its values, as steps=[8,16,32]");
    sweep.name = text.substr(0, equals);
    std::string values = text.substr(equals + 1);
    const bool isList = values.size() > 1 && values.front() == '[' && values.back() == ']';
    if (isList) values = values.substr(1, values.size() - 2);
    std::replace(values.begin(), values.end(), ',', ' ');
    std::istringstream words(values);
    for (std::string word; words >> word;) {
        char* end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (*end != '\0' || !std::isfinite(value)) return wrong(fmt::format("'{}' is no number", word));
        sweep.values.push_back(value);
    }
    if (sweep.values.size() < 2) return wrong("expected at least two values, the finest last");
    for (std::filesystem::path& each : cli::libraryRoots())
        sweep.options.libraryRoots.push_back(std::move(each));
    return sweep;
}

/// The report of the scene or of the subjects. bench-E01, bench-E03.
Result<Report> measured(const MeasureArguments& arguments) {
    if (arguments.scene.empty() && arguments.sweep.empty()) {
        const Result<std::vector<const Subject*>> chosen = choose(arguments.subjects);
        if (!chosen) return chosen.diagnostics;
        return measureAll(*chosen, arguments);
    }
    if (arguments.scene.empty() || arguments.sweep.empty() || !arguments.subjects.empty())
        return diagnose("bench-E03",
                        "--scene and --sweep belong together, and subjects are not measured then");
    const Result<SceneSweep> sweep = readSweep(arguments);
    if (!sweep) return sweep.diagnostics;
    Report report = runOne(
        "scene", fmt::format("{}: {}", arguments.scene, arguments.sweep),
        [&](Bench& bench) { return measureSweep(bench, *sweep); }, arguments.options);
    report.glibra = GLIBRA_VERSION;
    printLast(report);
    return report;
}

/// `glibra bench`: measures the subjects, prints them, writes the files and compares.
int measure(const MeasureArguments& arguments) {
    if (arguments.list) {
        printSubjects();
        return cli::kDone;
    }
    Diagnostics refused = overwritten(arguments);
    if (refused.empty()) refused = makeFolder(arguments.folder);
    if (!refused.empty()) {
        cli::print(refused);
        return cli::kSceneIsWrong;
    }
    std::optional<Report> earlier;
    if (!arguments.against.empty()) {
        Result<Report> read = readEarlier(arguments.against);
        cli::print(read.diagnostics);
        if (!read) return cli::kWrongUsage;
        earlier = std::move(*read);
    }

    const Result<Report> made = measured(arguments);
    if (!made) {
        cli::print(made.diagnostics);
        return cli::kWrongUsage;
    }
    const Report& report = *made;
    std::optional<RunComparison> comparison;
    if (earlier) {
        comparison = compare(*earlier, report, arguments.comparison);
        fmt::print("\nagainst {}\n{}", arguments.against, comparisonText(*comparison));
    }
    std::fflush(stdout);
    Diagnostics problems = writeFiles(arguments, report, comparison ? &*comparison : nullptr, true);
    cli::print(problems);
    if (lacksDriver(report)) return cli::kNoDriver;
    for (const SubjectRun& each : report.subjects) append(problems, each.diagnostics);
    if (hasError(problems)) return cli::kSceneIsWrong;
    return comparison && isWorse(*comparison) ? cli::kDiffers : cli::kDone;
}

/// Null if the number is infinite, which JSON cannot express.
nlohmann::ordered_json finite(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

nlohmann::ordered_json toJson(const BuiltinFunction& function, const Precision& precision) {
    nlohmann::ordered_json json{{"largestUlp", finite(precision.largest)},
                                {"meanUlp", precision.mean},
                                {"largestAbsolute", precision.largestAbsolute},
                                {"worstArguments", argumentsText(function, precision.worst)},
                                {"samples", precision.samples},
                                {"notNumbers", precision.notNumbers}};
    if (precision.timesTheBound) json["timesTheBound"] = finite(*precision.timesTheBound);
    return json;
}

nlohmann::ordered_json toJson(const std::vector<PrecisionRow>& rows) {
    auto json = nlohmann::ordered_json::array();
    for (const PrecisionRow& row : rows)
        json.push_back({{"function", row.function->name},
                        {"arguments", row.sweep->words},
                        {"bound", row.function->bound},
                        {"vertex", toJson(*row.function, row.vertex)},
                        {"fragment", toJson(*row.function, row.fragment)}});
    return json;
}

/// `glibra info --precision`: the output of `glibra info`, then the error of every GLSL function.
int printPrecision(Driver driver, bool asJson) {
    try {
        Bench bench({.driver = driver});
        const std::vector<PrecisionRow> rows = precisionTable(bench);
        if (asJson) {
            nlohmann::ordered_json json = cli::infoJson(bench.context());
            json["precision"] = toJson(rows);
            std::printf("%s\n", json.dump(2).c_str());
        } else {
            std::printf("%s\n%s", cli::infoText(bench.context()).c_str(), toText(rows).c_str());
        }
        return cli::kDone;
    } catch (const Failed& failed) {
        cli::print(failed.diagnostics);
        return cli::kNoDriver;
    }
}

void addMeasure(cli::CommandLine& line, MeasureArguments& to) {
    line.list("SUBJECT", to.subjects, "what to measure; all subjects if none is named");
    line.option("--scene", to.scene, "measure a scene instead: with each value of --sweep");
    line.option("--sweep", to.sweep,
                "with --scene: a variable or uniform and its values, the finest last, as steps=[8,16,32,64]");
    for (const char* each : {"size", "time", "steps", "set", "samples"})
        cli::addPictureOption(line, each, to.picture);
    line.flag("--list", to.list, "print the names of the subjects");
    line.flag("--quick", to.options.quick, "fewer settings and measurements: seconds, for CI");
    line.option("-o,--output", to.folder, "folder for bench.csv, bench.json and bench.html").written();
    line.option("--csv", to.csv, "write one row per point").written();
    line.option("--json", to.json, "write the whole run, for a later --against").written();
    line.option("--html", to.html, "write one page with all diagrams and tables").written();
    line.option("--against", to.against,
                "bench.json of an earlier run: print what changed; exit status 1 if an error grew");
    line.option("--tolerance", to.comparison.errorTolerance,
                "with --against: the share by which an error may grow")
        .within(0., 1e6)
        .withDefault();
    line.option("--time-factor", to.comparison.timeFactor,
                "with --against: exit status 1 also if a median time grew by more than this factor and the "
                "spreads do not overlap")
        .within(1., 1e6);
    line.driver(to.options.driver);
}

int runProgram(int argc, char** argv) {
    cli::Program program(
        "run time against error: curves and their Pareto fronts",
        "glibra bench --list\n"
        "glibra bench --scene fog.glib --sweep 'steps=[8,16,32,256]'\n"
        "glibra bench --against out/bench.json           # what changed since an earlier run",
        "glibra bench");
    cli::CommandLine line = program.line();
    MeasureArguments arguments;
    addMeasure(line, arguments);
    cli::CommandLine precision = line.subcommand(
        "precision", "the error of GLSL's functions on this driver, as `glibra info --precision` prints it",
        "glibra bench precision\n"
        "glibra bench precision --json\n"
        "glibra bench precision --driver osmesa");
    Driver driver = Driver::automatic;
    bool asJson = false;
    precision.driver(driver);
    precision.flag("--json", asJson, "as JSON");
    if (const std::optional<int> status = program.parse(argc, argv)) return *status;
    return precision.isGiven() ? printPrecision(driver, asJson) : measure(arguments);
}

}  // namespace
}  // namespace glibra::bench

int main(int argc, char** argv) {
    if (!glibra::system::openStandardFiles()) return glibra::cli::kNoDriver;
    try {
        return glibra::cli::endProgram(glibra::bench::runProgram(argc, argv));
    } catch (const glibra::base::DeviceLost& lost) {
        // Nothing is reported: nobody knows for how long the device was held before.
        glibra::cli::print({glibra::base::diagnosticOf(lost, {})});
        return glibra::cli::kSceneIsWrong;
    } catch (const std::exception& failure) {
        return glibra::cli::failProgram(glibra::base::reasonOf(failure));
    }
}
