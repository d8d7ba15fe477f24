#pragma once
// What a click can do about a message: make a missing shader, take another name, add a slider.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/live/live_scene.h"

namespace glibra::view {

struct MessageFix {
    std::string label;           ///< of the button: "Create lit.vert", "Use 'lighting.vert'", "Add a slider"
    std::filesystem::path file;  ///< to change or to make
    std::string made{};          ///< the text of a new file; empty: `file` is changed
    int line = 0;                ///< that is changed
    std::string from{}, to{};    ///< a word of the line and what takes its place; without `from`, `to` is
                                 ///< added to the statement of the line
};

/// What can be done about it; empty for most messages.
std::vector<MessageFix> fixesOf(const Diagnostic& message, const render::LiveScene& live);
/// The folders in which a file was looked for, if the message says that it is missing; otherwise empty.
std::string searchedFor(const Diagnostic& message, const render::LiveScene& live);
/// The text with the change; unchanged if the line has not the word.
std::string withFix(std::string_view text, const MessageFix& fix);

}  // namespace glibra::view
