#pragma once
// The example scenes that ship with glibra, the chapters that they are about, and the small pictures of
// scenes.

#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "gpu/context/context.h"
#include "system/child_process.h"

namespace glibra::view {

// Lists a folder for a file dialog.

struct FolderEntry {
    std::string name;
    bool isFolder = false;
};

struct FolderList {
    std::filesystem::path folder;      ///< absolute
    std::vector<FolderEntry> entries;  ///< folders first; sorted by name, ignoring case
    std::string problem;  ///< a sentence that says why the folder cannot be read; empty on success
};

/// The folders in `folder` and the files with one of these extensions (".png .bmp"), or all files if there
/// are none, without hidden ones. Links are followed.
FolderList listFolder(const std::filesystem::path& folder, std::string_view endings);

struct ExampleScene {
    std::filesystem::path file;
    std::string topic;    ///< its folder in `glib`
    std::string name;     ///< file name without extension
    std::string summary;  ///< its first comment line, without exercise numbers
    std::string source;   ///< the book and the chapter that it is about: "Graphics Shaders, chapter 4"
};

/// All scenes in ROOT/glib and its folders, sorted by topic and name, with the topic "start" first. Their
/// sources are those that the table in ROOT/glib/README.md states.
std::vector<ExampleScene> exampleScenes(const std::filesystem::path& root);

/// All chapters of the scenes, in their order.
std::vector<std::string> chaptersOf(std::span<const ExampleScene> scenes);

/// True if the scene is about that chapter; an empty one stands for all.
bool isOfChapter(const ExampleScene& scene, const std::string& chapter);

// Small pictures of scenes, cached between runs. A picture is valid as long as the scene and all files that
// it was made from have the same content.

inline constexpr int kThumbnailWidth = 320;
inline constexpr int kThumbnailHeight = 240;

/// The cache folder: $XDG_CACHE_HOME/glibra/thumbnails, by default ~/.cache/glibra/thumbnails. Empty if HOME
/// is not set.
std::filesystem::path thumbnailFolder();

/// The state of a scene's picture.
struct Thumbnail {
    enum class State {
        missing,  ///< not made yet, or out of date
        ready,
        failed  ///< the scene has an error; there is no picture until one of its files changes
    };
    State state = State::missing;
    std::filesystem::path picture;  ///< PNG, if ready
    std::string problem;            ///< why it failed
};

/// Looks up the cache. A file is only read if its time has changed while its size has not.
Thumbnail findThumbnail(const std::filesystem::path& folder, const std::filesystem::path& scene);

/// Draws the scene without a window and caches its picture or its failure.
Thumbnail makeThumbnail(gpu::Context& context, const std::filesystem::path& folder,
                        const std::filesystem::path& scene,
                        const std::vector<std::filesystem::path>& libraryRoots);

// Makes the pictures of scenes while the window stays usable: it runs this program again, as a process
// without a window. If drawing a scene crashes or does not end, only that picture is missing.

class ThumbnailMaker {
  public:
    /// `wake` is called on another thread whenever takeFinished() has something new.
    ThumbnailMaker(std::filesystem::path folder, std::vector<std::filesystem::path> scenes,
                   std::function<void()> wake);
    ThumbnailMaker(const ThumbnailMaker&) = delete;
    ThumbnailMaker& operator=(const ThumbnailMaker&) = delete;
    /// Kills the process.
    ~ThumbnailMaker();

    /// The scenes that were finished since the last call. The cache has a picture or a failure for each.
    std::vector<std::filesystem::path> takeFinished();
    [[nodiscard]] bool hasFinished();

  private:
    void run();
    /// Makes the pictures of `scenes_` from index `first` until the process ends. Returns the index of the
    /// first scene that was not finished, and the reason in `why`.
    std::size_t runProcess(std::size_t first, const char*& why);
    void finish(std::size_t scene);

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> scenes_;
    std::function<void()> wake_;
    system::Waker stop_;
    std::mutex mutex_;
    std::vector<std::size_t> finished_;  ///< indices of scenes
    std::thread thread_;
};

/// The work of the process: makes the pictures of these scenes in order, and prints an empty line after each.
/// Returns the exit status.
int makeThumbnails(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& scenes,
                   const std::vector<std::filesystem::path>& libraryRoots);

}  // namespace glibra::view
