#include "cli/info_output.h"

#include <nlohmann/json.hpp>
#include <variant>

#include "gpu/context/context.h"

namespace glibra::cli {

std::string infoText(const gpu::Context& context) {
    return "glibra " GLIBRA_VERSION "\n" + gpu::toText(gpu::describe(context));
}

std::string infoJsonText(const gpu::Context& context) {
    return infoJson(context).dump(2) + "\n";
}

nlohmann::ordered_json infoJson(const gpu::Context& context) {
    nlohmann::ordered_json json;
    json["glibra"] = GLIBRA_VERSION;
    for (const gpu::InfoEntry& each : gpu::describe(context))
        std::visit([&](const auto& value) { json[each.key] = value; }, each.value);
    return json;
}

namespace {

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

}  // namespace

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

}  // namespace glibra::cli
