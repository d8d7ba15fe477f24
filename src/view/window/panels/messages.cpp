// What the window tells the user: the list of messages about the scene, the first error over the picture,
// what a scene asks, the window "Verbose", and the result of the last action.

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/text.h"
#include "image/file.h"
#include "image/format.h"
#include "render/stats.h"
#include "view/edit/edited_file.h"
#include "view/edit/message_fixes.h"
#include "view/edit/source_lines.h"
#include "view/window/panels/source_header.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {

// The messages about the scene: the banner with the first error, and the list below the source or in the
// panel.

namespace {

/// Executed statements (glib-N02) stand in the window "Verbose", if it is open.
bool isListed(const Diagnostic& each, bool isVerboseOpen) {
    return !isVerboseOpen || each.id != "glib-N02";
}

std::ptrdiff_t countOf(const Ui& ui, Severity severity) {
    const Diagnostics& all = ui.session.diagnostics();
    const bool isVerboseOpen = toolWindow(ui, "verbose").isOpen;
    return std::ranges::count_if(all, [&](const Diagnostic& each) {
        return each.severity == severity && isListed(each, isVerboseOpen);
    });
}

/// The line that the message is about, as it was compiled.
std::string compiledLine(const Ui& ui, const Place& place) {
    const auto edited = ui.session.texts().find(place.file);
    if (edited == ui.session.texts().end()) return sourceLine(place);
    std::size_t begin = 0;
    for (int line = 1; line < place.line && begin != std::string::npos; ++line) {
        begin = edited->second.find('\n', begin);
        if (begin != std::string::npos) ++begin;
    }
    if (begin == std::string::npos) return {};
    std::string text = edited->second.substr(begin, edited->second.find('\n', begin) - begin);
    std::replace(text.begin(), text.end(), '\t', ' ');
    return text;
}

void sourceExcerpt(const Ui& ui, const Place& place) {
    const std::string line = compiledLine(ui, place);
    if (line.empty()) return;
    ImGui::PushFont(codeFont());
    const Excerpt shown = excerpt(line, place.column, roomForCode());
    ImGui::TextDisabled("%6d | %s", place.line, shown.text.c_str());
    ImGui::TextDisabled("       | %s", shown.caret.c_str());
    ImGui::PopFont();
}

/// A fold with what the driver got for the line, if it refused the shader.
void translatedLines(Ui& ui, const Place& place, const std::string& name) {
    if (!ui.session.hasScene()) return;
    const std::vector<glsl::EmittedLine> lines = ui.session.live().translatedLines(place);
    if (lines.empty()) return;
    const bool isOpen =
        ImGui::TreeNodeEx("##core", ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth,
                          "what the driver got");
    mark(ui, name + "/core");
    if (!isOpen) return;
    constexpr std::size_t kMostShown = 3;
    ImGui::TextWrapped(
        "glibra translates shaders to core GLSL, because drivers lack the older dialects. This line became:");
    ImGui::PushFont(codeFont());
    for (std::size_t i = 0; i < std::min(kMostShown, lines.size()); ++i) {
        ImGui::TextWrapped("%6d > %s", lines[i].number, lines[i].text.c_str());
        if (ui.frame.translation.empty()) ui.frame.translation = lines[i].text;
    }
    ImGui::PopFont();
}

/// Carries out what a button below a message says.
void apply(Ui& ui, const MessageFix& fix) {
    if (const Diagnostics problems = writingProblem(fix.file); !problems.empty()) {
        ui.notice = {"Examples are not changed; save a copy first", true};
        return;
    }
    std::error_code failure;
    if (!fix.made.empty()) {
        Diagnostics problems;
        if (std::filesystem::exists(fix.file, failure))
            ui.notice = {fix.file.filename().generic_string() + " exists already", true};
        else
            problems = image::writeFileAtomically(fix.file, std::as_bytes(std::span(fix.made)));
        if (!problems.empty()) ui.notice = problems.front();
        ui.requests.reload = true;
    } else {
        EditedFile& file = ui.shared.sources.try_emplace(fix.file, fix.file).first->second;
        const bool wasChanged = file.isChanged();
        replaceText(file, withFix(file.text(), fix));
        if (!wasChanged) saveSource(ui, fix.file);
    }
    showSource(ui, {fix.file.generic_string(), std::max(1, fix.line), 1});
}

/// The folders in which a missing file was looked for, and buttons for what can be done.
void fixes(Ui& ui, const Diagnostic& each, const std::string& name) {
    if (!ui.session.hasScene() || each.subject.empty()) return;
    const auto [known, isNew] = ui.fixes.known.try_emplace(each.text);
    if (isNew) known->second = {fixesOf(each, ui.session.live()), searchedFor(each, ui.session.live())};
    int index = 0;
    std::optional<MessageFix> chosen;
    for (const MessageFix& fix : known->second.fixes) {
        if (index > 0) continueRowForButton(fix.label.c_str());
        if (ImGui::SmallButton(fix.label.c_str())) chosen = fix;
        mark(ui, "{}/fix/{}", name, index++);
    }
    if (const std::string& searched = known->second.searched; !searched.empty()) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        ImGui::Dummy({width, ImGui::GetTextLineHeight()});
        lineOfText(searched.c_str(), at, at.x + width, packed(palette().dim));
        if (ImGui::IsItemHovered()) wrappedTooltip(searched.c_str(), ImGui::GetFontSize() * 32);
    }
    if (chosen) apply(ui, *chosen);
}

