#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <future>
#include <memory>
#include <set>
#include <system_error>
#include <tuple>

#include "base/contained_call.h"
#include "base/utf8.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/file_access.h"
#include "cli/info_output.h"
#include "cli/picture_options.h"
#include "image/compare/compare.h"
#include "image/compare/judge.h"
#include "image/file.h"
#include "image/foreign_headers.h"
#include "image/format.h"
#include "image/png/png_reader.h"
#include "image/read.h"
#include "image/write.h"
#include "system/memory.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
    std::string first, second, heatMap;
    image::Tolerance tolerance;
    bool exact = false;
    bool everything = false;
    bool json = false;
    suite::Shot limits;  ///< --timeout and --memory
};

using File = Result<std::vector<std::byte>>;

File readWhole(const std::string& path) {
    return image::readFile(path, {path, {path, 1, 1}});
}

Result<image::Image> decode(const std::vector<std::byte>& file, const std::string& path,
                            const suite::Shot& limits) {
    image::ReadOptions options{.limits = image::kDrawnLimits};
    options.decoder.seconds = limits.timeout;
    options.decoder.memory = limits.memory.value_or(options.decoder.memory);
    return image::decodeImage(file, path, {path, 1, 1}, options);
}

/// How two EXR files differ that show equal pictures; empty if they do not.
std::string layoutDifference(const std::vector<std::byte>& first, const std::vector<std::byte>& second) {
    if (image::formatOf(first) != image::Format::openExr || image::formatOf(second) != image::Format::openExr)
        return {};
    const auto expected = image::readExrHeader(first, {}), got = image::readExrHeader(second, {});
    if (!expected || !got) return {};
    const std::string one = image::describeExr(*expected), other = image::describeExr(*got);
    return one == other ? std::string()
                        : fmt::format("the pixels are equal, but not the files: {}; {}", one, other);
}

/// A pair of pictures: their files, and what messages call them if there are several.
struct Pair {
    std::string first, second;
    std::string name;     ///< empty: the only pair
    std::string heatMap;  ///< empty: none
};

std::string toText(const image::Judgement& judged, const image::Image& expected,
                   const image::Tolerance& tolerance) {
    const image::Comparison& found = judged.comparison;
    if (judged.same && found.identical)
        return found.nonFinite == 0 ? "identical\n" : fmt::format("identical: {}\n", judged.reason);
    std::string text = fmt::format("{}: {}\n", judged.same ? "within tolerance" : "different", judged.reason);
    if (!found.sameSize) return text;
    text += fmt::format("  largest difference  {:.4g} of 255 at {}, {}, component {}\n", found.largest * 255,
                        found.x, found.y, found.component);
    text += fmt::format("  pixels that differ  {} ({:.3g} %), {} beyond the limit\n", found.differingPixels,
                        differingFraction(found, expected) * 100, judged.beyond);
    text += fmt::format("  RMSE                {:.4g} of 255\n", found.rootMeanSquare * 255);
    text += fmt::format("  mean of a block     {} at {}, {}\n", image::biasText(judged, tolerance),
                        judged.biasX, judged.biasY);
    if (found.nonFinite > 0) text += fmt::format("  not finite          {} components\n", found.nonFinite);
    if (judged.structure) text += fmt::format("  structure           {:.4g}\n", *judged.structure);
    if (judged.flip) text += fmt::format("  mean FLIP           {:.4g}\n", *judged.flip);
    return text;
}

/// Writes the heat map: of the FLIP errors with --flip, otherwise of the differences. Returns the exit
/// status.
int writeHeatMap(const std::string& file, const image::Tolerance& tolerance, const image::Image& expected,
                 const image::Image& got) {
    if (expected.width != got.width || expected.height != got.height) {
        print({withoutId(Severity::warning, "no heat map is written, since the sizes differ")});
        return kDone;
    }
    const image::Image map = tolerance.flip ? image::flipHeatMap(image::flip(expected, got))
                                            : image::differenceHeatMap(expected, got);
    std::error_code ignored;  // reported with the file that cannot be written
    if (const fs::path folder = fs::path(file).parent_path(); !folder.empty())
        fs::create_directories(folder, ignored);
    return printErrors(image::writeImage(map, file)) ? kSceneIsWrong : kDone;
}

/// Compares pairs of pictures and prints what it finds; JSON is collected and printed at the end.
class Comparer {
  public:
    explicit Comparer(const CompareArguments& arguments) : arguments_(arguments) {}

