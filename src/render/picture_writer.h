#pragma once
// Frames of an animation to files, on threads of their own.

#include <glibra/diagnostic.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <thread>
#include <variant>
#include <vector>

#include "image/image.h"

namespace glibra::render {

/// Encodes and writes pictures while the next ones are drawn. One thread does it as long as it keeps up;
/// where drawing is the quicker part, more are started. At most two pictures wait, so that memory stays
/// bounded.
class PictureWriter {
  public:
    /// `written` is called with the number of files written so far, never by two threads at once; it must
    /// outlive this. `mostThreads` 0: as many as the machine has processors.
    explicit PictureWriter(const std::function<void(int)>& written, std::size_t mostThreads = 0);
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;
    ~PictureWriter() { finish(); }

    /// False once a file could not be written: there is no use in drawing more.
    bool add(image::Image picture, std::filesystem::path file);
    /// The same bytes as those of a file added before.
    bool addCopy(std::filesystem::path of, std::filesystem::path file);
    /// Waits for all; returns what went wrong: the errors of one file at most.
    Diagnostics finish();

  private:
    struct Item {
        std::variant<image::Image, std::filesystem::path> content;
        std::filesystem::path file;
    };
    bool wait(Item item);
    void startThread();
    bool take(Item& item);
    bool done(const Item& item, Diagnostics problems);
    void run();

    const std::function<void(int)>& written_;
    std::size_t mostThreads_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Item> waiting_;
    std::set<std::filesystem::path> beingWritten_;
    Diagnostics problems_;
    int count_ = 0;
    std::size_t idle_ = 0;  ///< threads that wait for a picture
    bool closed_ = false;
    bool failed_ = false;
    std::vector<std::jthread> threads_;
};

}  // namespace glibra::render
