#pragma once

#include <memory>
#include <string>
#include <vector>

#include "expression/known_names.h"
#include "glib/script.h"
#include "scene/file_lookup.h"
#include "scene/scene.h"

namespace glibra::scene {

/// A camera as a window can look through it.
struct NamedCamera {
    std::string name;  ///< "eye", "slice[2]"
    glm::dmat4 view{1.0};
    Projection projection;
    bool isMirrored = false;  ///< it turns the winding of triangles
};

/// A script with what its frames share: looked-up files, included scripts, and expressions, which are read
/// once.
class Interpretation {
  public:
    Interpretation(glib::Script script, InterpretOptions options);
    Interpretation(Interpretation&&) noexcept;
    Interpretation& operator=(Interpretation&&) noexcept;
    ~Interpretation();

    /// Runs the script once (language, 2) and records every draw with its complete state. Files are looked up
    /// but not read, except for included ones and the first bytes of texture files, which show their
    /// dimension.
    ///
    /// The `diagnostics` of the result are in the order of the text. They contain neither those of the script
    /// nor those of files, which stay in the FileReference. A statement with an error is skipped and the
    /// others are executed. Does not throw. Textures, programs and files have the same indices in all scenes
    /// of one script, as far as the same statements are executed; shapes have not.
    Scene at(const FrameInputs& inputs);

    /// Unknown names and wrong types, also in what `When`, `Repeat` and groups leave out with these inputs.
    /// The condition of a When decides where it reads a parameter or a counter.
    [[nodiscard]] Diagnostics mistakesLeftOut(const FrameInputs& inputs) const;

    [[nodiscard]] const glib::Script& script() const;
    /// The cameras that the last scene declares, sorted by name.
    [[nodiscard]] const std::vector<NamedCamera>& cameras() const;
    /// The script and the included ones that have been read.
    [[nodiscard]] std::vector<const glib::Script*> scripts() const;
    /// What the last scene depends on besides its variables. With nothing of time, window and mouse every
    /// call of at() gives the same scene.
    [[nodiscard]] expression::Depends depends() const;
    /// True if at() gives the same scene for all inputs, variables too.
    [[nodiscard]] bool isFixed() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The scene of a script at time 0.
Scene interpret(const glib::Script& script, const InterpretOptions& options = {});

}  // namespace glibra::scene
