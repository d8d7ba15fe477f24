#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "noise/noise_file.h"

namespace glibra::cli {
namespace {

struct NoiseArguments {
    noise::NoiseFile noise;
    std::vector<std::string> heights, gradients, curvatures;
    std::string size = "600x300";
    std::string output = "noise.png";
};

/// A point and its number: "3=.5".
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

int refuse(const std::string& why) {
    printError(why);
    return kWrongUsage;
}

int run(NoiseArguments& arguments) {
    noise::NoiseFile& noise = arguments.noise;
    char rest = 0;
    // NOLINTNEXTLINE(cert-err34-c): the count of matched fields is checked, and the width of the numbers is
    // bounded
    if (std::sscanf(arguments.size.c_str(), "%5dx%5d%c", &noise.width, &noise.height, &rest) != 2 ||
        noise.width < 1 || noise.height < 1 || noise.width > 16384 || noise.height > 16384)
        return refuse("--size " + arguments.size + " is not WxH with 1 to 16384 pixels a side");
    if (noise.options.dimensions == 2 && noise::endingOf(arguments.output) == ".svg")
        return refuse("an SVG file holds a graph of one dimension; write a .png");
    if (!arguments.curvatures.empty() && noise.options.smoothness == noise::Smoothness::cubic)
        return refuse("--curvature: heights and gradients determine a cubic; take --smooth quintic");
    for (const std::string& each : arguments.heights) noise.options.heights.insert(pointOf("--height", each));
    for (const std::string& each : arguments.gradients)
        noise.options.gradients.insert(pointOf("--gradient", each));
    for (const std::string& each : arguments.curvatures)
        noise.options.curvatures.insert(pointOf("--curvature", each));
    const Diagnostics problems = noise::writeNoise(noise, arguments.output);
    print(problems);
    return hasError(problems) ? kSceneIsWrong : kDone;
}

}  // namespace

void addNoise(CLI::App& app, int& status) {
    auto arguments = std::make_shared<NoiseArguments>();
    CLI::App* command = addCommand(app, "noise", "draws noise functions as graphs, pictures and textures",
                                   "glibra noise 2 --octaves 4 --turbulence -o n.png");
    NoiseArguments& to = *arguments;
    noise::GraphOptions& options = to.noise.options;
    const auto words = [&](const char* name, auto& value, auto table, const char* help) {
        command->add_option(name, value, help)->transform(CLI::CheckedTransformer(table));
    };
    command->add_option("DIMENSIONS", options.dimensions, "number of dimensions: 1 or 2")
        ->check(CLI::Range(1, 2));
    words("--lattice", options.lattice,
          std::map<std::string, noise::Lattice>{{"value", noise::Lattice::value},
                                                {"gradient", noise::Lattice::gradient},
                                                {"both", noise::Lattice::both}},
          "what is random at the points: value, gradient or both");
    words("--smooth", options.smoothness,
          std::map<std::string, noise::Smoothness>{{"cubic", noise::Smoothness::cubic},
                                                   {"quintic", noise::Smoothness::quintic}},
          "interpolation between the points: cubic or quintic");
    words("--gradients", options.slopes,
          std::map<std::string, noise::Slopes>{{"zero", noise::Slopes::zero},
                                               {"catmull-rom", noise::Slopes::catmullRom}},
          "gradients of value noise: zero or catmull-rom");
    words("--colors", to.noise.colors,
          std::map<std::string, noise::ColorScale>{{"grey", noise::ColorScale::grey},
                                                   {"rainbow", noise::ColorScale::rainbow},
                                                   {"heated", noise::ColorScale::heated},
                                                   {"uniform", noise::ColorScale::uniform}},
          "colors in two dimensions: grey, rainbow, heated or uniform");
    command->add_option("--octaves", options.octaves, "number of octaves, 1 to 8")
        ->check(CLI::Range(1, noise::kMostGraphOctaves));
    command->add_option("--points", options.cells, "points per period")
        ->check(CLI::Range(2, noise::kMostGraphCells));
    command->add_option("--seed", options.seed, "seed of the random values");
    command->add_flag("--turbulence", options.turbulence, "sum up absolute values");
    command->add_option("--height", to.heights, "POINT=NUMBER: the height of a point, -1 to 1")
        ->allow_extra_args(false);
    command
        ->add_option("--gradient", to.gradients, "POINT=NUMBER: the gradient at a point, in height per cell")
        ->allow_extra_args(false);
    command
        ->add_option(
            "--curvature", to.curvatures,
            "POINT=NUMBER: the second derivative at a point of a quintic, in height per cell squared")
        ->allow_extra_args(false);
    command->add_option("--size", to.size, "WxH in pixels or texels")->capture_default_str();
    command
        ->add_option(
            "-o,--output", to.output,
            "output file; .svg is a graph, .tex a raw float texture, any other ending a graph or picture")
        ->capture_default_str();
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
