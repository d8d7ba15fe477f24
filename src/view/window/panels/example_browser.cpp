// The window with the example scenes and their pictures.

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "base/own_library.h"
#include "glib/text.h"
#include "image/read.h"
#include "system/places.h"
#include "view/browse/example_scenes.h"
#include "view/edit/edited_file.h"
#include "view/window/panels/texel_view.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"

namespace glibra::view {
namespace {

struct ExampleBrowser {
    struct Tile {
        ExampleScene scene;
        Thumbnail thumbnail;
        std::optional<gpu::Texture> picture;  ///< loaded when the tile is first visible
    };

    bool isListed = false;  ///< `tiles` is up to date
    std::filesystem::path root;
    std::vector<Tile> tiles;
    std::array<char, 128> search{};
    std::vector<std::string> chapters;                   ///< of the tiles
    std::string chapter;                                 ///< the one whose scenes are shown; empty: all
    std::size_t found = 0;                               ///< number of tiles that the search finds
    std::string chosen;                                  ///< by the arrow keys: "topic/name"
    bool reveals = false;                                ///< the chosen tile is scrolled into view
    std::vector<std::pair<std::string, ImVec2>> places;  ///< of the found tiles in the last frame
    std::unique_ptr<ThumbnailMaker> maker;
    std::size_t wanted = 0, finished = 0;  ///< numbers of pictures that the maker has to make, and has made
};

constexpr float kTileWidth = 168;
constexpr float kTileHeight = kTileWidth * kThumbnailHeight / kThumbnailWidth;

/// True if the scene is of the chosen chapter, and each word of the search is in the name, the description or
/// the source.
bool isFound(const ExampleScene& scene, const ExampleBrowser& browser) {
    if (!isOfChapter(scene, browser.chapter)) return false;
    const std::string_view search = browser.search.data();
    const std::string text =
        glib::lower(scene.topic + "/" + scene.name + " " + scene.summary + " " + scene.source);
    std::istringstream words{glib::lower(search)};
    for (std::string word; words >> word;)
        if (text.find(word) == std::string::npos) return false;
    return true;
}

/// Starts making the pictures that are missing, those of the scenes that are shown first.
void makeMissing(ExampleBrowser& browser) {
    browser.maker.reset();
    std::vector<std::filesystem::path> missing;
    for (const bool areShown : {true, false})
        for (const ExampleBrowser::Tile& each : browser.tiles)
            if (each.thumbnail.state == Thumbnail::State::missing && isFound(each.scene, browser) == areShown)
                missing.push_back(each.scene.file);
    const std::filesystem::path cache = thumbnailFolder();
    browser.wanted = browser.finished + missing.size();
    if (!missing.empty() && !cache.empty())
        browser.maker = std::make_unique<ThumbnailMaker>(cache, std::move(missing), [] { Display::wake(); });
}

/// Lists the examples on the disk, and starts making the missing pictures.
void listExamples(const Session& session, ExampleBrowser& browser) {
    browser.isListed = true;
    browser.maker.reset();
    browser.tiles.clear();
    browser.root = exampleRoot(session.renderOptions().libraryRoots, session.path(), system::programFile());
    if (browser.root.empty()) return;
    const std::filesystem::path cache = thumbnailFolder();
    std::vector<ExampleScene> scenes = exampleScenes(browser.root);
    browser.chapters = chaptersOf(scenes);
    for (ExampleScene& each : scenes) {
        Thumbnail known = findThumbnail(cache, each.file);
        browser.tiles.push_back({std::move(each), std::move(known), std::nullopt});
    }
    browser.finished = 0;
    makeMissing(browser);
}

void takeFinished(ExampleBrowser& browser) {
    if (!browser.maker) return;
    for (const std::filesystem::path& file : browser.maker->takeFinished()) {
        ++browser.finished;
        for (ExampleBrowser::Tile& each : browser.tiles)
            if (each.scene.file == file) each.thumbnail = findThumbnail(thumbnailFolder(), file);
    }
    if (browser.finished >= browser.wanted) browser.maker.reset();
}

void loadPicture(const gpu::Capabilities& capabilities, ExampleBrowser::Tile& tile) {
    if (tile.picture || tile.thumbnail.state != Thumbnail::State::ready) return;
    Result<image::Image> read = image::readImage(tile.thumbnail.picture, {});
    if (!read || read->type != image::Component::u8 || read->components != 4) {
        tile.thumbnail = {Thumbnail::State::failed, {}, "the cached picture cannot be read"};
        return;
    }
    tile.picture = textureOfBytes(capabilities, read->width, read->height, read->data, GL_LINEAR, GL_LINEAR);
    if (!tile.picture) return;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// Opens an example in a tab of its own, so that the shown scene stays as it is. The tab is that of the shown
/// scene if it is empty.
void open(Ui& ui, const ExampleScene& scene, bool staysOpen) {
    ui.requests.open = scene.file;
    ui.requests.inNewTab = true;
    toolWindow(ui, kExamplesRow.name).isOpen = staysOpen;
}

void tile(Ui& ui, ExampleBrowser& browser, ExampleBrowser::Tile& each, bool areComing) {
    const ImVec2 size(kTileWidth * ui.shared.scale, kTileHeight * ui.shared.scale);
    const std::string name = each.scene.topic + "/" + each.scene.name;
    ImGui::PushID(name.c_str());
    ImGui::BeginGroup();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool isClicked = ImGui::InvisibleButton("tile", size);
    const bool isHovered = ImGui::IsItemHovered();
    const bool staysOpen = isHovered && (ImGui::IsMouseReleased(ImGuiMouseButton_Middle) ||
                                         (isClicked && ImGui::GetIO().KeyCtrl));
    mark(ui, "example/" + name);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 end(at.x + size.x, at.y + size.y);
    if (ImGui::IsRectVisible(at, end)) loadPicture(ui.context.capabilities(), each);
    if (each.picture) {
        draw.AddImageRounded(idOf(*each.picture), at, end, {0, 0}, {1, 1}, IM_COL32_WHITE,
                             4 * ui.shared.scale);
    } else {
        draw.AddRectFilled(at, end, ImGui::GetColorU32(ImGuiCol_FrameBg), 4 * ui.shared.scale);
        const bool isComing = each.thumbnail.state == Thumbnail::State::missing && areComing;
        const char* text = isComing ? "..." : "no picture";
        const ImVec2 width = ImGui::CalcTextSize(text);
        draw.AddText({at.x + (size.x - width.x) / 2, at.y + (size.y - width.y) / 2},
                     ImGui::GetColorU32(ImGuiCol_TextDisabled), text);
    }
    browser.places.emplace_back(name, at);
    const bool isChosen = name == browser.chosen;
    if (isChosen && std::exchange(browser.reveals, false)) ImGui::SetScrollHereY();
    if (isHovered || isChosen)
        draw.AddRect(at, end, ImGui::GetColorU32(ImGuiCol_ButtonActive), 4 * ui.shared.scale, 0, 2);
    draw.PushClipRect(at, {end.x, end.y + ImGui::GetTextLineHeightWithSpacing() * 2}, true);
    ImGui::TextUnformatted(each.scene.name.c_str());
    draw.PopClipRect();
    ImGui::EndGroup();
    if (isHovered) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(320 * ui.shared.scale);
        ImGui::TextUnformatted(each.scene.summary.empty() ? name.c_str() : each.scene.summary.c_str());
        if (!each.scene.source.empty()) ImGui::TextDisabled("%s", each.scene.source.c_str());
        if (!each.thumbnail.problem.empty()) ImGui::TextDisabled("%s", each.thumbnail.problem.c_str());
        ImGui::TextDisabled("Ctrl+click opens it and keeps this window");
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
    if (isClicked || staysOpen) open(ui, each.scene, staysOpen);
    ImGui::PopID();
}

/// The choice of a chapter.
void chapterChoice(Ui& ui, ExampleBrowser& browser) {
    if (browser.chapters.empty()) return;
    ImGui::SetNextItemWidth(260 * ui.shared.scale);
    const bool isOpen =
        beginCombo(ui, "##chapter", browser.chapter.empty() ? "all chapters" : browser.chapter.c_str(),
                   "examples/chapter", ImGuiComboFlags_HeightLarge);
    if (!isOpen) return;
    const std::string before = browser.chapter;
    if (ImGui::Selectable("all chapters", browser.chapter.empty())) browser.chapter.clear();
    for (const std::string& each : browser.chapters)
        if (choice(ui, each.c_str(), each == browser.chapter, "examples/chapter/{}", each))
            browser.chapter = each;
    ImGui::EndCombo();
    if (browser.chapter == before || !browser.maker) return;
    takeFinished(browser);
    makeMissing(browser);
}

/// For those who have no scene yet.
void newAndOpen(Ui& ui) {
    if (ui.session.hasScene()) return;
    if (button(ui, "New scene...", "examples/new")) askEmptyScene(ui);
    ImGui::SameLine();
    if (button(ui, "Open...", "examples/open")) openDialog(ui, false);
    ImGui::SameLine();
    ImGui::TextDisabled("or begin with an example:");
}

/// How many scenes are found, and that Enter opens the only one.
void countLine(ExampleBrowser& browser) {
    const auto found = std::ranges::count_if(
        browser.tiles, [&](const ExampleBrowser::Tile& each) { return isFound(each.scene, browser); });
    browser.found = static_cast<std::size_t>(found);
    if (browser.search[0] == 0 && browser.chapter.empty())
        ImGui::TextDisabled("%zu scenes", browser.tiles.size());
    else
        ImGui::TextDisabled("%zu of %zu scenes%s", browser.found, browser.tiles.size(),
                            browser.found == 1 ? "; Enter opens it" : "; arrows and Enter open one");
    if (!browser.maker) return;
    ImGui::SameLine();
    ImGui::TextDisabled("drawing pictures: %zu of %zu", browser.finished, browser.wanted);
}

void tiles(Ui& ui, ExampleBrowser& browser) {
    const float width = kTileWidth * ui.shared.scale + ImGui::GetStyle().ItemSpacing.x;
    const int columns = std::max(
        1, static_cast<int>((ImGui::GetContentRegionAvail().x + ImGui::GetStyle().ItemSpacing.x) / width));
    const std::string* topic = nullptr;
    int column = 0;
    browser.places.clear();
    for (ExampleBrowser::Tile& each : browser.tiles) {
        if (!isFound(each.scene, browser)) continue;
        if (!topic || *topic != each.scene.topic) {
            if (topic) ImGui::Spacing();
            topic = &each.scene.topic;
            column = 0;
            ImGui::TextDisabled("%s", topic->c_str());
            ImGui::Separator();
        } else if (column % columns != 0) {
            ImGui::SameLine();
        }
        tile(ui, browser, each, browser.maker != nullptr);
        ++column;
    }
    if (!topic) ImGui::TextDisabled("No name or description contains this text.");
}

/// The tile that the arrow key leads to from the chosen one: the nearest in that direction, which is in the
/// next row for up and down. Nothing is chosen at first.
void chooseByKeys(ExampleBrowser& browser) {
    const auto& places = browser.places;
    if (places.empty()) return;
    const int down = (isKeyPressed(GLFW_KEY_DOWN) ? 1 : 0) - (isKeyPressed(GLFW_KEY_UP) ? 1 : 0);
    const int right = (isKeyPressed(GLFW_KEY_RIGHT) ? 1 : 0) - (isKeyPressed(GLFW_KEY_LEFT) ? 1 : 0);
    const auto now =
        std::ranges::find_if(places, [&](const auto& each) { return each.first == browser.chosen; });
    if (now == places.end()) {
        browser.chosen = down > 0 ? places.front().first : std::string();
        browser.reveals = down > 0;
        return;
    }
    auto next = now;
    if (right > 0 && std::next(now) != places.end()) next = std::next(now);
    if (right < 0 && now != places.begin()) next = std::prev(now);
    if (down != 0) {
        const auto apart = [&](const auto& each) {
            return std::pair(std::abs(each.second.y - now->second.y),
                             std::abs(each.second.x - now->second.x));
        };
        for (auto each = places.begin(); each != places.end(); ++each) {
            const float lower = (each->second.y - now->second.y) * static_cast<float>(down);
            if (lower > 1 && (next == now || apart(*each) < apart(*next))) next = each;
        }
    }
    if (next == now) return;
    browser.chosen = next->first;
    browser.reveals = true;
}

void exampleWindow(Ui& ui, ExampleBrowser& browser, bool& isOpen) {
    takeFinished(browser);
    if (!isOpen) {
        browser.isListed = false;
        browser.maker.reset();
        return;
    }
    if (!browser.isListed) listExamples(ui.session, browser);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize(
        {std::min(screen.x - 40 * ui.shared.scale, 940 * ui.shared.scale), screen.y * .86F},
        ImGuiCond_Appearing);
    centreNextWindow(ImGuiCond_Appearing);
    if (ImGui::Begin(kExamplesRow.title, &isOpen, ImGuiWindowFlags_NoCollapse)) {
        if (browser.root.empty()) {
            ImGui::TextWrapped(
                "No example scenes were found. They are in the folder 'glib' of glibra's sources. Set the "
                "environment variable GLIBRA_PATH to the folder that contains 'glib'.");
        } else {
            ImGui::SetNextItemWidth(260 * ui.shared.scale);
            if (ImGui::IsWindowAppearing()) giveKeyboardToNext();
            const bool isEntered =
                ImGui::InputTextWithHint("##search", "search", browser.search.data(), browser.search.size(),
                                         ImGuiInputTextFlags_EnterReturnsTrue);
            mark(ui, "examples/search");
            ImGui::SameLine();
            chapterChoice(ui, browser);
            ImGui::SameLine();
            countLine(browser);
            const bool hasKeys = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
                                 ImGui::GetCurrentContext()->OpenPopupStack.empty();
            if (hasKeys) chooseByKeys(browser);
            const bool isEnter =
                isEntered || (hasKeys && ui.sliders.focused == 0 && !ImGui::GetIO().WantTextInput &&
                              isKeyPressed(GLFW_KEY_ENTER, false));
            if (isEnter)
                for (const ExampleBrowser::Tile& each : browser.tiles)
                    if (isFound(each.scene, browser) &&
                        (browser.found == 1 || each.scene.topic + "/" + each.scene.name == browser.chosen))
                        open(ui, each.scene, false);
            newAndOpen(ui);
            ImGui::BeginChild("tiles");
            tiles(ui, browser);
            ImGui::EndChild();
        }
    }
    ImGui::End();
}

class ExampleWindow final : public Panel {
  public:
    void show(Ui& ui) override { exampleWindow(ui, browser_, isOpen); }
    [[nodiscard]] bool needsFrames() const override {
        return browser_.maker && browser_.maker->hasFinished();
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        const auto pictures = std::ranges::count_if(browser_.tiles, [](const ExampleBrowser::Tile& each) {
            return each.thumbnail.state == Thumbnail::State::ready;
        });
        state["examples"] = {{"open", isOpen},          {"scenes", browser_.tiles.size()},
                             {"found", browser_.found}, {"chosen", browser_.chosen},
                             {"pictures", pictures},    {"drawing", browser_.maker != nullptr}};
    }
    void releaseDevice() override {
        for (ExampleBrowser::Tile& each : browser_.tiles) each.picture.reset();
    }

  private:
    ExampleBrowser browser_;
};

constexpr auto kExampleKeys =
    std::to_array<Shortcut>({{KeyGroup::scenes, GLFW_KEY_X, false, "X", "example scenes", toggleOpen}});

}  // namespace

const PanelRow kExamplesRow{.name = "examples",
                            .place = PanelPlace::floating,
                            .make = make<ExampleWindow>,
                            .isShared = true,
                            .keys = kExampleKeys,
                            .title = "Example scenes"};

}  // namespace glibra::view
