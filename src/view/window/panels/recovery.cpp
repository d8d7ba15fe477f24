// Keeps the texts that are not saved in files (edit/recovery.h), and offers them when their scene is opened
// again after the program has ended unexpectedly.

#include <imgui.h>

#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "view/edit/recovery.h"
#include "view/edit/source_files.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

constexpr double kBetweenWrites = .3;  ///< seconds

class RecoveryPanel final : public Panel {
  public:
    void work(Ui& ui) override {
        offer(ui);
        SafetyCopies& copies = ui.shared.copies;
        for (auto known = kept_.begin(); known != kept_.end();) {
            const auto source = ui.shared.sources.find(known->first);
            const bool isThere = source != ui.shared.sources.end() && source->second.isChanged();
            if (!isThere) copies.forget(known->first);
            known = isThere ? std::next(known) : kept_.erase(known);
        }
        isWaiting_ = false;
        const double now = ImGui::GetTime();
        for (const auto& [path, source] : ui.shared.sources) {
            if (!source.isChanged()) continue;
            Kept& kept = kept_[path];
            // Somebody may have removed the copy.
            if (kept.text == source.text() && copies.isKept(path)) continue;
            if (now - kept.at < kBetweenWrites) {
                isWaiting_ = true;
                continue;
            }
            kept = {source.text(), now};
            copies.keep(path, kept.text);
        }
    }
    [[nodiscard]] bool isWorking() const override { return isWaiting_; }

  private:
    /// Looks for texts of a scene that was loaded.
    void offer(Ui& ui) {
        if (!ui.session.hasScene()) return;
        auto& loaded = loaded_[&ui.session];
        if (std::exchange(loaded, ui.session.timesLoaded()) == ui.session.timesLoaded()) return;
        for (const SourceFile& each : sourceFiles(ui.session.live())) {
            if (kept_.contains(each.path) || ui.shared.recovered.contains(each.path)) continue;
            SafetyCopies::Others others = ui.shared.copies.othersOf(each.path);
            if (others.isOpen && told_.insert(each.path).second)
                ui.notice = "another window has text of " + each.path.filename().generic_string() +
                            " that is not saved; it is not in this window";
            if (!others.left) continue;
            if (const EditedFile file(each.path);
                file.text() == others.left->text || !file.whyReadOnly().empty()) {
                SafetyCopies::remove(*others.left);
                continue;
            }
            ui.shared.recovered.insert_or_assign(each.path, std::move(*others.left));
            showSource(ui, {each.path.generic_string(), 1, 1});
        }
    }

    struct Kept {
        std::string text;
        double at = -1;  ///< ImGui::GetTime() of the last writing
    };
    std::map<std::filesystem::path, Kept> kept_;
    std::map<const Session*, std::uint64_t> loaded_;
    std::set<std::filesystem::path> told_;  ///< that other windows have text of these
    bool isWaiting_ = false;
};

}  // namespace

const PanelRow kRecoveryRow{
    .name = "recovery", .place = PanelPlace::floating, .make = make<RecoveryPanel>, .isShared = true};

}  // namespace glibra::view
