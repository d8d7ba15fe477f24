#pragma once
// A gallery as a value: the scenes of a folder, with all that its pages show of them, and how they are found
// out.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/scene_head.h"
#include "suite/results/results.h"

namespace glibra::gallery {

/// A value that the scene gives a range, a choice, a switch or a colour.
struct Control {
    enum class Kind { range, choice, truth, color };
    std::string owner;  ///< the program; empty: a variable of the scene
    std::string name;
    Kind kind = Kind::range;
    std::vector<double> numbers;     ///< least, at first, greatest; of others the value, a choice's index
    std::vector<std::string> words;  ///< of a choice
};

/// A text that a scene is made of.
struct SourceText {
    std::string name;  ///< relative to the folder, or to the library
    std::string role;  ///< "scene", "vertex shader", "included"
    std::string text;
};

/// What is found out about a scene without drawing it.
struct Description {
    source::SceneHead head;
    int width = 0, height = 0;  ///< of its window
    std::vector<Control> controls;
    std::vector<SourceText> sources;  ///< the scene first
    std::vector<std::string> keys;    ///< that the scene declares
    bool mayMove = false;             ///< another time may give another picture
    std::string solution;             ///< of an exercise: path from the folder; empty if there is none
};

struct GalleryScene {
    std::string path;  ///< from the folder: "start/teapot.glib"
    std::string name;  ///< of its files on the site: letters, digits, "-_."; unique
    Description description;
    std::vector<std::string> chapters;                 ///< of sources, as the folder's README.md says
    suite::Verdict verdict = suite::Verdict::skipped;  ///< passed: it was drawn
    std::string reason;                                ///< why it was not drawn
    Diagnostics diagnostics;
    std::string picture, film;            ///< files on the site; empty if there is none
    int width = 0, height = 0;            ///< of the picture
    bool isLive = false;                  ///< it runs on its page, or a film of it does
    std::string whyFilm;                  ///< if a film runs there: page::whyNotLive()
    std::optional<std::size_t> solution;  ///< of an exercise: the scene that solves it
    std::vector<std::size_t> tasks;       ///< the exercises that it solves
};

struct Gallery {
    std::string title;
    std::string folder;  ///< as the user named it
    std::vector<GalleryScene> scenes;
    std::string driver;
    bool isEmbedded = false;  ///< live pages are for frames of other pages
};

inline bool isDrawn(const GalleryScene& scene) {
    return scene.verdict == suite::Verdict::passed;
}

/// The folder of a scene: "start"; "." for those in the gallery's folder itself.
std::string folderOf(const GalleryScene& scene);

/// Gives every scene its name, and connects exercises with their solutions.
void connect(Gallery& gallery);

/// "596 scenes: 595 drawn, 1 failed"
std::string summary(const Gallery& gallery);

// What can be found out about a scene without drawing it. It reads files of strangers, so it runs in worker
// processes.

struct DescribeTask {
    std::filesystem::path folder;  ///< of the gallery
    std::filesystem::path scene;   ///< with the folder
    RenderOptions options;         ///< `within` is the folder
};

/// Reads no file outside of the folder and the library. A scene with errors has what could be read of it.
Description describe(const DescribeTask& task);

/// A description as text for the pipe of a worker. parseDescription returns nothing for text that is none.
std::string toText(const Description& description);
std::optional<Description> parseDescription(std::string_view text);

}  // namespace glibra::gallery
