#pragma once
// Private to this room: what is local to Group, Pass, Once and Step.

#include <cstddef>
#include <vector>

#include "scene/state.h"

namespace glibra::scene {

/// Gives back at its end what is local to a scope.
class Scope {
  public:
    explicit Scope(Interpreter& in);
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope();

  private:
    Interpreter& in_;
    glm::dmat4 modelView_, model_;
    ProgramIndex program_;
    std::vector<ScopedTag> set_;
    std::vector<SavedMatrix> stack_;
    LocalState local_;
    RasterState raster_;
};

/// Sets the state at the beginning of a pass. What classic commands set stays.
void resetRaster(Interpreter&);

/// Remembers that the statement State, Viewport or Scissor decides the raster state of the draws after it.
void noteRasterStatement(Interpreter&, const glib::Command& command);
/// Remembers that the Pass or Fill does not take over what these statements before it have set.
void noteFreshRaster(Interpreter&, const glib::Command& command);
/// Reports glib-W39 for each of these statements that stands before a Pass or Fill and decides no draw.
void reportUnusedRaster(Interpreter&);

/// Statements that one frame may execute; those of repetitions and groups count each time.
inline constexpr std::size_t kMostStatements = 1'000'000;

/// The statement Repeat.
void doRepeat(Interpreter&, const glib::Command& command);

/// Runs the statements between two commands of the current script. Reports glib-W31.
void runBody(Interpreter&, std::size_t first, std::size_t last);

/// The index of a command of the current script.
std::size_t indexOf(const Interpreter&, const glib::Command&);

}  // namespace glibra::scene
