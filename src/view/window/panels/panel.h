#pragma once
// A panel of the window, and the row that registers it in panels.def.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace glibra::view {

struct Ui;

/// What Esc closes, in this order: a list of words or the reference, then the search bar.
enum class Closing { list, bar };

/// A panel owns its state. It receives the session, the settings and the sinks for requests with each call
/// (ui.h). Other panels reach it only through Ui::wanted, or open and close it if it is a tool window.
class Panel {
  public:
    Panel() = default;
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;
    virtual ~Panel() = default;

    bool isOpen = false;  ///< only used by tool windows (PanelRow::title)

    /// Runs in every frame of its tab, even while the tab is not shown.
    virtual void work(Ui& /*ui*/) {}
    /// Runs in every frame of the shown tab before anything is drawn: takes what it can do from Ui::wanted.
    virtual void update(Ui& /*ui*/) {}
    /// Draws the panel at its place, in every frame of the shown tab.
    virtual void show(Ui& /*ui*/) {}
    /// Draws over the scene's picture of this frame.
    virtual void drawOver(Ui& /*ui*/) {}
    /// Returns true if there was something to close.
    virtual bool close(Ui& /*ui*/, Closing /*what*/) { return false; }
    /// True while keys must not act outside of the panel.
    [[nodiscard]] virtual bool blocksKeys() const { return false; }
    /// True while work() has something to do.
    [[nodiscard]] virtual bool isWorking() const { return false; }
    /// True if the next frames show a change that no event announces.
    [[nodiscard]] virtual bool needsFrames() const { return false; }
    /// Adds the panel's part of `--state`.
    virtual void addTo(nlohmann::ordered_json& /*state*/, const Ui& /*ui*/) const {}
    /// The device is lost: releases everything that is on it.
    virtual void releaseDevice() {}
    /// There is a device again.
    virtual void restoreDevice() {}
};

/// A panel without state: a function of the frame, or of the frame and whether the tool window is open.
template <auto draw>
class Drawn final : public Panel {
  public:
    void show(Ui& ui) override {
        if constexpr (std::is_invocable_v<decltype(draw), Ui&>)
            draw(ui);
        else
            draw(ui, isOpen);
    }
};

/// The groups of the list of keys, in its order.
enum class KeyGroup { time, view, values, pipeline, source, scenes, window };

/// The key of actions without one, which the command palette lists.
inline constexpr int kNoKey = -2;

struct Shortcut {
    KeyGroup group;
    int key;  ///< GLFW_KEY_...
    bool control;
    const char* keys;  ///< as the list shows it; empty: another row describes the key
    const char* what;
    void (*act)(Ui&, Panel&);  ///< with the panel whose row has the shortcut
    bool whileTyping = false;  ///< works also while text is entered
};

/// Opens or closes a tool window.
void toggleOpen(Ui& ui, Panel& panel);

/// A shortcut's action that is a member function of the panel.
template <class Owner>
Owner ownerOf(void (Owner::*)(Ui&));
template <auto method>
void call(Ui& ui, Panel& panel) {
    (static_cast<decltype(ownerOf(method))&>(panel).*method)(ui);
}

enum class PanelPlace {
    head,      ///< at the top of the side panel
    section,   ///< of the side panel, if there is a scene or `withoutScene` is set
    edge,      ///< takes a part of Frame::room
    floating,  ///< a window or dialog of its own
    picture    ///< draws no widgets: the mouse over the picture
};

struct PanelRow {
    std::string_view name;
    PanelPlace place;
    std::unique_ptr<Panel> (*make)();
    bool isShared = false;      ///< one panel for all tabs, otherwise one per tab
    bool withoutScene = false;  ///< for sections
    std::span<const Shortcut> keys = {};
    const char* title = nullptr;     ///< a tool window's, for ImGui::Begin(); Esc closes it
    const char* checkBox = nullptr;  ///< label of its check box in the section Tools
    const char* help = nullptr;      ///< tooltip of the check box
};

template <class Made>
std::unique_ptr<Panel> make() {
    return std::make_unique<Made>();
}

// All panels of the window.

#define GLIBRA_PANEL(row) extern const PanelRow row;
#include "view/window/panels/panels.def"
#undef GLIBRA_PANEL

/// All rows, in the order of panels.def.
std::span<const PanelRow* const> panelRows();

/// One entry per row; null for the rows that are not of that kind.
using PanelSet = std::vector<std::unique_ptr<Panel>>;
/// Makes the panels of one tab, or those that all tabs share.
PanelSet makePanels(bool areShared);

/// A panel of a tab with its row.
struct PanelUse {
    const PanelRow* row = nullptr;
    Panel* panel = nullptr;
};
/// All panels that a tab shows, in the order of the rows.
std::vector<PanelUse> panelsOf(const PanelSet& shared, const PanelSet& own);

}  // namespace glibra::view
