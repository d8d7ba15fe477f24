#pragma once
// The names that the expressions of a scene may use, and their values while it is interpreted
// (language, 12.2).
//
// A name is looked for in this order:
//
//  1. among the names of the scopes around the statement, from the innermost out: counters of repetitions,
//     parameters of the group;
//  2. among the names of the Once or Step block that is open, then among those of the scene;
//  3. if neither the scene has the name nor any of its statements declares it, among the names of the scopes
//     around the Draw that runs the group.
//
// Which names the scopes have is one value, a Point. A scope keeps the Point that it begins with and gives it
// back, so that nothing of it is left. Every name has a slot. Types and words of a slot never change, so an
// expression is read once and evaluated for many frames, for as long as its names have the same slots.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "expression/known_names.h"
#include "scene/objects.h"
#include "scene/view.h"

namespace glibra::scene {

class Environment final : public expression::Names, public expression::Values {
  public:
    using Slot = std::uint32_t;

    /// Declares the names that every scene has (expression::sceneNames) and the cameras `camera` and `eye`.
    /// They have no values until they are set.
    Environment();

    /// Before a frame is interpreted: no name is declared besides those that every scene has, and none has a
    /// value. The slots stay.
    void beginFrame();

    // ---- The names of the scene.

    /// Some statement of the scene declares this name, though it may not have run yet.
    void expect(std::string_view name);
    /// Declares a name, or returns the slot that it has; nothing if it is declared with another type. An
    /// array may get another length, whose elements have no values yet.
    std::optional<Slot> declare(std::string_view path, const expression::Symbol& symbol);
    /// The same for a variable: inside Once and Step it is a copy that ends with the block.
    std::optional<Slot> declareVariable(std::string_view path, const expression::Symbol& symbol);
    /// Declares the fields of a camera: NAME.view and so on, and NAME.prev.view.
    void declareCamera(std::string_view name, std::size_t count = 0);
    /// Declares the name of a texture with its field NAME.size, a vector of `components`.
    std::optional<Slot> declareTexture(std::string_view name, std::size_t components);
    /// Declares the name of a buffer with its field NAME.count. With the type of its elements the buffer is
    /// an array, whose elements have no values while a scene is interpreted. False if the name is declared
    /// with another type.
    bool declareBuffer(std::string_view name, const std::optional<expression::Type>& element);
    /// Declares the name of a mesh with its fields NAME.vertices and NAME.primitives, which are numbers.
    bool declareMesh(std::string_view name);
    /// Declares a function of expressions. One that is declared again goes on to be the same.
    void declareFunction(const std::shared_ptr<const expression::Function>& function);
    /// True for an array of the elements of a buffer.
    static bool isBuffer(const expression::Symbol& symbol);

    /// Once or Step begins: what declareVariable() declares from here on ends with endBlock().
    void beginBlock();
    /// A variable that only the block has had is known after it, but has no value: `why`.
    void endBlock(const std::string& why);
    /// True if the block that is open has set the variable.
    [[nodiscard]] bool isOfBlock(std::string_view name) const;

    // ---- The names of scopes.

    /// The names of the scopes around a statement.
    struct Point {
        std::uint32_t node = 0;   ///< the innermost name
        std::size_t callers = 0;  ///< groups that are being drawn
        friend bool operator==(const Point&, const Point&) = default;
    };
    [[nodiscard]] Point here() const { return {node_, callers_.size()}; }
    /// Goes back to a point of the same statement or of one around it.
    void goTo(Point point);
    /// Enters a group that was declared at `declared`. Names of the Draw are out of sight from here on, but
    /// for those of rule 3. `owner` tells groups apart.
    void enterGroup(Point declared, const void* owner);
    /// Makes a name mean something else from here on. Its fields are out of sight. It has no value and is no
    /// object.
    Slot bind(std::string_view name, const expression::Symbol& symbol);
    /// Makes a name that a scope hides mean the scene's, or another one, from here on.
    void bind(std::string_view name, Slot slot);
    /// Makes a name of a scope stand for a texture or buffer.
    void setObject(Slot slot, const ObjectView& object) { variables_.at(slot).object = object; }
    [[nodiscard]] const std::optional<ObjectView>& objectOf(Slot slot) const {
        return variables_.at(slot).object;
    }
    /// Makes a name stand for a camera of the scene from here on, with all its fields.
    void bindCamera(std::string_view name, const CameraName& camera);
    /// The camera that a name of a scope stands for.
    [[nodiscard]] const std::optional<CameraName>& cameraOf(Slot slot) const {
        return variables_.at(slot).camera;
    }
    /// The slot of a name that a scope gives a meaning, by rules 1 and 3; nothing if the scene does.
    [[nodiscard]] std::optional<Slot> findLocal(std::string_view name) const;
    /// The same by rule 1 alone.
    [[nodiscard]] std::optional<Slot> findOwn(std::string_view name) const;