    /// Returns the exit status of the pair.
    int compare(const Pair& pair) {
        const File first = readWhole(pair.first), second = readWhole(pair.second);
        print(first.diagnostics);
        print(second.diagnostics);
        if (!first || !second) return kSceneIsWrong;
        if (pair.heatMap.empty() && *first == *second && image::pngChunks(*first)) {
            image::Judgement equal;
            equal.same = true;
            equal.reason = "the files have the same bytes";
            show(pair, equal, {}, {});
            return kDone;
        }
        auto decoding =
            std::async(std::launch::async, [&] { return decode(*second, pair.second, arguments_.limits); });
        const Result<image::Image> expected = decode(*first, pair.first, arguments_.limits);
        const Result<image::Image> got = decoding.get();
        for (const auto& [name, file, picture] :
             {std::tie(pair.first, *first, expected), std::tie(pair.second, *second, got)}) {
            print(picture.diagnostics);
            if (picture) print(image::warnIfShownOtherwise(file, name));
        }
        if (!expected || !got) return kSceneIsWrong;
        image::Judgement judged = image::judge(*expected, *got, arguments_.tolerance, arguments_.everything);
        if (judged.same && arguments_.exact)
            if (const std::string difference = layoutDifference(*first, *second); !difference.empty()) {
                judged.same = false;
                judged.reason = difference;
            }
        show(pair, judged, *expected, *got);
        const int written =
            pair.heatMap.empty() ? kDone : writeHeatMap(pair.heatMap, arguments_.tolerance, *expected, *got);
        return std::max(judged.same ? kDone : kDiffers, written);
    }

    /// A picture that only one of two folders has.
    int missing(const std::string& name, const std::string& from) {
        if (arguments_.json)
            add(name, R"({"same": false, "reason": "missing"})");
        else
            put(fmt::format("{}: missing from {}\n", name, from));
        return kDiffers;
    }

    /// Prints the JSON of the pairs of two folders.
    void finish() const {
        if (arguments_.json && !list_.empty()) put("[" + list_ + "]\n");
    }

  private:
    static void put(const std::string& text) {
        const std::string safe = base::printableText(text, true);
        std::fwrite(safe.data(), 1, safe.size(), stdout);
    }
    void add(const std::string& name, const std::string& json) {
        list_ += fmt::format("{}{{\"name\": {}, \"result\": {}}}", list_.empty() ? "" : ",\n", jsonText(name),
                             json);
    }
    void show(const Pair& pair, const image::Judgement& judged, const image::Image& expected,
              const image::Image& got) {
        if (!arguments_.json)
            put((pair.name.empty() ? "" : pair.name + ": ") + toText(judged, expected, arguments_.tolerance));
        else if (pair.name.empty())
            put(toJson(judged, expected, got, arguments_.tolerance));
        else
            add(pair.name, toJson(judged, expected, got, arguments_.tolerance));
    }

    const CompareArguments& arguments_;
    std::string list_;
};

/// The pictures in a folder and below it, by their paths from there. What cannot be listed or is a link to
/// nothing is a problem: it would be missing from both folders and count as the same.
std::set<std::string> picturesBelow(const fs::path& folder, Diagnostics& problems) {
    std::set<std::string> names;
    const auto report = [&](const fs::path& path, const std::string& why) {
        problems.push_back(diagnose("suite-E22",
                                    fmt::format("cannot look at all of '{}': {}; pictures would be left out",
                                                path.generic_string(), why),
                                    {folder.generic_string(), 1, 1}));
    };
    std::error_code failure;
    fs::recursive_directory_iterator each(folder, failure);
    for (const fs::recursive_directory_iterator end; !failure && each != end; each.increment(failure)) {
        if (each->path().filename().generic_string().starts_with('.') ||
            image::formatOfSuffix(each->path()) == image::Format::unknown)
            continue;
        std::error_code unknown;
        const fs::file_type type = each->status(unknown).type();
        if (type == fs::file_type::regular)
            names.insert(each->path().lexically_relative(folder).generic_string());
        else if (type == fs::file_type::none || type == fs::file_type::not_found)
            report(each->path(),
                   type == fs::file_type::none ? unknown.message() : "the target of the link is missing");
    }
    if (failure) report(folder, failure.message());
    return names;
}

constexpr const char* kIsCompared = "it is compared";

