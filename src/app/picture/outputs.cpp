#include "src/app/picture/outputs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <unordered_map>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/app/open/complain.h"
#include "src/app/picture/sheet.h"
#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/document/document.h"
#include "src/runtime/resources/counters.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

// Gives each file one name, following links as replace_file() does. Folders are cached, as many pictures share them.
class Places {
public:
    std::string of(const std::string& file) {
        std::error_code error;
        const fs::path path = content::without_links(file);
        const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
        const auto [found, is_new] = folders_.try_emplace(folder);
        if (is_new) found->second = fs::weakly_canonical(fs::absolute(folder, error), error);
        return (found->second / path.filename()).lexically_normal().string();
    }

private:
    std::unordered_map<std::string, fs::path> folders_;
};

}  // namespace

bool replace_a_file(std::span<const std::string> outputs) {
    return ranges::any_of(outputs, [](const std::string& file) {
        std::error_code error;
        return !file.empty() && !content::is_stream(file) && fs::is_regular_file(file, error);
    });
}

std::vector<std::string> read_by(std::span<const std::string> scenes, std::span<const std::string> outputs,
                                 const Access& access, bool grade) {
    std::vector<std::string> read(scenes.begin(), scenes.end());
    if (!replace_a_file(outputs)) return read;
    for (const std::string& scene : scenes)
        for (std::string& file : files_read_by(scene, access_to(scene, access, grade))) read.push_back(std::move(file));
    return read;
}

bool distinct_outputs(std::span<const std::string> outputs, std::span<const std::string> read) {
    Places places;
    std::unordered_map<std::string, const std::string*> taken;
    for (const std::string& file : read) taken.emplace(places.of(file), nullptr);
    bool distinct = true;
    for (const std::string& file : outputs) {
        if (file.empty() || content::is_stream(file)) continue;
        const auto [other, is_new] = taken.emplace(places.of(file), &file);
        if (is_new) continue;
        distinct = false;
        const std::string what = !other->second           ? "is read, and would be overwritten"
                                 : *other->second == file ? "would be two outputs"
                                                          : fmt::format("and '{}' would be one file", *other->second);
        complain(fmt::format("'{}' {}", file, what), "give each output a name of its own");
    }
    return distinct;
}

Exit check_outputs(std::span<const std::string> outputs, std::span<const std::string> read) {
    if (!distinct_outputs(outputs, read)) return exit_usage;
    Exit status = exit_fine;
    for (const std::string& file : outputs) {
        const std::string wrong = file.empty() ? "" : content::check_place(file);
        if (!wrong.empty() && !cannot_write(file, wrong)) status = exit_input;
    }
    return status;
}

namespace {

constexpr std::size_t most_waiting = 8, most_threads = 4;

Written write(const std::string& path, std::optional<content::Image> picture, bool light,
              const Writer::Wanted& wanted) {
    const runtime::Stopwatch watch;
    Written written;
    if (picture) written.error = content::write_image(path, *picture);
    if (written.error.empty() && (wanted.hash || (wanted.tile && !picture))) {
        const std::string bytes = content::whole_file(path);
        written.bytes = bytes.size();
        if (wanted.hash) written.sha256 = sha256(bytes);
        if (!picture) picture = content::decode_image(path, bytes).image;
    }
    if (wanted.tile && picture) written.tile = thumbnail(*picture, light);
    written.milliseconds = watch.milliseconds();
    return written;
}

}  // namespace

Writer::~Writer() { finish(); }

void Writer::add(std::string path, std::optional<content::Image> picture, const std::string& wrong, bool light) {
    const std::size_t threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most_threads);
    std::unique_lock lock(mutex_);
    if (!wrong.empty()) {
        written_.push_back({.error = wrong});
        return;
    }
    change_.wait(lock, [&] { return queue_.size() < most_waiting; });
    queue_.push_back({written_.size(), std::move(path), std::move(picture), light});
    written_.emplace_back();
    if (threads_.size() < std::min(threads, written_.size())) threads_.emplace_back([this] { work(); });
    change_.notify_all();
}

void Writer::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        change_.wait(lock, [&] { return done_ || !queue_.empty(); });
        if (queue_.empty()) return;
        Job job = std::move(queue_.front());
        queue_.pop_front();
        change_.notify_all();
        lock.unlock();
        Written written = write(job.path, std::move(job.picture), job.light, wanted_);
        lock.lock();
        written_[job.place] = std::move(written);
    }
}

const std::vector<Written>& Writer::finish() {
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    change_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    return written_;
}

namespace {

using Word = std::uint32_t;

// The first 32 bits of the fractions of the cube roots of the first 64 primes.
constexpr std::array<Word, 64> rounds{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

using State = std::array<Word, 8>;

void mix(State& state, const char* block) {
    std::array<Word, 64> w{};
    for (std::size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(block[i]);
    for (std::size_t i = 16; i < 64; ++i) {
        const Word a = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
        const Word b = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
        w[i] = w[i - 16] + a + w[i - 7] + b;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
        const Word sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const Word sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const Word one = h + sum1 + ((e & f) ^ (~e & g)) + rounds[i] + w[i];
        const Word two = sum0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
    }
    const State mixed{a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i) state[i] += mixed[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
    State state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
    for (; bytes.size() >= 64; bytes.remove_prefix(64)) mix(state, bytes.data());
    std::string last(bytes);
    last += '\x80';
    last.resize(last.size() <= 56 ? 56 : 120);
    for (int shift = 56; shift >= 0; shift -= 8) last += static_cast<char>(bits >> shift & 0xff);
    for (std::size_t i = 0; i < last.size(); i += 64) mix(state, &last[i]);
    std::string text;
    for (const Word word : state) text += fmt::format("{:08x}", word);
    return text;
}

}  // namespace snell::app
