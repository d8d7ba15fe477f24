#pragma once
// What the window and the process that draws for it send each other (drawing_process.h, drawing_service.h).

#include <glibra/diagnostic.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::view {

/// A message is 8 bytes with the length, then the text. False, or nothing, if the other process has ended.
bool sendMessage(int socket, std::string_view text);
std::optional<std::string> receiveMessage(int socket);
/// Removes the first whole message from bytes that were received; nothing if there is none.
std::optional<std::string> takeMessage(std::string& received);

/// The answer after a picture: what was reported about it.
std::string answerText(const Diagnostics& diagnostics);
Diagnostics diagnosticsOf(const nlohmann::json& answer);

/// The descriptors of the process. They are above all that the window has open.
inline constexpr int kDrawingSocket = 200, kDrawingMemory = 201;

}  // namespace glibra::view
