#include "view/window/window.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "system/folder.h"
#include "view/edit/source_files.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// The files of the scene, and those that it lacks, where they would be found.
std::vector<fs::path> allFiles(const render::LiveScene& live) {
    std::vector<fs::path> files = live.files();
    for (fs::path& each : live.missingFiles()) files.push_back(std::move(each));
    return files;
}

}  // namespace

Tabs::Tabs(gpu::Context& context, RenderOptions options, Shared& shared)
    : context_(context), options_(std::move(options)), shared_(shared) {
    add();
}

std::size_t Tabs::find(const fs::path& scene) const {
    const auto found = std::ranges::find_if(tabs_, [&](const std::unique_ptr<Tab>& each) {
        return each->session.hasScene() &&
               system::wholePath(each->session.path()) == system::wholePath(scene);
    });
    return static_cast<std::size_t>(found - tabs_.begin());
}

void Tabs::add() {
    tabs_.push_back(std::make_unique<Tab>(context_, options_, shared_, sharedPanels_, nextId_++));
    tabs_.back()->session.setContained(true);
    show(tabs_.size() - 1);
}

void Tabs::show(std::size_t tab) {
    if (tab >= tabs_.size()) return;
    shown_ = tab;
    shared_.tabChanged = true;
}

void Tabs::move(std::size_t from, std::size_t to) {
    to = std::min(to, tabs_.size() - 1);
    if (from >= tabs_.size() || from == to) return;
    const Tab* shown = tabs_[shown_].get();
    std::unique_ptr<Tab> moved = std::move(tabs_[from]);
    tabs_.erase(tabs_.begin() + static_cast<std::ptrdiff_t>(from));
    tabs_.insert(tabs_.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
    while (tabs_[shown_].get() != shown) shown_ = (shown_ + 1) % tabs_.size();
    shared_.tabChanged = true;
}

void Tabs::close(std::size_t tab) {
    if (tab >= tabs_.size()) return;
    std::vector<fs::path> gone;
    for (const SourceFile& each : tabs_[tab]->ui.files) gone.push_back(each.path);
    if (tabs_.size() == 1) add();
    if (shown_ == tab) show(tab + 1 < tabs_.size() ? tab + 1 : tab - 1);
    tabs_.erase(tabs_.begin() + static_cast<std::ptrdiff_t>(tab));
    if (shown_ > tab) --shown_;
    for (const fs::path& file : gone)
        if (std::ranges::none_of(tabs_, [&](const std::unique_ptr<Tab>& each) { return uses(*each, file); }))
            shared_.sources.erase(file);
}

void Tabs::releaseDevice() {
    for (const std::unique_ptr<Tab>& each : tabs_) {
        each->session.releaseDevice();
        for (const PanelUse& panel : each->ui.panels) panel.panel->releaseDevice();
    }
}

void Tabs::restoreDevice() {
    for (const std::unique_ptr<Tab>& each : tabs_) {
        each->session.restoreDevice();
        for (const PanelUse& panel : each->ui.panels) panel.panel->restoreDevice();
    }
}

bool Tabs::uses(const Tab& tab, const fs::path& file) const {
    const std::vector<SourceFile>& files = tab.ui.files;
    return std::ranges::any_of(files, [&](const SourceFile& each) { return each.path == file; });
}

std::vector<fs::path> Tabs::unsaved(std::size_t tab) const {
    std::vector<fs::path> files;
    for (const auto& each : shared_.sources) {
        const fs::path& path = each.first;
        if (!each.second.isChanged() || tab >= tabs_.size() || !uses(*tabs_[tab], path)) continue;
        const auto users =
            std::ranges::count_if(tabs_, [&](const std::unique_ptr<Tab>& one) { return uses(*one, path); });
        if (users == 1) files.push_back(path);
    }
    return files;
}

std::vector<fs::path> Tabs::unsaved() const {
    std::vector<fs::path> files;
    for (const auto& [path, source] : shared_.sources)
        if (source.isChanged()) files.push_back(path);
    return files;
}

double Tabs::keepValues(bool now) {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    double due = -1;
    for (const std::unique_ptr<Tab>& each : tabs_) {
        if (now) each->values.keepNow(each->session);
        const double left = each->values.keep(each->session, seconds);
        if (left >= 0 && (due < 0 || left < due)) due = left;
    }
    return due;
}

void Tabs::watch(FileWatch& watch) const {
    std::vector<fs::path> files;
    for (const std::unique_ptr<Tab>& each : tabs_) {
        if (!each->session.hasScene()) continue;
        for (fs::path& file : allFiles(each->session.live())) files.push_back(std::move(file));
    }
    const std::vector<fs::path>& copies = shared_.copies.copies();
    files.insert(files.end(), copies.begin(), copies.end());
    watch.watch(files);
}

void Tabs::markOutdated(const std::vector<fs::path>& files) {
    for (const std::unique_ptr<Tab>& each : tabs_) {
        if (!each->session.hasScene()) continue;
        for (const fs::path& own : allFiles(each->session.live()))
            each->isOutdated =
                each->isOutdated || std::ranges::find(files, system::wholePath(own)) != files.end();
    }
}

void Tabs::updateTitles() {
    // This runs in every frame. Unchanged paths are not copied, so that frames allocate no memory.
    bool areOld = shared_.tabs.size() != tabs_.size();
    shared_.tabs.resize(tabs_.size());
    for (std::size_t i = 0; i < tabs_.size(); ++i)
        areOld = areOld || shared_.tabs[i].label.empty() ||
                 shared_.tabs[i].path.native() != tabs_[i]->session.path().native();
    if (areOld) {
        std::vector<fs::path> paths;
        for (const std::unique_ptr<Tab>& each : tabs_)
            paths.push_back(fs::path(each->session.path()).replace_extension());
        const std::vector<std::string> names = namesApart(paths);
        for (std::size_t i = 0; i < tabs_.size(); ++i) {
            shared_.tabs[i].label = tabs_[i]->session.hasScene() ? names[i] : "empty";
            shared_.tabs[i].path = tabs_[i]->session.path();
        }
    }
    shared_.shownTab = shown_;
    for (std::size_t i = 0; i < tabs_.size(); ++i) {
        const Session& session = tabs_[i]->session;
        TabTitle& title = shared_.tabs[i];
        title.id = tabs_[i]->id;
        title.hasError = hasError(session.diagnostics());
        title.isUnsaved = std::ranges::any_of(shared_.sources, [&](const auto& each) {
            return each.second.isChanged() && uses(*tabs_[i], each.first);
        });
    }
}

}  // namespace glibra::view
