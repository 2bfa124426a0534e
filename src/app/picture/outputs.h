// Pictures as files: their names, and who writes them.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "src/app/open/complain.h"
#include "src/content/image/image.h"
#include "src/plan/files.h"

namespace snell::app {

// The files that a command was asked to write, looked at before the work that they are to hold.

// Returns true if writing these would replace at least one file.
bool replace_a_file(std::span<const std::string> outputs);

// The scenes, and, only if an output would replace a file, all that they may read: what outputs must not overwrite.
// `grade`: as for access_to().
std::vector<std::string> read_by(std::span<const std::string> scenes, std::span<const std::string> outputs,
                                 const Access& access, bool grade = false);

// Whether some of them are one file, under whatever names, or one of `read`, which is not to be overwritten; says so.
// Empty names, pipes and devices lose nothing.
bool distinct_outputs(std::span<const std::string> outputs, std::span<const std::string> read);

// What this ends with: exit_usage where they are not distinct, exit_input where one can't be written, both said.
Exit check_outputs(std::span<const std::string> outputs, std::span<const std::string> read);

// Writes pictures to files while the next ones are drawn.

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
