#pragma once
// The open scenes, each with its own values, view, time and undo. One of them is shown; the others are
// paused.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "view/scene/file_watch.h"
#include "view/session/session.h"
#include "view/session/value_keeper.h"
#include "view/window/panels/ui.h"

namespace glibra::view {

struct Tab {
    Tab(gpu::Context& context, const RenderOptions& options, Shared& shared, const PanelSet& sharedPanels,
        int number)
        : session(context, options),
          ui(context, session, shared),
          panels(makePanels(false)),
          values(shared.keptValues),
          id(number) {
        ui.panels = panelsOf(sharedPanels, panels);
    }

    Session session;
    Ui ui;
    PanelSet panels;     ///< its own ones
    ValueKeeper values;  ///< of the session
    int id = 0;
    bool isOutdated = false;  ///< its files have changed while it was not shown
};

class Tabs {
  public:
    /// Begins with one empty tab. `context` and `shared` must outlive this.
    Tabs(gpu::Context& context, RenderOptions options, Shared& shared);

    Tab& shown() { return *tabs_[shown_]; }
    [[nodiscard]] const Tab& shown() const { return *tabs_[shown_]; }
    Tab& at(std::size_t tab) { return *tabs_[tab]; }
    [[nodiscard]] const Tab& at(std::size_t tab) const { return *tabs_[tab]; }
    [[nodiscard]] std::size_t count() const { return tabs_.size(); }
    [[nodiscard]] std::size_t shownIndex() const { return shown_; }

    /// The index of the tab with that scene; count() if there is none.
    [[nodiscard]] std::size_t find(const std::filesystem::path& scene) const;
    /// Adds an empty tab and shows it.
    void add();
    void show(std::size_t tab);
    /// Moves a tab to another place among them; what is shown stays so.
    void move(std::size_t from, std::size_t to);
    /// Closes a tab; the only tab is replaced by an empty one.
    void close(std::size_t tab);

    /// Destroys all that the tabs have on the device, and makes it again on another one (Session).
    void releaseDevice();
    void restoreDevice();

    /// The files with unsaved text that only this tab shows.
    [[nodiscard]] std::vector<std::filesystem::path> unsaved(std::size_t tab) const;
    /// The files with unsaved text of all tabs.
    [[nodiscard]] std::vector<std::filesystem::path> unsaved() const;

    /// Writes the values of all scenes that have changed; `now`: at once. Returns the seconds until the next
    /// call is due; negative: there is nothing to write.
    double keepValues(bool now);

    /// Watches all files of all scenes, and the copies of texts that are not saved.
    void watch(FileWatch& watch) const;
    /// Marks the tabs that use one of these changed files as outdated.
    void markOutdated(const std::vector<std::filesystem::path>& files);
    /// Updates the titles for the tab bar.
    void updateTitles();

  private:
    [[nodiscard]] bool uses(const Tab& tab, const std::filesystem::path& file) const;

    gpu::Context& context_;
    RenderOptions options_;
    Shared& shared_;
    PanelSet sharedPanels_ = makePanels(true);
    int nextId_ = 0;
    std::vector<std::unique_ptr<Tab>> tabs_;
    std::size_t shown_ = 0;
};

}  // namespace glibra::view