int compareFolders(const CompareArguments& arguments, Comparer& comparer) {
    Diagnostics unlisted;
    const std::set<std::string> expected = picturesBelow(arguments.first, unlisted),
                                got = picturesBelow(arguments.second, unlisted);
    if (printErrors(unlisted)) return kSceneIsWrong;
    std::set<std::string> all = expected;
    all.insert(got.begin(), got.end());
    if (all.empty()) {
        printError(fmt::format("there are no pictures in '{}' and '{}'", arguments.first, arguments.second));
        return kSceneIsWrong;
    }
    if (!arguments.heatMap.empty()) {
        ReadFiles read;
        for (const std::string& name : all)
            for (const std::string& folder : {arguments.first, arguments.second})
                read.add(fs::path(folder) / name, kIsCompared);
        Diagnostics problems;
        for (const std::string& name : all)
            append(problems, read.overwrittenBy(fs::path(arguments.heatMap) / name, "--heatmap"));
        if (printErrors(problems)) return kSceneIsWrong;
    }
    int status = kDone;
    std::size_t same = 0;
    for (const std::string& name : all) {
        int of = kDone;
        if (!expected.contains(name) || !got.contains(name))
            of = comparer.missing(name, expected.contains(name) ? arguments.second : arguments.first);
        else
            of = comparer.compare(
                {(fs::path(arguments.first) / name).generic_string(),
                 (fs::path(arguments.second) / name).generic_string(), name,
                 arguments.heatMap.empty() ? "" : (fs::path(arguments.heatMap) / name).generic_string()});
        same += of == kDone ? 1 : 0;
        status = std::max(status, of);
    }
    comparer.finish();
    printLine(fmt::format("{} of {} pictures are the same", same, all.size()));
    return status;
}

int runCompareCommand(CompareArguments& arguments) {
    // Limits this process, which decodes PNG and BMP itself.
    system::MemoryLimit().set(arguments.limits.memory.value_or(base::memoryShare(1, 1)));
    if (arguments.exact) arguments.tolerance = image::exactTolerance();
    std::error_code failure;
    Comparer comparer(arguments);
    if (fs::is_directory(arguments.first, failure) && fs::is_directory(arguments.second, failure))
        return compareFolders(arguments, comparer);
    if (!arguments.heatMap.empty()) {
        ReadFiles read;
        for (const std::string& each : {arguments.first, arguments.second}) read.add(each, kIsCompared);
        if (printErrors(read.overwrittenBy(arguments.heatMap, "--heatmap"))) return kSceneIsWrong;
    }
    return comparer.compare({arguments.first, arguments.second, {}, arguments.heatMap});
}

}  // namespace

void addCompare(CommandLine& program, int& status) {
    auto arguments = std::make_shared<CompareArguments>();
    image::Tolerance& tolerance = arguments->tolerance;
    CommandLine command = program.subcommand(
        "compare", "compares two pictures; the exit status is 1 if they differ",
        "glibra compare expected.png got.png\n"
        "glibra compare expected.png got.png --heatmap difference.png\n"
        "glibra compare expected/ got/ --exact          # pictures of equal names in two folders");
    command.option("A", arguments->first, "picture file, the expected one, or a folder of them").required();
    command.option("B", arguments->second, "picture file, or a folder with pictures of the same names")
        .required();
    command
        .option("--heatmap", arguments->heatMap,
                "picture file (or folder) that shows where and how much they differ; with --flip, the FLIP "
                "errors")
        .written()
        .placeholder("FILE");
    command
        .option("--max", tolerance.largest, "difference that a component of every pixel may have, in 255ths")
        .within(0.0, 255.0)
        .withDefault();
    command
        .option("--fraction", tolerance.fraction, "fraction of the pixels that may differ by more than --max")
        .within(0.0, 1.0)
        .withDefault();
    command.option("--cluster", tolerance.cluster, "how many of those pixels may touch each other")
        .atLeast(0)
        .withDefault();
    command.option("--line", tolerance.line, "how many of those pixels may be in one row or column")
        .atLeast(0)
        .withDefault();
    command
        .option("--bias", tolerance.bias,
                "mean difference that a block of 16 x 16 pixels may have, in 255ths")
        .within(0.0, 255.0)
        .withDefault();
    command
        .option("--flip", tolerance.flip, "mean FLIP up to which pictures pass that exceed the limits above")
        .within(0.0, 1.0);
    command
        .option("--structure", tolerance.structure,
                "structural difference up to which pictures pass that exceed the limits above; "
                "edges may move by a pixel")
        .within(0.0, 1.0);
    command
        .option("--relative", tolerance.relative,
                "float pictures, instead of --max: allowed difference as a part of the value")
        .atLeast(0)
        .withDefault();
    command.option("--absolute", tolerance.absolute, "float pictures: allowed difference in addition")
        .atLeast(0)
        .withDefault();
    command.flag("--exact", arguments->exact, "no pixel may differ; overrides all limits");
    command.flag("--all", arguments->everything,
                 "compute FLIP and the structural difference even if they are not needed");
    command.flag("--json", arguments->json, "print the figures as JSON");
    arguments->limits.timeout = base::CallLimits{}.seconds;
    addPictureOption(command, "timeout", arguments->limits);
    addPictureOption(command, "memory", arguments->limits);
    for (const char* each :
         {"--cluster", "--line", "--bias", "--relative", "--absolute", "--timeout", "--memory", "--all"})
        command.find(each).rare();
    command.onRun([arguments, &status] { status = runCompareCommand(*arguments); });
}

}  // namespace glibra::cli
