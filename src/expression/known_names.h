#pragma once
// The names that an expression may have.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glibra/diagnostic.h>

#include "expression/type.h"

namespace glibra::expression {

// What an expression may name. The caller knows the names: it gives their types when an expression is parsed,
// and their values when it is evaluated.

/// What a value can change with: a set of bits.
enum class Depends : std::uint32_t {
    nothing = 0,
    time = 1U << 0U,
    tick = 1U << 1U,
    frame = 1U << 2U,
    window = 1U << 3U,
    mouse = 1U << 4U,
    model = 1U << 5U,
    camera = 1U << 6U,
    variable = 1U << 7U,
    counter = 1U << 8U,  ///< of a repetition or an array
    texture = 1U << 9U,
    buffer = 1U << 10U,
};
constexpr Depends operator|(Depends a, Depends b) {
    return static_cast<Depends>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr Depends operator&(Depends a, Depends b) {
    return static_cast<Depends>(static_cast<std::uint32_t>(a) & static_cast<std::uint32_t>(b));
}
constexpr bool any(Depends set) {
    return set != Depends::nothing;
}

/// True if another time, tick or frame may give another value.
constexpr bool changesWithTime(Depends set) {
    return any(set & (Depends::time | Depends::tick | Depends::frame));
}

/// What a name stands for.
struct Symbol {
    Type type;
    std::uint32_t slot = 0;   ///< handed to Values, so that an evaluation looks up no text
    std::uint32_t count = 0;  ///< elements of an array, whose elements have `type`; 0: not an array
    Depends depends = Depends::nothing;
    std::vector<std::string> words;  ///< of a choice: a number that counts these words from 0
    std::string what;                ///< of a record, for messages: "camera"
};

/// A function that a scene declares: `Let name(parameters) (body)`. Each call reads the body with the types
/// of its arguments.
struct Function {
    std::string name;
    std::vector<std::string> parameters;
    std::string body;
    Place origin;           ///< of the first byte of the body
    std::size_t order = 0;  ///< its body may call the functions of lower order alone
};

/// The names that an expression may use. A path is a name with its fields, without subscripts: "time",
/// "camera.view", "mouse.down", "light.prev.shadow". The fields of the elements of an array are arrays: if
/// `slice` is an array of 3 cameras, then "slice.view" is an array of 3 matrices, and `slice[1].view` an
/// element of it.
class Names {
  public:
    Names() = default;
    Names(const Names&) = default;
    Names& operator=(const Names&) = default;
    virtual ~Names() = default;

    [[nodiscard]] virtual std::optional<Symbol> find(std::string_view path) const = 0;

    /// What a path means in the body of a function of the scene.
    [[nodiscard]] virtual std::optional<Symbol> findInScene(std::string_view path) const {
        return find(path);
    }
    /// The function of the scene of that name; null if there is none.
    [[nodiscard]] virtual std::shared_ptr<const Function> findFunction(std::string_view /*name*/) const {
        return nullptr;
    }
    /// The names of these functions, to suggest for a misspelt one.
    [[nodiscard]] virtual std::vector<std::string> knownFunctions() const { return {}; }

    /// The names to suggest for a misspelt one: all first names for an empty path, else the fields of that
    /// path.
    [[nodiscard]] virtual std::vector<std::string> known(std::string_view path) const = 0;
};

/// The values of the names.
class Values {
  public:
    Values() = default;
    Values(const Values&) = default;
    Values& operator=(const Values&) = default;
    virtual ~Values() = default;

    /// The components of a symbol's value, as many as its type has, valid until the next call. `element` is
    /// below the symbol's count, and 0 for what is not an array. Null: there is no value here.
    [[nodiscard]] virtual const double* find(std::uint32_t slot, std::size_t element) const = 0;

    /// Why there is no value, for the message: "it is defined by itself". May be empty.
    [[nodiscard]] virtual std::string whyMissing(std::uint32_t slot, std::size_t element) const;
};

// The names that every scene has.

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

/// A word that follows a name of the scene and a point.
struct PartRow {
    std::string_view word;
    std::string_view form;  ///< "TEXTURE.level(n)"; NAME stands for several kinds of objects
    std::string_view summary;
};
std::span<const PartRow> partTable();

}  // namespace glibra::expression
