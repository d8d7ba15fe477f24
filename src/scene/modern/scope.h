#pragma once
// Private to this room: what is local to Group, Pass, Once and Step.

#include <cstddef>
#include <utility>

#include "scene/modern/environment.h"
#include "scene/state.h"

namespace glibra::scene {

/// Gives back at its end what is local to a scope.
class Scope {
  public:
    explicit Scope(Interpreter& in) : in_(in), state_(in.state), names_(in.shared->environment.here()) {
        in.state.stack.clear();
    }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() {
        static_cast<ScopedState&>(in_.state) = std::move(state_);
        in_.shared->environment.goTo(names_);
    }

  private:
    Interpreter& in_;
    ScopedState state_;
    Environment::Point names_;
};

/// Gives back at its end the names of the scopes, and nothing else.
class InnerNames {
  public:
    explicit InnerNames(Interpreter& in) : names_(in.shared->environment), before_(names_.here()) {}
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
    /// The file around it.
    [[nodiscard]] const RunningFile& before() const { return before_; }

  private:
    Interpreter& in_;
    RunningFile before_;
};

/// Sets the state at the beginning of a pass.
void resetRaster(Interpreter&);

/// Remembers that the statement decides this part of the raster state of the draws after it.
void noteRasterStatement(Interpreter&, const glib::Command& command, RasterPart part);
/// Remembers that the Pass or Fill does not take over what these statements before it have set.
void noteFreshRaster(Interpreter&, const glib::Command& command);
/// Reports glib-W39 for each of these statements that stands before a Pass or Fill and decides no draw.
void reportUnusedRaster(Interpreter&);

/// Statements that one frame may execute; those of repetitions and groups count each time.
inline constexpr std::size_t kMostStatements = 1'000'000;
/// Elements that expressions of `i` may give lists and arrays of one frame. Those of buffers do not count:
/// their memory is limited.
inline constexpr std::size_t kMostElements = 10'000'000;

/// The statement Repeat.
void doRepeat(Interpreter&, const glib::Command& command);

/// Runs the statements between two commands of the current script. Reports glib-W31.
void runBody(Interpreter&, std::size_t first, std::size_t last);

/// The index of a command of the current script.
std::size_t indexOf(const Interpreter&, const glib::Command&);

}  // namespace glibra::scene
