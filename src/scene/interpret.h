#pragma once

#include <glibra/render.h>
#include <glibra/result.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "expression/names.h"
#include "glib/script.h"
#include "scene/scene.h"

namespace glibra::scene {

/// The content of a file that the calling program has in memory, or null. May be empty.
using MemoryFiles = std::function<std::shared_ptr<const std::string>(const std::filesystem::path& path)>;

/// Both together: what `reader` has, else what `texts` has. `reader` may be null.
MemoryFiles memoryFiles(const std::map<std::filesystem::path, std::string>& texts,
                        const std::shared_ptr<const FileReader>& reader);

/// Folders that are searched after the scene's own (language, 8.6): normally those in GLIBRA_PATH.
struct InterpretOptions {
    std::vector<std::filesystem::path> libraryRoots;
    /// If it is not empty, only files below this folder and below the library folders are found.
    std::filesystem::path within{};
    MemoryFiles inMemory{};  ///< these files need not exist, and may lie outside of `within`
};

/// What a frame is a function of, besides the script and its files.
struct FrameInputs {
    double time = 0;                  ///< seconds since loading
    int width = 0, height = 0;        ///< pixels of the window; 0: as the scene states
    double mouseX = .5, mouseY = .5;  ///< 0..1 from the lower left corner of the window
    bool isMouseDown = false;
    /// Values of variables in place of those that the scene gives them, by name. A value with another number
    /// of components is ignored.
    std::map<std::string, std::vector<double>, std::less<>> variables{};
    std::map<std::string, std::string, std::less<>> words{};  ///< the same for choices
    /// The number of the step that each Step block is evaluated for, in the order of the text; 0 for those
    /// beyond the end. `time` inside such a block is tick / rate. Variables that are computed outside of it
    /// have the values of `time` above, which should therefore be tick / rate, too.
    std::vector<std::int64_t> ticks{};
    /// The step since which each Step block runs, because its values after `reset` have changed; 0 for those
    /// beyond the end. `tick` counts from it.
    std::vector<std::int64_t> firstTicks{};
    /// Seconds since the step before, for `camera.prev` in a Step block; 0: those since the frame before.
    double sinceStepBefore = 0;
    friend bool operator==(const FrameInputs&, const FrameInputs&) = default;
};

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

    [[nodiscard]] const glib::Script& script() const;
    /// The cameras that the last scene declares, sorted by name.
    [[nodiscard]] const std::vector<NamedCamera>& cameras() const;
    /// The script and the included ones that have been read.
    [[nodiscard]] std::vector<const glib::Script*> scripts() const;
    /// What the last scene depends on besides its variables. With nothing of time, window and mouse every
    /// call of at() gives the same scene.
    [[nodiscard]] expression::Depends depends() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The scene of a script at time 0.
Scene interpret(const glib::Script& script, const InterpretOptions& options = {});

}  // namespace glibra::scene
