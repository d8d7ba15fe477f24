#include "skip_runs.h"

#include <gtest/gtest.h>
#if __has_include(<sys/inotify.h>)
#include <sys/inotify.h>
#include <unistd.h>
#endif

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "../support/new_folder.h"
#include "gpu/context/context.h"
#include "render/scene_renderer.h"
#include "scene_text.h"

namespace glibra::test {
namespace {

#if __has_include(<sys/inotify.h>)
/// Records which files of a folder are opened while it exists (inotify).
class OpenedFiles {
  public:
    explicit OpenedFiles(const std::filesystem::path& folder) : queue_(::inotify_init1(IN_NONBLOCK)) {
        if (::inotify_add_watch(queue_, folder.c_str(), IN_OPEN) < 0) throw std::runtime_error("inotify");
    }
    OpenedFiles(const OpenedFiles&) = delete;
    OpenedFiles& operator=(const OpenedFiles&) = delete;
    ~OpenedFiles() { ::close(queue_); }

    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> names;
        alignas(inotify_event) std::array<char, 4096> buffer{};
        for (ssize_t size = 0; (size = ::read(queue_, buffer.data(), buffer.size())) > 0;)
            for (ssize_t at = 0; at < size;) {
                const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
                if (event->len > 0) names.insert(event->name);
                at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
            }
        return names;
    }

  private:
    int queue_;
};
#else
/// Nobody tells which files are opened: the tests that ask are left out (tests/windows.txt).
class OpenedFiles {
  public:
    explicit OpenedFiles(const std::filesystem::path&) {}
    [[nodiscard]] static std::set<std::string> names() { return {}; }
};
#endif

}  // namespace

SceneFolder::SceneFolder(const std::string& scene, const std::map<std::string, std::string>& files) {
    path_ = newFolder("skip");
    write("scene.glib", scene);
    for (const auto& [file, content] : files) write(file, content);
}

SceneFolder::~SceneFolder() {
    std::filesystem::remove_all(path_);
}

void SceneFolder::write(const std::string& file, const std::string& content) const {
    std::ofstream(path_ / file, std::ios::binary) << content;
}

std::uint64_t Drawing::count(const std::string& name) const {
    for (const render::Stats::Count& each : stats.counts)
        if (each.name == name) return each.value;
    return 0;
}

std::vector<std::string> Drawing::skipped(const std::string& what) const {
    std::vector<std::string> found;
    for (const plan::Skipped& each : stats.skipped)
        if (each.what == what) found.push_back(each.why);
    return found;
}

gpu::Context& sharedContext() {
    static const std::unique_ptr<gpu::Context> shared = [] {
        Result<gpu::Context> opened = gpu::openContext();
        if (!opened) throw std::runtime_error(text(opened.diagnostics));
        return std::make_unique<gpu::Context>(std::move(*opened));
    }();
    // Other tests of this program open their own contexts.
    shared->makeCurrent();
    return *shared;
}

Drawing draw(const SceneFolder& folder, const RenderOptions& options, render::SharedParts* shared,
             const std::vector<double>& times) {
    gpu::Context& context = sharedContext();
    Drawing run;
    const OpenedFiles opened(folder / "");
    const gpu::CallCounter counter;
    {
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::load(context, folder / "scene.glib", options, run.stats, shared);
        append(run.diagnostics, std::move(loaded.diagnostics));
        for (const double time : times) {
            if (!loaded) break;
            Result<image::Image> picture = loaded->draw(time, run.stats);
            append(run.diagnostics, std::move(picture.diagnostics));
            if (picture) run.pixels.insert(run.pixels.end(), picture->data.begin(), picture->data.end());
        }
    }
    EXPECT_FALSE(run.pixels.empty()) << text(run.diagnostics);
    run.calls = counter.counts();
    run.opened = opened.names();
    return run;
}

BothWays drawBothWays(const SceneFolder& folder, RenderOptions options) {
    BothWays pair;
    pair.skipping = draw(folder, options);
    options.skip = false;
    pair.whole = draw(folder, options);
    EXPECT_TRUE(pair.skipping.pixels == pair.whole.pixels);
    EXPECT_TRUE(pair.whole.skipped("draw").empty());
    return pair;
}

}  // namespace glibra::test
