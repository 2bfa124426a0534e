// Pictures go to disk while the next ones are drawn.
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

#include "src/content/image.h"

namespace snell::app {

// What became of a picture.
struct Written {
    std::string error;  // "" when it is there
    std::uintmax_t bytes = 0;
    std::string sha256;   // of the file, where wanted
    content::Image tile;  // a thumbnail, where wanted
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

    // Waits when more than a few are on their way. No picture: the file is there already, and is only looked at; unless
    // `wrong` says why it is not.
    void add(std::string path, std::optional<content::Image> picture, const std::string& wrong = {});
    // Waits for all; in the order in which they were added.
    const std::vector<Written>& finish();

private:
    struct Job {
        std::size_t place;
        std::string path;
        std::optional<content::Image> picture;
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