    // ---- All names.

    [[nodiscard]] std::optional<expression::Symbol> find(std::string_view path) const override;
    [[nodiscard]] std::optional<expression::Symbol> findInScene(std::string_view path) const override;
    [[nodiscard]] std::shared_ptr<const expression::Function> findFunction(
        std::string_view name) const override;
    [[nodiscard]] std::vector<std::string> knownFunctions() const override;
    /// How many functions are declared.
    [[nodiscard]] std::size_t functionCount() const { return functions_.size(); }
    /// The same as find() without a copy; null if there is no such name. Valid until the next declaration.
    [[nodiscard]] const expression::Symbol* lookUp(std::string_view path) const;
    /// The same for a name of the scene or of the block that is open, which a scope may hide.
    [[nodiscard]] const expression::Symbol* lookUpInScene(std::string_view path) const;
    [[nodiscard]] std::vector<std::string> known(std::string_view path) const override;

    /// Equal numbers mean that all names have the same slots, inside one group at one Draw.
    [[nodiscard]] std::uint64_t shape() const { return std::uint64_t{declared_} << 32U | node_; }
    /// True if the Draw of this group may give the name a meaning, by rule 3.
    [[nodiscard]] bool asksCallers(std::string_view path) const;

    // ---- Values.

    void set(Slot slot, std::span<const double> components, std::size_t element = 0);
    void setNumber(Slot slot, double number) { set(slot, {&number, 1}); }
    void set(std::string_view path, std::span<const double> components, std::size_t element = 0);
    void setNumber(std::string_view path, double number) { set(path, {&number, 1}); }
    void setCamera(std::string_view name, const CameraValues& values, std::size_t element = 0);
    /// Forgets one value. The error of an expression that reads the name says `why`.
    void forget(std::string_view path, std::string why);
    [[nodiscard]] const double* find(std::uint32_t slot, std::size_t element) const override;
    [[nodiscard]] std::string whyMissing(std::uint32_t slot, std::size_t element) const override;
    /// The components of all elements that have a value, in order.
    [[nodiscard]] std::vector<double> valuesOf(Slot slot) const;

    /// What the value of a name can change with, in this frame.
    [[nodiscard]] expression::Depends dependsOf(Slot slot) const {
        return variables_.at(slot).symbol.depends | variables_.at(slot).depends;
    }
    void addDepends(Slot slot, expression::Depends depends) {
        variables_.at(slot).depends = variables_.at(slot).depends | depends;
    }
    void setDepends(Slot slot, expression::Depends depends) { variables_.at(slot).depends = depends; }

  private:
    struct Variable {
        expression::Symbol symbol;
        expression::Depends depends = expression::Depends::nothing;  ///< besides those of the symbol
        std::vector<double> components;  ///< of all elements; a missing value is empty
        std::vector<bool> has;           ///< one per element
        std::string why;                 ///< there is no value, if that is known
        std::optional<ObjectView> object;
        std::optional<CameraName> camera;
    };
    /// A name of the scene, with the slots that it has had so far.
    struct Entry {
        std::vector<Slot> slots;
        std::optional<Slot> slot;  ///< nothing: it is not declared
    };
    using Table = std::map<std::string, Entry, std::less<>>;
    /// A name of a scope; or the border of a group, which has no name.
    struct Node {
        std::uint32_t parent = 0;
        std::string name;
        Slot slot = 0;
    };

    Slot add(const expression::Symbol& symbol);
    std::optional<Slot> declareIn(Table& table, std::string_view path, const expression::Symbol& symbol);
    void resize(Slot slot, std::uint32_t count);
    static void clear(Variable& variable);
    /// Another name is declared, or in another way.
    void noteDeclared(std::uint64_t what, std::uint64_t how);
    [[nodiscard]] static const Slot* slotIn(const Table& table, std::string_view path);
    [[nodiscard]] const Slot* sceneSlot(std::string_view path) const;
    /// By rule 1, from that node out. `isHidden`: a scope gives the head of the path another meaning.
    [[nodiscard]] const Slot* slotFrom(std::uint32_t node, std::string_view path, bool& isHidden) const;
    [[nodiscard]] const Slot* slotOf(std::string_view path) const;
    /// By rule 3.
    [[nodiscard]] const Slot* slotOfCallers(std::string_view path) const;
    [[nodiscard]] bool isActive(std::uint32_t node) const;
    std::uint32_t addNode(Node node);

