#include "suite/run/run_messages.h"

#include <fmt/format.h>

#include <sstream>

namespace glibra::suite {
namespace {

std::string head(char kind, const ShotReference& shot) {
    return fmt::format("{} {} {}\n", kind, shot.suite, shot.shot);
}

struct ToText {
    std::string operator()(const DriverIs& message) const {
        return "k\n" + message.words + "\n" + message.key;
    }
    std::string operator()(const Begins& message) const { return head('b', message.shot); }
    std::string operator()(const Phase& message) const {
        return head(static_cast<char>(message.kind), message.shot);
    }
    std::string operator()(const Done& message) const {
        return head('d', message.shot) + toJsonLine(message.result) + "\n" +
               (message.accepted ? toLine(*message.accepted) : "");
    }
};

}  // namespace

std::string toText(const Message& message) {
    return std::visit(ToText{}, message);
}

std::optional<Message> parseMessage(const std::string& text) {
    std::istringstream lines(text);
    std::string first, second, third;
    std::getline(lines, first);
    std::getline(lines, second);
    std::getline(lines, third);
    if (first == "k") return DriverIs{second, third};
    std::istringstream words(first);
    char kind = 0;
    ShotReference shot;
    if (!(words >> kind >> shot.suite >> shot.shot)) return std::nullopt;
    if (kind == 'b') return Begins{shot};
    for (const Phase::Kind each :
         {Phase::Kind::awaits, Phase::Kind::drawn, Phase::Kind::judges, Phase::Kind::recalls})
        if (kind == static_cast<char>(each)) return Phase{each, shot};
    if (kind != 'd') return std::nullopt;
    Result<ShotResult> result = parseJsonLine(second, {});
    if (!result) return std::nullopt;
    Done done{shot, std::move(*result), std::nullopt};
    if (!third.empty()) done.accepted = parseLine(third, {}).value;
    return done;
}

}  // namespace glibra::suite
