// Writes pictures to files while the next ones are drawn.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "src/content/image/image.h"

namespace snell::app {

// The outcome of writing a picture.
struct Written {
    std::string error;  // "" if the file was written
    std::uintmax_t bytes = 0;
    std::string sha256;   // of the file, if requested
    content::Image tile;  // a thumbnail, if requested
    double milliseconds = 0;
};

class Writer {
public:
    struct Wanted {
        bool hash = false, tile = false;
    };
    explicit Writer(Wanted wanted) : wanted_(wanted) {}
    ~Writer();
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    // Adds a picture; waits if more than a few are pending. Without a picture, the file exists already and is only read
    // for hash and thumbnail, unless `wrong` gives the error that prevented the picture. `light`: it holds light.
    void add(std::string path, std::optional<content::Image> picture, const std::string& wrong = {},
             bool light = false);
    // Waits until all are written; the results are in the order in which they were added.
    const std::vector<Written>& finish();

private:
    struct Job {
        std::size_t place;
        std::string path;
        std::optional<content::Image> picture;
        bool light;
    };
    void work();

    Wanted wanted_;
    std::mutex mutex_;
    std::condition_variable change_;
    std::deque<Job> queue_;
    bool done_ = false;
    std::vector<Written> written_;
    std::vector<std::thread> threads_;
};

}  // namespace snell::app
