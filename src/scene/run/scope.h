#pragma once
// Private to this room: what is local to Group, Pass, Once and Step.

#include <cstddef>
#include <utility>

#include "scene/run/state.h"

namespace glibra::scene {

/// Gives back at its end what is local to a scope.
class Scope {
  public:
    explicit Scope(Interpreter& in) : in_(in), state_(in.state), names_(in.names().here()) {
        in.state.stack.clear();
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() {
        static_cast<ScopedState&>(in_.state) = std::move(state_);
        in_.names().goTo(names_);
    }

  private:
    Interpreter& in_;
    ScopedState state_;
    Environment::Point names_;
};

/// Gives back at its end the names of the scopes, and nothing else.
class InnerNames {
  public:
    explicit InnerNames(Interpreter& in) : names_(in.names()), before_(names_.here()) {}
    InnerNames(const InnerNames&) = delete;
    InnerNames& operator=(const InnerNames&) = delete;
    ~InnerNames() { names_.goTo(before_); }

  private:
    Environment& names_;
    Environment::Point before_;
};

/// Statements of another file run until its end.
class InFile {
  public:
    InFile(Interpreter& in, RunningFile file)
        : in_(in),
          before_{std::exchange(in.script, file.script),
                  std::exchange(in.around.given, std::move(file.given))} {}
    InFile(const InFile&) = delete;
    InFile& operator=(const InFile&) = delete;
    ~InFile() {
        in_.script = before_.script;
        in_.around.given = std::move(before_.given);
    }

  private:
    Interpreter& in_;
    RunningFile before_;
};

/// Sets the state at the beginning of a pass.
void resetRaster(Interpreter&);

/// Remembers that the statement decides this part of the raster state of the draws after it.
void noteRasterStatement(Interpreter&, const Command& command, RasterPart part);
/// Remembers that the Pass or Fill does not take over what these statements before it have set.
void noteFreshRaster(Interpreter&, const Command& command);
/// Reports glib-W39 for each of these statements that stands before a Pass or Fill and decides no draw.
void reportUnusedRaster(Interpreter&);

// ---- Counts
// Private to this room: how many statements, rounds and elements a frame may have.

/// Statements that one frame may execute; those of repetitions and groups count each time.
inline constexpr std::size_t kMostStatements = 1'000'000;

/// Counts a statement that is about to run. False, with glib-E15, if there are too many.
bool countStatement(Interpreter&, const Command& command);
/// The same for a round of Repeat, whether or not it has statements.
bool countRound(Interpreter&, const Command& command);
/// The same for elements that an expression of `i` gives a list or array.
bool countElements(Interpreter&, const Value& owner, double count);

}  // namespace glibra::scene
