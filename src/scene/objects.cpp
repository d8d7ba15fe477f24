#include "scene/objects.h"

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
    if (content_->make) {
        Made made = content_->make();
        made.numbers.resize(content_->size);
        content_->hasFailed = hasError(made.problems);
        content_->made = std::move(made);
        content_->make = {};
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
    Diagnostics problems = made().made.problems;
    if (content_)
        std::erase_if(content_->made.problems,
                      [](const Diagnostic& each) { return each.severity != Severity::error; });
    return problems;
}

}  // namespace glibra::scene
