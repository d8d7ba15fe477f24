// The section with the keys that the scene declares, as buttons.

#include <fmt/format.h>
#include <imgui.h>

#include "glib/text.h"
#include "view/window/panels/shortcuts.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

void keysPanel(Ui& ui) {
    const std::vector<scene::KeyBinding> keys = sceneKeys(ui);
    if (keys.empty() || !section(ui, "Keys of the scene", "keys", true)) return;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton(keys[i].key.c_str())) ui.session.pressKey(keys[i].key);
        mark(ui, "key/{}", keys[i].key);
        if (keys[i].isHeld && ImGui::IsItemActive()) holdKey(ui, keys[i].key);
        ImGui::PopID();
        ImGui::SameLine();
        ImGui::TextUnformatted(effectOf(keys[i]).c_str());
        for (const PanelRow* row : panelRows())
            for (const Shortcut& each : row->keys)
                if (glib::sameWord(takenKey(ui, each), keys[i].key))
                    wrappedText(palette().dim, fmt::format("Shift+{}: {}", each.keys, each.what).c_str());
    }
}

}  // namespace

const PanelRow kSceneKeysRow{.name = "keys", .place = PanelPlace::section, .make = make<Drawn<keysPanel>>};

}  // namespace glibra::view