/// A message in one line, or whole if it is the opened one. Returns true if it was clicked, which opens it.
bool messageLine(Ui& ui, const Diagnostic& each, const std::string& text, int index,
                 const std::string& name) {
    const bool isOpen = ui.fixes.opened == index;
    const Color& color = severityColor(each.severity);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height =
        isOpen ? ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y : ImGui::GetTextLineHeight();
    const bool isClicked = ImGui::Selectable("##message", false, 0, {0, height});
    mark(ui, name);
    if (isOpen) {
        const ImVec2 after = ImGui::GetCursorScreenPos();
        ImGui::SetCursorScreenPos(at);
        wrappedText(color, text.c_str());
        ImGui::SetCursorScreenPos(after);
    } else {
        lineOfText(text.c_str(), at, at.x + width, packed(color));
    }
    if (isClicked) ui.fixes.opened = index;
    return isClicked;
}

/// A message that goes to its place. `file`: the shown one, whose name is left out.
void listed(Ui& ui, const Diagnostic& each, const std::filesystem::path& file, int index) {
    const std::string name = fmt::format("source/message/{}", index);
    const Place& place = each.place;
    std::string text = each.text;
    if (!place.file.empty()) {
        const std::string line = fmt::format("{}:{}: {}", place.line, place.column, each.text);
        text = place.file == file.generic_string()
                   ? line
                   : std::filesystem::path(place.file).filename().generic_string() + ":" + line;
    }
    ImGui::PushID(index);
    const bool isOpen = ui.fixes.opened == index;
    if (messageLine(ui, each, text, index, name) && !place.file.empty()) showSource(ui, place);
    if (isOpen && each.severity == Severity::error) translatedLines(ui, place, name);
    if (isOpen) fixes(ui, each, name);
    ImGui::PopID();
}

/// A message with its line and buttons, where no source is shown.
void detailed(Ui& ui, const Diagnostic& each, int index) {
    const std::string name = fmt::format("message/{}", index);
    ImGui::PushID(index);
    const bool isError = each.severity == Severity::error;
    const bool isOpen = ui.fixes.opened == index;
    messageLine(ui, each, isOpen ? toString(each) : each.text, index, name);
    if (!isOpen) return ImGui::PopID();
    fixes(ui, each, name);
    if (!each.place.file.empty()) {
        sourceExcerpt(ui, each.place);
        if (isError) translatedLines(ui, each.place, name);
        if (each.severity != Severity::note) {
            if (ui.session.hasScene()) {
                if (smallButton(ui, "Show", name + "/show")) showSource(ui, each.place);
                ImGui::SameLine();
            }
            if (smallButton(ui, "Edit", name + "/edit")) ui.notice = openInEditor(each.place);
            ImGui::SameLine();
        }
    }
    if (smallButton(ui, "Copy", name + "/copy")) ImGui::SetClipboardText(toString(each).c_str());
    ImGui::PopID();
}

