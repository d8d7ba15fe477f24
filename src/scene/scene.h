#pragma once
// An interpreted Script: everything that a frame needs, as values. There is no GL, no pixel and no mesh data
// here. File names are resolved, but a file is read only when something visible needs it.

#include <glibra/diagnostic.h>
#include <glm/mat4x4.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "expression/known_names.h"
#include "scene/nodes.h"
#include "scene/objects.h"

namespace glibra::scene {

/// What a key of the keyboard does in a window.
struct KeyBinding {
    std::string key;                          ///< as written: "k", "space"
    std::string variable;                     ///< that it sets; empty if it restarts
    std::vector<std::vector<double>> values;  ///< one after another, with each press; one value: that one
    bool isHeld = false;    ///< moves the variable while it is down: by value - current in a second
    bool restarts = false;  ///< time and steps begin at 0
    Place place;
};

/// A variable of a Let statement that the window and --set can change.
struct Variable {
    std::string name;
    glib::UniformForm form = glib::UniformForm::number;
    /// Least, current and largest of a range, with one current value per component; otherwise the components.
    std::vector<double> written;
    std::vector<double> current;     ///< the components that the frame has
    std::vector<std::string> words;  ///< of a choice, which is a range that counts them from 0
    Place place;                     ///< of the value
    /// What Bound says of a range: its end with the finest picture is not always its largest number.
    struct Fineness {
        double coarsest = 0, finest = 0;  ///< above 0 and different
        bool isWhole = false;             ///< all its values are whole numbers
    };
    std::optional<Fineness> bound{};

    /// The components that the script states.
    [[nodiscard]] std::span<const double> statedValues() const {
        const std::span<const double> all(written);
        return form == glib::UniformForm::range ? all.subspan(1, all.size() - 2) : all;
    }
    /// The limits of a range, which are the same for all components.
    [[nodiscard]] double least() const { return written.front(); }
    [[nodiscard]] double largest() const { return written.back(); }
};

/// A statement that needs a file and names none. A window asks its user for the file.
struct MissingFile {
    std::string word;  ///< the command
    Place place;
    bool isModel = false;  ///< otherwise a texture
};

struct Scene : Declarations {
    std::string path;
    int width = 600, height = 600;
    NodeList frame;                ///< the last content of the window is the picture
    std::vector<OnceBlock> once;   ///< before the frame; what they write lasts
    std::vector<StepBlock> steps;  ///< between Once and the frame; what they write lasts
    std::map<std::string, FileReference, std::less<>> glslTexts;  ///< of Glsl statements, by name
    std::vector<Check> checks;
    std::vector<Print> prints;
    std::vector<IdleCheck> idleChecks;
    std::vector<KeyBinding> keys;
    std::vector<std::string> messages;      ///< of the MessageBox statements that ran
    std::vector<MissingFile> missingFiles;  ///< of this file, not of included ones
    /// The values of variables at the end of the script: uniforms of the same name that nothing else sets
    /// read them.
    std::vector<glib::UniformSpec> namedValues;
    std::map<std::string, Place, std::less<>> setNames;  ///< tags of Set, and where each stands first
    bool usesLookAt = false;
    glm::dmat4 view{1.0};  ///< viewing matrix of the last LookAt
    std::vector<Variable> variables;
    std::vector<std::shared_ptr<const expression::Function>> functions;  ///< of expressions
    /// The names of FrameInputs::variables that exist, each with the number of its components.
    std::map<std::string, std::size_t, std::less<>> usedVariables;
    /// Uniforms, vertex inputs and samplers that the scene does not set are found by their names (language,
    /// 12), and blocks find buffers and lights.
    bool suppliesNames = false;
    /// A frame begins with what the one before has written into textures; otherwise with what is declared.
    bool goesOn = false;
    bool reversesWindow = false;  ///< a pass into the window, which need not have run, is reversed
    bool hasStages = false;       ///< a Vertex or Fragment statement has a shader
    bool setsLights = false;      ///< Light, Material, or Set of a name that begins with gl_
    std::set<std::string, std::less<>> localNames;  ///< the counters of Repeat and the parameters of groups
    std::set<std::string, std::less<>> otherNames;  ///< of groups, cameras, samplers and meshes
    /// What statements that do not run in this frame write in others: other values of variables decide.
    std::set<TextureIndex> mayBeWritten;
    bool verbose = false;  ///< Verbose: the diagnostics contain a glib-N02 for each executed operation
    std::set<std::string> hiddenFiles;  ///< included files that are not shown (shownRoots)
    Diagnostics diagnostics;
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

}  // namespace glibra::scene
