// Keeps the texts that are not saved in files (edit/recovery.h), and offers them when their scene is opened
// again after the program has ended unexpectedly.

#include <imgui.h>

#include <cstdint>
#include <functional>
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
    /// A window that is closed has asked about its texts.
    ~RecoveryPanel() override {
        for (const auto& each : kept_) forgetText(folder_, each.first);
    }

    void work(Ui& ui) override {
        offer(ui);
        for (auto known = kept_.begin(); known != kept_.end();) {
            const auto source = ui.shared.sources.find(known->first);
            const bool isThere = source != ui.shared.sources.end() && source->second.isChanged();
            if (!isThere) forgetText(folder_, known->first);
            known = isThere ? std::next(known) : kept_.erase(known);
        }
        isWaiting_ = false;
        const double now = ImGui::GetTime();
        for (const auto& [path, source] : ui.shared.sources) {
            if (!source.isChanged()) continue;
            Kept& kept = kept_[path];
            if (kept.isWritten && kept.text == source.text()) continue;
            if (now - kept.at < kBetweenWrites) {
                isWaiting_ = true;
                continue;
            }
            kept = {source.text(), now, true};
            keepText(folder_, path, kept.text);
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
            if (kept_.contains(each.path) || !asked_.insert(each.path).second) continue;
            std::optional<RecoveredText> text = keptText(folder_, each.path);
            if (!text) continue;
            if (const EditedFile file(each.path); file.text() == text->text || !file.whyReadOnly().empty()) {
                forgetText(folder_, each.path);
                continue;
            }
            ui.shared.recovered.insert_or_assign(each.path, std::move(*text));
            showSource(ui, {each.path.string(), 1, 1});
        }
    }

    struct Kept {
        std::string text;
        double at = -1;  ///< ImGui::GetTime() of the last writing
        bool isWritten = false;
    };
    std::filesystem::path folder_ = recoveryFolder();
    std::map<std::filesystem::path, Kept> kept_;
    std::map<const Session*, std::uint64_t> loaded_;
    std::set<std::filesystem::path> asked_;
    bool isWaiting_ = false;
};

}  // namespace

const PanelRow kRecoveryRow{
    .name = "recovery", .place = PanelPlace::floating, .make = make<RecoveryPanel>, .isShared = true};

}  // namespace glibra::view
