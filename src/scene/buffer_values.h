#pragma once
// The numbers that a scene gives a buffer.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace glibra::scene {

/// Numbers in order, which copies share. Those of an expression are computed when they are first read, so
/// that a buffer that nothing reads costs nothing. One thread at a time may read them.
class BufferValues {
  public:
    struct Made {
        std::vector<double> numbers;  ///< without an error as many as were promised
        Diagnostics problems;
    };

    BufferValues() = default;
    BufferValues(std::vector<double> numbers);
    /// `make` gives that many numbers. It is called at most once.
    BufferValues(std::size_t size, std::function<Made()> make);

    /// Computes nothing.
    [[nodiscard]] std::size_t size() const { return content_ ? content_->size : 0; }
    [[nodiscard]] bool empty() const { return size() == 0; }
    /// As many as size(); what could not be computed is 0.
    [[nodiscard]] const std::vector<double>& numbers() const;
    [[nodiscard]] bool hasFailed() const;
    /// What computing them has reported: all at the first call, and at later ones, also those of copies, the
    /// errors.
    [[nodiscard]] Diagnostics takeProblems() const;

    /// Numbers of which some could not be computed equal no others.
    friend bool operator==(const BufferValues& a, const BufferValues& b) {
        return a.content_ == b.content_ || (!a.hasFailed() && !b.hasFailed() && a.numbers() == b.numbers());
    }

  private:
    struct Content {
        std::size_t size = 0;
        std::function<Made()> make;  ///< empty: `made` is there
        Made made;
        bool hasFailed = false;
    };
    const Content& made() const;

    std::shared_ptr<Content> content_;
};

}  // namespace glibra::scene