template <class Show>
void inOrder(Ui& ui, Show&& show) {
    if (ui.fixes.loaded != ui.session.timesLoaded()) ui.fixes = {ui.session.timesLoaded(), {}, 0};
    int index = 0;
    const bool isVerboseOpen = toolWindow(ui, "verbose").isOpen;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note})
        for (const Diagnostic& each : ui.session.diagnostics())
            if (each.severity == severity && isListed(each, isVerboseOpen)) show(each, index++);
}

/// The section, while no source is shown. Each tab opens and closes its own.
struct MessageSection {
    std::ptrdiff_t lastErrors = 0;
    bool isOpen = false;
};

void messagesPanel(Ui& ui, MessageSection& shown) {
    // With the source, the list stands below its text.
    if (ui.settings.showSource && ui.session.hasScene()) return;
    const auto errors = countOf(ui, Severity::error);
    const auto warnings = countOf(ui, Severity::warning);
    const auto notes = countOf(ui, Severity::note);
    if (errors + warnings + notes == 0) return;
    const std::string title =
        errors + warnings == 0 ? fmt::format("Messages ({})###messages", base::counted(notes, "note"))
                               : fmt::format("Messages ({}, {})###messages", base::counted(errors, "error"),
                                             base::counted(warnings, "warning"));
    if (errors > 0 && shown.lastErrors == 0) shown.isOpen = true;
    shown.lastErrors = errors;
    ImGui::SetNextItemOpen(shown.isOpen);
    ImGui::PushFont(headingFont());
    shown.isOpen = ImGui::CollapsingHeader(title.c_str());
    ImGui::PopFont();
    mark(ui, "messages");
    if (!shown.isOpen) return;
    inOrder(ui, [&](const Diagnostic& each, int index) { detailed(ui, each, index); });
}

