#include "render/picture_writer.h"

#include <utility>

#include "image/file.h"
#include "image/write.h"

namespace glibra::render {
namespace {

Diagnostics copyFile(const std::filesystem::path& from, const std::filesystem::path& to) {
    const auto bytes = image::readFile(from, {from.string(), {from.string(), 1, 1}});
    if (!bytes) return bytes.diagnostics;
    return image::writeFileAtomically(to, *bytes);
}

}  // namespace

PictureWriter::PictureWriter(const std::function<void(int)>& written) : written_(written) {
    thread_ = std::jthread([this] { run(); });
}

bool PictureWriter::add(image::Image picture, std::filesystem::path file) {
    return wait({std::move(picture), std::move(file)});
}

bool PictureWriter::addCopy(std::filesystem::path of, std::filesystem::path file) {
    return wait({std::move(of), std::move(file)});
}

bool PictureWriter::wait(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < 2 || failed_; });
    if (failed_) return false;
    waiting_.push_back(std::move(item));
    changed_.notify_all();
    return true;
}

Diagnostics PictureWriter::finish() {
    {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }
    if (thread_.joinable()) thread_.join();
    return std::move(problems_);
}

void PictureWriter::run() {
    for (int count = 1;; ++count) {
        Item item;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
            if (waiting_.empty()) return;
            item = std::move(waiting_.front());
            waiting_.pop_front();
            changed_.notify_all();
        }
        const auto* picture = std::get_if<image::Image>(&item.content);
        Diagnostics problems = picture ? image::writeImage(*picture, item.file)
                                       : copyFile(std::get<std::filesystem::path>(item.content), item.file);
        const bool bad = hasError(problems);
        {
            const std::scoped_lock lock(mutex_);
            append(problems_, std::move(problems));
            if (bad) {
                failed_ = true;
                waiting_.clear();
                changed_.notify_all();
                return;
            }
        }
        written_(count);
    }
}

}  // namespace glibra::render
