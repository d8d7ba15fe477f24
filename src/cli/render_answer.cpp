#include "cli/render_answer.h"

#include <charconv>

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

}  // namespace

std::string pack(const Answer& answer) {
    Packer packer;
    packer.add(answer.status);
    packer.add(answer.explanation);
    packer.add(answer.statsJson);
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
    answer.status = from.number();
    answer.explanation = from.text();
    answer.statsJson = from.text();
    for (int count = from.number(); count > 0; --count) {
        const int frame = from.number();
        Diagnostic remark;
        remark.severity = static_cast<Severity>(from.number());
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

}  // namespace glibra::cli
