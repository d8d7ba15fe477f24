// Values that a user has set as a text, which other runs of the program read.

#include <nlohmann/json.hpp>

#include "view/scene/knobs.h"

namespace glibra::view {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string KeptValues::text() const {
    if (values_.empty()) return {};
    Json owners = Json::array(), values = Json::array();
    for (const auto& [name, number] : owners_) owners.push_back({name, number});
    for (const auto& [key, kept] : values_)
        values.push_back({{"program", {key.first.first, key.first.second}},
                          {"name", key.second},
                          {"form", static_cast<int>(kept.form)},
                          {"written", kept.written},
                          {"value", kept.current}});
    return Json{{"programs", owners}, {"values", values}}.dump(1, ' ', false, Json::error_handler_t::replace);
}

KeptValues KeptValues::ofText(std::string_view text) {
    KeptValues kept;
    const auto ownerOf = [](const Json& json) {
        return Owner(json.at(0).get<std::string>(), json.at(1).get<int>());
    };
    try {
        const Json json = Json::parse(text);
        for (const Json& each : json.at("programs")) kept.owners_.push_back(ownerOf(each));
        for (const Json& each : json.at("values"))
            kept.values_[{ownerOf(each.at("program")), each.at("name").get<std::string>()}] = {
                static_cast<glib::UniformForm>(each.at("form").get<int>()),
                each.at("written").get<std::vector<double>>(), each.at("value").get<std::vector<double>>()};
    } catch (const Json::exception&) {
        return {};  // somebody has changed the file
    }
    return kept;
}

}  // namespace glibra::view
