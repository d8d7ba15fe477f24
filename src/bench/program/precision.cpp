#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench/program/commands.h"
#include "bench/subjects/builtin_precision.h"
#include "cli/commands.h"
#include "cli/info_output.h"
#include "gpu/context/context.h"

namespace glibra::bench {
namespace {

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

}  // namespace

int printPrecision(Driver driver, bool asJson) {
    const Result<gpu::Context> context = gpu::openContext({.driver = driver});
    if (!context) {
        cli::print(context.diagnostics);
        return cli::kNoDriver;
    }
    const Result<std::vector<PrecisionRow>> rows = precisionTable(context->capabilities());
    if (!rows) {
        cli::print(rows.diagnostics);
        return cli::kNoDriver;
    }
    if (asJson) {
        nlohmann::ordered_json json = cli::infoJson(*context);
        json["precision"] = toJson(*rows);
        std::printf("%s\n", json.dump(2).c_str());
    } else {
        std::printf("%s\n%s", cli::infoText(*context).c_str(), toText(*rows).c_str());
    }
    return cli::kDone;
}

}  // namespace glibra::bench
