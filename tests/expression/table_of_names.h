#pragma once
// Names with their values, in a table.

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/known_names.h"

namespace glibra::expression::test {

/// A table of names, which has values for those that were set.
class NameTable : public Names, public Values {
  public:
    /// Adds a name, or replaces one of the same path. Returns its slot; `symbol.slot` is not read.
    std::uint32_t add(std::string path, Symbol symbol);
    std::uint32_t add(std::string path, const Type& type, Depends depends, std::uint32_t count = 0) {
        return add(std::move(path),
                   {.type = type, .count = count, .depends = depends, .words = {}, .what = {}});
    }
    /// Adds sceneNames().
    void addSceneNames();
    /// Adds a camera with all its fields; `count` above 0: an array of cameras.
    void addCamera(const std::string& path, std::uint32_t count = 0);

    /// Sets the components of a value, as many as its type has. Other sizes and elements are ignored.
    void set(std::uint32_t slot, std::span<const double> components, std::size_t element = 0);
    void set(std::uint32_t slot, double value, std::size_t element = 0) { set(slot, {&value, 1}, element); }
    /// The same by path; unknown paths are ignored.
    void set(std::string_view path, std::span<const double> components, std::size_t element = 0);
    void set(std::string_view path, double value, std::size_t element = 0) {
        set(path, {&value, 1}, element);
    }

    [[nodiscard]] std::optional<Symbol> find(std::string_view path) const override;
    [[nodiscard]] std::vector<std::string> known(std::string_view path) const override;
    [[nodiscard]] const double* find(std::uint32_t slot, std::size_t element) const override;

  private:
    struct Stored {
        Type type;
        std::vector<double> components;
        std::vector<bool> isSet;  ///< by element
    };
    std::map<std::string, Symbol, std::less<>> symbols_;
    std::vector<Stored> values_;  ///< by slot
};

inline std::uint32_t NameTable::add(std::string path, Symbol symbol) {
    symbol.slot = static_cast<std::uint32_t>(values_.size());
    const std::size_t elements = std::max<std::size_t>(symbol.count, 1);
    values_.push_back(
        {symbol.type, std::vector<double>(elements * symbol.type.size()), std::vector<bool>(elements)});
    const std::uint32_t slot = symbol.slot;
    symbols_.insert_or_assign(std::move(path), std::move(symbol));
    return slot;
}

inline void NameTable::addSceneNames() {
    for (const NameRow& each : sceneNames()) add(std::string(each.path), each.type, each.depends);
}

inline void NameTable::addCamera(const std::string& path, std::uint32_t count) {
    const Symbol camera{
        .type = Type::record(), .count = count, .depends = Depends::camera, .words = {}, .what = "camera"};
    for (const std::string& each : {path, path + ".prev"}) {
        add(each, camera);
        for (const NameRow& field : cameraFields())
            add(each + "." + std::string(field.path), field.type, field.depends, count);
    }
}

inline void NameTable::set(std::uint32_t slot, std::span<const double> components, std::size_t element) {
    if (slot >= values_.size()) return;
    Stored& stored = values_[slot];
    if (components.size() != stored.type.size() || element >= stored.isSet.size()) return;
    std::ranges::copy(components,
                      stored.components.begin() + static_cast<std::ptrdiff_t>(element * components.size()));
    stored.isSet[element] = true;
}

inline void NameTable::set(std::string_view path, std::span<const double> components, std::size_t element) {
    if (const auto found = symbols_.find(path); found != symbols_.end())
        set(found->second.slot, components, element);
}

inline std::optional<Symbol> NameTable::find(std::string_view path) const {
    const auto found = symbols_.find(path);
    if (found == symbols_.end()) return std::nullopt;
    return found->second;
}

inline std::vector<std::string> NameTable::known(std::string_view path) const {
    std::vector<std::string> names;
    const std::string prefix = path.empty() ? std::string() : std::string(path) + ".";
    for (const auto& [each, symbol] : symbols_)
        if (each.starts_with(prefix) && each.find('.', prefix.size()) == std::string::npos)
            names.push_back(each.substr(prefix.size()));
    return names;
}

inline const double* NameTable::find(std::uint32_t slot, std::size_t element) const {
    if (slot >= values_.size() || element >= values_[slot].isSet.size() || !values_[slot].isSet[element])
        return nullptr;
    return values_[slot].components.data() + element * values_[slot].type.size();
}

}  // namespace glibra::expression::test
