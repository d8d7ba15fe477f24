#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "image/compare.h"
#include "image/read.h"

namespace glibra::cli {
namespace {

struct CompareArguments {
    std::string first, second;
    double largest = 0;
    double fraction = 0;
    bool json = false;
};

int run(const CompareArguments& arguments) {
    const Result<image::Image> first = image::readImage(arguments.first);
    const Result<image::Image> second = image::readImage(arguments.second);
    print(first.diagnostics);
    print(second.diagnostics);
    if (!first || !second) return kSceneIsWrong;
    const image::Comparison found = image::compare(*first, *second);
    const double pixels = static_cast<double>(first->width) * first->height;
    const double fraction = found.sameSize ? static_cast<double>(found.differingPixels) / pixels : 1;
    const bool same = found.sameSize && (found.identical || found.largest * 255 <= arguments.largest ||
                                         fraction <= arguments.fraction);
    if (arguments.json) {
        const nlohmann::ordered_json json{{"same", same},
                                          {"identical", found.identical},
                                          {"sameSize", found.sameSize},
                                          {"largest", found.largest * 255},
                                          {"at", {found.x, found.y}},
                                          {"differingPixels", found.differingPixels},
                                          {"fraction", fraction},
                                          {"rmse", found.rootMeanSquare * 255}};
        std::printf("%s\n", json.dump(2).c_str());
    } else if (!found.sameSize) {
        std::printf("different sizes: %d x %d and %d x %d\n", first->width, first->height, second->width,
                    second->height);
    } else if (found.identical) {
        std::printf("identical\n");
    } else {
        std::printf(
            "%s",
            fmt::format("{}: largest difference {:.4g} of 255 at pixel {}, {}; {} pixels differ ({:.3g} %); "
                        "RMSE {:.4g}\n",
                        same ? "within tolerance" : "different", found.largest * 255, found.x, found.y,
                        found.differingPixels, fraction * 100, found.rootMeanSquare * 255)
                .c_str());
    }
    return same ? kDone : kDiffers;
}

}  // namespace

void addCompare(CLI::App& app, int& status) {
    auto arguments = std::make_shared<CompareArguments>();
    CLI::App* command = app.add_subcommand("compare", "two images; exit status 1 if they differ");
    command->add_option("A", arguments->first, "image file")->required();
    command->add_option("B", arguments->second, "image file")->required();
    command
        ->add_option("--max", arguments->largest, "largest difference of a component that passes, in 255ths")
        ->check(CLI::Range(0.0, 255.0));
    command->add_option("--fraction", arguments->fraction, "fraction of pixels that may differ by any amount")
        ->check(CLI::Range(0.0, 1.0));
    command->add_flag("--json", arguments->json, "the figures as JSON");
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
