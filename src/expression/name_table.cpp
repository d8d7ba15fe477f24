#include "expression/name_table.h"

#include <algorithm>

namespace glibra::expression {
namespace {

using D = Depends;

constexpr NameRow kSceneNames[] = {
    {"time", Type::number(), D::time, "seconds since the start; in `Step r` the number of the step / r"},
    {"dt", Type::number(), D::nothing, "seconds from one frame, or step, to the next; the same for all"},
    {"frame", Type::number(), D::frame, "number of the frame, from 0"},
    {"tick", Type::number(), D::tick, "number of the simulation step, from 0"},
    {"window", Type::vector(2), D::window, "width and height of the window in pixels"},
    {"aspect", Type::number(), D::window, "width / height of the window"},
    {"mouse", Type::vector(2), D::mouse,
     "place of the mouse, 0 to 1 from the lower left corner; .5 .5 without a window"},
    {"mouse.down", Type::boolean(), D::mouse, "whether the left button is down"},
    {"model", Type::matrix(4), D::model, "the product of the transforms below the camera"},
};

constexpr NameRow kCameraFields[] = {
    {"view", Type::matrix(4), D::camera, "from the world to the eye"},
    {"projection", Type::matrix(4), D::camera, "from the eye to the clip space"},
    {"viewProjection", Type::matrix(4), D::camera, "projection * view"},
    {"inverseView", Type::matrix(4), D::camera, "from the eye to the world"},
    {"shadow", Type::matrix(4), D::camera, "viewProjection, mapped from -1..1 to 0..1"},
    {"position", Type::vector(3), D::camera, "the eye in the world"},
    {"direction", Type::vector(3), D::camera, "the direction of view in the world, of length 1"},
    {"near", Type::number(), D::camera, "distance of the near plane"},
    {"far", Type::number(), D::camera, "distance of the far plane"},
    {"fov", Type::number(), D::camera, "vertical full angle of view in degrees; 0 of an `Ortho`"},
    {"aspect", Type::number(), D::camera, "width / height of the picture"},
};

}  // namespace

std::span<const NameRow> sceneNames() {
    return kSceneNames;
}
std::span<const NameRow> cameraFields() {
    return kCameraFields;
}

std::uint32_t NameTable::add(std::string path, Symbol symbol) {
    symbol.slot = static_cast<std::uint32_t>(values_.size());
    const std::size_t elements = std::max<std::size_t>(symbol.count, 1);
    values_.push_back(
        {symbol.type, std::vector<double>(elements * symbol.type.size()), std::vector<bool>(elements)});
    const std::uint32_t slot = symbol.slot;
    symbols_.insert_or_assign(std::move(path), std::move(symbol));
    return slot;
}

void NameTable::addSceneNames() {
    for (const NameRow& each : kSceneNames) add(std::string(each.path), each.type, each.depends);
}

void NameTable::addCamera(const std::string& path, std::uint32_t count) {
    const Symbol camera{
        .type = Type::record(), .count = count, .depends = D::camera, .words = {}, .what = "camera"};
    for (const std::string& each : {path, path + ".prev"}) {
        add(each, camera);
        for (const NameRow& field : kCameraFields)
            add(each + "." + std::string(field.path), field.type, field.depends, count);
    }
}

void NameTable::set(std::uint32_t slot, std::span<const double> components, std::size_t element) {
    if (slot >= values_.size()) return;
    Stored& stored = values_[slot];
    if (components.size() != stored.type.size() || element >= stored.isSet.size()) return;
    std::ranges::copy(components,
                      stored.components.begin() + static_cast<std::ptrdiff_t>(element * components.size()));
    stored.isSet[element] = true;
}

void NameTable::set(std::string_view path, std::span<const double> components, std::size_t element) {
    if (const auto found = symbols_.find(path); found != symbols_.end())
        set(found->second.slot, components, element);
}

std::optional<Symbol> NameTable::find(std::string_view path) const {
    const auto found = symbols_.find(path);
    if (found == symbols_.end()) return std::nullopt;
    return found->second;
}

std::vector<std::string> NameTable::known(std::string_view path) const {
    std::vector<std::string> names;
    const std::string prefix = path.empty() ? std::string() : std::string(path) + ".";
    for (const auto& [each, symbol] : symbols_)
        if (each.starts_with(prefix) && each.find('.', prefix.size()) == std::string::npos)
            names.push_back(each.substr(prefix.size()));
    return names;
}

const double* NameTable::find(std::uint32_t slot, std::size_t element) const {
    if (slot >= values_.size() || element >= values_[slot].isSet.size() || !values_[slot].isSet[element])
        return nullptr;
    return values_[slot].components.data() + element * values_[slot].type.size();
}

}  // namespace glibra::expression
