#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/subjects/builtin_precision.h"
#include "cli/commands.h"
#include "gpu/context.h"
#include "gpu/info.h"

namespace glibra::cli {
namespace {

struct InfoArguments {
    Driver driver = Driver::automatic;
    bool json = false;
    bool precision = false;
};

/// Null where the number is infinite, which JSON cannot say.
nlohmann::ordered_json finite(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

nlohmann::ordered_json asJson(const bench::BuiltinFunction& function, const bench::Precision& precision) {
    nlohmann::ordered_json json{{"largestUlp", finite(precision.largest)},
                                {"meanUlp", precision.mean},
                                {"largestAbsolute", precision.largestAbsolute},
                                {"worstArguments", bench::argumentsText(function, precision.worst)},
                                {"samples", precision.samples},
                                {"notNumbers", precision.notNumbers}};
    if (precision.ofBound) json["timesTheBound"] = finite(*precision.ofBound);
    return json;
}

nlohmann::ordered_json asJson(const std::vector<bench::PrecisionRow>& rows) {
    auto json = nlohmann::ordered_json::array();
    for (const bench::PrecisionRow& row : rows)
        json.push_back({{"function", row.function->name},
                        {"arguments", row.sweep->words},
                        {"bound", row.function->bound},
                        {"vertex", asJson(*row.function, row.vertex)},
                        {"fragment", asJson(*row.function, row.fragment)}});
    return json;
}

int run(const InfoArguments& arguments) {
    const Result<gpu::Context> context = gpu::openContext({.driver = arguments.driver});
    if (!context) {
        print(context.diagnostics);
        return kNoDriver;
    }
    std::vector<bench::PrecisionRow> precision;
    if (arguments.precision) {
        Result<std::vector<bench::PrecisionRow>> measured = bench::precisionTable(context->capabilities());
        if (!measured) {
            print(measured.diagnostics);
            return kNoDriver;
        }
        precision = std::move(*measured);
    }
    if (arguments.json) {
        nlohmann::ordered_json json;
        json["glibra"] = GLIBRA_VERSION;
        for (const gpu::InfoEntry& each : gpu::describe(*context))
            std::visit([&](const auto& value) { json[each.key] = value; }, each.value);
        if (arguments.precision) json["precision"] = asJson(precision);
        std::printf("%s\n", json.dump(2).c_str());
        return kDone;
    }
    std::printf("glibra %s\n%s", GLIBRA_VERSION, gpu::toText(gpu::describe(*context)).c_str());
    if (arguments.precision) std::printf("\n%s", bench::toText(precision).c_str());
    return kDone;
}

}  // namespace

void addInfo(CLI::App& app, int& status) {
    auto arguments = std::make_shared<InfoArguments>();
    CLI::App* command = app.add_subcommand("info", "the driver, its limits and capabilities");
    command->add_option("--driver", arguments->driver, "which OpenGL: auto, egl, egl-device, osmesa")
        ->transform(CLI::CheckedTransformer(kDriversByWord));
    command->add_flag("--precision", arguments->precision,
                      "measure the error of GLSL's functions against what the specification allows");
    command->add_flag("--json", arguments->json, "as JSON");
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
