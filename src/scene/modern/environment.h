#pragma once
// The names that the expressions of a scene may use, and their values while it is interpreted (language, 12).
//
// Every name has a slot, which it keeps for as long as the script is loaded: expressions are read once and
// evaluated for many frames.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "expression/names.h"
#include "scene/camera.h"

namespace glibra::scene {

class Environment final : public expression::Names, public expression::Values {
  public:
    using Slot = std::uint32_t;

    /// Declares the names that every scene has (expression::sceneNames) and the cameras `camera` and `eye`.
    /// They have no values until they are set.
    Environment();

    /// Declares a name, or returns the slot that it has; nothing if it is declared with another type. An
    /// array may get another length, whose elements have no values yet.
    std::optional<Slot> declare(std::string_view path, const expression::Symbol& symbol);
    /// A number that is the same for equal lengths of all arrays: an expression that has been read counts on
    /// them.
    [[nodiscard]] std::size_t lengths() const { return length_; }
    /// Declares the fields of a camera: NAME.view and so on, and NAME.prev.view.
    void declareCamera(std::string_view name, std::size_t count = 0);

    void set(Slot slot, std::span<const double> components, std::size_t element = 0);
    void set(std::string_view path, std::span<const double> components, std::size_t element = 0);
    void setNumber(std::string_view path, double number) { set(path, {&number, 1}); }
    void setCamera(std::string_view name, const CameraValues& values, std::size_t element = 0);
    /// Declares the name of a texture with its field NAME.size, a vector of `components`.
    std::optional<Slot> declareTexture(std::string_view name, std::size_t components);
    /// Declares the name of a buffer with its field NAME.count. With the type of its elements the buffer is
    /// an array, which has no values until setElements(). False if the name is declared with another type.
    bool declareBuffer(std::string_view name, const std::optional<expression::Type>& element);
    /// Sets all elements of a buffer, and how many there are.
    void setElements(std::string_view name, std::vector<double> components);

    /// Forgets all values, before a frame is interpreted.
    void forgetValues();
    /// Forgets one value. The error of an expression that reads the name says `why`.
    void forget(std::string_view path, std::string why);

    /// Makes a name mean something else until endScope(): parameters of groups and counters of repetitions.
    /// `owner` tells the declarations of one name apart; equal owners get the same slot.
    void beginScope() { scopes_.push_back(scoped_.size()); }
    void endScope();
    Slot declareScoped(const void* owner, std::string_view name, const expression::Symbol& symbol);

    [[nodiscard]] std::optional<expression::Symbol> find(std::string_view path) const override;
    /// The same for a name that no scope hides.
    [[nodiscard]] std::optional<expression::Symbol> findOutermost(std::string_view path) const;
    [[nodiscard]] std::vector<std::string> known(std::string_view path) const override;
    [[nodiscard]] const double* find(std::uint32_t slot, std::size_t element) const override;
    [[nodiscard]] std::string whyMissing(std::uint32_t slot, std::size_t element) const override;

    /// What the value of a name can change with.
    [[nodiscard]] expression::Depends dependsOf(Slot slot) const {
        return variables_.at(slot).symbol.depends;
    }
    void addDepends(Slot slot, expression::Depends depends) {
        variables_.at(slot).symbol.depends = variables_.at(slot).symbol.depends | depends;
    }
    void setDepends(Slot slot, expression::Depends depends) { variables_.at(slot).symbol.depends = depends; }
    /// The components of all elements that have a value, in order.
    [[nodiscard]] std::vector<double> valuesOf(Slot slot) const;

    /// What a name is at one moment: all its elements, and what it can change with.
    struct Kept {
        std::uint32_t count = 0;
        expression::Depends depends = expression::Depends::nothing;
        std::vector<double> components;
        std::vector<bool> has;
        std::string why;
    };
    [[nodiscard]] Kept keep(Slot slot) const;
    /// Gives a name back what keep() returned.
    void giveBack(Slot slot, Kept kept);

  private:
    struct Variable {
        expression::Symbol symbol;
        std::vector<double> components;  ///< of all elements; a missing value is empty
        std::vector<bool> has;           ///< one per element
        std::string why;                 ///< there is no value, if that is known
        bool isBuffer = false;           ///< it has as many elements as setElements() gives it
    };
    Slot add(const expression::Symbol& symbol);
    void resize(Slot slot, std::uint32_t count);

    std::map<std::string, Slot, std::less<>> slots_;
    std::map<std::pair<const void*, std::string>, Slot> scopedSlots_;
    std::vector<std::pair<std::string, Slot>> scoped_;  ///< the innermost last
    std::vector<std::size_t> scopes_;
    std::vector<Variable> variables_;
    std::map<Slot, std::uint32_t> lengths_;  ///< of the arrays that got another length
    std::map<std::map<Slot, std::uint32_t>, std::size_t> lengthIds_;
    std::size_t length_ = 0;
};

}  // namespace glibra::scene
