#include "cli/info_output.h"

#include <nlohmann/json.hpp>
#include <variant>

#include "gpu/context/info.h"

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

}  // namespace glibra::cli