/// The first error and how many more there are, at the lower edge of the picture. `banner`: their text.
void errorBanner(Ui& ui, std::string& banner) {
    banner.clear();
    const Diagnostics& all = ui.session.diagnostics();
    const auto first = std::ranges::find(all, Severity::error, &Diagnostic::severity);
    if (first == all.end()) return;
    std::string text = first->text;
    if (!first->place.file.empty())
        text =
            fmt::format("{}:{}:{}: {}", std::filesystem::path(first->place.file).filename().generic_string(),
                        first->place.line, first->place.column, first->text);
    const auto others = countOf(ui, Severity::error) - 1;
    const std::string more = others > 0 ? fmt::format("and {} more", others) : std::string();
    banner = text + (more.empty() ? "" : " " + more);

    const ImGuiStyle& style = ImGui::GetStyle();
    const float height = std::ceil(ImGui::GetTextLineHeight() + 2 * style.FramePadding.y + 4);
    const Rectangle& picture = ui.frame.picture;
    const float end = picture[0] + picture[2];
    // Where the picture is seen.
    const float left = std::clamp(ui.frame.covered, picture[0], std::max(picture[0], end - 1));
    ImGui::SetNextWindowPos({left, picture[1] + picture[3]}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({end - left, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, packed(palette().banner));
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("##banner", nullptr, kFlags)) {
        const bool isClicked = ImGui::InvisibleButton("first error", {end - left, height});
        mark(ui, "banner");
        if (ImGui::IsItemHovered()) {
            ui.frame.hoverText = text;
            wrappedTooltip(text.c_str(), ImGui::GetFontSize() * 32);
        }
        if (isClicked && !first->place.file.empty() && ui.session.hasScene()) showSource(ui, first->place);
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const float pad = style.FramePadding.x + 2;
        const float top = picture[1] + picture[3] - height + style.FramePadding.y + 2;
        const float right = end - pad;
        const float moreLeft = more.empty() ? right : right - ImGui::CalcTextSize(more.c_str()).x;
        const ImU32 color = packed(palette().bannerText);
        draw.AddText({moreLeft, top}, color, more.c_str());
        lineOfText(text.c_str(), {left + pad, top}, more.empty() ? right : moreLeft - pad, color);
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

class MessagesPanel final : public Panel {
  public:
    void show(Ui& ui) override { messagesPanel(ui, section_); }

  private:
    MessageSection section_;
};

class Banner final : public Panel {
  public:
    void show(Ui& ui) override { errorBanner(ui, text_); }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override { state["banner"] = text_; }

  private:
    std::string text_;
};

// What a scene asks the user when it is loaded: messages, and files that it does not name.

struct MessageBox {
    std::uint64_t loaded = 0;  ///< Session::timesLoaded() of the texts
    std::vector<std::string> texts;
    bool isShown = false;
    std::uint64_t asked = 0;  ///< Session::timesLoaded() when the user was asked for a file last
};

/// The messages are shown again after a reload only if they have changed, so that edits are not interrupted.
void showMessages(Ui& ui, MessageBox& box) {
    constexpr const char* kTitle = "Message";
    if (ui.session.hasScene() && box.loaded != ui.session.timesLoaded()) {
        box.loaded = ui.session.timesLoaded();
        if (const auto& texts = ui.session.live().scene().messages; texts != box.texts) {
            box.texts = texts;
            box.isShown = !box.texts.empty();
        }
    }
    if (!box.isShown) return;
    if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
    if (!beginModal(kTitle)) return;
    ImGui::PushTextWrapPos(
        std::min(420 * ui.shared.scale, ImGui::GetIO().DisplaySize.x - 60 * ui.shared.scale));
    for (const std::string& each : box.texts) ImGui::TextUnformatted(each.c_str());
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    if (ImGui::IsWindowAppearing()) giveKeyboardToNext();
    if (ImGui::Button("OK", {80 * ui.shared.scale, 0}) || isKeyPressed(GLFW_KEY_ENTER) ||
        isKeyPressed(GLFW_KEY_ESCAPE)) {
        box.isShown = false;
        ImGui::CloseCurrentPopup();
    }
    mark(ui, "messageBox/ok");
    ImGui::EndPopup();
}

/// Asks for the file of a model or texture that the scene does not name.
void askForMissingFile(Ui& ui, MessageBox& box) {
    const bool isPopupOpen =
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (!ui.session.hasScene() || box.isShown || isPopupOpen || ui.wanted.file || ui.shared.question ||
        box.asked == ui.session.timesLoaded())
        return;
    box.asked = ui.session.timesLoaded();
    const std::vector<scene::MissingFile>& all = ui.session.live().scene().missingFiles;
    if (all.empty()) return;
    const scene::MissingFile& missing = all.front();
    std::string endings = missing.isModel ? ".obj" : "";
    if (!missing.isModel)
        for (const image::FormatRow& each : image::formats()) endings += each.suffixes;
    askForFile(ui,
               {.title = fmt::format("A file for {} in line {}", missing.word, missing.place.line),
                .button = "Use",
                .hint = fmt::format(
                    "Line {} of {} does not name a file. 'Save values' writes your choice into the scene.",
                    missing.place.line, ui.session.path().filename().generic_string()),
                .endings = std::move(endings),
                .chosen = [place = missing.place](Ui& in, const std::filesystem::path& file) {
                    std::string problem = in.session.chooseFile(place, file);
                    in.requests.reload = problem.empty();
                    return problem;
                }});
}

class MessageBoxPanel final : public Panel {
  public:
    void show(Ui& ui) override {
        askForMissingFile(ui, box_);
        showMessages(ui, box_);
    }
    [[nodiscard]] bool blocksKeys() const override { return box_.isShown; }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["messageBox"] = box_.isShown ? box_.texts : std::vector<std::string>();
    }

  private:
    MessageBox box_;
};

// The window "Verbose": what the scene does, statement by statement, and what was made for it.

std::string verboseText(const Session& session) {
    std::string text;
    for (const Diagnostic& each : session.diagnostics())
        if (each.id == "glib-N02") text += std::to_string(each.place.line) + ": " + each.text + "\n";
    return text + "\n" + render::toText(session.live().loadStats());
}

void verboseWindow(Ui& ui, bool& isOpen) {
    if (ui.session.hasScene() && ui.session.isVerbose() != isOpen) {
        ui.session.setVerbose(isOpen);
        ui.requests.reload = true;
    }
    if (!isOpen) return;
    placeFloating(ui, 30, 60, 620, 420);
    if (ImGui::Begin(kVerboseRow.title, &isOpen, ImGuiWindowFlags_NoCollapse)) {
        const std::string text = ui.session.hasScene() ? verboseText(ui.session) : std::string();
        if (button(ui, "Copy", "verbose/copy")) ImGui::SetClipboardText(text.c_str());
        ImGui::BeginChild("text", {0, 0}, true, ImGuiWindowFlags_HorizontalScrollbar);
        ImGui::PushFont(codeFont());
        ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
        ImGui::PopFont();
        ImGui::EndChild();
        mark(ui, "verbose/text");
    }
    ImGui::End();
}

// The result of the last action for a moment on the picture, while the panel with the status line is hidden.

constexpr double kSeconds = 4;

class NoticeOverlay final : public Panel {
  public:
    void show(Ui& ui) override {
        const double now = ImGui::GetTime();
        if (ui.notice.text != text_) {
            text_ = ui.notice.text;
            since_ = now;
        }
        isShown_ = !ui.shared.showPanel && !text_.empty() && now - since_ < kSeconds;
        if (!isShown_) return;
        ui.frame.isFollowed = true;  // until it goes
        const float gap = 8 * ui.shared.scale;
        // Not over the tabs of the source.
        const Rectangle& room = ui.frame.room;
        const float left = std::max(room[0], ui.frame.covered);
        ImGui::SetNextWindowPos({left + gap, room[1] + gap});
        ImGui::SetNextWindowBgAlpha(.9F);
        if (ImGui::Begin("##notice", nullptr,
                         ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                             ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoInputs |
                             ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
            ImGui::PushTextWrapPos(std::max(100.F, room[0] + room[2] - left - 4 * gap));
            ImGui::TextColored(asVector(ui.notice.isError ? palette().error : palette().text), "%s",
                               text_.c_str());
            ImGui::PopTextWrapPos();
            markWindow(ui, "notice/overlay");
        }
        ImGui::End();
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["noticeOverlay"] = isShown_;
    }

  private:
    std::string text_;
    double since_ = 0;
    bool isShown_ = false;
};

}  // namespace

void messageList(Ui& ui, const std::filesystem::path& file) {
    inOrder(ui, [&](const Diagnostic& each, int index) { listed(ui, each, file, index); });
}

const PanelRow kMessagesRow{
    .name = "messages", .place = PanelPlace::section, .make = make<MessagesPanel>, .withoutScene = true};
const PanelRow kBannerRow{.name = "banner", .place = PanelPlace::floating, .make = make<Banner>};

const PanelRow kMessageBoxRow{
    .name = "messageBox", .place = PanelPlace::floating, .make = make<MessageBoxPanel>};

const PanelRow kVerboseRow{.name = "verbose",
                           .place = PanelPlace::floating,
                           .make = make<Drawn<verboseWindow>>,
                           .isShared = true,
                           .title = "Verbose"};

const PanelRow kNoticeRow{.name = "notice", .place = PanelPlace::floating, .make = make<NoticeOverlay>};

}  // namespace glibra::view
