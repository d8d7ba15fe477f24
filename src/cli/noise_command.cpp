#include <charconv>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "noise/noise_file.h"

namespace glibra::cli {
namespace {

/// Words of an option and their values.
template <class Value>
using Words = std::vector<std::pair<const char*, Value>>;

struct NoiseArguments {
    noise::NoiseFile noise;
    std::string size = "600x300";
    std::string output = "noise.png";
};

/// Reads a point and its number, "3=.5", into `to`. Returns what is wrong with the text, or an empty text.
std::string readPoint(const std::string& text, std::map<int, double>& to) {
    int point = 0;
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [equals, problem] = std::from_chars(text.data(), end, point);
    if (problem == std::errc() && equals != end && *equals == '=' && point >= 0) {
        const auto [last, trouble] = std::from_chars(equals + 1, end, value);
        if (trouble == std::errc() && last == end && value >= -1e6 && value <= 1e6) {
            if (to.insert({point, value}).second) return {};
            return "point " + std::to_string(point) + " has a value already; '" + text + "' is one more";
        }
    }
    return "expected POINT=NUMBER, as 3=.5, found '" + text + "'";
}

int runNoiseCommand(NoiseArguments& arguments) {
    noise::NoiseFile& noise = arguments.noise;
    char rest = 0;
    // NOLINTNEXTLINE(cert-err34-c): the count of matched fields is checked, and the width of the numbers is
    // bounded
    if (std::sscanf(arguments.size.c_str(), "%5dx%5d%c", &noise.width, &noise.height, &rest) != 2 ||
        noise.width < 1 || noise.height < 1 || noise.width > 16384 || noise.height > 16384)
        return refuse("--size " + arguments.size + " is not WxH with 1 to 16384 pixels a side");
    if (noise.options.dimensions == 2 && noise::endingOf(arguments.output) == ".svg")
        return refuse("an SVG file holds a graph of one dimension; write a .png");
    if (const std::string useless = noise::uselessOption(noise, arguments.output); !useless.empty())
        return refuse(useless);
    return printErrors(noise::writeNoise(noise, arguments.output)) ? kSceneIsWrong : kDone;
}

}  // namespace

void addNoise(CommandLine& program, int& status) {
    auto arguments = std::make_shared<NoiseArguments>();
    CommandLine command = program.subcommand(
        "noise", "draws noise functions as graphs, pictures and textures",
        "glibra noise 1 --octaves 4 -o noise.svg                    # a graph\n"
        "glibra noise 2 --octaves 4 --turbulence -o noise.png       # a picture\n"
        "glibra noise 2 --size 256x256 -o noise.tex                 # a raw float texture");
    NoiseArguments& to = *arguments;
    noise::GraphOptions& options = to.noise.options;
    const auto points = [&command](const char* name, std::map<int, double>& values, const char* help) {
        command.repeated(name, [&values](const std::string& text) { return readPoint(text, values); }, help);
    };
    command.option("DIMENSIONS", options.dimensions, "number of dimensions").within(1, 2);
    command.choice("--lattice", options.lattice,
                   Words<noise::Lattice>{{"value", noise::Lattice::value},
                                         {"gradient", noise::Lattice::gradient},
                                         {"both", noise::Lattice::both}},
                   "what is random at the points: value, gradient or both");
    command.choice("--smooth", options.smoothness,
                   Words<noise::Smoothness>{{"cubic", noise::Smoothness::cubic},
                                            {"quintic", noise::Smoothness::quintic}},
                   "interpolation between the points: cubic or quintic");
    command.choice(
        "--gradients", options.slopes,
        Words<noise::Slopes>{{"zero", noise::Slopes::zero}, {"catmull-rom", noise::Slopes::catmullRom}},
        "gradients of value noise: zero or catmull-rom");
    command.choice("--colors", to.noise.colors,
                   Words<noise::ColorScale>{{"grey", noise::ColorScale::grey},
                                            {"rainbow", noise::ColorScale::rainbow},
                                            {"heated", noise::ColorScale::heated},
                                            {"uniform", noise::ColorScale::uniform},
                                            {"sky", noise::ColorScale::sky},
                                            {"fire", noise::ColorScale::fire}},
                   "colors in two dimensions: grey, rainbow (blue, green, red), heated (black, red, yellow, "
                   "white), uniform, sky (blue, white) or fire (red, yellow)");
    command.option("--octaves", options.octaves, "number of octaves").within(1, noise::kMostGraphOctaves);
    command.option("--points", options.cells, "points per period").within(2, noise::kMostGraphCells);
    command.option("--seed", options.seed, "seed of the random values");
    command.flag("--turbulence", options.turbulence, "sum up absolute values");
    points("--height", options.heights, "POINT=NUMBER: the height of a point, -1 to 1");
    points("--gradient", options.gradients, "POINT=NUMBER: the gradient at a point, in height per cell");
    points("--curvature", options.curvatures,
           "POINT=NUMBER: the second derivative at a point of a quintic, in height per cell squared");
    command.option("--size", to.size, "WxH in pixels or texels").withDefault();
    command
        .option("-o,--output", to.output,
                "output file; .svg is a graph, .tex a raw float texture, any other ending a graph or picture")
        .written()
        .withDefault();
    command.onRun([arguments, &status] { status = runNoiseCommand(*arguments); });
}

}  // namespace glibra::cli
