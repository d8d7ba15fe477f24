#include <fmt/format.h>

#include <cstdio>
#include <future>
#include <memory>

#include "base/memory_limit.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/json_output.h"
#include "cli/picture_options.h"
#include "image/compare/heat_map.h"
#include "image/compare/judge.h"
#include "image/file.h"
#include "image/png/png_chunks.h"
#include "image/read.h"
#include "image/write.h"

namespace glibra::cli {
namespace {

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
    image::ReadOptions options;
    options.decoder.seconds = limits.timeout;
    options.decoder.memory = limits.memory.value_or(options.decoder.memory);
    return image::decodeImage(file, path, {path, 1, 1}, options);
}

std::string toText(const image::Judgement& judged, const image::Image& expected) {
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
    text += fmt::format("  mean of a block     {:.3g} of 255 at {}, {}\n", judged.bias, judged.biasX,
                        judged.biasY);
    if (found.nonFinite > 0) text += fmt::format("  not finite          {} components\n", found.nonFinite);
    if (judged.structure) text += fmt::format("  structure           {:.4g}\n", *judged.structure);
    if (judged.flip) text += fmt::format("  mean FLIP           {:.4g}\n", *judged.flip);
    return text;
}

void show(const image::Judgement& judged, const image::Image& expected, const image::Image& got, bool json) {
    const std::string text = json ? toJson(judged, expected, got) : toText(judged, expected);
    std::fwrite(text.data(), 1, text.size(), stdout);
}

/// Writes the heat map: of the FLIP errors with --flip, otherwise of the differences. Returns the exit
/// status.
int writeHeatMap(const CompareArguments& arguments, const image::Image& expected, const image::Image& got) {
    if (expected.width != got.width || expected.height != got.height) {
        print({withoutId(Severity::warning, "no heat map is written, since the sizes differ")});
        return kDone;
    }
    const image::Image map = arguments.tolerance.flip ? image::flipHeatMap(image::flip(expected, got))
                                                      : image::differenceHeatMap(expected, got);
    const Diagnostics problems = image::writeImage(map, arguments.heatMap);
    print(problems);
    return hasError(problems) ? kSceneIsWrong : kDone;
}

int run(CompareArguments& arguments) {
    // Limits this process, which decodes PNG and BMP itself.
    base::MemoryLimit().set(arguments.limits.memory.value_or(base::memoryShare(1, 1)));
    if (arguments.exact) arguments.tolerance = image::exactTolerance();
    const File first = readWhole(arguments.first), second = readWhole(arguments.second);
    print(first.diagnostics);
    print(second.diagnostics);
    if (!first || !second) return kSceneIsWrong;
    const bool heatMap = !arguments.heatMap.empty();
    if (!heatMap && *first == *second && image::pngChunks(*first)) {
        image::Judgement equal;
        equal.same = true;
        equal.reason = "the files have the same bytes";
        show(equal, {}, {}, arguments.json);
        return kDone;
    }

    auto decoding =
        std::async(std::launch::async, [&] { return decode(*second, arguments.second, arguments.limits); });
    const Result<image::Image> expected = decode(*first, arguments.first, arguments.limits);
    const Result<image::Image> got = decoding.get();
    print(expected.diagnostics);
    print(got.diagnostics);
    if (!expected || !got) return kSceneIsWrong;
    const image::Judgement judged = image::judge(*expected, *got, arguments.tolerance, arguments.everything);
    show(judged, *expected, *got, arguments.json);
    const int written = heatMap ? writeHeatMap(arguments, *expected, *got) : kDone;
    return std::max(judged.same ? kDone : kDiffers, written);
}

}  // namespace

void addCompare(CommandLine& program, int& status) {
    auto arguments = std::make_shared<CompareArguments>();
    image::Tolerance& tolerance = arguments->tolerance;
    CommandLine command =
        program.subcommand("compare", "compares two pictures; the exit status is 1 if they differ",
                           "glibra compare expected.png got.png --heatmap difference.png");
    command.option("A", arguments->first, "picture file, the expected one").required();
    command.option("B", arguments->second, "picture file").required();
    command
        .option("--heatmap", arguments->heatMap,
                "picture file that shows where and how much they differ; with --flip, the FLIP errors")
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
    addPictureOption(command, "timeout", arguments->limits);
    addPictureOption(command, "memory", arguments->limits);
    command.onRun([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
