// Diagnostics of the open scenes, in the background: first those that need no driver, after a rest the driver's too.
// Editors take them file by file.
#pragma once

#include <string>

#include "parser/text/diagnostic.h"
#include "src/content/process.h"
#include "src/server/documents.h"
#include "src/server/state.h"
#include "src/server/wire/messages.h"

namespace snell::server {

class Checks {
public:
    explicit Checks(State& state) : state_(state) {}

    // Ends what has become needless, takes what is done, and begins what is due.
    void go_on();
    int descriptor() const { return background_.descriptor(); }
    // When go_on() has something to do, if nothing happens before.
    Clock::time_point due() const;

private:
    struct Next {
        Scene* scene = nullptr;
        bool driver = false;
        Clock::time_point at = Clock::time_point::max();
    };
    Next next() const;
    Scene* current() const;
    void begin(const Next& next);
    void take(const std::string& result);
    void publish();

    State& state_;
    content::Process background_;
    std::string path_;  // of the scene that is being checked
    bool driver_ = false;
    Clock::time_point began_;
};

// An array of {uri, version, diagnostics}, one for each file of the sources; texts that are open have a version. What
// has no place is said of the beginning of `scene`.
Json published(const Diagnostics& diagnostics, const Sources& sources, const std::string& scene,
               const Documents& documents, const Services& services, Encoding encoding);

}  // namespace snell::server
