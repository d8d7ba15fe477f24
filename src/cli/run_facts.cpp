#include "cli/run_facts.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <ctime>

#include "suite/options/option_words.h"
#include "system/places.h"

namespace glibra::cli {

std::string commandLine() {
    std::string line;
    for (const std::string& word : system::ownWords())
        line += (line.empty() ? "" : " ") + suite::shellWord(word);
    return line;
}

std::string utcNow() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

}  // namespace glibra::cli
