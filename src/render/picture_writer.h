#pragma once
// Frames of an animation to files, on a thread of its own.

#include <glibra/diagnostic.h>

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <thread>
#include <variant>

#include "image/image.h"

namespace glibra::render {

/// Encodes and writes pictures in order while the next one is drawn. At most two wait, so that memory stays
/// bounded when encoding is the slower part.
class PictureWriter {
  public:
    /// `written` is called on that thread with the number of files written so far; it must outlive this.
    explicit PictureWriter(const std::function<void(int)>& written);
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;
    ~PictureWriter() { finish(); }

    /// False once a file could not be written: there is no use in drawing more.
    bool add(image::Image picture, std::filesystem::path file);
    /// The same bytes as those of a file added before.
    bool addCopy(std::filesystem::path of, std::filesystem::path file);
    /// Waits for all; returns what went wrong.
    Diagnostics finish();

  private:
    struct Item {
        std::variant<image::Image, std::filesystem::path> content;
        std::filesystem::path file;
    };
    bool wait(Item item);
    void run();

    const std::function<void(int)>& written_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Item> waiting_;
    Diagnostics problems_;
    bool closed_ = false;
    bool failed_ = false;
    std::jthread thread_;
};

}  // namespace glibra::render