    std::vector<Variable> variables_;
    std::size_t permanent_ = 0;  ///< variables of names that every scene has, which come first
    Table scene_, block_;
    bool isInBlock_ = false;
    std::set<std::string, std::less<>> expected_;
    std::map<std::string, std::shared_ptr<const expression::Function>, std::less<>> functions_;
    std::vector<Node> nodes_{Node{}};  ///< the first one has no name
    std::map<std::pair<std::uint32_t, std::string>, std::vector<std::uint32_t>> children_;
    std::map<std::pair<std::uint32_t, const void*>, std::uint32_t> borders_;
    std::uint32_t node_ = 0;
    std::vector<std::uint32_t> callers_;  ///< the nodes of the Draws that are running, the innermost last
    /// A number for each order of declarations.
    std::uint32_t declared_ = 0;
    std::map<std::tuple<std::uint32_t, std::uint64_t, std::uint64_t>, std::uint32_t> afterDeclaring_;
    std::map<std::string, std::uint64_t, std::less<>> expectedNumbers_;
};

/// The names of an environment, with a note of each that is looked up.
class NotedNames final : public expression::Names {
  public:
    explicit NotedNames(const Environment& names) : names_(names) {}
    [[nodiscard]] std::optional<expression::Symbol> find(std::string_view path) const override;
    [[nodiscard]] std::optional<expression::Symbol> findInScene(std::string_view path) const override;
    [[nodiscard]] std::shared_ptr<const expression::Function> findFunction(
        std::string_view name) const override;
    [[nodiscard]] std::vector<std::string> knownFunctions() const override { return names_.knownFunctions(); }
    [[nodiscard]] std::vector<std::string> known(std::string_view path) const override {
        return names_.known(path);
    }
    /// A name, and what it was. Without a meaning the count is none.
    struct Note {
        enum class Kind : std::uint8_t { name, nameOfScene, function };
        std::string path;
        Environment::Slot slot = 0;
        std::optional<std::uint32_t> count;
        Kind kind = Kind::name;
        std::shared_ptr<const expression::Function> function{};
    };
    [[nodiscard]] std::vector<Note> take() const { return std::move(notes_); }

  private:
    void note(std::string_view path, const std::optional<expression::Symbol>& symbol, Note::Kind kind) const;

    const Environment& names_;
    mutable std::vector<Note> notes_;
};

/// What was made from names, once for each meaning that they have.
template <class T>
class MadeOfNames {
  public:
    /// What was made of the names as they are now; null if nothing was.
    T* find(const Environment& names) {
        for (Made& each : all_) {
            const bool isSure = each.shape == names.shape() && !each.asksCallers;
            if (!isSure && !isSame(each, names)) continue;
            if (!isSure) note(each, names);
            return &each.value;
        }
        return nullptr;
    }
    T& add(const Environment& names, std::vector<NotedNames::Note> notes, T value) {
        Made& made = all_.emplace_back(Made{std::move(value), std::move(notes)});
        note(made, names);
        return made.value;
    }

  private:
    struct Made {
        T value;
        std::vector<NotedNames::Note> notes;
        std::uint64_t shape = 0;   ///< at which the names have had these meanings
        bool asksCallers = false;  ///< another Draw may give them others
    };
    static void note(Made& made, const Environment& names) {
        made.shape = names.shape();
        made.asksCallers = std::ranges::any_of(made.notes, [&](const auto& each) {
            return each.kind == NotedNames::Note::Kind::name && names.asksCallers(each.path);
        });
    }
    static bool isSame(const Made& made, const Environment& names) {
        using Kind = NotedNames::Note::Kind;
        for (const NotedNames::Note& each : made.notes) {
            if (each.kind == Kind::function) {
                if (names.findFunction(each.path) != each.function) return false;
                continue;
            }
            const expression::Symbol* now =
                each.kind == Kind::name ? names.lookUp(each.path) : names.lookUpInScene(each.path);
            if (now == nullptr ? each.count.has_value()
                               : !(each.count == now->count && each.slot == now->slot))
                return false;
        }
        return true;
    }
    std::vector<Made> all_;
};

}  // namespace glibra::scene
