#include "cli/render_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <new>

#include "cli/library_hint.h"

namespace glibra::cli {
namespace {

constexpr int kNoFrame = -1;

/// Writes numbers as "7 " and texts as "3 abc".
class Packer {
  public:
    void add(int number) { text_ += std::to_string(number) + ' '; }
    void add(std::string_view text) {
        add(static_cast<int>(text.size()));
        text_ += text;
    }
    void add(const Diagnostic& remark, int frame) {
        for (const int each :
             {frame, static_cast<int>(remark.severity), remark.place.line, remark.place.column})
            add(each);
        for (const std::string& each : {remark.id, remark.text, remark.place.file}) add(each);
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

class Unpacker {
  public:
    explicit Unpacker(std::string_view packed) : rest_(packed) {}
    /// A worker that a scene has taken over may announce more than it sends.
    [[nodiscard]] bool isAtEnd() const { return rest_.empty(); }
    int number() {
        int value = 0;
        const char* end = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value).ptr;
        rest_.remove_prefix(std::min(rest_.size(), static_cast<std::size_t>(end - rest_.data()) + 1));
        return value;
    }
    std::string text() {
        const auto size = static_cast<std::size_t>(number());
        std::string text(rest_.substr(0, size));
        rest_.remove_prefix(text.size());
        return text;
    }

  private:
    std::string_view rest_;
};

Answer wrong(const std::string& scene, const char* id, const std::string& text) {
    return {.status = kSceneIsWrong, .remarks = {{diagnose(id, text, {scene, 1, 1})}, {}}};
}

}  // namespace

std::string pack(const Answer& answer) {
    Packer packer;
    packer.add(answer.status);
    packer.add(answer.explanation);
    packer.add(answer.statsJson);
    packer.add(static_cast<int>(answer.shaders.size()));
    for (const render::TranslatedShader& each : answer.shaders) {
        packer.add(each.name);
        packer.add(each.source);
    }
    packer.add(static_cast<int>(answer.lines.size()));
    for (const auto& [place, line] : answer.lines) {
        packer.add(place.first);
        packer.add(place.second);
        packer.add(line);
    }
    std::size_t count = answer.remarks.general.size();
    for (const auto& [frame, remarks] : answer.remarks.ofFrames) count += remarks.size();
    packer.add(static_cast<int>(count));
    for (const Diagnostic& each : answer.remarks.general) packer.add(each, kNoFrame);
    for (const auto& [frame, remarks] : answer.remarks.ofFrames)
        for (const Diagnostic& each : remarks) packer.add(each, frame);
    return packer.take();
}

Answer unpack(std::string_view packed) {
    Unpacker from(packed);
    Answer answer;
    answer.status = std::clamp(from.number(), kDone, kNoDriver);
    answer.explanation = from.text();
    answer.statsJson = from.text();
    for (int count = from.number(); count > 0 && !from.isAtEnd(); --count) {
        std::string name = from.text();
        answer.shaders.push_back({std::move(name), from.text()});
    }
    for (int count = from.number(); count > 0 && !from.isAtEnd(); --count) {
        std::string file = from.text();
        const int number = from.number();
        answer.lines[{std::move(file), number}] = from.text();
    }
    for (int count = from.number(); count > 0 && !from.isAtEnd(); --count) {
        const int frame = from.number();
        Diagnostic remark;
        remark.severity =
            static_cast<Severity>(std::clamp(from.number(), 0, static_cast<int>(Severity::error)));
        remark.place.line = from.number();
        remark.place.column = from.number();
        remark.id = from.text();
        remark.text = from.text();
        remark.place.file = from.text();
        (frame == kNoFrame ? answer.remarks.general : answer.remarks.ofFrames[frame])
            .push_back(std::move(remark));
    }
    return answer;
}

Answer answerOf(const base::Outcome& outcome, const std::string& scene, const suite::Shot& picture,
                const Deed& deed) {
    if (outcome.end == base::Outcome::End::finished) return unpack(outcome.answer);
    if (outcome.end == base::Outcome::End::deviceLost)
        return {.status = kSceneIsWrong, .remarks = {{base::diagnosticOf(outcome.lost, scene)}, {}}};
    if (outcome.end == base::Outcome::End::timedOut)
        return wrong(scene, "draw-E07",
                     fmt::format("not {} within {:g} seconds (--timeout)", deed.participle, picture.timeout));
    return wrong(
        scene, "draw-E06",
        fmt::format(
            "the process that {} the scene ended {}{}", deed.past,
            outcome.signal > 0 ? fmt::format("with signal {}", outcome.signal) : std::string("by itself"),
            outcome.nearMemoryLimit ? ", perhaps because it reached its limit of memory (--memory)" : ""));
}

Answer guarded(const std::string& scene, const std::function<Answer()>& work) {
    try {
        Answer answer = work();
        append(answer.remarks.general, libraryHint(scene, answer.remarks.general));
        return answer;
    } catch (const base::DeviceLost&) {
        throw;  // the worker must not be used any more
    } catch (const std::bad_alloc&) {
        return wrong(scene, "draw-E05", "out of memory (--memory)");
    } catch (const std::exception& failure) {
        return wrong(scene, "draw-E06", failure.what());
    }
}

}  // namespace glibra::cli
