#include "scene/buffer_values.h"

#include <utility>

namespace glibra::scene {

BufferValues::BufferValues(std::vector<double> numbers) {
    if (numbers.empty()) return;
    const std::size_t size = numbers.size();
    content_ = std::make_shared<Content>(Content{size, {}, {std::move(numbers), {}}});
}

BufferValues::BufferValues(std::size_t size, std::function<Made()> make)
    : content_(std::make_shared<Content>(Content{size, std::move(make), {}})) {}

const BufferValues::Content& BufferValues::made() const {
    static const Content kNothing;
    if (!content_) return kNothing;
    if (const auto make = std::exchange(content_->make, {})) {
        content_->made = make();
        content_->made.numbers.resize(content_->size);
        content_->hasFailed = hasError(content_->made.problems);
    }
    return *content_;
}

const std::vector<double>& BufferValues::numbers() const {
    return made().made.numbers;
}

bool BufferValues::hasFailed() const {
    return made().hasFailed;
}

Diagnostics BufferValues::takeProblems() const {
    made();
    return content_ ? std::exchange(content_->made.problems, {}) : Diagnostics();
}

}  // namespace glibra::scene
