#pragma once
// The settings that the window keeps between runs, as JSON in the user's configuration folder.

#include <glibra/render.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace glibra::view {

/// What becomes of the room beside the panels if its shape is not that of the scene's window.
enum class PictureShape {
    scene,  ///< the picture keeps the scene's shape, with margins
    fill    ///< the picture fills the room; the scene fits in, by the smaller side
};

/// Which values are labelled on the picture.
enum class LabelChoice { all, changed, chosen };

/// Where the source stands.
enum class SourcePlace {
    automatic,  ///< beside the picture if there is room for both, otherwise below it
    beside,
    below,
    over  ///< over the left part of the picture, which stays visible behind it
};

/// Sizes are screen coordinates at the current scale; the file has them at scale 1, so that they are right on
/// a screen of another density.
struct Settings {
    int windowWidth = 0, windowHeight = 0;  ///< 0: from the scene's size
    float panelWidth = 0;                   ///< 0: the default
    SourcePlace sourcePlace = SourcePlace::automatic;
    /// The source's part of the room: of its width beside or over the picture, of its height below it.
    float sourceBeside = .5F, sourceBelow = .45F, sourceOver = .5F;
    bool showSource = false;
    bool compilesWhileTyping = false;
    bool wrapsLines = false;  ///< of the source
    std::string layout;       ///< positions of the floating windows, in ImGui's format
    float layoutScale = 1;    ///< the scale of `layout`
    bool lightTheme = false;
    LabelCorner labelCorner = LabelCorner::bottomLeft;
    LabelChoice labelChoice = LabelChoice::all;
    std::string hardcopyFolder;  ///< empty: the current folder
    float zoom = 1;              ///< of texts and widgets, in addition to the screen's scale
    int samples = 4;             ///< per pixel on the screen
    PictureShape pictureShape = PictureShape::scene;
    std::map<std::string, bool, std::less<>> folds;  ///< sections that are not as at first: true if open
    std::vector<std::string> tabs;                   ///< the scenes of the open tabs
    int shownTab = 0;                                ///< index into `tabs`
    std::vector<std::string> recent;                 ///< scene files, most recently opened first

    void addRecent(const std::filesystem::path& scene);
    /// Multiplies the sizes of windows and panels.
    void scaleSizes(float by);
};

inline constexpr float kLeastSource = .15F, kMostSource = .85F;  ///< parts of the room
inline constexpr float kLeastZoom = .5F, kMostZoom = 4;
inline constexpr int kMostSamples = 32;

/// $XDG_CONFIG_HOME/glibra/view.json, by default ~/.config/glibra/view.json. Empty if HOME is not set.
std::filesystem::path settingsFile();
/// Missing or damaged settings get their defaults.
Settings readSettings(const std::filesystem::path& file);
/// Errors are ignored: the settings are lost then.
void writeSettings(const Settings& settings, const std::filesystem::path& file);

}  // namespace glibra::view
