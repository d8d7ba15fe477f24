#include "cli/suite_progress.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "base/utf8.h"
#include "suite/options/option_words.h"
#include "system/places.h"
#include "system/terminal.h"

namespace glibra::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenFrames{100};
constexpr std::chrono::seconds kBetweenLines{10};
constexpr std::size_t kBarWidth = 24;

}  // namespace

std::string readableTime(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(std::max(0.0, seconds)));
    const long long hours = whole / 3600;
    const long long minutes = whole / 60 % 60;
    return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                     : fmt::format("{}:{:02}", minutes, whole % 60);
}

SuiteProgress::SuiteProgress(std::size_t total, bool terminal)
    : total_(total), terminal_(terminal), start_(Clock::now()), shown_(start_) {}

std::string SuiteProgress::figures(Clock::time_point now) const {
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double rate = seconds > 0 ? static_cast<double>(done_) / seconds : 0;
    std::string text = fmt::format("{}/{}", done_, total_);
    if (rate > 0)
        text += fmt::format("  {:.3g} a second  {} left", rate,
                            readableTime(static_cast<double>(total_ - done_) / rate));
    if (failed_ > 0) text += fmt::format("  {} failed", failed_);
    return text;
}

void SuiteProgress::show(bool now) {
    const Clock::time_point time = Clock::now();
    if (!now &&
        time - shown_ < (terminal_ ? Clock::duration(kBetweenFrames) : Clock::duration(kBetweenLines)))
        return;
    shown_ = time;
    if (!terminal_) {
        std::fprintf(stderr, "%s\n", figures(time).c_str());
        return;
    }
    const std::size_t full = total_ > 0 ? kBarWidth * done_ / total_ : kBarWidth;
    std::string line =
        fmt::format("[{:=<{}}{: <{}}] {}  {}", "", full, "", kBarWidth - full, figures(time), current_);
    std::size_t end = std::min(line.size(), system::terminalColumns() - 1);
    while (end > 0 && end < line.size() && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U) --end;
    line.resize(end);
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
}

void SuiteProgress::add(bool failed) {
    ++done_;
    if (failed) ++failed_;
    show(false);
}

void SuiteProgress::begins(const std::string& name) {
    current_ = base::printableText(name);
    if (terminal_) show(false);
}

void SuiteProgress::print(const std::string& line) {
    clear();
    std::fprintf(stderr, "%s\n", line.c_str());
    if (terminal_) show(true);
}

void SuiteProgress::clear() {
    if (terminal_) std::fputs("\r\033[K", stderr);
}

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
