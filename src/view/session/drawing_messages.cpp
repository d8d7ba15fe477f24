#include "view/session/drawing_messages.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

namespace glibra::view {
namespace {

constexpr std::size_t kHead = sizeof(std::uint64_t);

}  // namespace

std::optional<std::string> takeMessage(std::string& received) {
    std::uint64_t length = 0;
    if (received.size() < kHead) return std::nullopt;
    std::memcpy(&length, received.data(), kHead);
    if (received.size() - kHead < length) return std::nullopt;
    std::string text = received.substr(kHead, length);
    received.erase(0, kHead + length);
    return text;
}

bool sendMessage(int socket, std::string_view text) {
    const auto length = static_cast<std::uint64_t>(text.size());
    std::string bytes(kHead, '\0');
    std::memcpy(bytes.data(), &length, kHead);
    bytes += text;
    for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t sent = ::send(socket, rest.data(), rest.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        rest.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

std::optional<std::string> receiveMessage(int socket) {
    std::string received;
    for (;;) {
        if (std::optional<std::string> text = takeMessage(received)) return text;
        std::array<char, 1 << 16> bytes{};
        const ssize_t length = ::recv(socket, bytes.data(), bytes.size(), 0);
        if (length < 0 && errno == EINTR) continue;
        if (length <= 0) return std::nullopt;
        received.append(bytes.data(), static_cast<std::size_t>(length));
    }
}

std::string answerText(const Diagnostics& diagnostics) {
    nlohmann::json list = nlohmann::json::array();
    for (const Diagnostic& each : diagnostics)
        list.push_back({each.id, each.text, each.place.file, each.place.line, each.place.column});
    return nlohmann::json{{"diagnostics", list}}.dump(-1, ' ', false,
                                                      nlohmann::json::error_handler_t::replace);
}

Diagnostics diagnosticsOf(const nlohmann::json& answer) {
    Diagnostics diagnostics;
    for (const nlohmann::json& each : answer.at("diagnostics"))
        diagnostics.push_back(diagnose(each[0].get<std::string>(), each[1].get<std::string>(),
                                       {each[2].get<std::string>(), each[3].get<int>(), each[4].get<int>()}));
    return diagnostics;
}

}  // namespace glibra::view
