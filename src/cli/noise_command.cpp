#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "cli/commands.h"
#include "image/file.h"
#include "image/write.h"
#include "noise/graph.h"

namespace glibra::cli {
namespace {

struct NoiseArguments {
    noise::GraphOptions options;
    noise::ColorScale colors = noise::ColorScale::grey;
    std::vector<std::string> heights, gradients;
    std::string size = "600x300";
    std::string output = "noise.png";
    int width = 0, height = 0;
};

/// "3=.5": the point and its number.
std::pair<int, double> pointOf(const std::string& option, const std::string& text) {
    int point = 0;
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [equals, problem] = std::from_chars(text.data(), end, point);
    if (problem != std::errc() || equals == end || *equals != '=' || point < 0)
        throw CLI::ValidationError(option, "POINT=NUMBER is wanted, as 3=.5");
    const auto [last, trouble] = std::from_chars(equals + 1, end, value);
    if (trouble != std::errc() || last != end || !(value >= -1e6 && value <= 1e6))
        throw CLI::ValidationError(option, "POINT=NUMBER is wanted, as 3=.5");
    return {point, value};
}

std::string endingOf(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

Diagnostics writeNoise(const NoiseArguments& arguments) {
    const std::string ending = endingOf(arguments.output);
    if (ending == ".tex")
        return image::writeFileAtomically(
            arguments.output, noise::noiseTexture(arguments.options, arguments.width, arguments.height));
    if (ending == ".svg") {
        const std::string svg = noise::graphSvg(arguments.options, arguments.width, arguments.height);
        return image::writeFileAtomically(arguments.output, std::as_bytes(std::span(svg)));
    }
    const std::vector<std::uint8_t> pixels =
        arguments.options.dimensions == 1
            ? noise::graphPixels(arguments.options, arguments.width, arguments.height)
            : noise::noisePixels(arguments.options, arguments.colors, arguments.width, arguments.height);
    image::Image picture{arguments.width, arguments.height, 3, image::Component::u8, {}};
    const auto bytes = std::as_bytes(std::span(pixels));
    picture.data.assign(bytes.begin(), bytes.end());
    return image::writeImage(picture, arguments.output);
}

int run(NoiseArguments& arguments) {
    char rest = 0;
    // NOLINTNEXTLINE(cert-err34-c): the count of matched fields is checked, and the width of the numbers is
    // bounded
    if (std::sscanf(arguments.size.c_str(), "%5dx%5d%c", &arguments.width, &arguments.height, &rest) != 2 ||
        arguments.width < 1 || arguments.height < 1 || arguments.width > 16384 || arguments.height > 16384) {
        std::fprintf(stderr, "glibra: error: --size %s is not WxH with 1 to 16384 pixels a side\n",
                     arguments.size.c_str());
        return kWrongUsage;
    }
    if (arguments.options.dimensions == 2 && endingOf(arguments.output) == ".svg") {
        std::fprintf(stderr, "glibra: error: an SVG file holds a graph of one dimension; write a .png\n");
        return kWrongUsage;
    }
    for (const std::string& each : arguments.heights)
        arguments.options.heights.insert(pointOf("--height", each));
    for (const std::string& each : arguments.gradients)
        arguments.options.gradients.insert(pointOf("--gradient", each));
    const Diagnostics problems = writeNoise(arguments);
    print(problems);
    return hasError(problems) ? kSceneIsWrong : kDone;
}

}  // namespace

void addNoise(CLI::App& app, int& status) {
    auto arguments = std::make_shared<NoiseArguments>();
    CLI::App* command = app.add_subcommand("noise", "noise functions as graphs, pictures and textures");
    NoiseArguments& to = *arguments;
    const auto words = [&](const char* name, auto& value, auto table, const char* help) {
        command->add_option(name, value, help)->transform(CLI::CheckedTransformer(table));
    };
    command->add_option("DIMENSIONS", to.options.dimensions, "1 or 2")->check(CLI::Range(1, 2));
    words("--lattice", to.options.lattice,
          std::map<std::string, noise::Lattice>{{"value", noise::Lattice::value},
                                                {"gradient", noise::Lattice::gradient},
                                                {"both", noise::Lattice::both}},
          "what is random at the points: value, gradient, both");
    words("--smooth", to.options.smoothness,
          std::map<std::string, noise::Smoothness>{{"cubic", noise::Smoothness::cubic},
                                                   {"quintic", noise::Smoothness::quintic}},
          "between the points: cubic, quintic");
    words("--gradients", to.options.slopes,
          std::map<std::string, noise::Slopes>{{"zero", noise::Slopes::zero},
                                               {"catmull-rom", noise::Slopes::catmullRom}},
          "of value noise: zero, catmull-rom");
    words("--colors", to.colors,
          std::map<std::string, noise::ColorScale>{{"grey", noise::ColorScale::grey},
                                                   {"rainbow", noise::ColorScale::rainbow},
                                                   {"heated", noise::ColorScale::heated},
                                                   {"uniform", noise::ColorScale::uniform}},
          "of two dimensions: grey, rainbow, heated, uniform");
    command->add_option("--octaves", to.options.octaves, "1 to 8")
        ->check(CLI::Range(1, noise::kMostGraphOctaves));
    command->add_option("--points", to.options.cells, "points in a period")
        ->check(CLI::Range(2, noise::kMostGraphCells));
    command->add_option("--seed", to.options.seed, "another seed, other noise");
    command->add_flag("--turbulence", to.options.turbulence, "sum of absolute values");
    command->add_option("--height", to.heights, "POINT=NUMBER: the height of a point, -1 to 1")
        ->allow_extra_args(false);
    command->add_option("--gradient", to.gradients, "POINT=NUMBER: the gradient at a point, height a cell")
        ->allow_extra_args(false);
    command->add_option("--size", to.size, "WxH in pixels or texels")->capture_default_str();
    command
        ->add_option("-o,--output", to.output,
                     ".svg: graph; .tex: raw float texture; every other ending: graph or picture")
        ->capture_default_str();
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
