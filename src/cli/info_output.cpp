#include "cli/info_output.h"

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <variant>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/sister_program.h"
#include "gpu/context/context.h"

namespace glibra::cli {
namespace {

/// The same as the text of a JSON object.
std::string infoJsonText(const gpu::Context& context) {
    return infoJson(context).dump(2) + "\n";
}

using Json = nlohmann::ordered_json;

/// ASCII, so that a terminal obeys nothing of it. Bytes that are not UTF-8 are replaced.
std::string lines(const Json& json) {
    return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

Json asJson(const Diagnostics& diagnostics) {
    Json list = Json::array();
    for (const Diagnostic& each : diagnostics)
        list.push_back({{"file", each.place.file},
                        {"line", each.place.line},
                        {"column", each.place.column},
                        {"severity", name(each.severity)},
                        {"id", each.id},
                        {"text", each.text}});
    return list;
}

/// Runs `glibra bench` and `glibra info --precision`.
constexpr SisterProgram kBenchProgram{
    "glibra-bench",
    "build it with `cmake --build BUILD_FOLDER --target glibra_bench_program` (this needs Boost)"};

struct InfoArguments {
    Driver driver = Driver::automatic;
    bool json = false;
    bool precision = false;
};

/// Starts glibra-bench, which prints what `runInfoCommand` prints, with the measured precision.
int measurePrecision(const InfoArguments& arguments) {
    std::vector<std::string> words{"precision"};
    if (arguments.json) words.emplace_back("--json");
    words.insert(words.end(), {"--driver", std::string(word(arguments.driver))});
    return becomeProgram(kBenchProgram, words);
}

int runInfoCommand(const InfoArguments& arguments) {
    if (arguments.precision) return measurePrecision(arguments);
    const Result<gpu::Context> context = gpu::openContext({.driver = arguments.driver});
    if (!context) {
        print(context.diagnostics);
        return kNoDriver;
    }
    std::fputs((arguments.json ? infoJsonText(*context) : infoText(*context)).c_str(), stdout);
    return kDone;
}

}  // namespace

std::string infoText(const gpu::Context& context) {
    return "glibra " GLIBRA_VERSION "\n" + gpu::toText(gpu::describe(context));
}

nlohmann::ordered_json infoJson(const gpu::Context& context) {
    nlohmann::ordered_json json;
    json["glibra"] = GLIBRA_VERSION;
    for (const gpu::InfoEntry& each : gpu::describe(context))
        std::visit([&](const auto& value) { json[each.key] = value; }, each.value);
    return json;
}

std::string toJson(const std::vector<CheckedScene>& scenes) {
    Json list = Json::array();
    for (const CheckedScene& each : scenes)
        list.push_back({{"scene", each.scene},
                        {"good", !hasError(each.diagnostics)},
                        {"diagnostics", asJson(each.diagnostics)}});
    return lines(list);
}

std::string jsonText(const std::string& text) {
    return Json(text).dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string toJson(const image::Judgement& judged, const image::Image& expected, const image::Image& got,
                   const image::Tolerance& tolerance) {
    const image::Comparison& found = judged.comparison;
    Json json{{"same", judged.same},
              {"decidedBy", name(judged.decidedBy)},
              {"reason", judged.reason},
              {"identical", found.identical},
              {"sameSize", found.sameSize}};
    if (!found.sameSize) {
        json["sizes"] = {{expected.width, expected.height}, {got.width, got.height}};
        return lines(json);
    }
    json["largest"] = found.largest * 255;  // null where it is infinite, as is the RMSE
    json["at"] = {found.x, found.y};
    json["component"] = found.component;
    json["differingPixels"] = found.differingPixels;
    json["fraction"] = found.identical ? 0 : differingFraction(found, expected);
    json["rmse"] = found.rootMeanSquare * 255;
    json["beyond"] = judged.beyond;
    json["cluster"] = judged.cluster;
    json["clusterAt"] = {judged.clusterX, judged.clusterY};
    json["line"] = judged.line;
    json["bias"] = judged.bias;
    json["biasCountsUpTo"] = tolerance.largest;  // larger differences of a pixel count as this
    json["biasAt"] = {judged.biasX, judged.biasY};
    json["nonFinite"] = found.nonFinite;
    if (judged.structure) json["structure"] = *judged.structure;
    if (judged.flip) json["flip"] = *judged.flip;
    return lines(json);
}

double differingFraction(const image::Comparison& found, const image::Image& picture) {
    return static_cast<double>(found.differingPixels) / (static_cast<double>(picture.width) * picture.height);
}

void addBench(CommandLine& program, int& status) {
    program.subcommand("bench", "measures run time against error, as curves with their Pareto fronts",
                       [&status](const std::vector<std::string>& arguments) {
                           status = becomeProgram(kBenchProgram, arguments);
                       });
}

void addInfo(CommandLine& program, int& status) {
    auto arguments = std::make_shared<InfoArguments>();
    CommandLine command =
        program.subcommand("info", "prints the driver, its limits and its capabilities",
                           "glibra info                 # driver, limits, capabilities\n"
                           "glibra info --json\n"
                           "glibra info --precision     # the errors of the GLSL functions");
    command.driver(arguments->driver);
    command.flag(
        "--precision", arguments->precision,
        "measure the errors of the GLSL functions and compare them with the limits of the specification");
    command.flag("--json", arguments->json, "print as JSON");
    command.onRun([arguments, &status] { status = runInfoCommand(*arguments); });
}

}  // namespace glibra::cli
