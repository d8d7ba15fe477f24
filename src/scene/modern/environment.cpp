#include "scene/modern/environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "expression/name_table.h"

namespace glibra::scene {
namespace {

using expression::Depends;
using expression::Symbol;
using expression::Type;

Symbol symbolOf(Type type, Depends depends, std::size_t count = 0) {
    Symbol symbol;
    symbol.type = type;
    symbol.depends = depends;
    symbol.count = static_cast<std::uint32_t>(count);
    return symbol;
}

Symbol record(std::string what, std::size_t count = 0) {
    Symbol symbol = symbolOf(Type::record(), Depends::nothing, count);
    symbol.what = std::move(what);
    return symbol;
}

/// The number of elements of a buffer is known when it is read; an expression is checked before.
constexpr std::uint32_t kElementsOfBuffers = 0x7fffffff;
constexpr const char* kWhoReadsElements = "only Expect (condition) reads the elements of buffers";

std::span<const double> componentsOf(const glm::dmat4& matrix) {
    return {&matrix[0][0], 16};
}
std::span<const double> componentsOf(const glm::dvec3& vector) {
    return {&vector[0], 3};
}

}  // namespace

Environment::Environment() {
    for (const expression::NameRow& each : expression::sceneNames())
        declare(each.path, symbolOf(each.type, each.depends));
    declareCamera("camera");
    declareCamera("eye");
}

Environment::Slot Environment::add(const Symbol& symbol) {
    const auto slot = static_cast<Slot>(variables_.size());
    Variable variable;
    variable.symbol = symbol;
    variable.symbol.slot = slot;
    variable.isBuffer = symbol.count == kElementsOfBuffers;
    if (variable.isBuffer) variable.why = kWhoReadsElements;
    const std::size_t elements = variable.isBuffer ? 0 : std::max<std::size_t>(1, symbol.count);
    variable.components.resize(elements * symbol.type.size());
    variable.has.resize(elements);
    variables_.push_back(std::move(variable));
    return slot;
}

std::optional<Environment::Slot> Environment::declare(std::string_view path, const Symbol& symbol) {
    if (const auto known = slots_.find(path); known != slots_.end()) {
        Symbol& earlier = variables_[known->second].symbol;
        if (earlier.type != symbol.type || earlier.what != symbol.what) return std::nullopt;
        if (earlier.count != symbol.count) {
            const bool isBuffer = variables_[known->second].isBuffer || symbol.count == kElementsOfBuffers;
            if (earlier.count == 0 || symbol.count == 0 || isBuffer) return std::nullopt;
            resize(known->second, symbol.count);
        }
        earlier.depends = earlier.depends | symbol.depends;
        earlier.words = symbol.words;
        return known->second;
    }
    return slots_[std::string(path)] = add(symbol);
}

void Environment::resize(Slot slot, std::uint32_t count) {
    Variable& variable = variables_[slot];
    variable.symbol.count = count;
    variable.components.assign(count * variable.symbol.type.size(), 0);
    variable.has.assign(count, false);
    lengths_[slot] = count;
    length_ = lengthIds_.try_emplace(lengths_, lengthIds_.size() + 1).first->second;
}

void Environment::declareCamera(std::string_view name, std::size_t count) {
    const std::string camera(name);
    declare(camera, record("camera", count));
    declare(camera + ".prev", record("camera", count));
    for (const expression::NameRow& each : expression::cameraFields())
        for (const char* moment : {".", ".prev."})
            declare(camera + moment + std::string(each.path), symbolOf(each.type, each.depends, count));
}

std::optional<Environment::Slot> Environment::declareTexture(std::string_view name, std::size_t components) {
    if (!declare(name, record("texture"))) return std::nullopt;
    return declare(std::string(name) + ".size", symbolOf(Type::vector(components), Depends::texture));
}

bool Environment::declareBuffer(std::string_view name, const std::optional<Type>& element) {
    const bool isNew =
        declare(name, element ? symbolOf(*element, Depends::buffer, kElementsOfBuffers) : record("buffer"))
            .has_value();
    return isNew && declare(std::string(name) + ".count", symbolOf(Type::number(), Depends::buffer));
}

void Environment::setElements(std::string_view name, std::vector<double> components) {
    const auto known = slots_.find(name);
    if (known == slots_.end() || !variables_[known->second].isBuffer) return;
    Variable& variable = variables_[known->second];
    const std::size_t count = components.size() / variable.symbol.type.size();
    variable.components = std::move(components);
    variable.has.assign(count, true);
    variable.why = fmt::format("'{}' has {} elements", name, count);
    setNumber(std::string(name) + ".count", static_cast<double>(count));
}

void Environment::set(Slot slot, std::span<const double> components, std::size_t element) {
    Variable& variable = variables_.at(slot);
    const std::size_t size = variable.symbol.type.size();
    if (element >= variable.has.size() || components.size() < size) return;
    std::copy_n(components.begin(), size,
                variable.components.begin() + static_cast<std::ptrdiff_t>(element * size));
    variable.has[element] = true;
}

void Environment::set(std::string_view path, std::span<const double> components, std::size_t element) {
    if (const auto known = slots_.find(path); known != slots_.end()) set(known->second, components, element);
}

void Environment::setCamera(std::string_view name, const CameraValues& values, std::size_t element) {
    const std::string prefix = std::string(name) + ".";
    const glm::dmat4 viewProjection = values.viewProjection(), inverse = values.inverseView(),
                     shadow = values.shadow();
    const glm::dvec3 position = values.position(), direction = values.direction();
    set(prefix + "view", componentsOf(values.view), element);
    set(prefix + "projection", componentsOf(values.projection), element);
    set(prefix + "viewProjection", componentsOf(viewProjection), element);
    set(prefix + "inverseView", componentsOf(inverse), element);
    set(prefix + "shadow", componentsOf(shadow), element);
    set(prefix + "position", componentsOf(position), element);
    set(prefix + "direction", componentsOf(direction), element);
    const std::array numbers{std::pair{"near", values.near}, std::pair{"far", values.far},
                             std::pair{"fov", values.fieldOfView}, std::pair{"aspect", values.aspect}};
    for (const auto& [field, number] : numbers) set(prefix + field, {&number, 1}, element);
}

void Environment::forgetValues() {
    for (Variable& each : variables_) {
        std::fill(each.has.begin(), each.has.end(), false);
        each.why.clear();
        if (each.isBuffer) each.why = kWhoReadsElements;
    }
}

void Environment::forget(std::string_view path, std::string why) {
    const auto known = slots_.find(path);
    if (known == slots_.end()) return;
    Variable& variable = variables_[known->second];
    std::fill(variable.has.begin(), variable.has.end(), false);
    variable.why = std::move(why);
}

std::string Environment::whyMissing(std::uint32_t slot, std::size_t) const {
    return variables_.at(slot).why;
}

std::vector<double> Environment::valuesOf(Slot slot) const {
    const Variable& variable = variables_.at(slot);
    const std::size_t size = variable.symbol.type.size();
    std::vector<double> values;
    for (std::size_t i = 0; i < variable.has.size(); ++i) {
        if (!variable.has[i]) continue;
        const auto first = variable.components.begin() + static_cast<std::ptrdiff_t>(i * size);
        values.insert(values.end(), first, first + static_cast<std::ptrdiff_t>(size));
    }
    return values;
}

void Environment::endScope() {
    scoped_.resize(scopes_.back());
    scopes_.pop_back();
}

Environment::Slot Environment::declareScoped(const void* owner, std::string_view name, const Symbol& symbol) {
    const auto [known, isNew] = scopedSlots_.try_emplace({owner, std::string(name)}, 0);
    if (isNew) known->second = add(symbol);
    scoped_.emplace_back(std::string(name), known->second);
    return known->second;
}

std::optional<Symbol> Environment::find(std::string_view path) const {
    for (auto each = scoped_.rbegin(); each != scoped_.rend(); ++each)
        if (each->first == path) return variables_[each->second].symbol;
    return findOutermost(path);
}

std::optional<Symbol> Environment::findOutermost(std::string_view path) const {
    const auto known = slots_.find(path);
    return known != slots_.end() ? std::optional(variables_[known->second].symbol) : std::nullopt;
}

std::vector<std::string> Environment::known(std::string_view path) const {
    std::set<std::string> names;
    const std::string prefix = path.empty() ? std::string() : std::string(path) + ".";
    const auto consider = [&](std::string_view name) {
        if (!name.starts_with(prefix)) return;
        const std::string_view rest = name.substr(prefix.size());
        names.emplace(rest.substr(0, rest.find('.')));
    };
    for (const auto& [name, slot] : slots_) consider(name);
    for (const auto& [name, slot] : scoped_) consider(name);
    return {names.begin(), names.end()};
}

const double* Environment::find(std::uint32_t slot, std::size_t element) const {
    const Variable& variable = variables_.at(slot);
    if (element >= variable.has.size() || !variable.has[element]) return nullptr;
    return &variable.components[element * variable.symbol.type.size()];
}

Environment::Kept Environment::keep(Slot slot) const {
    const Variable& variable = variables_.at(slot);
    return {variable.symbol.count, variable.symbol.depends, variable.components, variable.has, variable.why};
}

void Environment::giveBack(Slot slot, Kept kept) {
    Variable& variable = variables_.at(slot);
    if (variable.symbol.count != kept.count) resize(slot, kept.count);
    variable.symbol.depends = kept.depends;
    variable.components = std::move(kept.components);
    variable.has = std::move(kept.has);
    variable.why = std::move(kept.why);
}

}  // namespace glibra::scene
