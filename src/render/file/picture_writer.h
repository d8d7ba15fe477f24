#pragma once
// Writes the frames of an animation to files, on separate threads.

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

/// Writes the bytes of one file to another.
Diagnostics copyFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Encodes and writes pictures while the next ones are drawn. It starts with one thread and adds more when
/// drawing is faster. At most two pictures wait, so that the use of memory is bounded.
class PictureWriter {
  public:
    /// `written` is called with the number of files written so far, never by two threads at once; it must
    /// outlive the writer. `mostThreads` 0: one thread per processor.
    explicit PictureWriter(const std::function<void(int)>& written, std::size_t mostThreads = 0);
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;
    ~PictureWriter() { finish(); }

    /// Returns false after a file could not be written: drawing more is useless.
    bool add(image::Image picture, std::filesystem::path file);
    /// Adds a copy of a file that was added before.
    bool addCopy(std::filesystem::path of, std::filesystem::path file);
    /// Waits for all files and returns the errors of at most one file.
    Diagnostics finish();

  private:
    struct Item {
        std::variant<image::Image, std::filesystem::path> content;
        std::filesystem::path file;
    };
    bool wait(Item item);
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
    std::size_t idle_ = 0;  ///< threads waiting for a picture
    bool closed_ = false;
    bool failed_ = false;
    std::vector<std::jthread> threads_;
};

}  // namespace glibra::render
