// Scenes from text, on the bench.
#pragma once

#include "src/accuracy/found/change.h"
#include "src/accuracy/measure.h"
#include "src/document/document.h"
#include "tests/harness/harness.h"

namespace snell::test {

class AccuracyTest : public GlTest {
protected:
    // What a scene is read into. Stays for as long as its bench.
    struct Read {
        std::unique_ptr<Files> files;
        Sources sources;
        Diagnostics diagnostics;
        Plan plan;
    };

    accuracy::Bench& bench_of(const std::string& path, int width, int height);
    accuracy::Bench& bench_of_text(std::string_view scene, int width, int height);
    const Plan& plan() const { return read->plan; }
    // Replaces the first `before` in any of the texts.
    accuracy::Change change(accuracy::ChangeKind kind, std::string_view before, std::string_view after) const;
    // The shaders full.vert and full.frag, for quads that fill the picture.
    void write_full(std::string_view fragment) const;

    std::unique_ptr<Read> read;
    std::unique_ptr<accuracy::Bench> bench;

    void TearDown() override;
};

}  // namespace snell::test
