#pragma once
// The scenes that are open, each with values, view, time and undo of its own. One of them is shown; the
// others stand still.

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "view/scene/file_watch.h"
#include "view/scene/session.h"
#include "view/window/ui.h"

namespace glibra::view {

struct Tab {
    Tab(gpu::Context& context, const RenderOptions& options, Shared& shared, int number)
        : session(context, options), ui(context, session, shared), id(number) {}

    Session session;
    Ui ui;
    int id = 0;
    bool isOutdated = false;  ///< files have changed while it was not shown
};

class Tabs {
  public:
    /// One tab without a scene. What is passed must outlive it.
    Tabs(gpu::Context& context, RenderOptions options, Shared& shared, float scale);

    Tab& shown() { return *tabs_[shown_]; }
    Tab& at(std::size_t tab) { return *tabs_[tab]; }
    [[nodiscard]] std::size_t count() const { return tabs_.size(); }
    [[nodiscard]] std::size_t number() const { return shown_; }

    /// Number of the tab that has the scene; count() if none has.
    [[nodiscard]] std::size_t find(const std::filesystem::path& scene) const;
    /// Makes an empty tab and shows it.
    void add();
    void show(std::size_t tab);
    /// The last one is emptied instead.
    void close(std::size_t tab);

    /// Files with text that is not saved, which only this tab shows.
    [[nodiscard]] std::vector<std::filesystem::path> unsaved(std::size_t tab) const;
    /// The same of all tabs.
    [[nodiscard]] std::vector<std::filesystem::path> unsaved() const;

    /// All files of all scenes.
    void watch(FileWatch& watch) const;
    /// These files were saved: the tabs that are not shown will be read again when they are. True if the
    /// shown one has to be now.
    bool noteChanged(const std::vector<std::filesystem::path>& files);
    /// For the bar.
    void writeTitles();

  private:
    [[nodiscard]] bool uses(const Tab& tab, const std::filesystem::path& file) const;

    gpu::Context& context_;
    RenderOptions options_;
    Shared& shared_;
    float scale_;
    int nextId_ = 0;
    std::vector<std::unique_ptr<Tab>> tabs_;
    std::size_t shown_ = 0;
};

}  // namespace glibra::view
