#pragma once
// Names with their values, in a table; and the names that every scene has.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/names.h"

namespace glibra::expression {

/// A name that needs no declaration.
struct NameRow {
    std::string_view path;
    Type type;
    Depends depends;
    std::string_view summary;
};

/// time, dt, frame, tick, window, aspect, mouse, mouse.down, model.
std::span<const NameRow> sceneNames();
/// view, projection, ... without `prev`, which has these fields again.
std::span<const NameRow> cameraFields();

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

}  // namespace glibra::expression
